// SPDX-License-Identifier: Apache-2.0
#include "app/cli/film_flags.h"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/cli/names.h"
#include "render/export/formats/export_formats.h"

namespace sline::cli {

namespace {

Result<std::optional<double>> parseHold(const std::string& text) {
  if (text.empty())
    return std::optional<double>();
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc() || stop != end || !(value >= 0.0 && value <= 600.0))
    return Error{.reason = "--hold " + text + " is no time of rest",
                 .remedy = "Give seconds, 0 to 600"};
  return std::optional<double>(value);
}

}  // namespace

Result<render::FilmOptions> understood(const FilmFlags& flags, const model::Scene& scene) {
  using render::Motion;
  static constexpr std::array<std::pair<std::string_view, Motion>, 3> motions{
      {{"turntable", Motion::turntable},
       {"tour", Motion::tour},
       {"gamma-sweep", Motion::gammaSweep}}};
  render::FilmOptions options;
  const auto* const motion = std::find_if(motions.begin(), motions.end(), [&](const auto& known) {
    return known.first == flags.motion;
  });
  if (motion == motions.end())
    return Error{.reason = "--motion " + flags.motion + " is unknown",
                 .remedy = "Give turntable, tour or gamma-sweep"};
  options.motion = motion->second;
  options.seconds = flags.seconds;
  for (const auto& [name, number] :
       {std::pair("--fps", flags.framesPerSecond), std::pair("--film-height", flags.height)})
    if (number != std::round(number))
      return Error{.reason = std::string(name) + " takes a whole number",
                   .remedy = "Give one, as in " + std::to_string(std::lround(number))};
  options.framesPerSecond = int(std::lround(flags.framesPerSecond));
  options.height = int(std::lround(flags.height));
  const Result<std::optional<double>> hold = parseHold(flags.hold);
  if (!hold.ok())
    return hold.error();
  options.hold = *hold;
  if (!flags.swept.empty() && options.motion != Motion::gammaSweep)
    return Error{
        .reason = "--sweep names what a gamma-sweep changes, and this film is a " + flags.motion,
        .remedy = "Add --motion gamma-sweep"};
  for (const std::string& name : flags.swept) {
    const Result<std::vector<model::NodeId>> ids = nodesNamed(scene, name);
    if (!ids.ok())
      return ids.error();
    options.swept.insert(options.swept.end(), ids->begin(), ids->end());
  }
  return options;
}

Status addFilmTarget(const FilmFlags& flags, std::map<std::string, std::string>& targets) {
  if (!flags.file)
    return Unit{};
  std::string extension = std::filesystem::path(*flags.file).extension().string();
  for (char& c : extension)
    c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  std::string known;
  for (const render::ExportFormat& format : render::exportFormats()) {
    if (!format.choices.film || !*format.extension)
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
