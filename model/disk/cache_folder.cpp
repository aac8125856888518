// SPDX-License-Identifier: Apache-2.0
#include "model/disk/cache_folder.h"

#include <cstdlib>

namespace sline::model {

namespace {
/// Returns an absolute folder named by the environment, or an empty path where there is none.
std::filesystem::path folderNamedBy(const char* variable) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets it
  const std::filesystem::path folder = value ? value : "";
  return folder.is_absolute() ? folder : std::filesystem::path();
}

std::filesystem::path userFolder(const char* variable, const std::filesystem::path& inHome) {
  if (const auto folder = folderNamedBy(variable); !folder.empty())
    return folder / "sline";
  if (const auto home = folderNamedBy("HOME"); !home.empty())
    return home / inHome / "sline";
  return {};
}
}  // namespace

std::filesystem::path userCacheFolder() {
  return userFolder("XDG_CACHE_HOME", ".cache");
}

std::filesystem::path userStateFolder() {
  return userFolder("XDG_STATE_HOME", std::filesystem::path(".local") / "state");
}

}  // namespace sline::model
