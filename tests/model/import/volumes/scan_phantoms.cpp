// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/volumes/scan_phantoms.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/model/import/written_meshes.h"

namespace sline::test {

int ballAt(const glm::dvec3& p) {
  const double out = glm::distance(p, ballCentre) - ballRadius;
  return int(std::lround(std::clamp(200.0 - 100.0 * out, -900.0, 900.0)));
}

glm::dmat4 gridOf(double side, const glm::ivec3& size) {
  glm::dmat4 grid(side);
  for (int i = 0; i < 3; ++i)
    grid[3][i] = -0.5 * side * double(size[i] - 1);
  grid[3][3] = 1.0;
  return grid;
}

WrittenVolume ball() {
  const glm::ivec3 size(32, 28, 26);
  return sampled(size, gridOf(2.0, size), ballAt);
}

int bodyAt(const glm::dvec3& p) {
  const double out = std::hypot(p.x / 40.0, p.y / 30.0);
  if (std::abs(p.x) < 45.0 && p.y > 36.0 && p.y < 42.0)
    return 100;
  if (out > 1.0)
    return -1000;
  if (glm::distance(glm::dvec2(p), glm::dvec2(-15.0, 0.0)) < 10.0)
    return -850;
  if (glm::distance(glm::dvec2(p), glm::dvec2(18.0, 0.0)) < 16.0)
    return 700;
  if (glm::distance(p, glm::dvec3(1.0, 19.0, 10.0)) < 1.5)
    return 500;
  return 40;
}

WrittenVolume body() {
  const glm::ivec3 size(50, 50, 25);
  return sampled(size, gridOf(2.0, size), bodyAt);
}

std::filesystem::path written(const QTemporaryDir& folder, const char* name,
                              const QByteArray& bytes) {
  const QString path = folder.filePath(QLatin1String(name));
  writeText(path, bytes);
  return path.toStdString();
}

model::ImportOptions with(std::vector<model::Threshold> thresholds) {
  model::ImportOptions options;
  options.thresholds = std::move(thresholds);
  return options;
}

}  // namespace sline::test
