// SPDX-License-Identifier: Apache-2.0
#include "render/picture/picture.h"

#include <algorithm>
#include <optional>

#include "model/base/parallel.h"
#include "model/scene/visible_structures.h"
#include "render/drawn/coinciding.h"
#include "render/drawn/face_patterns.h"
#include "render/drawn/gamma_offsets.h"
#include "render/picture/layer_painter.h"
#include "render/picture/picture_output.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

namespace {

/// What a picture shows, and from where.
struct Sitting {
  const model::Scene& scene;
  const PictureSettings& settings;
  std::vector<model::VisibleStructure> structures;
  PictureView view;

  Sitting(const model::Scene& drawn, const model::Camera& camera, const PictureSettings& asked)
      : scene(drawn),
        settings(asked),
        structures(model::visibleStructures(drawn)),
        view(camera, boundsOf(structures), asked.width, asked.height) {}

 private:
  static model::Box boundsOf(std::span<const model::VisibleStructure> structures) {
    model::Box bounds;
    for (const model::VisibleStructure& structure : structures)
      bounds.add(structure.node->mesh->bounds());
    return bounds;
  }
};

Status checkRequest(const model::Camera& camera, const PictureSettings& settings) {
  if (settings.width < 1 || settings.height < 1 || settings.width > 65535 ||
      settings.height > 65535)
    return Error{.reason = "a picture of " + std::to_string(settings.width) + "×" +
                           std::to_string(settings.height) + " pixels cannot be drawn",
                 .remedy = "Ask for 1 to 65535 pixels each way"};
  if (settings.surfaceStep < 1 || settings.surfaceStep > 4)
    return Error{.reason = "a surface cannot be drawn with one pixel for " +
                           std::to_string(settings.surfaceStep) + " of the picture each way",
                 .remedy = "Ask for 1 to 4"};
  if (const auto fault = model::cameraFault(camera))
    return Error{.where = "camera", .reason = std::string(*fault), .remedy = "Correct the camera"};
  return Unit{};
}

}  // namespace

struct Picture::Data {
  OpenDriver openDriver;                ///< where there is no device yet
  std::unique_ptr<gpu::Device> device;  ///< null: the processor draws alone
  Easel main;
  Easel aside;  ///< its painter is made for the first preview
  PictureOptions options;
  SurfaceCache surfaces;
  SectionCache<CappedSurface> sections;
  Hulls hulls;
  PictureTimings timings;
  int layersDrawn = 0;
  bool givenUp = false;

  /// Returns the prepared structures; nothing if `unwanted` asks to stop before all are prepared,
  /// and those that are ready by then are kept.
  std::optional<std::vector<PreparedStructure>> prepareStructures(const Sitting& sitting,
                                                                  const Output& output);
  /// Has samples that stand for several pixels taken of coarser forms of the surfaces.
  void sampleCoarsely(std::vector<PreparedStructure>& visible, const Sitting& sitting,
                      const Output& output) const;
  int textureSide() const;
  int regionSide() const;
  std::size_t atlasPixels() const;
  /// Returns what draws: not `automatic`.
  PictureOptions::Painter painter() const;
  bool processor() const { return painter() == PictureOptions::Painter::processor; }
  Easel& easel(const Output& output);
  /// Makes a device, for what only a driver draws; the error says what that is.
  Status bringDriver(const PictureInput& input);
  Status paint(const PictureInput& input, const PixelRect& region, Stopwatch& stopwatch,
               const Output& output);
  Status picture(const model::Scene& scene, const model::Camera& camera,
                 const PictureSettings& settings, const Output& output);
};

std::optional<std::vector<PreparedStructure>> Picture::Data::prepareStructures(
    const Sitting& sitting, const Output& output) {
  const model::Scene& scene = sitting.scene;
  std::vector<PreparedStructure> visible;
  surfaces.prepareSmall(sitting.structures, output.unwanted);
  hulls.take(scene);
  for (const model::VisibleStructure& structure : sitting.structures) {
    if (output.unwanted && *output.unwanted)
      return std::nullopt;
    const model::Node& node = *structure.node;
    PreparedStructure& shown = visible.emplace_back();
    shown.id = node.id;
    shown.mesh = node.mesh;
    shown.style = structure.style;
    shown.sections = sectionsThatCut(scene.sectionsOf(node.id), node.mesh->bounds());
    const Coarseness allowed = options.levelsOfDetail
                                   ? allowedCoarseness(shown, sitting.view, sitting.settings)
                                   : Coarseness{};
    shown.cached = &surfaces.at(node.mesh, node.provenance, allowed);
    shown.prepared = shown.cached;
    findGammaOffsets(scene, shown);
    if (!shown.sections.empty()) {
      shown.pattern = cutPattern(scene, node, &hulls);
      shown.cut = shown.capped = sections.at(shown.cached->surface, shown.sections);
    }
  }
  const auto hatched =
      std::size_t(std::count_if(visible.begin(), visible.end(), [](const PreparedStructure& shown) {
        return showsHatching(shown.style);
      }));
  for (PreparedStructure& shown : visible)
    shown.hatchCells = hatchCellsEach(hatched);
  sampleCoarsely(visible, sitting, output);
  std::vector<model::MeshPtr> meshes;
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup())
      meshes.push_back(node.mesh);
  if (!output.aside) {
    surfaces.keepOnly(meshes);
    sections.forgetUnused();
  }
  std::sort(visible.begin(), visible.end(),
            [](const PreparedStructure& a, const PreparedStructure& b) { return a.id < b.id; });
  Coinciding coinciding;
  for (PreparedStructure& shown : visible)
    shown.buried = coinciding.isBuried(shown);
  return visible;
}

void Picture::Data::sampleCoarsely(std::vector<PreparedStructure>& visible, const Sitting& sitting,
                                   const Output& output) const {
  if (!options.levelsOfDetail || !processor() || sitting.settings.surfaceStep == 1)
    return;
  // Structures that share a surface take turns.
  std::map<CachedSurface*, std::vector<PreparedStructure*>> bySurface;
  for (PreparedStructure& shown : visible)
    bySurface[shown.cached].push_back(&shown);
  std::vector<const std::vector<PreparedStructure*>*> each;
  each.reserve(bySurface.size());
  for (const auto& entry : bySurface)
    each.push_back(&entry.second);
  parallelFor(each.size(), 1, [&](std::size_t i) {
    for (PreparedStructure* shown : *each[i])
      if (!output.unwanted || !*output.unwanted)
        shown->sampled = shown->cached->sampleLevels.at(
            shown->surface(), sampledCoarseness(*shown, sitting.view, sitting.settings));
  });
}

int Picture::Data::textureSide() const {
  constexpr int ofTheProcessor = 16384;
  return device ? device->limits().textureSide : ofTheProcessor;
}

int Picture::Data::regionSide() const {
  const int driver =
      device ? std::min(textureSide(), device->limits().viewportSide) : textureSide();
  return options.maximumSide > 0 ? std::min(options.maximumSide, driver) : driver;
}

std::size_t Picture::Data::atlasPixels() const {
  if (options.atlasPixels > 0)
    return options.atlasPixels;
  return painter() == PictureOptions::Painter::card ? 48'000'000 : 20'000'000;
}

PictureOptions::Painter Picture::Data::painter() const {
  using Painter = PictureOptions::Painter;
  const bool chosen = options.painter != Painter::automatic;
  const Painter painter = chosen                          ? options.painter
                          : !device || device->software() ? Painter::processor
                                                          : Painter::card;
  // The processor has 8 bits per channel.
  return device && options.deep && painter == Painter::processor ? Painter::driver : painter;
}

Easel& Picture::Data::easel(const Output& output) {
  if (!output.aside)
    return main;
  constexpr std::size_t pixels = 2'000'000;
  if (!aside.painter)
    aside.painter = main.painter->another({.side = textureSide(), .pixels = pixels});
  // Between two previews, the other easel's pictures may have released surfaces that were kept.
  aside.painter->forget();
  return aside;
}

Status Picture::Data::bringDriver(const PictureInput& input) {
  const auto printed = std::find_if(input.shown.begin(), input.shown.end(),
                                    [](const auto& shown) { return shown.printedHatching; });
  const std::string what = printed != input.shown.end()
                               ? "hatching that is found pixel by pixel needs OpenGL"
                               : "what reaches behind the eye needs OpenGL";
  auto made = openDriver ? openDriver() : Error{.reason = "there is none"};
  if (!made)
    return Error{.reason = what + ": " + made.error().reason, .remedy = made.error().remedy};
  device = std::move(*made);
  for (Easel* each : {&main, &aside})
    if (each->painter)
      TRY(each->painter->equip(*device));
  return Unit{};
}

Status Picture::Data::paint(const PictureInput& input, const PixelRect& region,
                            Stopwatch& stopwatch, const Output& output) {
  Easel& used = easel(output);
  PictureCanvas& canvas = used.canvas;
  auto outcome = Result<LayerPainter::Outcome>(LayerPainter::Outcome::tooLarge);
  if (std::max(region.width, region.height) <= regionSide()) {
    if (device)
      TRY(canvas.resize({region.width, region.height}, false));
    outcome = used.painter->paint(device.get(), input, region, canvas, stopwatch);
    if (!outcome)
      return outcome.error();
  }
  if (*outcome == LayerPainter::Outcome::needsDriver) {
    TRY(bringDriver(input));
    return paint(input, region, stopwatch, output);
  }
  if (*outcome == LayerPainter::Outcome::givenUp) {
    givenUp = true;
    return Unit{};
  }
  if (*outcome == LayerPainter::Outcome::tooLarge) {
    if (std::max(region.width, region.height) < 2 * passes::ResolvePass::tileSide)
      return Error{.reason =
                       "the structures of this scene do not fit into the memory set aside "
                       "for a picture, not even piece by piece",
                   .remedy = "Hide some structures"};
    const auto [first, second] =
        halves(region, output.pieces ? output.pieces->grid : output.samples);
    for (const PixelRect& half : {first, second})
      if (Status s = paint(input, half, stopwatch, output); !s || givenUp)
        return s;
    return Unit{};
  }
  layersDrawn += used.painter->layersDrawn();
  const Delivery delivery{.easel = used,
                          .input = input,
                          .region = region,
                          .output = output,
                          .device = [&]() -> Result<gpu::Device*> {
                            if (!device)
                              TRY(bringDriver(input));
                            return device.get();
                          }};
  const bool wanted = TRY(deliver(delivery));
  givenUp = !wanted;
  if (output.image || output.pieces)
    stopwatch.pass(device.get(), "read");
  return Unit{};
}

Status Picture::Data::picture(const model::Scene& scene, const model::Camera& camera,
                              const PictureSettings& settings, const Output& output) {
  TRY(checkRequest(camera, settings));
  givenUp = false;
  const Sitting sitting(scene, camera, settings);
  const PictureView& view = sitting.view;
  std::optional<std::vector<PreparedStructure>> prepared = prepareStructures(sitting, output);
  if (!prepared) {
    givenUp = true;
    return Unit{};
  }
  std::vector<PreparedStructure>& visible = *prepared;
  // A graphics card draws whole surfaces in less time than it takes to enlarge samples.
  int step = painter() == PictureOptions::Painter::card ? 1 : settings.surfaceStep;
  for (PreparedStructure& s : visible) {
    s.printedHatching = showsPrintedHatching(s.style, settings);
    if (s.printedHatching)
      step = 1;  // its ink is found from the surface, pixel by pixel
  }
  const model::KeyLight own = scene.keyLight().value_or(model::KeyLight());
  Stopwatch stopwatch;
  std::map<model::NodeId, StructureLines> lines;
  const bool whole =
      !output.pieces && !output.aside && std::max(settings.width, settings.height) <= regionSide();
  layersDrawn = 0;
  for (const PreparedStructure& s : visible)
    s.cached->scales.hurry(settings.hurried);
  const PictureInput input{.view = view,
                           .shown = visible,
                           .background = settings.environment.background,
                           .light = settings.environment.light.value_or(own.towards),
                           .keyLight = settings.environment.keyLight.value_or(own.shades),
                           .parts = settings.parts,
                           .surfaceStep = step,
                           .processor = processor(),
                           .card = painter() == PictureOptions::Painter::card,
                           .lines = whole ? nullptr : &lines,
                           .unwanted = output.unwanted};
  Status done = Unit{};
  const int band = output.pieces ? output.pieces->bandRows : settings.height;
  for (int top = settings.height; top > 0 && done.ok() && !givenUp; top -= band) {
    const int rows = std::min(band, top);
    done = paint(input, {0, top - rows, settings.width, rows}, stopwatch, output);
  }
  const bool makeshift =
      std::any_of(visible.begin(), visible.end(),
                  [](const PreparedStructure& s) { return s.cached->scales.lacks(); });
  // The next picture shall not keep what lacks something, and none is drawn again to lack it.
  if (makeshift) {
    easel(output).painter->forget();
    givenUp = givenUp || output.aside;
  }
  if (!output.aside) {
    timings = stopwatch.done();
    timings.layersDrawn = layersDrawn;
    timings.makeshift = makeshift;
  }
  return done;
}

PictureTarget::PictureTarget(const gpu::Target& texture)
    : m_texture(&texture), m_width(texture.size().width), m_height(texture.size().height) {}

Picture::Picture() : m_data(std::make_unique<Data>()) {}
Picture::~Picture() = default;

Result<std::unique_ptr<Picture>> Picture::create(const PictureOptions& options) {
  std::unique_ptr<Picture> picture(new Picture);
  Data& data = *picture->m_data;
  data.options = options;
  data.main.canvas.deep = options.deep;
  data.device = TRY(gpu::Device::create());
  data.main.painter = std::make_unique<LayerPainter>(
      AtlasLimits{.side = data.textureSide(), .pixels = data.atlasPixels(), .deep = options.deep});
  TRY(data.main.painter->equip(*data.device));
  return picture;
}

std::unique_ptr<Picture> Picture::withoutDriver(const PictureOptions& options, OpenDriver open) {
  std::unique_ptr<Picture> picture(new Picture);
  Data& data = *picture->m_data;
  data.options = options;
  data.openDriver = std::move(open);
  data.main.painter = std::make_unique<LayerPainter>(
      AtlasLimits{.side = data.textureSide(), .pixels = data.atlasPixels()});
  return picture;
}

void Picture::prepare(const model::Scene& scene, const model::Camera& camera,
                      const PictureSettings& settings, int samples,
                      const std::atomic<bool>* unwanted) {
  if (!checkRequest(camera, settings).ok())
    return;  // the picture itself will say so
  PictureSettings sampled = settings;
  sampled.width *= samples;
  sampled.height *= samples;
  m_data->prepareStructures({scene, camera, sampled}, {.unwanted = unwanted, .aside = true});
}

Result<Image> Picture::render(const model::Scene& scene, const model::Camera& camera,
                              const PictureSettings& settings, int samples) {
  if (samples > 1) {
    PictureSettings larger = settings;
    larger.width *= samples;
    larger.height *= samples;
    const Result<Image> drawn = render(scene, camera, larger);
    return drawn.ok() ? averaged(*drawn, samples) : drawn;
  }
  Image image{.width = settings.width, .height = settings.height, .rgba = {}};
  TRY(checkRequest(camera, settings));
  image.rgba.resize(std::size_t(settings.width) * settings.height * 4);
  TRY(m_data->picture(scene, camera, settings, {.image = &image}));
  return image;
}

DrawPicture Picture::drawing() {
  return [this](const model::Scene& scene, const model::Camera& camera,
                const PictureSettings& settings) { return render(scene, camera, settings); };
}

Result<bool> Picture::renderPieces(const model::Scene& scene, const model::Camera& camera,
                                   const PictureSettings& settings, const PicturePieces& pieces) {
  TRY(checkRequest(camera, settings));
  if (pieces.grid < 1 || pieces.bandRows < 1 || settings.width % pieces.grid != 0 ||
      settings.height % pieces.grid != 0 || pieces.bandRows % pieces.grid != 0)
    return Error{.reason = "a picture cannot be drawn in such pieces",
                 .remedy = "Ask for sizes that are multiples of the pieces' grid"};
  TRY(m_data->picture(scene, camera, settings, {.pieces = &pieces}));
  return !m_data->givenUp;
}

Status Picture::draw(const model::Scene& scene, const model::Camera& camera,
                     const PictureSettings& settings) {
  return m_data->picture(scene, camera, settings, {});
}

Result<bool> Picture::drawInto(const TargetJob& job, const model::Scene& scene,
                               const model::Camera& camera, const PictureSettings& settings) {
  const PictureTarget& target = job.target;
  const bool holds = target.texture() ? bool(m_data->device)
                                      : target.pixels().size() == std::size_t(target.width()) *
                                                                      std::size_t(target.height());
  if (!holds || target.width() != settings.width || target.height() != settings.height)
    return Error{.reason = "a picture cannot be drawn into pixels of another size",
                 .remedy = "Ask for a picture of their size"};
  const Output output{.target = &job.target, .unwanted = job.unwanted, .outlines = job.outlines};
  TRY(m_data->picture(scene, camera, settings, output));
  if (m_data->device)
    m_data->device->finish();
  return !m_data->givenUp;
}

Result<bool> Picture::refineInto(const TargetJob& job, const model::Scene& scene,
                                 const model::Camera& camera, const PictureSettings& settings) {
  PictureSettings finer = settings;
  finer.samples = 2;
  finer.width *= finer.samples;
  finer.height *= finer.samples;
  finer.hurried = true;
  const Output large{
      .target = &job.target, .unwanted = job.unwanted, .aside = true, .samples = finer.samples};
  TRY(m_data->picture(scene, camera, finer, large));
  if (!m_data->givenUp && !job.outlines.empty()) {
    // Their width is at most some pixels: more samples would not be seen. Layers are those kept.
    const Output outlines{
        .target = &job.target, .unwanted = job.unwanted, .outlines = job.outlines, .over = true};
    TRY(m_data->picture(scene, camera, settings, outlines));
  }
  if (m_data->device)
    m_data->device->finish();
  return !m_data->givenUp;
}

Result<std::optional<Image>> Picture::preview(const model::Scene& scene,
                                              const model::Camera& camera,
                                              const PictureSettings& settings,
                                              const std::atomic<bool>* unwanted) {
  TRY(checkRequest(camera, settings));
  Image image{.width = settings.width, .height = settings.height, .rgba = {}};
  image.rgba.resize(std::size_t(settings.width) * settings.height * 4);
  const Output output{.image = &image, .unwanted = unwanted, .aside = true};
  TRY(m_data->picture(scene, camera, settings, output));
  if (m_data->givenUp)
    return std::optional<Image>();
  return std::optional<Image>(std::move(image));
}

const PictureTimings& Picture::timings() const {
  return m_data->timings;
}

}  // namespace sline::render
