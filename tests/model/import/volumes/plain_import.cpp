// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/volumes/plain_import.h"

namespace sline::test {

Result<model::Imported> importOf(const std::vector<std::filesystem::path>& inputs,
                                 std::optional<model::Frame> frame) {
  model::ImportOptions options;
  options.smoothing.mode = model::Smoothing::Mode::off;
  options.frame = frame;
  options.keepFileNames = true;
  return model::importInputs(inputs, options);
}

std::filesystem::path inFolder(const QTemporaryDir& folder, const char* name) {
  return folder.filePath(name).toStdString();
}

}  // namespace sline::test
