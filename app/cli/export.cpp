// SPDX-License-Identifier: Apache-2.0
// Implements `sline export`: reads files and writes those that others print and edit.
#include <algorithm>
#include <filesystem>
#include <map>

#include "app/cli/commands/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/files/export_notes.h"
#include "app/cli/files/interruption.h"
#include "app/cli/files/targets.h"
#include "app/cli/flags/film_flags.h"
#include "app/cli/flags/package_flags.h"
#include "app/cli/flags/page_flags.h"
#include "app/cli/flags/picture_options.h"
#include "app/cli/flags/typed_options.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/formats/assembled.h"
#include "render/export/order/common_options.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/pixels/pixel_options.h"
#include "render/export/plate/source_credits.h"

namespace sline::cli {

namespace {

struct ExportFlags {
  InputFlags input;
  PictureFlags picture;
  PageFlags page;
  FilmFlags film;
  PackageFlags package;
  TypedOptions options;  ///< of single kinds, and the credit
  /// Holds a target for each of the formats that are wanted.
  std::map<std::string, std::string> targets;
};

Result<PictureSpec> parsePictureFlags(const ExportFlags& flags, const render::ExportPage& page) {
  if (flags.targets.empty()) {
    std::string known;
    for (const render::ExportFormat& format : render::exportFormats())
      known += (known.empty() ? "Give --" : ", --") + std::string(format.id) + " FILE";
    return Error{.reason = "nothing says what to write", .remedy = known};
  }
  PictureSpec spec = TRY(parseFlagsWithoutOutput(flags.picture));
  if (spec.hatching == render::HatchingMethod::asPrinted)
    return Error{.reason = "hatching as Sline's paper prints it is made of grey pixels, not lines",
                 .remedy = "Leave --hatching out, or draw a picture with `sline render`"};
  // The camera is fitted to the page's shape.
  spec.size = {int(std::lround(100.0f * page.sizeMm.x)), int(std::lround(100.0f * page.sizeMm.y))};
  return spec;
}

/// Holds what the flags say before a scene is read.
struct ParsedExport {
  model::ImportOptions import;
  render::ExportOrder job;  ///< its page, the options of kinds and the credit
  PictureSpec spec;
};

bool areAllViews(const render::ExportOrder& job) {
  return job.of<render::ViewsOptions>().subject == render::ViewSubject::all;
}

/// Checks options against each other.
Status checkOptions(const ExportFlags& flags, const render::ExportOrder& job) {
  const auto& sheet = job.of<render::SheetOptions>();
  if (!render::hasSheet(job) && !areAllViews(job))
    for (const render::ExportOption* option : render::paperOptions())
      if (!flags.options.typed(*option).empty())
        return Error{.reason = std::string(option->flag) + " is of sheets of paper alone",
                     .remedy = "Add --sheet with its kind, or --views all"};
  if (job.of<render::PixelOptions>().bits == 1 && !flags.picture.blackAndWhite)
    return Error{.reason = "--bits 1 leaves black and white alone",
                 .remedy = "Give --bw, too, which draws the scene for that"};
  if (!sheet.text.empty() && sheet.kind != render::SheetKind::patient)
    return Error{.reason = "--text stands on sheets for patients alone",
                 .remedy = "Add --sheet patient"};
  return Unit{};
}

Result<ParsedExport> parseExport(const ExportFlags& typed) {
  ParsedExport wish;
  ExportFlags flags = typed;
  wish.import = TRY(importOptions(flags.input));
  const render::ExportPage page = TRY(parseFlags(flags.page));
  wish.job.page = page;
  TypedOptions options = flags.options;
  completeFilmSize(options, flags.page.sizeMm != PageFlags().sizeMm || !flags.page.sizePx.empty());
  const bool oneShown = !flags.picture.view.empty() || !flags.picture.cameraFile.empty();
  if (oneShown && options.typed(render::viewsOption).empty())
    options.set(render::viewsOption, "shown");
  TRY(options.applyTo(wish.job));
  TRY(checkOptions(flags, wish.job));
  // Reduced to what files can hold.
  wish.job.credit = {render::plainLine(wish.job.credit.author),
                     render::plainLine(wish.job.credit.copyright)};
  // Without a word about labels a sheet has those of its kind.
  if (render::hasSheet(wish.job))
    flags.picture.labels.mode = render::LabelMode::off;
  const PictureSpec spec = TRY(parsePictureFlags(flags, page));
  wish.spec = spec;
  wish.spec.labels.sources = wish.job.sources;
  wish.job.environment = spec.environment;
  wish.job.pureInk = spec.blackAndWhite;
  wish.spec.blackAndWhite = false;  // colours go last, when the order of a kind is made
  spec.labels.writeTo(wish.job);
  return wish;
}

/// Checks whether the scene has what tests are to ask for.
Status checkAskedNames(const render::ExportOrder& job) {
  for (const std::string& name : render::askedNames(job))
    if (job.scene.named(name).empty())
      return Error{.reason = "--ask-only: no structure or group is called \"" + name + "\"",
                   .remedy = "See the names with `sline info`"};
  return Unit{};
}

/// Returns all that the files are made of.
Result<render::ExportOrder> exportOrderOf(const ExportFlags& flags, ParsedExport& wish,
                                          const ArrangedScene& arranged) {
  render::ExportOrder job = wish.job;
  job.scene = arranged.scene;
  job.camera = arranged.camera;
  job.viewName = wish.spec.labels.viewName;
  job.words = wish.spec.labels.words;
  TRY(parseSweep(flags.film, arranged.scene, job.of<render::FilmOptions>()));
  TRY(checkAskedNames(job));
  // Pictures beside a sheet are of its figure.
  if (render::hasSheet(job) && !areAllViews(job))
    job.page.sizeMm = render::sheetFigureMm(job);
  return job;
}

/// Returns what frames the job's scene on the page of each kind: its camera stays where the page is
/// that for which it was arranged, and is fitted again to others. What has the page of the job's
/// sheet is framed as that.
render::Framing framingOf(const render::ExportOrder& job, const PictureSpec& spec,
                          const glm::vec2& pageMm, const render::Typesetting& typesetting) {
  return [&typesetting, spec, pageMm, job](const render::ExportOrder& order) {
    const glm::vec2 page = order.page.sizeMm;
    if (page == pageMm)
      return Result(job.camera);
    PictureSpec own = spec;
    own.labels.sides = render::sidesOfPlate(
        render::sheetFigure(page == job.page.sizeMm ? job : order), typesetting);
    own.size = {int(std::lround(100.0f * page.x)), int(std::lround(100.0f * page.y))};
    return cameraFor(order.scene, own);
  };
}

/// Tells that files written beside a sheet show the sheet's figure and are as large.
void tellOfSheet(const render::ExportOrder& job,
                 const std::map<std::string, std::string>& targets) {
  if (!render::hasSheet(job) || areAllViews(job))
    return;
  const auto rounded = [](float mm) { return std::to_string(std::lround(mm)); };
  for (const auto& [kind, target] : targets)
    if (const render::ExportFormat* format = render::exportFormat(kind);
        !format->has(render::sheetOption) &&
        (format->page == render::PageUse::pixels || format->page == render::PageUse::drawing))
      tell(target + " is of the sheet's figure: " + rounded(job.page.sizeMm.x) + " by " +
           rounded(job.page.sizeMm.y) + " mm");
}

/// Warns that the choice of structures is no choice where saved views make it.
void warnOfViews(const render::ExportOrder& job, const std::map<std::string, std::string>& targets,
                 const Warn& tellWarning) {
  if (job.of<render::FilmOptions>().motion == render::Motion::tour)
    tellWarning("a tour shows what its views show: --only changes nothing in it");
  const bool views = !job.scene.views().empty() &&
                     std::any_of(targets.begin(), targets.end(), [&job](const auto& target) {
                       return render::meansAllViews(job.of<render::ViewsOptions>().subject,
                                                    *render::exportFormat(target.first));
                     });
  if (views)
    tellWarning(
        "each view shows what was saved with it: --only changes nothing in them. Add --views shown "
        "for what is shown alone");
}

Exit writeAll(render::ExportWish wish, const std::map<std::string, std::string>& targets,
              Progress& progress, const Warn& tellWarning) {
  const Interruption interruption;
  for (const render::ExportFormat& format : render::exportFormats()) {
    const auto target = targets.find(format.id);
    if (target == targets.end())
      continue;
    wish.target = target->second;
    const auto pieces = render::assembled(wish, format);
    if (!pieces.ok())
      return complain(pieces.error(), Exit::wrongUse);
    for (const render::ExportPiece& piece : *pieces) {
      render::ExportNotes notes;
      const auto show = [&](double share, std::string_view what) {
        progress.show(share, what);
        return !interruption.wanted();
      };
      const Status written = format.write(piece.order, piece.target, {show, &notes});
      progress.wipe();
      if (!written.ok())
        return complain(written.error(), Exit::failed);
      if (!render::namesSources(format))
        for (const render::ExportNote& note : render::creditNotes(piece.order))
          render::addNote(notes, note);
      for (const render::ExportNote& note : notes)
        tellWarning(piece.target.string() + ": " + textOf(note));
    }
  }
  return Exit::done;
}

/// Checks whether all targets may be written.
Status checkExportTargets(const ExportFlags& flags) {
  std::vector<std::string> read = flags.input.inputs;
  read.push_back(flags.picture.cameraFile);
  for (const render::ExportOption* option : render::exportOptions())
    if (const auto* text = std::get_if<render::TextOption>(&option->kind); text && text->fromFile)
      read.push_back(flags.options.typed(*option));
  return checkTargets(exportTargets(flags.targets), read);
}

Exit runExport(const ExportFlags& typed, const Warn& tellWarning) {
  ExportFlags flags = typed;
  if (const Status film = addFilmTarget(typed.film, flags.targets); !film.ok())
    return complain(film.error(), Exit::wrongUse);
  if (const Status package = addPackageTarget(typed.package, flags.targets); !package.ok())
    return complain(package.error(), Exit::wrongUse);
  Result<ParsedExport> wish = parseExport(flags);
  if (!wish.ok())
    return complain(wish.error(), Exit::wrongUse);
  if (const Status fine = checkExportTargets(flags); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  // One typesetting serves all that set text, the writers too.
  const auto typesetting = render::Typesetting::create();
  if (!typesetting.ok())
    return complain(typesetting.error(), Exit::failed);
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, wish->import, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  warnOfSides(imported->scene);
  const Result<ArrangedScene> arranged =
      arrangeOnPage(wish->job.page.sizeMm, imported->scene, wish->spec);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  if (arranged->scene.visibleBounds().empty())
    tellWarning("no structure is visible: the drawing is empty");
  const glm::vec2 pageMm = wish->job.page.sizeMm;
  const Result<render::ExportOrder> job = exportOrderOf(flags, *wish, *arranged);
  if (!job.ok())
    return complain(job.error(), Exit::wrongUse);
  tellOfSheet(*job, flags.targets);
  if (!flags.picture.only.empty())
    warnOfViews(*job, flags.targets, tellWarning);
  const render::ExportWish all{.order = *job,
                               .framing = framingOf(*job, wish->spec, pageMm, **typesetting),
                               .filled = false,
                               .target = {}};
  const Exit written = writeAll(all, flags.targets, progress, tellWarning);
  if (written == Exit::done && job->labels.mode == render::LabelMode::numbers)
    if (const auto shown = render::assembledPicture(all); shown.ok())
      printKey(render::reportOfPlate(*shown, **typesetting));
  return written;
}

/// Returns "png, tiff": the kinds of files that have the option.
std::string kindsWith(const render::ExportOption& option) {
  std::string kinds;
  for (const render::ExportFormat& format : render::exportFormats())
    if (format.has(option))
      kinds += (kinds.empty() ? "" : ", ") + std::string(format.id);
  return kinds;
}

/// Declares the flags that single kinds have. A sheet's figure has its size from the paper.
void declareOptions(CLI::App& command, TypedOptions& options) {
  for (const render::ExportOption* option : render::exportOptions()) {
    if (option->group != render::OptionGroup::kind || !*option->flag)
      continue;
    CLI::Option* declared = options.declare(command, *option, kindsWith(*option));
    if (option == &render::sheetOption)
      declared->excludes("--size-mm")->excludes("--size-px");
  }
}

void declareExport(CLI::App& command, ExportFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  for (const render::ExportFormat& format : render::exportFormats())
    command
        .add_option_function<std::string>(
            "--" + std::string(format.id),
            [&flags, id = std::string(format.id)](const std::string& target) {
              flags.targets[id] = target;
            },
            format.help)
        ->type_name(*format.extension ? "FILE" : "FOLDER");
  declarePage(command, flags.page);
  declareOptions(command, flags.options);
  CLI::Option* view = command
                          .add_option("--view,--from", flags.picture.view,
                                      "A saved view of the scene, shown as it was saved; else "
                                      "anterior, posterior, left, right, superior or inferior, "
                                      "fitted to what is visible; anterior if not given, or where "
                                      "--look auto sees most")
                          ->type_name("NAME");
  addCameraOption(command, flags.picture, view);
  addDetailOptions(command, flags.picture);
  addLookOption(command, flags.picture);
  addAppearanceOptions(command, flags.picture);
  flags.picture.labels.marks = "on";
  flags.picture.labels.mode = render::LabelMode::on;
  declareLabels(command, flags.picture.labels);
  addSectionOptions(command, flags.picture.sections);
  declareFilm(command, flags.film);
  declarePackage(command, flags.package);
  for (const render::ExportOption* option : render::creditOptions())
    flags.options.declare(command, *option);
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("auto");
  command.add_option("--assembly", flags.input.assembly, assemblyHelp)->type_name("ID");
  addFrame(command, flags.input);
  addTogether(command, flags.input);
  addThreshold(command, flags.input);
  command.footer(
      "Lines are as wide as in a picture of the same shape: a contour is 1/360 of the page's\n"
      "height, whatever its pixels. Vectors hold names of groups and structures; where the scene\n"
      "came from and when it was drawn is in no file, and who drew it only with --author. Several\n"
      "kinds can be written at once.\n\n"
      "  sline export pelvis.sline --png pelvis.png --size-mm 180x120 --dpi 300\n"
      "  sline export pelvis.sline --tiff figure1.tiff --bw --bits 1 --dpi 600\n"
      "  sline export pelvis.sline --pptx lesson.pptx --self-test\n"
      "  sline export pelvis.sline --page pelvis.html --language de\n"
      "  sline export pelvis.sline --pdf lesson.pdf --anki lesson.apkg --views all\n"
      "  sline export pelvis.sline --package moodle -o pelvis.xml --language de\n"
      "  sline export pelvis.sline --svg pelvis.svg --view anterior --size-mm 180x120\n"
      "  sline export abdomen/ --svg abdomen.svg --gamma 3 --background transparent");
}

}  // namespace

void addExport(CLI::App& program, Exit& exit, const Warn& tellWarning) {
  addCommand<ExportFlags>(
      program, exit, {"export", "Write pictures for print and vector drawings of what files hold"},
      declareExport,
      [tellWarning](const ExportFlags& flags) { return runExport(flags, tellWarning); });
}

}  // namespace sline::cli
