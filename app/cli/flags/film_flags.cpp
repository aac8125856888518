// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/film_flags.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/cli/files/names.h"
#include "app/cli/flags/option_kinds.h"
#include "app/cli/flags/values.h"
#include "model/base/letters.h"
#include "render/export/formats/export_formats.h"

namespace sline::cli {

void declareFilm(CLI::App& command, FilmFlags& flags) {
  command.add_option("--video", flags.file, "A film of the kind that its extension tells")
      ->type_name("FILE.{mp4,webp,gif}");
  many(command.add_option(
           "--sweep", flags.swept,
           "A structure or group whose Γ a gamma-sweep changes, else everything's; may be "
           "given again"))
      ->type_name("NAME");
}

Status parseSweep(const FilmFlags& flags, const model::Scene& scene, render::FilmOptions& options) {
  if (flags.swept.empty())
    return Unit{};
  if (options.motion != render::Motion::gammaSweep)
    return Error{.reason = "--sweep names what a gamma-sweep changes, and this film is another",
                 .remedy = "Add --motion gamma-sweep"};
  for (const std::string& name : flags.swept) {
    const std::vector<model::NodeId> ids = TRY(nodesNamed(scene, name));
    options.swept.insert(options.swept.end(), ids.begin(), ids.end());
  }
  return Unit{};
}

void completeFilmSize(TypedOptions& options, bool pageTyped) {
  const std::string typed = options.typed(render::filmFormatOption);
  if (typed.empty()) {
    if (pageTyped || !options.typed(render::filmHeightOption).empty())
      options.set(render::filmFormatOption, "page");
    return;
  }
  // A size that has a name of its own keeps it; a wrong one is told as any other choice is.
  const Result<Size> size = parseSize(typed);
  if (!size.ok() || render::parseOption(render::filmFormatOption, typed).ok())
    return;
  options.set(render::filmFormatOption, "typed");
  options.set(render::filmWidthOption, std::to_string(size->width));
  options.set(render::filmHeightOption, std::to_string(size->height));
}

Status addFilmTarget(const FilmFlags& flags, std::map<std::string, std::string>& targets) {
  if (!flags.file)
    return Unit{};
  const std::string extension = lowerExtension(*flags.file);
  std::string known;
  for (const render::ExportFormat& format : render::exportFormats()) {
    if (!format.has(render::motionOption) || !*format.extension)
      continue;
    known += (known.empty() ? "" : ", ") + std::string(format.extension);
    if (extension != std::string(".") + format.extension)
      continue;
    const auto [other, fresh] = targets.emplace(format.id, *flags.file);
    if (!fresh)
      return Error{.file = *flags.file,
                   .reason = "--video and --" + std::string(format.id) + " " + other->second +
                             " ask for two films of one kind",
                   .remedy = "Leave one out, or export twice"};
    return Unit{};
  }
  return Error{.file = *flags.file,
               .reason = extension.empty()
                             ? "the name has no extension, which decides the kind of film"
                             : "no film is written as \"" + extension + "\"",
               .remedy = "Give one of " + known};
}

}  // namespace sline::cli
