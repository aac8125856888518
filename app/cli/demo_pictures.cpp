// SPDX-License-Identifier: Apache-2.0
// Implements `sline demo-pictures FOLDER MODELS`, which `--help` does not list: draws, when the
// program is built, the pictures of the demos and of drawing styles that the start page shows
// (widgets/start/demo_pictures.h, drawing_choice.h).
#include <filesystem>
#include <string>

#include "app/cli/commands/command.h"
#include "app/cli/flags/values.h"
#include "model/demo/demo.h"
#include "model/disk/whole_file.h"
#include "model/look/drawing_styles.h"
#include "model/scene/resolved_styles.h"
#include "render/export/encoding/few_colours.h"
#include "render/picture/card_picture.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::cli {

namespace {

struct DemoPictureFlags {
  std::string folder;
  std::string models;
};

constexpr int mostColours = 192;

Status writePicture(const render::HeadlessPicture& picture, const model::Scene& scene,
                    const render::CardPicture& card, const std::filesystem::path& file) {
  const render::Image image = TRY(picture->render(scene, card.camera, card.settings, card.samples));
  return model::writeText(file, render::pngOfFewColours(image, mostColours));
}

/// Returns the scene with lines and strokes for a picture that is shown a few fingers wide.
model::Scene withBroadLines(const model::Scene& scene) {
  constexpr float broader = 1.8f;
  constexpr float fewer = 0.35f;
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  std::vector<model::Node> nodes = scene.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].style.penWeight = broader * styles[i].penWeight;
    nodes[i].style.hatchDensity = HatchDensity::clamped(fewer * styles[i].hatchDensity.value());
  }
  model::Scene broad = scene;
  broad.setNodes(std::move(nodes));
  return broad;
}

/// Draws one demo in each style.
Status writeDrawings(const render::HeadlessPicture& picture, const model::Scene& scene,
                     const std::filesystem::path& folder) {
  model::FormIndex forms;
  for (const model::DrawingStyle& style : model::drawingStyles()) {
    render::CardPicture card = render::cardPicture(scene);
    card.settings.environment.background = TRY(parseBackground(std::string(style.background)));
    const model::Scene drawn =
        model::withDrawingStyle(scene, style, forms, {.camera = card.camera}).scene;
    TRY(writePicture(picture, withBroadLines(drawn), card,
                     folder / ("drawing-" + std::string(style.id) + ".png")));
  }
  return Unit{};
}

Exit writePictures(const DemoPictureFlags& flags) {
  const auto picture = render::HeadlessPicture::create();
  if (!picture.ok())
    return complain(picture.error(), Exit::failed);
  const std::filesystem::path folder = flags.folder;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    return complain({.file = flags.folder, .reason = failed.message()}, Exit::failed);
  for (std::size_t i = 0; i < model::demoNames.size(); ++i)
    for (const model::Sex sex : {model::Sex::female, model::Sex::male}) {
      const auto name = model::DemoName(i);
      const std::filesystem::path file = folder / (model::demoKey(name, sex) + ".png");
      if (std::filesystem::exists(file))  // the same for both
        continue;
      const model::Scene scene = model::demo(name, sex, flags.models);
      if (const Status written = writePicture(*picture, scene, render::cardPicture(scene), file);
          !written.ok())
        return complain(written.error(), Exit::failed);
    }
  const model::Scene scene =
      model::demo(model::DemoName::abdomen, model::Sex::female, flags.models);
  if (const Status written = writeDrawings(*picture, scene, folder); !written.ok())
    return complain(written.error(), Exit::failed);
  return Exit::done;
}

}  // namespace

void addDemoPictures(CLI::App& program, Exit& exit) {
  addCommand<DemoPictureFlags>(
      program, exit, {"demo-pictures", "Draw the start page's pictures of the demos"},
      [](CLI::App& command, DemoPictureFlags& flags) {
        command.group("");
        command.add_option("FOLDER", flags.folder, "Where those that are missing are written")
            ->required();
        command.add_option("MODELS", flags.models, "Where the modelled scenes are kept")
            ->required();
      },
      writePictures);
}

}  // namespace sline::cli
