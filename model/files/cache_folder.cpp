// SPDX-License-Identifier: Apache-2.0
#include "model/files/cache_folder.h"

#include <cstdlib>

namespace sline::model {

namespace {
/// An absolute folder named by the environment; empty where there is none.
std::filesystem::path folderNamedBy(const char* variable) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets it
  const std::filesystem::path folder = value ? value : "";
  return folder.is_absolute() ? folder : std::filesystem::path();
}
}  // namespace

std::filesystem::path userCacheFolder() {
  if (const auto cache = folderNamedBy("XDG_CACHE_HOME"); !cache.empty())
    return cache / "sline";
  if (const auto home = folderNamedBy("HOME"); !home.empty())
    return home / ".cache" / "sline";
  return {};
}

}  // namespace sline::model
