// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/style_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "model/scene/style_fields.h"
#include "render/vectors/cropped.h"

namespace sline::render {

namespace {

constexpr int rings = 28;
constexpr int around = 40;

/// Returns the vertices of a bean on its side, as seen from the front: a closed surface with
/// everything that lines can show, including a hollow. Millimetres.
std::vector<glm::vec3> beanPositions() {
  const auto at = [](float t, float a) {
    const float x = std::cos(t);
    const float thick = 1.5f * std::pow(std::max(std::sin(t), 0.0f), 0.6f);
    const float bend = 1.7f * x * x - 0.6f;
    return glm::vec3(3.2f * x, thick * std::sin(a), thick * std::cos(a) + bend);
  };
  std::vector<glm::vec3> positions;
  for (int ring = 1; ring < rings; ++ring)
    for (int i = 0; i < around; ++i)
      positions.push_back(at(glm::pi<float>() * float(ring) / float(rings),
                             glm::two_pi<float>() * float(i) / float(around)));
  positions.push_back(at(0.0f, 0.0f));
  positions.push_back(at(glm::pi<float>(), 0.0f));
  return positions;
}

std::vector<model::Triangle> beanTriangles() {
  std::vector<model::Triangle> triangles;
  const auto index = [](int ring, int i) {
    return std::uint32_t((ring - 1) * around + i % around);
  };
  const auto left = std::uint32_t((rings - 1) * around);
  for (int i = 0; i < around; ++i) {
    triangles.push_back({left, index(1, i + 1), index(1, i)});
    triangles.push_back({left + 1, index(rings - 1, i), index(rings - 1, i + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      triangles.push_back({index(ring, i), index(ring, i + 1), index(ring + 1, i)});
      triangles.push_back({index(ring, i + 1), index(ring + 1, i + 1), index(ring + 1, i)});
    }
  }
  return triangles;
}

/// Draws the middle of a page as high as the figure, since pens are measured by the page's height.
Result<VectorDrawing> sampleOf(const ExportOrder& order, const model::Scene& scene) {
  const float height = std::max(order.page.sizeMm.y, 2.0f * sampleMm.y);
  model::Camera camera;
  camera.projection = model::Projection::orthographic;
  camera.heightMm = height;
  const VectorSettings settings{.sizeMm = {std::max(sampleMm.x, pageLimitsMm.low), height},
                                .environment = order.environment};
  const glm::vec2 corner = 0.5f * (settings.sizeMm - sampleMm);
  VectorDrawing drawing = TRY(drawVectors(scene, camera, settings));
  return cropped(std::move(drawing), corner, sampleMm);
}

/// Adds the bean with that style, so many times as large, and then moved.
void addBean(model::Scene& scene, const model::Style& style, float size = 1.0f,
             const glm::vec3& by = glm::vec3(0.0f)) {
  std::vector<glm::vec3> positions = beanPositions();
  for (glm::vec3& position : positions)
    position = size * position + by;
  Result<model::Mesh> mesh = model::Mesh::create(std::move(positions), beanTriangles());
  if (mesh.ok())
    scene.append({.style = style, .mesh = std::make_shared<const model::Mesh>(std::move(*mesh))});
}

}  // namespace

Result<std::vector<VectorDrawing>> styleSamples(const ExportOrder& order,
                                                const std::vector<model::NodeId>& structures) {
  std::vector<VectorDrawing> samples;
  for (const model::NodeId id : structures) {
    model::Scene scene;
    scene.setKeyLight(order.scene.keyLight());
    model::Style style = model::answersOf(order.scene.resolve(id));
    style.visible = true;
    addBean(scene, style);
    VectorDrawing drawing = TRY(sampleOf(order, scene));
    samples.push_back(std::move(drawing));
  }
  return samples;
}

Result<VectorDrawing> hiddenLinesSample(const ExportOrder& order, model::HiddenLines how) {
  constexpr float outline = 1.0f;  // Γ
  constexpr float thinPen = 0.6f;
  constexpr Colour quiet{160, 160, 160};
  // The one in front is so large that the sample shows no more of it than the edge of its left end,
  // behind which most of the other one lies.
  constexpr float size = 6.0f;
  const glm::vec3 by{17.6f, -40.0f, -5.1f};
  model::Style behind{.gamma = Gamma::clamped(outline), .fill = model::Fill::none};
  behind.penWeight = thinPen;
  behind.hiddenLines = how;
  model::Style front{.gamma = Gamma::clamped(outline), .fill = model::Fill::paper};
  front.penWeight = thinPen;
  front.inkColour = quiet;
  model::Scene scene;
  addBean(scene, behind);
  addBean(scene, front, size, by);
  return sampleOf(order, scene);
}

}  // namespace sline::render
