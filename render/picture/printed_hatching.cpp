// SPDX-License-Identifier: Apache-2.0
#include "render/picture/printed_hatching.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lines/ground/stages.h"
#include "render/lines/techniques/line_technique.h"
#include "render/picture/atlas.h"

namespace sline::render {

namespace {

constexpr float cellSize = 0.05f;  // c_s, of F
// Depth may change by this many times a step's length on a slope without being a contour.
constexpr float steepest = 8.0f;

/// Returns T_H as S eq. 7 prints it.
float entered(Gamma gamma) {
  return std::clamp(gamma.value() - 2.0f, 0.0f, 1.0f);
}

passes::HatchingDraw hatchingDraw(const PreparedStructure& shown, const PictureView& view,
                                  const passes::SurfaceDraw& surface) {
  const model::Surface& s = shown.surface();
  const float stride = view.outputUnit();
  const float step = stride * view.millimetresPerPixel(s.boundingSphere.centre);
  return {.surface = surface,
          .gridCorner = s.boundingSphere.centre,
          .cell = std::max(cellSize * s.featureSize, 1e-20f),
          .feature = s.featureSize,
          .threshold =
              0.5f * std::numbers::pi_v<float> * (1.0f - entered(shown.style.gamma)),  // eq. 10
          .opacity = transitions(shown.style.gamma).lines,
          .stride = stride,
          .contourJump = 0.5f * cellSize * s.featureSize + steepest * step,
          .projection = view.depthTerms()};
}

// Noise is inked in shade of more than this, lit from the eye by that share of the light.
constexpr float leastNoiseShade = 0.12f;
constexpr float lightFromEye = 0.35f;
constexpr float noiseCell = 1.6f;  // λ

bool isNoise(const model::ResolvedStyle& style) {
  return style.technique == model::Technique::noiseLic;
}

/// Noise enters as the streamlines of other techniques along the same directions do.
float noiseEntered(Gamma gamma) {
  return techniqueOf(LineKind::hatchingStreamline).entered(gamma);
}

/// Returns a cell of noise in mm; the size in the picture is held within a root of two, so that
/// noise does not swim while the camera moves.
float cellOfNoise(float millimetresPerUnit) {
  return std::exp2(std::round(std::log2(std::max(noiseCell * millimetresPerUnit, 1e-20f))));
}

passes::NoiseLicDraw noiseDraw(const PreparedStructure& shown, const PrintedHatching::Sight& sight,
                               const passes::SurfaceDraw& surface) {
  const model::Surface& s = shown.surface();
  const float stride = sight.view.outputUnit();
  const float step = stride * sight.view.millimetresPerPixel(s.boundingSphere.centre);
  const float lines = transitions(shown.style.gamma).lines;
  return {
      .surface = surface,
      .middle = s.boundingSphere.centre,
      .cell = cellOfNoise(std::max(step, sight.view.millimetresPerPixel(s.boundingSphere.centre))),
      .light = sight.view.toPatient(sight.light),
      .leastShade = leastNoiseShade,
      .fromEye = lightFromEye,
      .entered =
          lines * noiseEntered(shown.style.gamma) * std::min(shown.style.hatchTone.value(), 1.0f),
      .stride = stride,
      .contourJump = 0.5f * cellSize * s.featureSize + steepest * step,
      .projection = sight.view.depthTerms()};
}

}  // namespace

bool showsPrintedHatching(const model::ResolvedStyle& style, const PictureSettings& settings) {
  if (!settings.parts.hatching || !(transitions(style.gamma).lines > 0.0f))
    return false;
  if (isNoise(style))
    return noiseEntered(style.gamma) > 0.0f;
  return settings.hatching == HatchingMethod::asPrinted && entered(style.gamma) > 0.0f;
}

int printedHatchingReach(const PictureView& view) {
  return int(std::ceil(float(passes::HatchingPass::longestSearch) * view.outputUnit())) + 1;
}

Status PrintedHatching::preparePass(const gpu::Device& device, const PreparedStructure& shown) {
  if (isNoise(shown.style) && !m_noise) {
    m_noise = TRY(passes::NoiseLicPass::create(device.dialect()));
  } else if (!isNoise(shown.style) && !m_pass) {
    m_pass = TRY(passes::HatchingPass::create(device.dialect()));
  }
  return Unit{};
}

Status PrintedHatching::prepare(gpu::TextureSize size) {
  if (m_target && m_target->size().width >= size.width && m_target->size().height >= size.height)
    return Unit{};
  m_target.reset();
  m_fields.reset();
  m_depths.reset();
  const gpu::TextureSize rounded{roundedToStep(size.width), roundedToStep(size.height)};
  m_fields =
      std::make_unique<gpu::Texture>(gpu::TextureFormat::rgba32i, rounded, "hatching fields");
  m_depths =
      std::make_unique<gpu::Texture>(gpu::TextureFormat::depth32f, rounded, "hatching depth");
  m_target = TRY(gpu::Target::create({{m_fields.get()}, m_depths.get()}, "hatching fields"));
  return Unit{};
}

void PrintedHatching::draw(gpu::Device& device, const Sight& sight, const Layer& layer) const {
  const PreparedStructure& shown = layer.members.front();
  const PictureView& view = sight.view;
  const passes::HatchingFields fields{*m_fields, *m_depths, *m_target};
  const passes::SurfaceView surfaceView{
      .viewProjection = view.viewProjection(), .eye = view.eyeVector(), .pictureSize = view.size()};
  const passes::SurfaceDraw surface{
      .surface = shown.cached->geometry(true),
      .triangles = layer.triangles.front(),
      .layer = layer.area,
      .slot = layer.slot,
      .fill = {.filigree = shown.surface().filigreeSize,
               .twoSided = needsTwoSides(shown.surface(), view.camera())}};
  if (isNoise(shown.style)) {
    const passes::NoiseLicDraw draw = noiseDraw(shown, sight, surface);
    m_noise->drawFields(device, fields, sight.atlas.surfaceDepths(), surfaceView, draw);
    m_noise->convolve(device, sight.atlas.inkTarget(), fields, draw);
    return;
  }
  const passes::HatchingDraw draw = hatchingDraw(shown, view, surface);
  m_pass->drawFields(device, fields, sight.atlas.surfaceDepths(), surfaceView, draw);
  m_pass->search(device, sight.atlas.inkTarget(), fields, draw);
}

Status PrintedHatching::draw(gpu::Device& device, const Sight& sight, std::span<const Layer> layers,
                             std::span<const std::size_t> changed) {
  gpu::TextureSize largest;
  for (const std::size_t i : changed)
    if (layers[i].members.front().printedHatching) {
      TRY(preparePass(device, layers[i].members.front()));
      largest = {std::max(largest.width, layers[i].slot.width),
                 std::max(largest.height, layers[i].slot.height)};
    }
  if (largest.width == 0)
    return Unit{};
  TRY(prepare(largest));
  for (const std::size_t i : changed)
    if (layers[i].members.front().printedHatching)
      draw(device, sight, layers[i]);
  return Unit{};
}

}  // namespace sline::render
