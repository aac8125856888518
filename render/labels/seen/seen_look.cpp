// SPDX-License-Identifier: Apache-2.0
#include "render/labels/seen/seen_look.h"

#include <algorithm>
#include <cmath>

#include "render/drawn/gamma_offsets.h"
#include "render/drawn/section_caps.h"
#include "render/drawn/surface_fill.h"
#include "render/lines/ground/stages.h"
#include "render/sight/rules.h"

namespace sline::render {

namespace {
/// The shares of a surface that suggestive contours and hatching take on the average.
constexpr float suggestiveInk = 0.1f;
constexpr float hatchingInk = 0.2f;
/// The least shade that is taken to be somewhere near on a shaded surface, as surfaces are rough.
constexpr float unevenShade = 0.3f;
constexpr float usualPen = 2.0f;  // λ, METHOD §4

/// Returns how much a shade shows of its colour where the surface has that cosine between its
/// normal and the line of sight, without highlights, which are white. On paper its shadows deepen
/// with what has entered; on a dark ground they are there from the beginning.
float tone(float facing, float entered) {
  constexpr float inShadow = 0.3f;  // a pure colour's
  constexpr float inLight = 1.0f;
  const float shaded = glm::mix(inShadow, inLight, rule::headlight(facing));
  return entered * shaded + (1.0f - entered) * inLight;
}
}  // namespace

SeenLook::SeenLook(const model::ResolvedStyle& style, bool onDark)
    : m_fill(style.fill),
      m_gamma(style.gamma.value()),
      m_onDark(onDark ? 1.0f : 0.0f),
      m_opacity(style.opacity.value()) {
  const Transitions t = transitions(style.gamma);
  m_shading = t.shading;
  m_complete = t.complete;
  const Transitions most = transitions(gammaSpan(style).most);
  m_mostShading = most.shading;
  m_mostComplete = most.complete;
  // The eye follows a pen of half the usual width as well as any wider one.
  m_lines = t.lines * m_opacity * std::min(2.0f * style.penWeight, 1.0f);
  m_pen = usualPen * style.penWeight;
  m_surfaceLines = m_lines * (suggestiveInk * t.suggestive + hatchingInk * t.hatching);
  m_strokes = m_surfaceLines + m_opacity * unevenShade * t.shading;
}

SeenFill SeenLook::surface(float facing, float bent) const {
  SeenFill fill = surfaceAt(m_shading, m_complete, facing, bent);
  if (m_mostShading > m_shading || m_mostComplete > m_complete)
    fill.cover = std::max(fill.cover, surfaceAt(m_mostShading, m_mostComplete, facing, bent).cover);
  return fill;
}

SeenFill SeenLook::surfaceAt(float shading, float complete, float facing, float bent) const {
  SeenFill wash;
  if (m_fill == model::Fill::paper)
    wash.cover = m_opacity;
  else if (m_fill == model::Fill::veil)
    wash.cover = veilStrength * m_opacity;
  else if (m_fill == model::Fill::tint)
    wash = {tintStrength * m_opacity, tintStrength * m_opacity};
  const float angle = rule::enteringAngle(std::clamp(facing, 0.0f, 1.0f), m_onDark);
  const float entered = rule::enteredAt(angle, bent, shading, complete);
  const float shade = entered * m_opacity;
  const float own = shade * tone(std::clamp(facing, 0.0f, 1.0f), m_onDark > 0.0f ? 1.0f : entered);
  return {own + wash.colour * (1.0f - shade), shade + wash.cover * (1.0f - shade)};
}

SeenFill SeenLook::cutFace(model::CutFaces faces, model::CutPattern pattern) const {
  if (isPaperFace(faces, pattern))
    return {0.0f, m_opacity};
  return {m_opacity * capTint(m_gamma), m_opacity};
}

}  // namespace sline::render
