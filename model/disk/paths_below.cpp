// SPDX-License-Identifier: Apache-2.0
#include "model/disk/paths_below.h"

#include <algorithm>
#include <system_error>

namespace sline::model {

bool staysBelow(const std::filesystem::path& path) {
  if (path.is_absolute() || path.has_root_name() || path.empty())
    return false;
  int depth = 0;
  for (const std::filesystem::path& part : path) {
    depth += part == ".." ? -1 : part == "." || part.empty() ? 0 : 1;
    if (depth < 0)
      return false;
  }
  return depth > 0;
}

std::filesystem::path realPath(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  constexpr int mostLinks = 40;  // as Linux follows
  std::error_code failure;
  fs::path place = fs::absolute(path.empty() ? fs::path(".") : path, failure);
  for (int i = 0; i < mostLinks; ++i) {
    place = fs::weakly_canonical(place, failure);
    if (failure || !fs::is_symlink(fs::symlink_status(place, failure)))
      break;
    place = place.parent_path() / fs::read_symlink(place, failure);
  }
  place = place.lexically_normal();
  return place.has_filename() ? place : place.parent_path();
}

bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const std::filesystem::path whole = realPath(path);
  const std::filesystem::path top = realPath(folder);
  const auto [end, next] = std::mismatch(top.begin(), top.end(), whole.begin(), whole.end());
  return end == top.end() && next != whole.end();
}

}  // namespace sline::model
