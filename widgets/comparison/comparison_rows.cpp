// SPDX-License-Identifier: Apache-2.0
#include "widgets/comparison/comparison_rows.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "model/scene/visible_structures.h"

namespace sline::widgets {

ComparisonRows::ComparisonRows(const std::vector<Model>& models, const model::Camera& camera) {
  for (const Model& model : models) {
    const model::Camera fitted = model::fittedToVisible(model.scene, camera, 1.0f);
    const render::ComparedModel compared{
        .name = model.name, .note = {}, .scene = model.scene, .camera = fitted};
    const float size = fitted.projection == model::Projection::perspective
                           ? glm::distance(fitted.eye, fitted.target)
                           : fitted.heightMm;
    m_rows.push_back({.model = compared,
                      .shown = compared,
                      .pivot = model.scene.visibleBounds().centre(),
                      .ends = model::zoomEnds(model.scene.visibleBounds()),
                      .target = fitted.target,
                      .size = std::max(size, 1e-6f)});
  }
}

void ComparisonRows::roughen(const std::optional<render::Noise>& noise) {
  m_rough = noise.has_value();
  for (Row& row : m_rows) {
    const model::Camera camera = row.shown.camera;
    row.shown = noise ? render::roughened(row.model, *noise) : row.model;
    row.shown.camera = camera;
  }
}

void ComparisonRows::turn(std::size_t row, const model::Camera& camera) {
  const Row& from = m_rows[row];
  for (Row& to : m_rows) {
    const float larger = to.size / from.size;
    to.shown.camera = camera;
    to.shown.camera.eye = to.target + larger * (camera.eye - from.target);
    to.shown.camera.target = to.target + larger * (camera.target - from.target);
    to.shown.camera.heightMm *= larger;
  }
  m_rows[row].shown.camera = camera;
}

std::vector<render::ComparedModel> ComparisonRows::sheet() const {
  std::vector<render::ComparedModel> all;
  for (const Row& row : m_rows) {
    all.push_back(row.model);
    all.back().camera = row.shown.camera;
    if (m_rough)
      all.push_back(row.shown);
  }
  return all;
}

}  // namespace sline::widgets
