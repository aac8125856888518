// SPDX-License-Identifier: Apache-2.0
// Reads and writes the file of a figure, which may come from any author: nothing in it is believed
// before it is checked. resources/help/figures.md describes it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/figure/figure.h"

namespace sline::model {

/// Returns the figure; errors name the place: "panels[2].inset.part".
Result<Figure> figureFromText(std::string_view text);
Result<Figure> readFigure(const std::filesystem::path& file);

/// Returns the text that `figureFromText` reads as that figure; keys that are as usual are left
/// out.
std::string figureText(const Figure& figure);
/// Writes the figure, unless what it says could not be read again.
Status writeFigure(const Figure& figure, const std::filesystem::path& file);

/// Returns where the file of a scene lies that the figure's file names, or why it is not read: it
/// must be a scene file in the folder of the figure or below it, links followed.
Result<std::filesystem::path> scenePath(const std::filesystem::path& figureFile,
                                        const std::string& scene);

/// Returns the scene's path as the figure's file names it, or why it cannot.
Result<std::string> sceneName(const std::filesystem::path& figureFile,
                              const std::filesystem::path& scene);

}  // namespace sline::model
