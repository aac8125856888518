// SPDX-License-Identifier: Apache-2.0
// Declares the flags of films that are no export options: the file that a film goes to, and the
// structures that have their Γ changed by a sweep.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/flags/typed_options.h"
#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/motion/film_options.h"

namespace CLI {
class App;
}  // namespace CLI

namespace sline::cli {

/// Holds the flags as typed.
struct FilmFlags {
  std::optional<std::string> file;  ///< its extension tells its kind
  std::vector<std::string> swept;
};

void declareFilm(CLI::App& command, FilmFlags& flags);
/// Looks up the structures of a Γ sweep in the scene. An error counts as wrong use.
Status parseSweep(const FilmFlags& flags, const model::Scene& scene, render::FilmOptions& options);
/// Takes `--film-size 640x360` apart. Without the flag, `--film-height` and a page whose size was
/// typed ask for the page's shape.
void completeFilmSize(TypedOptions& options, bool pageTyped);
/// Adds `--video FILE` as one of the kinds that have a flag of their own; fails if that kind has a
/// target already.
Status addFilmTarget(const FilmFlags& flags, std::map<std::string, std::string>& targets);

}  // namespace sline::cli
