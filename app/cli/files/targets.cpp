// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/targets.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "model/base/letters.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/slicer/fiducials.h"
#include "model/scene_file/scene_file.h"
#include "render/export/formats/export_formats.h"

namespace sline::cli {

namespace fs = std::filesystem;

namespace {

/// Lists endings of well-known kinds besides those of the tables of formats and of file kinds; a
/// file named so would be taken for what it is not.
constexpr std::array<std::string_view, 26> foreignEndings{
    "ai",  "avi", "bmp", "csv",  "doc", "docx", "eps", "fcsv", "htm", "html", "json", "md",   "mkv",
    "mov", "mpg", "mrb", "mrml", "odp", "odt",  "ppt", "pptx", "ps",  "svgz", "txt",  "webm", "gz"};

/// Returns the name's ending without the dot.
std::string endingOf(const fs::path& name) {
  const std::string ending = lowerExtension(name);
  return ending.empty() ? ending : ending.substr(1);
}

bool hasKindOfOurs(const std::string& ending) {
  const auto formats = render::exportFormats();
  return std::any_of(formats.begin(), formats.end(), [&](const render::ExportFormat& format) {
    return ending == format.extension || ending == format.otherExtension;
  });
}

bool isKnown(const std::string& ending) {
  const auto kinds = model::fileKinds();
  return hasKindOfOurs(ending) ||
         std::any_of(kinds.begin(), kinds.end(),
                     [&](const model::FileKind& kind) { return "." + ending == kind.extension; }) ||
         std::find(foreignEndings.begin(), foreignEndings.end(), ending) != foreignEndings.end();
}

/// Returns the name that the target should have.
std::string rightName(const Target& target) {
  fs::path name(target.name);
  name.replace_extension(target.endings.empty() ? std::string() : target.endings.front());
  return name.string();
}

Status checkEnding(const Target& target) {
  const std::string ending = endingOf(target.name);
  if (ending.empty() || (target.endings.empty() && !target.folder) ||
      std::find(target.endings.begin(), target.endings.end(), ending) != target.endings.end() ||
      !isKnown(ending))
    return Unit{};
  return Error{.file = target.name,
               .reason = "." + ending + " is the ending of another kind of file than " +
                         target.flag + " writes",
               .remedy = "Name it " + rightName(target)};
}

Status checkName(const Target& target) {
  if (target.name.empty())
    return Error{.reason = target.flag + " names no file", .remedy = "Write one after it"};
  if (target.name == "-")
    return Error{.reason = target.flag + " - is no file",
                 .remedy = "Name one; /dev/stdout is standard output, ./- a file called so"};
  std::error_code unknown;
  const fs::file_status there = fs::status(target.name, unknown);
  if (fs::exists(there) && !fs::is_regular_file(there) && !fs::is_directory(there))
    return Unit{};
  if (target.scene)
    return Unit{};
  if (model::isSceneFile(target.name))
    return Error{.file = target.name,
                 .reason = "this is a scene's name, and " + target.flag + " writes no scene",
                 .remedy = target.endings.empty() ? "Give another name"
                                                  : "Name it as in " + rightName(target)};
  return checkEnding(target);
}

bool isBelow(const fs::path& path, const fs::path& folder) {
  std::error_code unknown;
  const fs::path whole = fs::weakly_canonical(path, unknown);
  const fs::path top = fs::weakly_canonical(folder, unknown);
  return std::mismatch(top.begin(), top.end(), whole.begin(), whole.end()).first == top.end();
}

Status checkAgainst(const Target& target, const std::string& read) {
  std::error_code unknown;
  if (read.empty() || !fs::exists(target.name, unknown))
    return Unit{};
  if (fs::is_regular_file(read, unknown) && fs::equivalent(read, target.name, unknown) &&
      !(target.scene && model::isSceneFile(read)))
    return Error{.file = target.name,
                 .reason = target.flag + " would write over a file that is read, " + read,
                 .remedy = "Give another name"};
  if (fs::is_directory(read, unknown) && fs::is_regular_file(target.name, unknown) &&
      isBelow(target.name, read) &&
      (model::isSurfaceFileInFolder(target.name) || model::isFiducialFile(target.name)))
    return Error{
        .file = target.name,
        .reason = target.flag + " would write over a file of the folder that is read, " + read,
        .remedy = "Give another name, or write to another folder"};
  return Unit{};
}

/// Returns the path with its links followed, or as it is named if they cannot be, as to a pipe.
fs::path placeOf(const std::string& name) {
  std::error_code failure;
  const fs::path named = fs::absolute(name, failure).lexically_normal();
  const fs::path place = fs::weakly_canonical(named, failure);
  return failure ? named : place;
}

bool sameFile(const std::string& a, const std::string& b) {
  std::error_code unknown;
  const fs::path place = placeOf(a);
  return fs::equivalent(a, b, unknown) || (place == placeOf(b) && place != "/dev/null");
}

}  // namespace

std::vector<Target> exportTargets(const std::map<std::string, std::string>& byKind) {
  std::vector<Target> targets;
  for (const render::ExportFormat& format : render::exportFormats()) {
    const auto found = byKind.find(format.id);
    if (found == byKind.end())
      continue;
    Target target{.flag = "--" + std::string(format.id), .name = found->second, .endings = {}};
    for (const char* ending : {format.extension, format.otherExtension})
      if (*ending)
        target.endings.emplace_back(ending);
    target.folder = target.endings.empty();
    targets.push_back(std::move(target));
  }
  return targets;
}

Status checkTargets(std::span<const Target> targets, std::span<const std::string> read) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    TRY(checkName(targets[i]));
    for (const std::string& file : read)
      TRY(checkAgainst(targets[i], file));
    for (std::size_t k = 0; k < i; ++k)
      if (sameFile(targets[k].name, targets[i].name))
        return Error{.file = targets[i].name,
                     .reason = targets[k].flag + " and " + targets[i].flag + " name the same file",
                     .remedy = "Give each a name of its own"};
  }
  return Unit{};
}

}  // namespace sline::cli
