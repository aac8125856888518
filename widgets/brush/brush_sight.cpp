// SPDX-License-Identifier: Apache-2.0
#include "widgets/brush/brush_sight.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "model/base/parallel.h"
#include "model/camera/camera_moves.h"
#include "model/geometry/normals.h"
#include "model/geometry/sight.h"

namespace sline::widgets {

namespace {

constexpr float cellSide = 32.0f;  // pixels
constexpr std::size_t grain = 4096;

/// Finds the pixels of many points.
class PixelFinder {
 public:
  PixelFinder(const model::Camera& camera, const glm::vec2& size)
      : m_camera(camera),
        m_frame(model::cameraFrame(camera)),
        m_size(size),
        m_slope(camera.projection == model::Projection::perspective ? model::edgeSlope(camera)
                                                                    : 0.0f) {}

  /// Returns the pixel of a point before the eye, no number for others.
  glm::vec2 at(const glm::vec3& p) const {
    const glm::vec3 way = p - m_camera.eye;
    float half = 0.5f * m_camera.heightMm;
    if (m_camera.projection == model::Projection::perspective) {
      const float depth = -glm::dot(way, m_frame.back);
      if (!(depth > 0.0f))
        return glm::vec2(std::numeric_limits<float>::quiet_NaN());
      half = depth * m_slope;
    }
    const float scale = 0.5f * m_size.y / half;
    return 0.5f * m_size +
           scale * glm::vec2(glm::dot(way, m_frame.right), -glm::dot(way, m_frame.up));
  }

 private:
  const model::Camera& m_camera;
  model::CameraFrame m_frame;
  glm::vec2 m_size;
  float m_slope;
};

}  // namespace

BrushGroundPtr brushGround(const model::MeshPtr& mesh) {
  return std::make_shared<const BrushGround>(BrushGround{
      .mesh = mesh, .tree = model::treeOf(mesh), .normals = model::vertexNormals(*mesh)});
}

BrushSight::BrushSight(From from)
    : m_from(std::move(from)), m_sights(m_from.ground->mesh->vertexCount(), Sight::unknown) {
  constexpr float liftShare = 1e-4f;
  m_lift = liftShare * glm::length(m_from.ground->mesh->bounds().size());
  m_columns = std::size_t(std::ceil(std::max(m_from.size.x, 1.0f) / cellSide));
  m_rows = std::size_t(std::ceil(std::max(m_from.size.y, 1.0f) / cellSide));
  placeVertices();
  sortIntoCells();
}

void BrushSight::placeVertices() {
  const auto positions = m_from.ground->mesh->positions();
  const PixelFinder finder(m_from.camera, m_from.size);
  m_pixels.resize(positions.size());
  parallelFor(positions.size(), grain, [&](std::size_t v) {
    const glm::vec3& p = positions[v];
    const bool faces =
        glm::dot(m_from.ground->normals[v], model::towardsEye(m_from.camera, p)) > 0.0f;
    const bool kept = std::all_of(
        m_from.planes.begin(), m_from.planes.end(),
        [&p](const model::Plane& plane) { return glm::dot(plane.normal, p) <= plane.offset; });
    const glm::vec2 pixel =
        faces && kept ? finder.at(p) : glm::vec2(std::numeric_limits<float>::quiet_NaN());
    const bool within =
        pixel.x >= 0.0f && pixel.y >= 0.0f && pixel.x < m_from.size.x && pixel.y < m_from.size.y;
    m_pixels[v] = within ? pixel : glm::vec2(std::numeric_limits<float>::quiet_NaN());
  });
}

std::size_t BrushSight::cellAt(float x, float y) const {
  const auto place = [](float at, std::size_t count) {
    return std::min(std::size_t(std::max(at, 0.0f) / cellSide), count - 1);
  };
  return place(y, m_rows) * m_columns + place(x, m_columns);
}

void BrushSight::sortIntoCells() {
  m_cellStarts.assign(m_columns * m_rows + 1, 0);
  for (const glm::vec2& pixel : m_pixels)
    if (!std::isnan(pixel.x))
      ++m_cellStarts[cellAt(pixel.x, pixel.y) + 1];
  for (std::size_t cell = 1; cell < m_cellStarts.size(); ++cell)
    m_cellStarts[cell] += m_cellStarts[cell - 1];
  m_inCells.resize(m_cellStarts.back());
  std::vector<std::uint32_t> next(m_cellStarts.begin(), m_cellStarts.end() - 1);
  for (std::size_t v = 0; v < m_pixels.size(); ++v)
    if (!std::isnan(m_pixels[v].x))
      m_inCells[next[cellAt(m_pixels[v].x, m_pixels[v].y)]++] = std::uint32_t(v);
}

bool BrushSight::reaches(std::uint32_t vertex) const {
  const BrushGround& ground = *m_from.ground;
  const glm::vec3& p = ground.mesh->positions()[vertex];
  const glm::vec3 towards = model::towardsEye(m_from.camera, p);
  model::Ray ray{.origin = p + m_lift * (ground.normals[vertex] + towards), .direction = towards};
  if (m_from.camera.projection == model::Projection::perspective)
    ray.farthest = glm::distance(m_from.camera.eye, ray.origin);
  if (!m_from.planes.empty())
    ray = model::keptPart(ray, m_from.planes);
  return !(ray.nearest <= ray.farthest) || !ground.tree->blocked(ray);
}

void BrushSight::look(std::span<const std::uint32_t> vertices) {
  parallelFor(vertices.size(), 64, [&](std::size_t i) {
    Sight& sight = m_sights[vertices[i]];
    if (sight == Sight::unknown)
      sight = reaches(vertices[i]) ? Sight::seen : Sight::hidden;
  });
}

void BrushSight::lookEverywhere(const std::stop_token& stop) {
  const std::span<const std::uint32_t> all = m_inCells;
  for (std::size_t from = 0; from < all.size() && !stop.stop_requested(); from += grain)
    look(all.subspan(from, std::min(grain, all.size() - from)));
}

std::optional<std::uint32_t> BrushSight::cornerAt(const glm::vec2& pixel) const {
  const model::Ray sight = sightThrough(m_from.camera, pixel, m_from.size);
  const auto met = model::nearestKept(*m_from.ground->tree, sight, m_from.planes);
  if (!met || met->cutFace)
    return std::nullopt;
  const model::Triangle& corners = m_from.ground->mesh->triangles()[met->hit.triangle];
  const std::array<float, 3> weights{1.0f - met->hit.u - met->hit.v, met->hit.u, met->hit.v};
  return corners[std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin())];
}

void SightAhead::want(const BrushSight::From& from) {
  if (m_coming.valid()) {
    if (m_wanted == from)
      return;
    m_stop.request_stop();
    if (!arrived())
      return;  // the next move of the mouse asks again
  } else if (m_known && m_known->from() == from) {
    return;
  }
  m_stop = {};
  m_wanted = from;
  m_coming = std::async(std::launch::async, [from, stop = m_stop.get_token()] {
    auto sight = std::make_shared<BrushSight>(from);
    sight->lookEverywhere(stop);
    return sight;
  });
}

BrushSightPtr SightAhead::take(const BrushSight::From& from) {
  if (m_coming.valid() && m_wanted == from) {
    m_stop.request_stop();
    m_known = m_coming.get();
  }
  if (!m_known || m_known->from() != from)
    m_known = std::make_shared<BrushSight>(from);
  return m_known;
}

bool SightAhead::arrived() const {
  return m_coming.valid() &&
         m_coming.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void SightAhead::forget() {
  m_stop.request_stop();
  m_coming = {};
  m_known = {};
}

}  // namespace sline::widgets
