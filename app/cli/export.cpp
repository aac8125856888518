// SPDX-License-Identifier: Apache-2.0
// `sline export`: files in, what others print and edit out.
#include <charconv>
#include <map>

#include "app/cli/anki_options.h"
#include "app/cli/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/export_notes.h"
#include "app/cli/film_options.h"
#include "app/cli/interruption.h"
#include "app/cli/picture_options.h"
#include "app/cli/pixel_options.h"
#include "app/cli/sheet_options.h"
#include "app/cli/targets.h"
#include "render/export/formats/export_formats.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_order.h"
#include "render/export/xml_text.h"
#include "render/vectors/vector_drawing.h"

namespace sline::cli {

namespace {

struct ExportFlags {
  InputFlags input;
  PictureFlags picture;
  PixelFlags pixels;
  FilmFlags film;
  render::AnkiOptions anki;
  std::string sizeMm = "160x90";
  SheetFlags sheet;
  render::ExportCredit credit;
  /// A target for each of the formats that are wanted.
  std::map<std::string, std::string> targets;
};

/// "160x90", each side within what a page may have.
Result<glm::vec2> parsePage(std::string_view text) {
  const auto side = [](std::string_view part) -> std::optional<float> {
    float value = 0.0f;
    const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (fault != std::errc() || end != part.data() + part.size() ||
        !render::pageLimitsMm.contain(value))
      return std::nullopt;
    return value;
  };
  const std::size_t cross = text.find('x');
  if (cross != std::string_view::npos) {
    const std::optional<float> width = side(text.substr(0, cross));
    const std::optional<float> height = side(text.substr(cross + 1));
    if (width && height)
      return glm::vec2(*width, *height);
  }
  return Error{.reason = "\"" + std::string(text) + "\" is no size of a page",
               .remedy = "Write width and height in millimetres, 10 to 5000 each, as in 160x90"};
}

Result<render::ExportPage> understoodPage(const ExportFlags& flags) {
  const Result<std::optional<render::ExportPage>> pixels = pageOf(flags.pixels);
  if (!pixels.ok())
    return pixels.error();
  if (*pixels)
    return **pixels;
  const Result<glm::vec2> size = parsePage(flags.sizeMm);
  if (!size.ok())
    return size.error();
  return render::ExportPage{.sizeMm = *size, .dpi = float(flags.pixels.dpi)};
}

Result<PictureOrder> understoodExport(const ExportFlags& flags, const render::ExportPage& page) {
  if (flags.targets.empty()) {
    std::string known;
    for (const render::ExportFormat& format : render::exportFormats())
      known += (known.empty() ? "Give --" : ", --") + std::string(format.id) + " FILE";
    return Error{.reason = "nothing says what to write", .remedy = known};
  }
  Result<PictureOrder> order = understoodLook(flags.picture);
  if (!order.ok())
    return order;
  if (order->hatching == render::HatchingMethod::asPrinted)
    return Error{.reason = "hatching as Sline's paper prints it is made of grey pixels, not lines",
                 .remedy = "Leave --hatching out, or draw a picture with `sline render`"};
  // The camera is fitted to the page's shape.
  order->size = {int(std::lround(100.0f * page.sizeMm.x)),
                 int(std::lround(100.0f * page.sizeMm.y))};
  return order;
}

render::ExportOrder exportOrder(const ArrangedScene& arranged, const PictureOrder& order,
                                const render::ExportPage& page) {
  render::ExportOrder job;
  job.scene = arranged.scene;
  job.camera = arranged.camera;
  job.viewName = order.labels.viewName;
  job.page = page;
  job.look = {order.background, order.light, order.keyLight};
  job.labels = order.labels.style;
  job.marks = order.labels.marks;
  return job;
}

/// The order with the figure as large as its sheet lets it, and the camera fitted to that.
Result<render::ExportOrder> onSheet(render::ExportOrder job, PictureOrder& order,
                                    const render::Typesetting& typesetting) {
  job.page.sizeMm = render::sheetFigureMm(job);
  const render::ExportOrder figure = render::sheetFigure(job);
  order.labels.sides = render::sidesOfPlate(figure, typesetting);
  order.size = {int(std::lround(100.0f * job.page.sizeMm.x)),
                int(std::lround(100.0f * job.page.sizeMm.y))};
  const Result<model::Camera> camera = cameraFor(job.scene, order);
  if (!camera.ok())
    return camera.error();
  job.camera = *camera;
  return job;
}

/// As files can hold it.
Result<render::ExportCredit> understoodCredit(const render::ExportCredit& typed) {
  constexpr std::size_t longest = 500;
  for (const auto& [name, text] :
       {std::pair("--author", typed.author), std::pair("--copyright", typed.copyright)})
    if (text.size() > longest)
      return Error{.reason = std::string(name) + " is too long",
                   .remedy = "Write at most " + std::to_string(longest) + " bytes"};
  return render::ExportCredit{render::plainLine(typed.author), render::plainLine(typed.copyright)};
}

/// What the flags say before a scene is read.
struct Wanted {
  model::ImportOptions import;
  render::ExportPage page;
  render::ExportPixels pixels;
  render::ExportSheet sheet;
  render::ExportCredit credit;
  PictureOrder order;
};

Result<Wanted> wanted(const ExportFlags& flags) {
  const Result<model::ImportOptions> import = importOptions(flags.input);
  if (!import.ok())
    return import.error();
  const Result<render::ExportPage> page = understoodPage(flags);
  if (!page.ok())
    return page.error();
  const Result<render::ExportPixels> pixels = understood(flags.pixels, flags.picture.blackAndWhite);
  if (!pixels.ok())
    return pixels.error();
  const Result<render::ExportSheet> sheet = understood(flags.sheet);
  if (!sheet.ok())
    return sheet.error();
  const Result<render::ExportCredit> credit = understoodCredit(flags.credit);
  if (!credit.ok())
    return credit.error();
  const Result<PictureOrder> order = understoodExport(flags, *page);
  if (!order.ok())
    return order.error();
  return Wanted{*import, *page, *pixels, *sheet, *credit, *order};
}

/// All that the files are made of.
Result<render::ExportOrder> understoodJob(const ExportFlags& flags, Wanted& wish,
                                          const ArrangedScene& arranged,
                                          const render::Typesetting& typesetting) {
  const Result<render::FilmOptions> film = understood(flags.film, arranged.scene);
  if (!film.ok())
    return film.error();
  render::ExportOrder job = exportOrder(arranged, wish.order, wish.page);
  job.pixels = wish.pixels;
  job.film = *film;
  job.anki = flags.anki;
  job.sheet = wish.sheet;
  job.credit = wish.credit;
  if (wish.sheet.kind == render::SheetKind::none)
    return job;
  return onSheet(job, wish.order, typesetting);
}

/// What is written beside a sheet shows the sheet's figure, and is as large.
void tellOfSheet(const render::ExportOrder& job,
                 const std::map<std::string, std::string>& targets) {
  if (job.sheet.kind == render::SheetKind::none)
    return;
  const auto rounded = [](float mm) { return std::to_string(std::lround(mm)); };
  for (const auto& [kind, target] : targets)
    if (const render::ExportFormat* format = render::exportFormat(kind);
        !format->choices.sheet && format->page != render::PageUse::none)
      tell(target + " is of the sheet's figure: " + rounded(job.page.sizeMm.x) + " by " +
           rounded(job.page.sizeMm.y) + " mm");
}

Exit writeAll(const render::ExportOrder& job, const std::map<std::string, std::string>& targets,
              Progress& progress, const Warn& tellWarning) {
  const Interruption interruption;
  for (const render::ExportFormat& format : render::exportFormats()) {
    const auto target = targets.find(format.id);
    if (target == targets.end())
      continue;
    render::ExportNotes notes;
    const auto show = [&](double share, std::string_view what) {
      progress.show(share, what);
      return !interruption.wanted();
    };
    const Status written = format.write(job, target->second, {show, &notes});
    progress.wipe();
    if (!written.ok())
      return complain(written.error(), Exit::failed);
    for (const render::ExportNote& note : notes)
      tellWarning(target->second + ": " + textOf(note));
  }
  return Exit::done;
}

/// Whether all targets may be written.
Status checkExportTargets(const ExportFlags& flags) {
  std::vector<std::string> read = flags.input.inputs;
  read.push_back(flags.picture.cameraFile);
  read.push_back(flags.sheet.text);
  return checkTargets(exportTargets(flags.targets), read);
}

Exit runExport(const ExportFlags& typed, const Warn& tellWarning) {
  ExportFlags flags = typed;
  if (const Status film = addFilmTarget(typed.film, flags.targets); !film.ok())
    return complain(film.error(), Exit::wrongUse);
  Result<Wanted> wish = wanted(flags);
  if (!wish.ok())
    return complain(wish.error(), Exit::wrongUse);
  if (const Status fine = checkExportTargets(flags); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  if (flags.film.motion == "tour" && !flags.picture.only.empty())
    tellWarning("a tour shows what its views show: --only changes nothing in it");
  // One for all that set text, the writers too.
  const auto typesetting = render::Typesetting::create();
  if (!typesetting.ok())
    return complain(typesetting.error(), Exit::failed);
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, wish->import, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  const Result<ArrangedScene> arranged =
      arrangedOn(wish->page.sizeMm, imported->scene, wish->order);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  if (arranged->scene.visibleBounds().empty())
    tellWarning("no structure is visible: the drawing is empty");
  const Result<render::ExportOrder> job = understoodJob(flags, *wish, *arranged, **typesetting);
  if (!job.ok())
    return complain(job.error(), Exit::wrongUse);
  tellOfSheet(*job, flags.targets);
  const Exit written = writeAll(*job, flags.targets, progress, tellWarning);
  if (written == Exit::done && job->labels.mode == render::LabelMode::numbers)
    printKey(render::reportOfPlate(*job, **typesetting));
  return written;
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
  command.add_option("--size-mm", flags.sizeMm, "Width and height of the page in millimetres")
      ->type_name("WxH")
      ->capture_default_str();
  addPixelOptions(command, flags.pixels);
  addSheetOptions(command, flags.sheet);
  CLI::Option* view = command
                          .add_option("--view,--from", flags.picture.view,
                                      "A saved view of the scene, shown as it was saved; else "
                                      "anterior, posterior, left, right, superior or inferior, "
                                      "fitted to what is visible")
                          ->type_name("NAME")
                          ->capture_default_str();
  addCameraOption(command, flags.picture, view);
  addDetailOptions(command, flags.picture);
  addLookOptions(command, flags.picture);
  flags.picture.labels.marks = "on";
  addLabelOptions(command, flags.picture.labels, "the page");
  addSectionOptions(command, flags.picture.sections);
  addFilmOptions(command, flags.film);
  addAnkiOptions(command, flags.anki);
  command
      .add_option("--author", flags.credit.author,
                  "Who made it, written into the file where its kind has a place for that; nothing "
                  "is unless you say it here")
      ->type_name("NAME");
  command
      .add_option("--copyright", flags.credit.copyright,
                  "Whose it is or what others may do with it, as in \"CC BY 4.0\"; likewise")
      ->type_name("TEXT");
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("auto");
  command.add_option("--assembly", flags.input.assembly, assemblyHelp)->type_name("ID");
  command.add_option("--frame", flags.input.frame, frameHelp)->type_name("LPS|RAS|file");
  addThreshold(command, flags.input);
  command.footer(
      "Lines are as wide as in a picture of the same shape: a contour is 1/360 of the page's\n"
      "height, whatever its pixels. Vectors hold names of groups and structures; where the scene\n"
      "came from and when it was drawn is in no file, and who drew it only with --author. Several\n"
      "kinds can be written at once.\n\n"
      "  sline export pelvis.sline --png pelvis.png --size-mm 180x120 --dpi 300\n"
      "  sline export pelvis.sline --tiff figure1.tiff --bw --bits 1 --dpi 600\n"
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
