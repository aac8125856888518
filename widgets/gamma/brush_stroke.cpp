// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/brush_stroke.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/parallel.h"
#include "model/geometry/normals.h"
#include "model/geometry/sight.h"
#include "model/geometry/topology.h"
#include "widgets/viewport/tools/navigation.h"

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

float distanceTo(const glm::vec2& from, const glm::vec2& to, const glm::vec2& p) {
  const glm::vec2 way = to - from;
  const float length = glm::dot(way, way);
  const float part =
      length > 0.0f ? glm::clamp(glm::dot(p - from, way) / length, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, from + part * way);
}

}  // namespace

float brushWeight(const Brush& brush, float pixels) {
  if (pixels >= brush.radius)
    return 0.0f;
  const float core = (1.0f - brush.softness) * brush.radius;
  if (pixels <= core)
    return brush.strength;
  return brush.strength * (1.0f - glm::smoothstep(core, brush.radius, pixels));
}

BrushGroundPtr brushGround(const model::MeshPtr& mesh) {
  const model::VertexFaces faces(*mesh);
  return std::make_shared<const BrushGround>(BrushGround{
      .mesh = mesh, .tree = model::treeOf(mesh), .normals = model::vertexNormals(*mesh, faces)});
}

BrushStroke::BrushStroke(Start start)
    : m_start(std::move(start)),
      m_sights(m_start.ground->mesh->vertexCount(), Sight::unknown),
      m_covered(m_sights.size(), 0.0f),
      m_before(m_start.before ? *m_start.before : model::Paint(m_sights.size(), 0)),
      m_paint(m_before) {
  constexpr float liftShare = 1e-4f;
  m_lift = liftShare * glm::length(m_start.ground->mesh->bounds().size());
  m_columns = std::size_t(std::ceil(std::max(m_start.size.x, 1.0f) / cellSide));
  m_rows = std::size_t(std::ceil(std::max(m_start.size.y, 1.0f) / cellSide));
  placeVertices();
  sortIntoCells();
}

void BrushStroke::placeVertices() {
  const auto positions = m_start.ground->mesh->positions();
  const PixelFinder finder(m_start.camera, m_start.size);
  m_pixels.resize(positions.size());
  parallelFor(positions.size(), grain, [&](std::size_t v) {
    const glm::vec3& p = positions[v];
    const bool faces =
        glm::dot(m_start.ground->normals[v], model::towardsEye(m_start.camera, p)) > 0.0f;
    const bool kept = std::all_of(
        m_start.planes.begin(), m_start.planes.end(),
        [&p](const model::Plane& plane) { return glm::dot(plane.normal, p) <= plane.offset; });
    const glm::vec2 pixel =
        faces && kept ? finder.at(p) : glm::vec2(std::numeric_limits<float>::quiet_NaN());
    const bool within =
        pixel.x >= 0.0f && pixel.y >= 0.0f && pixel.x < m_start.size.x && pixel.y < m_start.size.y;
    m_pixels[v] = within ? pixel : glm::vec2(std::numeric_limits<float>::quiet_NaN());
  });
}

std::size_t BrushStroke::cellAt(float x, float y) const {
  const auto place = [](float at, std::size_t count) {
    return std::min(std::size_t(std::max(at, 0.0f) / cellSide), count - 1);
  };
  return place(y, m_rows) * m_columns + place(x, m_columns);
}

void BrushStroke::sortIntoCells() {
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

bool BrushStroke::sees(std::uint32_t vertex) const {
  const BrushGround& ground = *m_start.ground;
  const glm::vec3& p = ground.mesh->positions()[vertex];
  const glm::vec3 towards = model::towardsEye(m_start.camera, p);
  model::Ray ray{.origin = p + m_lift * (ground.normals[vertex] + towards), .direction = towards};
  if (m_start.camera.projection == model::Projection::perspective)
    ray.farthest = glm::distance(m_start.camera.eye, ray.origin);
  if (!m_start.planes.empty())
    ray = model::keptPart(ray, m_start.planes);
  return !(ray.nearest <= ray.farthest) || !ground.tree->blocked(ray);
}

std::vector<std::uint32_t> BrushStroke::cornerAt(const glm::vec2& pixel) const {
  const model::Ray sight = sightThrough(m_start.camera, pixel, m_start.size);
  const auto met = model::nearestKept(*m_start.ground->tree, sight, m_start.planes);
  if (!met || met->cutFace)
    return {};
  const model::Triangle& corners = m_start.ground->mesh->triangles()[met->hit.triangle];
  const std::array<float, 3> weights{1.0f - met->hit.u - met->hit.v, met->hit.u, met->hit.v};
  return {corners[std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin())]};
}

bool BrushStroke::cover(std::uint32_t vertex, float weight) {
  if (weight <= m_covered[vertex])
    return false;
  m_covered[vertex] = weight;
  const float before = m_before[vertex];
  const float target = m_start.brush.erases ? 0.0f : 255.0f;
  const auto value = std::uint8_t(std::lround(glm::mix(before, target, weight)));
  const bool changes = m_paint[vertex] != value;
  m_paint[vertex] = value;
  return changes;
}

bool BrushStroke::move(const glm::vec2& from, const glm::vec2& to) {
  const float radius = m_start.brush.radius;
  const glm::vec2 low = glm::min(from, to) - radius;
  const glm::vec2 high = glm::max(from, to) + radius;
  std::vector<std::uint32_t> touched;
  std::vector<float> weights;
  const std::size_t first = cellAt(low.x, low.y);
  const std::size_t last = cellAt(high.x, high.y);
  for (std::size_t row = first / m_columns; row <= last / m_columns; ++row)
    for (std::size_t column = first % m_columns; column <= last % m_columns; ++column) {
      const std::size_t cell = row * m_columns + column;
      for (std::uint32_t i = m_cellStarts[cell]; i < m_cellStarts[cell + 1]; ++i) {
        const std::uint32_t v = m_inCells[i];
        const float weight = brushWeight(m_start.brush, distanceTo(from, to, m_pixels[v]));
        if (weight <= m_covered[v] || m_sights[v] == Sight::hidden)
          continue;
        touched.push_back(v);
        weights.push_back(weight);
      }
    }
  parallelFor(touched.size(), 64, [&](std::size_t i) {
    Sight& sight = m_sights[touched[i]];
    if (sight == Sight::unknown)
      sight = sees(touched[i]) ? Sight::seen : Sight::hidden;
  });
  bool changed = false;
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (m_sights[touched[i]] == Sight::seen)
      changed = cover(touched[i], weights[i]) || changed;
  // A brush smaller than the triangles paints all the same.
  if (touched.empty())
    for (const std::uint32_t v : cornerAt(to))
      changed = cover(v, m_start.brush.strength) || changed;
  return changed;
}

}  // namespace sline::widgets
