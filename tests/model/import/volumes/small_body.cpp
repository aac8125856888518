// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/volumes/small_body.h"

#include <array>

#include "tests/model/import/written_meshes.h"

namespace sline::test {

int labelledBodyAt(const glm::dvec3& p) {
  const auto box = [&](const glm::dvec3& low, const glm::dvec3& high) {
    return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y &&
           p.z < high.z;
  };
  if (box({4.0, -6.0, -5.0}, {11.0, 1.0, 3.0}))
    return 1;  // left
  if (box({-9.0, -12.0, 2.0}, {-3.0, -4.0, 7.0}))
    return 2;  // right, in front, towards the head
  if (box({-5.0, 3.0, -13.0}, {1.0, 10.0, -8.0}))
    return 5;  // behind, towards the feet
  return 0;
}

const WrittenVolume& smallBody() {
  static const WrittenVolume body = [] {
    glm::dmat4 grid(2.0);
    grid[3] = glm::dvec4(-15.0, -15.0, -15.0, 1.0);
    return sampled(glm::ivec3(15), grid, labelledBodyAt);
  }();
  return body;
}

Result<model::Imported> importBytes(const QTemporaryDir& folder, const QString& name,
                                    const QByteArray& bytes, model::Smoothing::Mode mode) {
  const QString path = folder.filePath(name);
  writeText(path, bytes);
  model::ImportOptions options;
  options.smoothing.mode = mode;
  options.keepFileNames = true;
  return model::importInputs(std::array{std::filesystem::path(path.toStdString())}, options);
}

}  // namespace sline::test
