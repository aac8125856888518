// SPDX-License-Identifier: Apache-2.0
// `sline export`: files in, what others print and edit out.
#include <array>
#include <charconv>

#include "app/cli/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/picture_options.h"
#include "app/cli/text_file.h"
#include "render/export/svg/svg_document.h"
#include "render/vectors/vector_drawing.h"

namespace sline::cli {

namespace {

/// What is exported, and to which page.
struct ExportJob {
  const model::Scene& scene;
  const model::Camera& camera;
  const PictureOrder& order;
  glm::vec2 sizeMm;
  std::string target;
};

Status writeSvg(const ExportJob& job, Progress& progress) {
  const Result<render::VectorDrawing> drawing = render::drawVectors(
      job.scene, job.camera,
      {.sizeMm = job.sizeMm,
       .background = job.order.background,
       .light = job.order.light,
       .keyLight = job.order.keyLight},
      [&progress](double share, std::string_view what) { progress.show(0.9 * share, what); });
  if (!drawing.ok())
    return drawing.error();
  progress.show(0.9, "writing " + job.target);
  return writeText(job.target, render::svgDocument(*drawing, job.scene));
}

/// A kind of file, by the flag that names one.
struct ExportFormat {
  const char* flag;
  const char* help;
  Status (*write)(const ExportJob& job, Progress& progress);
};
constexpr std::array formats{
    ExportFormat{"--svg",
                 "Vectors for Inkscape, Illustrator and print: lines and hatching as smooth paths, "
                 "hidden ones removed, a named group for each structure",
                 writeSvg},
};

struct ExportFlags {
  InputFlags input;
  PictureFlags picture;
  std::string sizeMm = "160x90";
  std::array<std::string, formats.size()> targets;
};

/// "160x90", each side within what a page may have.
Result<glm::vec2> parsePage(std::string_view text) {
  const auto side = [](std::string_view part) -> std::optional<float> {
    float value = 0.0f;
    const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (fault != std::errc() || end != part.data() + part.size() ||
        !(value >= render::smallestPageMm && value <= render::largestPageMm))
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

Result<PictureOrder> understoodExport(const ExportFlags& flags, glm::vec2& page) {
  if (std::all_of(flags.targets.begin(), flags.targets.end(),
                  [](const std::string& target) { return target.empty(); }))
    return Error{.reason = "nothing says what to write", .remedy = "Give --svg FILE"};
  const Result<glm::vec2> size = parsePage(flags.sizeMm);
  if (!size.ok())
    return size.error();
  page = *size;
  Result<PictureOrder> order = understoodLook(flags.picture);
  if (!order.ok())
    return order;
  if (order->hatching == render::HatchingMethod::asPrinted)
    return Error{.reason = "hatching as Sline's paper prints it is made of grey pixels, not lines",
                 .remedy = "Leave --hatching out, or draw a picture with `sline render`"};
  // The camera is fitted to the page's shape.
  order->size = {int(std::lround(100.0f * page.x)), int(std::lround(100.0f * page.y))};
  return order;
}

Exit runExport(const ExportFlags& flags) {
  const Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  glm::vec2 page(0.0f);
  const Result<PictureOrder> order = understoodExport(flags, page);
  if (!order.ok())
    return complain(order.error(), Exit::wrongUse);

  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input.inputs, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  const Result<ArrangedScene> arranged = arrangedFor(imported->scene, *order);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  if (arranged->scene.visibleBounds().empty())
    warn("no structure is visible: the drawing is empty");
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (flags.targets[i].empty())
      continue;
    const Status written = formats[i].write(
        {arranged->scene, arranged->camera, *order, page, flags.targets[i]}, progress);
    if (!written.ok()) {
      progress.wipe();
      return complain(written.error(), Exit::failed);
    }
  }
  return Exit::done;
}

void declareExport(CLI::App& command, ExportFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  for (std::size_t i = 0; i < formats.size(); ++i)
    command.add_option(formats[i].flag, flags.targets[i], formats[i].help)->type_name("FILE");
  command.add_option("--size-mm", flags.sizeMm, "Width and height of the page in millimetres")
      ->type_name("WxH")
      ->capture_default_str();
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
  addSectionOptions(command, flags.picture.sections);
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("auto");
  command.add_option("--frame", flags.input.frame, frameHelp)->type_name("LPS|RAS|file");
  command.footer(
      "Lines are as wide as in a picture of the same shape: a contour is 1/360 of the page's\n"
      "height. Names of groups and structures are written into the file, nothing else is.\n\n"
      "  sline export pelvis.sline --svg pelvis.svg --view anterior --size-mm 180x120\n"
      "  sline export abdomen/ --svg abdomen.svg --gamma 3 --background transparent");
}

}  // namespace

void addExport(CLI::App& program, Exit& exit) {
  addCommand<ExportFlags>(program, exit,
                          {"export", "Write vector drawings of meshes, folders and scenes"},
                          declareExport, runExport);
}

}  // namespace sline::cli
