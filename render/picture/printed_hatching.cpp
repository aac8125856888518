// SPDX-License-Identifier: Apache-2.0
#include "render/picture/printed_hatching.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lines/stages.h"
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

}  // namespace

bool showsPrintedHatching(const model::ResolvedStyle& style, const PictureSettings& settings) {
  return settings.hatching == HatchingMethod::asPrinted && settings.parts.hatching &&
         entered(style.gamma) > 0.0f && transitions(style.gamma).lines > 0.0f;
}

int printedHatchingReach(const PictureView& view) {
  return int(std::ceil(float(passes::HatchingPass::longestSearch) * view.outputUnit())) + 1;
}

Status PrintedHatching::prepare(const gpu::Device& device, gpu::TextureSize size) {
  if (!m_pass) {
    auto pass = passes::HatchingPass::create(device.dialect());
    if (!pass)
      return pass.error();
    m_pass = std::move(*pass);
  }
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
  auto target = gpu::Target::create({{m_fields.get()}, m_depths.get()}, "hatching fields");
  if (!target)
    return target.error();
  m_target = std::move(*target);
  return Unit{};
}

Status PrintedHatching::draw(gpu::Device& device, const PictureView& view, const Atlas& atlas,
                             std::span<const Layer> layers, std::span<const std::size_t> changed) {
  gpu::TextureSize largest;
  for (const std::size_t i : changed)
    if (layers[i].members.front().printedHatching)
      largest = {std::max(largest.width, layers[i].slot.width),
                 std::max(largest.height, layers[i].slot.height)};
  if (largest.width == 0)
    return Unit{};
  if (Status s = prepare(device, largest); !s)
    return s;
  const passes::HatchingFields fields{*m_fields, *m_depths, *m_target};
  const passes::SurfaceView surfaceView{
      .viewProjection = view.viewProjection(), .eye = view.eyeVector(), .pictureSize = view.size()};
  for (const std::size_t i : changed) {
    const Layer& layer = layers[i];
    const PreparedStructure& shown = layer.members.front();
    if (!shown.printedHatching)
      continue;
    const passes::SurfaceDraw surface{
        .surface = *shown.cached->geometry,
        .ranges = layer.coverage.front().ranges,
        .visible = layer.coverage.front().visible,
        .layer = layer.area,
        .slot = layer.slot,
        .fill = {.filigree = shown.surface().filigreeSize,
                 .twoSided = needsTwoSides(shown.surface(), view.camera())}};
    const passes::HatchingDraw draw = hatchingDraw(shown, view, surface);
    m_pass->drawFields(device, fields, atlas.surfaceDepths(), surfaceView, draw);
    m_pass->search(device, atlas.inkTarget(), fields, draw);
  }
  return Unit{};
}

}  // namespace sline::render
