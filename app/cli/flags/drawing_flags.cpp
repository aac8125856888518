// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/drawing_flags.h"

#include <algorithm>

#include "app/cli/flags/values.h"

namespace sline::cli {

std::string drawingNames(const std::string& between) {
  std::string names;
  for (const model::DrawingStyle& style : model::drawingStyles())
    names += (names.empty() ? "" : between) + std::string(style.id);
  return names;
}

std::string drawingHelp() {
  std::string help =
      "Draws all in one manner, on the background that it is made for; flags of single looks are "
      "applied afterwards.";
  for (const model::DrawingStyle& style : model::drawingStyles())
    help += " " + std::string(style.id) + ": " + std::string(style.description);
  return help;
}

Status parseDrawing(const PictureFlags& flags, PictureSpec& spec) {
  std::string background = flags.background.empty() ? "white" : flags.background;
  if (!flags.drawing.empty()) {
    spec.drawing = model::drawingStyleNamed(flags.drawing);
    if (!spec.drawing)
      return Error{.reason = "--drawing " + flags.drawing + " is unknown",
                   .remedy = "There are: " + drawingNames(", ")};
    if (flags.background.empty() && !flags.blackAndWhite)
      background = spec.drawing->background;
  }
  spec.environment.background = TRY(parseBackground(background));
  return Unit{};
}

Result<model::Scene> inDrawingStyle(const model::Scene& scene, const PictureSpec& spec) {
  if (!spec.drawing)
    return scene;
  const model::Scene cut = TRY(cutOpen(scene, spec));
  const model::Camera camera = TRY(cameraFor(cut, spec));
  model::FormIndex forms;
  const model::Scene drawn =
      model::withDrawingStyle(cut, *spec.drawing, forms, {.camera = camera}).scene;
  model::Scene after = scene;
  after.setNodes(drawn.nodes());
  std::vector<model::Section> own = scene.sections();
  for (model::Section& section : own)
    section.hatched = section.hatched || spec.drawing->hatchedSections;
  after.setSections(std::move(own));
  return after;
}

}  // namespace sline::cli
