// SPDX-License-Identifier: Apache-2.0
// The flags of films.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/order/export_order.h"

namespace sline::cli {

/// As typed.
struct FilmFlags {
  std::optional<std::string> file;  ///< of a kind that its extension tells
  std::string motion = "turntable";
  double seconds = 8.0;
  double framesPerSecond = 25.0;
  double height = 720.0;
  std::string hold;
  std::vector<std::string> swept;
};

/// Whose Γ changes is looked up in the scene. An error is a wrong use.
Result<render::FilmOptions> understood(const FilmFlags& flags, const model::Scene& scene);
/// `--video FILE` as one of the kinds that have a flag of their own; fails where that kind has a
/// target already.
Status addFilmTarget(const FilmFlags& flags, std::map<std::string, std::string>& targets);

}  // namespace sline::cli
