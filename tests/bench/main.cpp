// SPDX-License-Identifier: Apache-2.0
// Runs sline-bench, which turns the camera once around a scene and reports where the time and the
// memory went. Figures of one run are compared with each other (frame against plain Phong), never
// with a clock: machines are shared and noisy.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <glm/vec2.hpp>
#include <iostream>
#include <map>

#include "model/edit/look.h"
#include "model/focus/form.h"
#include "model/import/plan/import.h"
#include "model/look/opening_look.h"
#include "render/gpu/headless/context.h"
#include "render/picture/picture.h"
#include "tests/bench/gamma_drag.h"
#include "tests/bench/known_lines.h"
#include "tests/bench/large_tree.h"
#include "tests/bench/leaders.h"
#include "tests/bench/line_growth.h"
#include "tests/bench/measure.h"
#include "tests/bench/meshing.h"
#include "tests/bench/occlusion.h"
#include "tests/bench/opening.h"
#include "tests/bench/performance_page.h"
#include "tests/bench/plates.h"
#include "tests/bench/report.h"
#include "tests/bench/stage.h"
#include "tests/bench/techniques.h"
#include "tests/bench/turning.h"
#include "tests/bench/yardsticks.h"
#include "tests/support/process_memory.h"

using namespace sline;

namespace {
struct Options {
  std::vector<std::filesystem::path> inputs;
  int frames = 60;
  std::string size = "1280x720";
  int moving = 1;
  std::optional<float> gamma;
  int drags = 0;
  float meshingMm = 0.0f;
  int structures = 0;
  int turning = 0;
  int lineGrowth = -1;
  bool knownLines = false;
  bool curves = false;
  bool opening = false;
  bool asOpened = false;
  bool occlusion = false;
  std::vector<std::string> scales;
  std::string technique;
  bench::LeaderCourse leaders;
  bench::PlateCourse plates;
  bool json = false;
  std::filesystem::path page;
  std::vector<std::string> subdivided;  ///< how often, and the file
};

std::optional<glm::ivec2> parsedSize(const std::string& text) {
  glm::ivec2 size(0);
  char end = 0;
  if (std::sscanf(text.c_str(), "%5dx%5d%c", &size.x, &size.y, &end) != 2)
    return std::nullopt;
  if (size.x < 16 || size.y < 16 || size.x > 20000 || size.y > 20000)
    return std::nullopt;
  return size;
}

int fail(const Error& error) {
  std::cerr << "sline-bench: " << error.text() << '\n';
  return 1;
}

Status measureFrames(render::Picture& picture, const bench::Stage& stage, bench::Report& report) {
  std::vector<double> lines;
  std::map<std::string, std::vector<double>> passes;
  std::vector<std::string> order;
  const auto frame = bench::timed(stage.frames, stage.camera, [&](const model::Camera& camera) {
    const Status status = picture.draw(stage.scene, camera, stage.settings);
    lines.push_back(picture.timings().lines);
    for (const auto& pass : picture.timings().passes) {
      if (!passes.contains(pass.name))
        order.push_back(pass.name);
      passes[pass.name].push_back(pass.milliseconds);
    }
    return status;
  });
  if (!frame)
    return frame.error();
  report.frame = bench::spreadOf(*frame);
  report.lines = bench::spreadOf(lines);
  for (const std::string& name : order)
    report.passes.emplace_back(name, bench::spreadOf(passes[name]));
  return Unit{};
}

/// Turns as a window does while the camera moves.
Status measureMoving(render::Picture& picture, const bench::Stage& stage, bench::Report& report) {
  render::PictureSettings settings = stage.settings;
  settings.surfaceStep = 3;
  const auto frame = bench::timed(stage.frames, stage.camera, [&](const model::Camera& camera) {
    return picture.draw(stage.scene, camera, settings);
  });
  if (!frame)
    return frame.error();
  report.moving = bench::spreadOf(*frame);
  return Unit{};
}

/// Imports and counts; the camera stands before the whole scene.
Result<bench::Stage> importStage(const Options& options, const glm::ivec2& size,
                                 bench::Report& report) {
  const bench::Stopwatch watch;
  const auto imported = model::importInputs(options.inputs, {});
  if (!imported)
    return imported.error();
  report.importMs = watch.milliseconds();
  bench::Stage stage{.scene = bench::withGamma(imported->scene, options.gamma),
                     .settings = {.width = size.x, .height = size.y, .surfaceStep = options.moving},
                     .frames = options.frames};
  for (const model::NodeId id : stage.scene.structuresBelow(model::rootId)) {
    ++report.structures;
    report.triangles += stage.scene.find(id)->mesh->triangleCount();
  }
  const float aspect = float(size.x) / float(size.y);
  stage.camera =
      model::anatomicalCamera(model::AnatomicalView::anterior, stage.scene.visibleBounds(), aspect);
  model::FormIndex forms;
  if (options.asOpened)
    if (const auto look = model::openingLook(imported->scene, forms, {.aspect = aspect})) {
      stage.scene = look->scene;
      stage.camera = model::framedCamera(*look, aspect);
    }
  return stage;
}

/// Prints the time that drags of Γ take.
Status runDrags(const Options& options, const glm::ivec2& size) {
  bench::Report report;
  auto context = render::gpu::HeadlessContext::create();
  if (!context)
    return context.error();
  auto picture = render::Picture::create();
  if (!picture)
    return picture.error();
  const auto stage = importStage(options, size, report);
  if (!stage)
    return stage.error();
  const auto dragged = bench::dragGamma(**picture, {.scene = stage->scene,
                                                    .camera = stage->camera,
                                                    .settings = stage->settings,
                                                    .structures = options.drags});
  if (!dragged)
    return dragged.error();
  std::cout << report.structures << " structures, " << report.triangles << " triangles, "
            << (*context)->driver() << '\n'
            << bench::asText(*dragged);
  return Unit{};
}

/// Imports surfaces as their files have them.
auto importAsFiled(const Options& options) {
  model::ImportOptions unsmoothed;
  unsmoothed.smoothing.mode = model::Smoothing::Mode::off;
  return model::importInputs(options.inputs, unsmoothed);
}

/// Prints what our own algorithms make of each surface, as its file has it, and what OpenMesh makes
/// of it.
Status runMeshing(const Options& options) {
  const auto imported = importAsFiled(options);
  if (!imported)
    return imported.error();
  std::vector<bench::MeshingRow> rows;
  for (const model::NodeId id : imported->scene.structuresBelow(model::rootId)) {
    const model::Node& node = *imported->scene.find(id);
    if (node.mesh->triangleCount() > 0)
      rows.push_back(bench::measureMeshing(node.name, node.mesh, options.meshingMm));
  }
  std::cout << bench::asText(rows);
  return Unit{};
}

/// Prints how steady lines are while the camera turns, or how true curves are: of the look that a
/// scene opens with, or with one Γ for all and paper as their fill. Outlines are dashed where they
/// are hidden.
Status runLines(const Options& options, const glm::ivec2& size) {
  bench::Report report;
  Options chosen = options;
  chosen.asOpened = !options.gamma;
  auto stage = importStage(chosen, size, report);
  if (!stage)
    return stage.error();
  const std::vector<model::NodeId> ids = stage->scene.structuresBelow(model::rootId);
  if (options.gamma) {
    const model::Style paper{.fill = model::Fill::paper};
    stage->scene = model::withLook(stage->scene, ids, paper).scene;
  }
  const model::Style dashes{.hiddenLines = model::HiddenLines::dashed};
  stage->scene = model::withLook(stage->scene, ids, dashes).scene;
  const bench::TurningRun run{.scene = stage->scene,
                              .camera = stage->camera,
                              .width = size.x,
                              .height = size.y,
                              .steps = options.turning};
  if (options.turning > 0)
    std::cout << bench::measureTurning(run);
  if (options.curves)
    std::cout << bench::measureCurves(run);
  std::vector<model::NodeId> named;
  for (const std::string& name : options.scales)
    for (const model::NodeId id : stage->scene.named(name))
      named.push_back(id);
  if (!named.empty())
    std::cout << bench::measureScales(run, named);
  return Unit{};
}

/// Prints how long the import takes and the look that the scene opens with.
Status runOpening(const Options& options) {
  const bench::Stopwatch watch;
  const auto imported = model::importInputs(options.inputs, {});
  if (!imported)
    return imported.error();
  std::cout << imported->scene.structuresBelow(model::rootId).size() << " structures, import "
            << watch.milliseconds() << " ms\n"
            << bench::measureOpening(imported->scene);
  return Unit{};
}

/// Prints what the lines of a technique cost, turning once around the scene.
Status runTechnique(const Options& options, const glm::ivec2& size) {
  bench::Report report;
  const auto stage = importStage(options, size, report);
  if (!stage)
    return stage.error();
  const auto names = model::namesOf(model::Technique());
  const auto named = std::find(names.begin(), names.end(), options.technique);
  bench::TechniqueRun run{.scene = stage->scene,
                          .technique = model::Technique(named - names.begin()),
                          .cameras = {},
                          .aspect = float(size.x) / float(size.y)};
  for (int i = 0; i < stage->frames; ++i)
    run.cameras.push_back(bench::turned(stage->camera, float(i) / float(stage->frames)));
  std::cout << bench::measureTechnique(run);
  if (options.turning > 0)
    std::cout << bench::measureTurning({.scene = bench::drawnBy(stage->scene, run.technique),
                                        .camera = stage->camera,
                                        .width = size.x,
                                        .height = size.y,
                                        .steps = options.turning});
  return Unit{};
}

/// Prints what contours and suggestive contours cost as surfaces grow.
Status runLineGrowth(const Options& options, const glm::ivec2& size) {
  bench::Report report;
  const auto stage = importStage(options, size, report);
  if (!stage)
    return stage.error();
  std::vector<model::Camera> cameras;
  for (int i = 0; i < stage->frames; ++i)
    cameras.push_back(bench::turned(stage->camera, float(i) / float(stage->frames)));
  return bench::measureLineGrowth({stage->scene, cameras, options.lineGrowth, size}, std::cout);
}

/// Prints how long the ambient occlusion of each surface takes, as its file has it.
Status runOcclusion(const Options& options) {
  const auto imported = importAsFiled(options);
  if (!imported)
    return imported.error();
  std::cout << bench::measureOcclusion(imported->scene);
  return Unit{};
}

/// Prints which leaders do not end on what they name, or all that is wrong with what is written.
Status runPlates(const Options& options) {
  auto context = render::gpu::HeadlessContext::create();
  if (!context)
    return context.error();
  auto picture = render::Picture::create();
  if (!picture)
    return picture.error();
  const auto imported = model::importInputs(options.inputs, {});
  if (!imported)
    return imported.error();
  if (options.plates.products > 0)
    return bench::countPlates(**picture, imported->scene, options.plates, std::cout);
  const auto faults = bench::judgeScene(**picture, imported->scene, options.leaders, std::cout);
  return faults ? Status(Unit{}) : faults.error();
}

Result<bench::Report> run(const Options& options, const glm::ivec2& size) {
  bench::Report report;
  auto context = render::gpu::HeadlessContext::create();
  if (!context)
    return context.error();
  auto picture = render::Picture::create();
  if (!picture)
    return picture.error();
  report.driver = (*context)->driver();
  test::resetPeak();
  report.baseRssMiB = test::residentMiB();
  const auto stage = importStage(options, size, report);
  if (!stage)
    return stage.error();
  const bench::Stopwatch prepareWatch;
  (*picture)->prepare(stage->scene, stage->camera, stage->settings);
  report.preprocessMs = prepareWatch.milliseconds();
  if (const Status status = measureFrames(**picture, *stage, report); !status)
    return status.error();
  if (const Status status = measureMoving(**picture, *stage, report); !status)
    return status.error();
  // Read here, since the yardsticks upload and hold what no picture needs.
  report.restRssMiB = test::residentMiB();
  report.peakRssMiB = test::peakResidentMiB();
  if (const Status status = bench::measurePhong(*stage, report); !status)
    return status.error();
  if (const Status status = bench::measureVectors(*stage, report); !status)
    return status.error();
  if (const Status status = bench::measureDrag(**picture, *stage, report); !status)
    return status.error();
  if (const Status status = bench::measureReopening(*stage, report); !status)
    return status.error();
  const Status vtk = bench::measureVtk(*stage, report);
  (*context)->makeCurrent();
  if (!vtk)
    return vtk.error();
  return report;
}

/// Writes the surfaces of the inputs as one, subdivided so often.
Status runSubdivision(const Options& options) {
  const auto imported = importAsFiled(options);
  if (!imported)
    return imported.error();
  return bench::writeSubdivided(imported->scene, std::stoi(options.subdivided[0]),
                                options.subdivided[1]);
}

/// Does what was asked for instead of a turn, if anything was.
std::optional<Status> runInstead(const Options& options, const glm::ivec2& size) {
  if (!options.page.empty())
    return bench::writePerformancePage(options.page, options.inputs);
  if (!options.subdivided.empty())
    return runSubdivision(options);
  if (options.drags > 0)
    return runDrags(options, size);
  if (!options.leaders.foci.empty() || options.plates.products > 0)
    return runPlates(options);
  if (options.lineGrowth >= 0)
    return runLineGrowth(options, size);
  if (!options.technique.empty())
    return runTechnique(options, size);
  if (options.turning > 0 || options.curves || !options.scales.empty())
    return runLines(options, size);
  if (options.meshingMm > 0.0f)
    return runMeshing(options);
  if (options.opening)
    return runOpening(options);
  if (options.occlusion)
    return runOcclusion(options);
  return std::nullopt;
}

void addLeaderOptions(CLI::App& app, bench::LeaderCourse& course) {
  app.add_option("--leaders", course.foci,
                 "Instead of turning: judge by pictures whether leaders end on what they name, "
                 "with these in focus (NAME,NAME; may be given again)")
      ->allow_extra_args(false);
  app.add_option("--labels", course.labels, "Labels in a picture, at most");
  app.add_flag("--self-test", course.selfTest,
               "Judge the numbers of a self-test sheet, which labels what one sees by itself");
  app.add_option("--every", course.every, "Looks at every so many of the pictures");
  app.add_option("--height", course.height, "Of the pictures that are judged");
  app.add_option("--keep", course.folder, "Where pictures with faults go");
}

void addPlateOptions(CLI::App& app, bench::PlateCourse& course) {
  app.add_option(
         "--plates", course.products,
         "Instead: make so many pictures, sheets, figures, slides and stills with "
         "everything written in them, and count what is wrong with it, in colour and in ink")
      ->check(CLI::Range(1, 1000));
  app.add_option("--judge-every", course.judged,
                 "Of every so many plates: whether leaders end on what they name")
      ->check(CLI::Range(1, 1000));
  app.add_flag("--near-plates", course.near,
               "Of plates: those alone that anatomy may fill, as their camera is near");
  app.add_flag("--unruled", course.unruled,
               "Of plates: what the rules for ink and for the foot are good for, too");
  app.add_option("--keep-plates", course.folder, "Where plates with faults go");
}

void addOptions(CLI::App& app, Options& options) {
  app.add_option("INPUT", options.inputs, "Meshes, folders, 3D Slicer scenes");
  app.add_option("--frames", options.frames, "Pictures of one full turn")
      ->check(CLI::Range(1, 10000));
  app.add_option("--size", options.size, "Width x height in pixels")->capture_default_str();
  app.add_option("--gamma", options.gamma, "Γ of every structure; without it 0 … 5 by name")
      ->check(CLI::Range(0.0f, 5.0f));
  app.add_option("--drag-gamma", options.drags,
                 "Instead of turning: drag Γ of so many structures, the largest and some others")
      ->check(CLI::Range(1, 10000));
  app.add_option("--meshing", options.meshingMm,
                 "Instead of turning: simplify each surface to so many mm, find its neighbours and "
                 "subdivide it, here and by OpenMesh's own algorithms")
      ->check(CLI::Range(0.001f, 1000.0f));
  app.add_option("--structures", options.structures,
                 "Without INPUT: ask a tree of so many structures for their styles and bounds")
      ->check(CLI::Range(1, 1'000'000));
  app.add_flag("--known-lines", options.knownLines,
               "Without INPUT: recall and precision of each technique on a surface of which all "
               "lines are known");
  app.add_option("--moving", options.moving,
                 "Draw as while the camera moves: lines as ever, surfaces with one pixel for so "
                 "many of the picture, each way")
      ->check(CLI::Range(2, 4));
  app.add_option("--steady-lines", options.turning,
                 "Instead: turn by so many steps of half a degree and say what lines pop")
      ->check(CLI::Range(1, 720));
  app.add_option("--line-growth", options.lineGrowth,
                 "Instead: what contours and suggestive contours cost, of the surfaces as they are "
                 "and after each of so many subdivisions, beside VTK's silhouettes and Phong")
      ->check(CLI::Range(0, 4));
  app.add_flag("--true-curves", options.curves,
               "Instead: say how far curves lie from the lines that they stand for");
  app.add_flag("--opening", options.opening,
               "Instead of turning: choose the look that the scene opens with");
  app.add_flag("--as-opened", options.asOpened,
               "Turn the scene with the look and from the side that it opens with");
  app.add_flag("--occlusion", options.occlusion,
               "Instead of turning: find how much of its own sky each surface hides");
  app.add_option("--scales", options.scales,
                 "Instead: the suggestive strokes of these structures without and with the "
                 "picture's scale");
  const auto names = model::namesOf(model::Technique());
  app.add_option(
         "--technique", options.technique,
         "Instead: what the lines of this technique cost, per surface and in each view; with "
         "--steady-lines also how steady they are")
      ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
  addLeaderOptions(app, options.leaders);
  addPlateOptions(app, options.plates);
  app.add_flag("--json", options.json, "Print JSON");
  app.add_option("--subdivided", options.subdivided,
                 "Instead: write the surface, subdivided N times, as a PLY file")
      ->type_name("N FILE")
      ->expected(2);
  app.add_option("--page", options.page,
                 "Instead: make the guide's page about speed of the INPUTs, which --json printed");
}
}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Turns the camera around a scene and reports time and memory"};
  addOptions(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (options.structures > 0) {
    std::cout << bench::measureTree(options.structures);
    return 0;
  }
  if (options.knownLines) {
    std::cout << bench::measureKnownLines();
    return 0;
  }
  if (options.inputs.empty()) {
    std::cerr << "sline-bench: INPUT is missing\n";
    return 2;
  }
  const auto size = parsedSize(options.size);
  if (!size) {
    std::cerr << "sline-bench: --size wants WxH, each from 16 to 20000, not " << options.size
              << '\n';
    return 2;
  }
  if (const auto status = runInstead(options, *size))
    return *status ? 0 : fail(status->error());
  const auto report = run(options, *size);
  if (!report)
    return fail(report.error());
  std::cout << (options.json ? asJson(*report) : asText(*report));
  return 0;
}
