// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/file_in_folder.h"

#include <algorithm>

namespace sline::model {

std::optional<std::filesystem::path> fileInFolder(const std::filesystem::path& file,
                                                  std::string_view name) {
  if (name.empty() || name.find_first_of(":\\") != std::string_view::npos ||
      name.find('\0') != std::string_view::npos)
    return std::nullopt;
  const std::filesystem::path relative(name);
  if (relative.is_absolute() || relative.has_root_path())
    return std::nullopt;
  for (const std::filesystem::path& part : relative)
    if (part == "..")
      return std::nullopt;
  std::error_code code;
  const std::filesystem::path folder = std::filesystem::weakly_canonical(file, code).parent_path();
  const std::filesystem::path target = std::filesystem::weakly_canonical(folder / relative, code);
  if (code || folder.empty())
    return std::nullopt;
  const auto [end, unused] =
      std::mismatch(folder.begin(), folder.end(), target.begin(), target.end());
  return end == folder.end() ? std::optional(target) : std::nullopt;
}

}  // namespace sline::model
