// SPDX-License-Identifier: Apache-2.0
// Implements `sline describe`: says in words what a picture shows.
#include <algorithm>

#include "app/cli/commands/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/flags/page_flags.h"
#include "app/cli/flags/picture_options.h"
#include "render/export/description/alt_text.h"
#include "render/lettering/typesetting.h"

namespace sline::cli {

namespace {

struct DescribeFlags {
  InputFlags input;
  PictureFlags picture;
  std::size_t words = render::usualWords;
  bool seen = false;
};

Exit runDescribe(const DescribeFlags& flags) {
  const Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  Result<PictureSpec> spec = parseFlagsWithoutOutput(flags.picture);
  if (!spec.ok())
    return complain(spec.error(), Exit::wrongUse);
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  warnOfSides(imported->scene);
  render::ExportOrder order;
  const glm::vec2 page = order.page.sizeMm;
  spec->size = {int(std::lround(100.0f * page.x)), int(std::lround(100.0f * page.y))};
  const Result<ArrangedScene> arranged = arrangeOnPage(page, imported->scene, *spec);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  spec->labels.writeTo(order);
  order.scene = arranged->scene;
  order.camera = arranged->camera;
  order.viewName = spec->labels.viewName;
  order.words = spec->labels.words;
  progress.wipe();
  const bool own = !flags.seen && flags.words == render::usualWords;
  std::cout << onOneLine(own ? render::altTextOf(order).text
                             : render::describedPicture(order, flags.words))
            << '\n';
  return Exit::done;
}

void declareDescribe(CLI::App& command, DescribeFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  addTogether(command, flags.input);
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  CLI::Option* view = command
                          .add_option("--view", flags.picture.view,
                                      "A saved view of the scene, shown as it was saved; else "
                                      "anterior, posterior, left, right, superior or inferior, "
                                      "fitted to what is visible")
                          ->type_name("NAME");
  addCameraOption(command, flags.picture, view);
  addDetailOptions(command, flags.picture);
  addLookOption(command, flags.picture);
  flags.picture.labels.mode = render::LabelMode::on;
  declareLabels(command, flags.picture.labels);
  addSectionOptions(command, flags.picture.sections);
  command.add_option("--words", flags.words, "The most words that it may have")
      ->type_name("N")
      ->check(CLI::Range(10, 2000))
      ->capture_default_str();
  command.add_flag("--seen", flags.seen,
                   "Says what is seen, even where the view has words of its own "
                   "(`sline view --alt`)");
  command.footer(
      "It is what exports say of the picture for who does not see it: in the structure of a PDF,\n"
      "in SVG, slides and cards, and in the details of pictures. In English, German, Dutch,\n"
      "Norwegian and Latin. With --labels off, numbers or blank it names nothing.\n\n"
      "  sline describe pelvis.sline --view \"From the front\" --language de");
}

}  // namespace

void addDescribe(CLI::App& program, Exit& exit) {
  addCommand<DescribeFlags>(
      program, exit, {"describe", "Say in words what a picture shows, for who does not see it"},
      declareDescribe, runDescribe);
}

}  // namespace sline::cli
