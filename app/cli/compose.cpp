// SPDX-License-Identifier: Apache-2.0
// Implements `sline compose`: makes a figure of several panels from its file.
#include <filesystem>
#include <memory>

#include "app/cli/commands/command.h"
#include "app/cli/files/export_notes.h"
#include "app/cli/files/interruption.h"
#include "app/cli/files/targets.h"
#include "app/cli/flags/option_kinds.h"
#include "app/cli/flags/typed_options.h"
#include "model/edit/settled_units.h"
#include "model/figure/figure_file.h"
#include "model/figure/figure_keys.h"
#include "model/look/opening_look.h"
#include "render/export/figure/figure_checks.h"
#include "render/export/figure/figure_options.h"
#include "render/lettering/typesetting.h"

namespace sline::cli {

namespace {

struct ComposeFlags {
  std::string figure;
  std::vector<std::string> outputs;
  TypedOptions options;
};

Status checkComposeTargets(const ComposeFlags& flags, const std::vector<std::string>& scenes) {
  std::vector<std::string> read = scenes;
  read.push_back(flags.figure);
  std::vector<Target> targets;
  for (const std::string& output : flags.outputs) {
    TRY(render::checkPageName(output, "a figure"));
    targets.push_back({.flag = "--output", .name = output, .endings = {}});
  }
  return checkTargets(targets, read);
}

struct ReadScenes {
  render::FigureScenes scenes;
  std::vector<std::string> files;
};

/// Reads each scene that a panel shows, once.
Result<ReadScenes> readScenes(const model::Figure& figure, const std::string& file) {
  ReadScenes read;
  for (const model::FigurePanel& panel : figure.panels) {
    const std::string& name = model::sceneOf(figure, panel);
    if (panel.inset || name.empty() || read.scenes.contains(name))
      continue;
    const std::filesystem::path path = TRY(model::scenePath(file, name));
    model::SceneDocument document = TRY(openedScene(path.string()));
    if (model::hasDoubtedUnits(document.scene))
      warn(
          file + ": " + name +
          ": nobody has said how long the unit of its files is; lengths stand with a \"?\", and so "
          "do scale bars that hold for it, too");
    read.scenes.emplace(name, std::make_shared<const model::Scene>(model::dressed(document.scene)));
    read.files.push_back(path.string());
  }
  return read;
}

Exit writeFigures(const render::ComposedFigure& figure, const ComposeFlags& flags,
                  const render::ExportOrder& options, const render::ExportProgress& tell,
                  Progress& progress) {
  for (const std::string& output : flags.outputs) {
    const Status written = render::writeFigure(figure, options, output, tell);
    progress.wipe();
    if (!written.ok())
      return complain(written.error(), Exit::failed);
  }
  return Exit::done;
}

/// Says what the panels lack, and what cannot be printed; returns whether all can.
bool tellFaults(const render::ComposedFigure& figure, const std::string& file) {
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    for (const render::ExportNote& note : figure.panels[i].plate.notes)
      warn(file + ": " + model::panelName(figure.plan.figure, i) + ": " + factOf(note));
  const std::vector<Error> faults = render::printFaults(figure);
  for (Error fault : faults) {
    fault.file = file;
    complain(fault, Exit::failed);
  }
  return faults.empty();
}

Exit compose(const ComposeFlags& flags, const render::FigurePlan& plan,
             const render::ExportOrder& options) {
  const Interruption interruption;
  Progress progress;
  const render::ExportProgress tell([&](double share, std::string_view what) {
    progress.show(share, std::string(what));
    return !interruption.wanted();
  });
  const Result<render::ComposedFigure> figure = render::composeFigure(plan, tell);
  progress.wipe();
  if (!figure.ok())
    return complain(figure.error(), Exit::failed);
  return tellFaults(*figure, flags.figure) ? writeFigures(*figure, flags, options, tell, progress)
                                           : Exit::failed;
}

Exit runCompose(const ComposeFlags& flags) {
  render::ExportOrder options = render::usualFigureOrder();
  if (const Status fine = flags.options.applyTo(options); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  if (const Status fine = checkComposeTargets(flags, {}); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  const Result<model::Figure> figure = model::readFigure(flags.figure);
  if (!figure.ok())
    return complain(figure.error(), Exit::failed);
  if (const Status fine = render::checkFigureOptions(options, figure->blackAndWhite); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  const Result<ReadScenes> read = readScenes(*figure, flags.figure);
  if (!read.ok())
    return complain(read.error(), Exit::failed);
  if (const Status fine = checkComposeTargets(flags, read->files); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  const auto typesetting = render::Typesetting::create();
  if (!typesetting.ok())
    return complain(typesetting.error(), Exit::failed);
  Result<render::FigurePlan> plan = render::planFigure(*figure, read->scenes, options);
  if (!plan.ok()) {
    Error error = plan.error();
    error.file = flags.figure;
    return complain(error, Exit::failed);
  }
  return compose(flags, *plan, options);
}

/// Returns the keys of a figure's file, as help lists them.
std::string keysText() {
  std::string text;
  std::string_view object;
  for (const model::FigureKeyNote& note : model::figureKeyNotes()) {
    if (object != note.object)
      text += (object.empty() ? "Keys of a " : "\n\nOf a ") + std::string(note.object) + ":";
    object = note.object;
    text += "\n  " + std::string(note.id) + ": " + note.value + "\n      " + note.help;
  }
  return text;
}

void declareCompose(CLI::App& command, ComposeFlags& flags) {
  command
      .add_option("FIGURE", flags.figure,
                  "The figure's file (json): its panels, from views of scenes beside it")
      ->required();
  many(command.add_option("-o,--output", flags.outputs,
                          "The figure: svg and pdf with lines as lines and text as text, or png or "
                          "tiff; may be given again"))
      ->required()
      ->type_name("FILE");
  for (const render::ExportOption* option : render::figureOptions())
    flags.options.declare(command, *option, {}, render::usualFigureOrder());
  command.footer(
      "A figure shows saved views of one or several scenes as panels a, b, c ... on one page.\n"
      "Nothing is written where letters or lines are smaller than the figure allows.\n\n"
      "  {\"sline_figure\": 1, \"width\": \"double\", \"scene\": \"pelvis.sline\", \"legend\": "
      "\"all\",\n"
      "   \"panels\": [{\"view\": \"anterior\"}, {\"view\": \"left\"},\n"
      "              {\"view\": \"Pelvic floor\", \"camera\": {\"like\": \"a\"}},\n"
      "              {\"inset\": {\"of\": \"a\", \"part\": [30, 35, 20, 15], \"lines\": "
      "true}}]}\n\n"
      "  sline compose figure1.json -o figure1.pdf -o figure1.tiff --dpi 600\n\n" +
      keysText());
}

}  // namespace

void addCompose(CLI::App& program, Exit& exit) {
  addCommand<ComposeFlags>(program, exit,
                           {"compose", "Make a figure of several panels on one page"},
                           declareCompose, runCompose);
}

}  // namespace sline::cli
