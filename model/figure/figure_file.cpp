// SPDX-License-Identifier: Apache-2.0
#include "model/figure/figure_file.h"

#include <system_error>

#include "model/disk/paths_below.h"
#include "model/disk/whole_file.h"
#include "model/figure/figure_layout.h"
#include "model/figure/figure_rows.h"
#include "model/scene_file/scene_file.h"

namespace sline::model {

namespace {

constexpr JsonLimits figureLimits{
    .bytes = std::size_t(1) << 20, .values = 20'000, .keysOfObject = 200, .depth = 8};

constexpr const char* remedy = "Change it in the figure's file";

}  // namespace

Result<Figure> figureFromText(std::string_view text) {
  const Result<Json> json = parseJson(text, figureLimits);
  if (!json.ok()) {
    Error error = json.error();
    error.remedy = "Write the figure as JSON; the guide has an example";
    return error;
  }
  JsonFault fault;
  const JsonValue whole(*json, fault);
  Figure figure;
  readByRows(whole, figureRows(), figure);
  if (whole.json().is_object() && !fault.any())
    for (const char* key : {"sline_figure", "panels"})
      if (!whole.json().contains(key))
        whole.fail("\"" + std::string(key) + "\" is missing");
  if (fault.any())
    return Error{.where = fault.where, .reason = fault.reason, .remedy = remedy};
  TRY(checkFigure(figure));
  return figure;
}

Result<Figure> readFigure(const std::filesystem::path& file) {
  const std::string text = TRY(readText(file, figureLimits.bytes));
  Result<Figure> figure = figureFromText(text);
  if (figure.ok())
    return figure;
  Error error = figure.error();
  error.file = file.string();
  return error;
}

std::string figureText(const Figure& figure) {
  return writtenByRows(figureRows(), figure)
             .dump(2, ' ', false, FigureJson::error_handler_t::replace) +
         "\n";
}

Status writeFigure(const Figure& figure, const std::filesystem::path& file) {
  const std::string text = figureText(figure);
  if (const Result<Figure> again = figureFromText(text); !again.ok())
    return Error{.file = file.string(),
                 .where = again.error().where,
                 .reason = again.error().reason,
                 .remedy = again.error().remedy};
  return writeText(file, text);
}

Result<std::filesystem::path> scenePath(const std::filesystem::path& figureFile,
                                        const std::string& scene) {
  const std::filesystem::path folder = figureFile.parent_path();
  const std::filesystem::path named(scene);
  Error error{.file = figureFile.string(), .where = "scene \"" + scene + "\""};
  if (!isSceneFile(named)) {
    error.reason = "it is no scene file";
    error.remedy = "Save it as a scene file, and name it with its ending .sline";
    return error;
  }
  if (!staysBelow(named) || !liesBelow(folder / named, folder.empty() ? "." : folder)) {
    error.reason = "it does not lie in the figure's folder or below it";
    error.remedy = "Put the figure's file beside its scenes";
    return error;
  }
  return folder / named;
}

Result<std::string> sceneName(const std::filesystem::path& figureFile,
                              const std::filesystem::path& scene) {
  if (scene.empty())
    return Error{.reason = "the scene has never been saved",
                 .remedy = "Save it first, so that the figure's file can name it"};
  const std::filesystem::path folder =
      figureFile.has_parent_path() ? figureFile.parent_path() : std::filesystem::path(".");
  const std::filesystem::path named = realPath(scene).lexically_relative(realPath(folder));
  const Result<std::filesystem::path> path = scenePath(figureFile, named.string());
  return path.ok() ? Result<std::string>(named.generic_string()) : path.error();
}

}  // namespace sline::model
