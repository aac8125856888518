// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/style_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "model/scene/style_fields.h"

namespace sline::render {

namespace {

/// Returns a bean on its side, as seen from the front: a closed surface with everything that lines
/// can show, including a hollow. Millimetres.
model::MeshPtr bean() {
  constexpr int rings = 28;
  constexpr int around = 40;
  std::vector<glm::vec3> positions;
  std::vector<model::Triangle> triangles;
  const auto at = [](float t, float a) {
    const float x = std::cos(t);
    const float thick = 1.5f * std::pow(std::max(std::sin(t), 0.0f), 0.6f);
    const float bend = 1.7f * x * x - 0.6f;
    return glm::vec3(3.2f * x, thick * std::sin(a), thick * std::cos(a) + bend);
  };
  for (int ring = 1; ring < rings; ++ring)
    for (int i = 0; i < around; ++i)
      positions.push_back(at(glm::pi<float>() * float(ring) / float(rings),
                             glm::two_pi<float>() * float(i) / float(around)));
  const auto index = [](int ring, int i) {
    return std::uint32_t((ring - 1) * around + i % around);
  };
  const auto left = std::uint32_t(positions.size());
  positions.push_back(at(0.0f, 0.0f));
  positions.push_back(at(glm::pi<float>(), 0.0f));
  for (int i = 0; i < around; ++i) {
    triangles.push_back({left, index(1, i + 1), index(1, i)});
    triangles.push_back({left + 1, index(rings - 1, i), index(rings - 1, i + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      triangles.push_back({index(ring, i), index(ring, i + 1), index(ring + 1, i)});
      triangles.push_back({index(ring, i + 1), index(ring + 1, i + 1), index(ring + 1, i)});
    }
  }
  Result<model::Mesh> mesh = model::Mesh::create(std::move(positions), std::move(triangles));
  return mesh.ok() ? std::make_shared<const model::Mesh>(std::move(*mesh)) : nullptr;
}

Path moved(Path path, const glm::vec2& by) {
  for (Curve& curve : path) {
    curve.start += by;
    for (Cubic& piece : curve.pieces) {
      piece.control1 += by;
      piece.control2 += by;
      piece.end += by;
    }
  }
  return path;
}

}  // namespace

Result<std::vector<VectorDrawing>> styleSamples(const ExportOrder& order,
                                                const std::vector<model::NodeId>& structures) {
  // Pens are measured by the page's height, so each sample is the middle of a page as high as the
  // figure.
  const model::MeshPtr mesh = bean();
  const float height = std::max(order.page.sizeMm.y, 2.0f * sampleMm.y);
  model::Camera camera;
  camera.projection = model::Projection::orthographic;
  camera.heightMm = height;
  const VectorSettings settings{.sizeMm = {std::max(sampleMm.x, pageLimitsMm.low), height},
                                .environment = order.environment};
  std::vector<VectorDrawing> samples;
  const glm::vec2 corner = 0.5f * (settings.sizeMm - sampleMm);
  for (const model::NodeId id : structures) {
    model::Scene scene;
    scene.setKeyLight(order.scene.keyLight());
    model::Node node;
    node.mesh = mesh;
    node.style = model::answersOf(order.scene.resolve(id));
    node.style.visible = true;
    scene.append(std::move(node));
    Result<VectorDrawing> drawing = drawVectors(scene, camera, settings);
    if (!drawing.ok())
      return drawing.error();
    drawing->sizeMm = sampleMm;
    for (VectorStructure& structure : drawing->structures) {
      if (structure.tones) {
        structure.tones->at -= corner;
        structure.tones->edge = moved(std::move(structure.tones->edge), -corner);
      }
      for (VectorShape& shape : structure.fills)
        shape.path = moved(std::move(shape.path), -corner);
      for (VectorLines& lines : structure.lines)
        for (VectorShape& shape : lines.shapes)
          shape.path = moved(std::move(shape.path), -corner);
    }
    samples.push_back(std::move(*drawing));
  }
  return samples;
}

}  // namespace sline::render
