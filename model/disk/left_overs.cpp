// SPDX-License-Identifier: Apache-2.0
#include "model/disk/left_overs.h"

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "model/disk/process.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view partEnding = ".part";

std::string beginningFor(const fs::path& named) {
  return "." + named.filename().string() + ".";
}

/// Tells whether the name is that of a part, and its writer no longer runs.
bool isLeft(std::string_view name, std::string_view beginning) {
  if (!name.starts_with(beginning) || !name.ends_with(partEnding) ||
      name.size() < beginning.size() + partEnding.size())
    return false;
  name.remove_prefix(beginning.size());
  name.remove_suffix(partEnding.size());
  int process = 0;
  const char* end = name.data() + name.size();
  const auto [rest, fault] = std::from_chars(name.data(), end, process);
  const bool numbered =
      rest != end && *rest == '-' &&
      std::string_view(rest, end).find_first_not_of("-0123456789") == std::string_view::npos;
  return fault == std::errc() && (rest == end || numbered) && !isRunning(process);
}

}  // namespace

fs::path partBeside(const fs::path& named, int number) {
  return named.parent_path() /
         (beginningFor(named) + std::to_string(processNumber()) +
          (number == 0 ? "" : "-" + std::to_string(number)) + std::string(partEnding));
}

void removeLeftOvers(const fs::path& named) {
  const std::string beginning = beginningFor(named);
  const fs::path folder = named.parent_path();
  std::vector<fs::path> left;
  std::error_code fault;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, fault), end;
       !fault && entry != end; entry.increment(fault))
    if (isLeft(entry->path().filename().string(), beginning))
      left.push_back(entry->path());
  for (const fs::path& path : left)
    fs::remove_all(path, fault);
}

}  // namespace sline::model
