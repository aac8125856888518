// SPDX-License-Identifier: Apache-2.0
#include "tests/render/lines/hatched_subject.h"

#include <glm/geometric.hpp>

#include "render/lines/ground/view_scale.h"
#include "tests/support/shapes.h"

namespace sline::test {

model::Camera orthographic(const glm::vec3& direction, float heightMm) {
  return {.projection = model::Projection::orthographic,
          .eye = 80.0f * glm::normalize(direction),
          .target = {0, 0, 0},
          .up = {0, 0.1f, 1},
          .heightMm = heightMm};
}

Subject torusSubject() {
  return Subject(test::torus(10.0f, 7.0f, 200, 100));
}

std::span<const render::HatchPoint> pointsOf(const render::Hatching& h,
                                             const render::HatchStroke& s) {
  return std::span(h.points).subspan(s.first, s.count);
}

double ink(const render::Hatching& hatching, const model::Camera& camera) {
  const render::ViewScale scale(camera);
  double sum = 0.0;
  for (const render::HatchStroke& s : hatching.strokes) {
    const auto points = pointsOf(hatching, s);
    for (std::size_t i = 1; i < points.size(); ++i)
      sum += double(glm::distance(scale.project(points[i - 1].position).at,
                                  scale.project(points[i].position).at)) *
             double(points[i - 1].halfWidth + points[i].halfWidth);
  }
  return sum;
}

}  // namespace sline::test
