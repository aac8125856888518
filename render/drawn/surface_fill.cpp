// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/surface_fill.h"

#include "model/base/contrast.h"
#include "render/lines/ground/stages.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

namespace {

/// Returns how much a wash of that kind hides, apart from the style's opacity.
float washStrength(model::Fill fill) {
  switch (fill) {
    case model::Fill::paper:
      return 1.0f;
    case model::Fill::tint:
      return tintStrength;
    case model::Fill::veil:
      return veilStrength;
    case model::Fill::none:
      break;
  }
  return 0.0f;
}

}  // namespace

FillStages fillStages() {
  constexpr std::size_t half = 16;
  FillStages stages{};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const float part = float(i) / float(half);
    const Transitions t = transitions(Gamma::clamped(i < half ? 3.0f + part * part : 3.0f + part));
    stages[i] = {t.shading, t.complete, 0.0f, 0.0f};
  }
  return stages;
}

glm::vec4 backgroundColour(Background background) {
  switch (background) {
    case Background::white:
      return {1.0f, 1.0f, 1.0f, 1.0f};
    case Background::paper:
      return {glm::vec3(250.0f, 246.0f, 236.0f) / 255.0f, 1.0f};
    case Background::dark:
      return {glm::vec3(28.0f, 30.0f, 34.0f) / 255.0f, 1.0f};
    case Background::transparent:
      break;
  }
  return {0.0f, 0.0f, 0.0f, 0.0f};
}

Colour inkColour(const model::ResolvedStyle& style, Background background) {
  if (background != Background::dark)
    return style.inkColour.value_or(Colour{0, 0, 0});
  // Inks are chosen for paper; on a dark ground they are lightened as far as lines need.
  constexpr Colour light{238, 236, 230};
  constexpr Colour ground{28, 30, 34};
  constexpr double legible = 4.5;
  return style.inkColour ? legibleOn(ground, *style.inkColour, legible) : light;
}

bool isOpaque(const model::ResolvedStyle& style) {
  return transitions(gammaSpan(style).least).complete >= 1.0f && style.opacity.value() >= 1.0f;
}

bool hasFill(const model::ResolvedStyle& style) {
  return style.opacity.value() > 0.0f &&
         (style.fill != model::Fill::none || transitions(gammaSpan(style).most).shading > 0.0f);
}

float fillCover(const model::ResolvedStyle& style) {
  const float shading = transitions(style.gamma).shading;
  return style.opacity.value() * (1.0f - (1.0f - washStrength(style.fill)) * (1.0f - shading));
}

SurfaceFill surfaceFill(const DrawnStructure& shown, const PictureView& view,
                        Background background) {
  using Kind = SurfaceFill::Kind;
  const model::ResolvedStyle& style = shown.style;
  const Transitions t = transitions(style.gamma);
  SurfaceFill fill;
  if (!hasFill(style))
    return fill;
  const GammaSpan span = gammaSpan(style);
  fill.kind = transitions(span.most).shading > 0.0f ? Kind::phong : Kind::flat;
  fill.colour = rgb(style.colour);
  fill.shading = t.shading;
  fill.complete = t.complete;
  fill.leastComplete = transitions(span.least).complete;
  fill.opacity = style.opacity.value();
  fill.gamma = style.gamma.value();
  fill.gammaOffsets = shown.gammaOffsets;
  fill.byForm = transitions(span.most).shading > 0.0f && transitions(span.least).shading < 1.0f;
  fill.filigree = shown.surface().filigreeSize;
  fill.darkGround = background == Background::dark;
  fill.twoSided = needsTwoSides(shown.surface(), view.camera());
  if (style.fill == model::Fill::paper || style.fill == model::Fill::veil) {
    // A picture without background is meant for white paper.
    const bool transparent = background == Background::transparent;
    fill.wash = transparent ? glm::vec4(1.0f) : backgroundColour(background);
  } else if (style.fill == model::Fill::tint) {
    fill.wash = glm::vec4(fill.colour, 1.0f);
  }
  fill.wash *= washStrength(style.fill);
  fill.wash *= fill.opacity;
  return fill;
}

}  // namespace sline::render
