// SPDX-License-Identifier: Apache-2.0
// The flags of films that are no options of theirs: where one goes, and whose Γ a sweep changes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/motion/film_options.h"

namespace CLI {
class App;
}  // namespace CLI

namespace sline::cli {

/// As typed.
struct FilmFlags {
  std::optional<std::string> file;  ///< of a kind that its extension tells
  std::vector<std::string> swept;
};

void declareFilm(CLI::App& command, FilmFlags& flags);
/// Looks up in the scene whose Γ changes. An error is a wrong use.
Status understoodSweep(const FilmFlags& flags, const model::Scene& scene,
                       render::FilmOptions& options);
/// `--video FILE` as one of the kinds that have a flag of their own; fails where that kind has a
/// target already.
Status addFilmTarget(const FilmFlags& flags, std::map<std::string, std::string>& targets);

}  // namespace sline::cli
