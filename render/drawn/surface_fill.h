// SPDX-License-Identifier: Apache-2.0
// Describes how a structure's surface is filled, and the colours of ink and ground (METHOD §7).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_settings.h"
#include "render/drawn/picture_view.h"

namespace sline::render {

/// How much a tint's colour covers, and how much a veil's paper: two fifths of what lies behind one
/// veil show, a sixth behind two, so that near and far stay apart.
inline constexpr float tintStrength = 0.2f;
inline constexpr float veilStrength = 0.6f;

/// Describes how the surface's pixels look.
struct SurfaceFill {
  enum class Kind { depthOnly, flat, phong };
  Kind kind = Kind::depthOnly;
  glm::vec4 wash{0.0f};  ///< premultiplied, under the shading; a flat fill consists of it alone
  glm::vec3 colour{1.0f};
  float shading = 0.0f;        ///< T_P
  float complete = 0.0f;       ///< clamp01(Γ − 4): mixes the opacity with 1
  float leastComplete = 0.0f;  ///< the least that `complete` is anywhere
  float opacity = 1.0f;        ///< that of the style
  float gamma = 2.0f;          ///< the structure's own
  /// By how much Γ differs at each vertex; null: nowhere. Then it says T_P and clamp01(Γ − 4).
  GammaOffsetsPtr gammaOffsets;
  bool byForm = false;    ///< somewhere shading has entered in part, as the form's curvature says
  float filigree = 1.0f;  ///< F_c in mm
  /// Fills enter as light instead of shade: from parts that face the eye, while on paper they enter
  /// from the rim, as S eq. 11 says.
  bool darkGround = false;
  bool twoSided = false;  ///< normals turn towards the eye
  /// What is seen more aslant is shaded as if n·v were this much.
  float leastFacing = 0.0f;
};

/// Holds T_P (x) and clamp01(Γ − 4) (y) at some Γ, for shaders: at 3 + (i/16)² for i = 0 … 16, as
/// shading sets in steeply, and at 3 + i/16 for i = 16 … 32.
using FillStages = std::array<glm::vec4, 33>;
FillStages fillStages();

/// Returns red, green and blue from 0 to 1, encoded as sRGB.
inline glm::vec3 rgb(const Colour& colour) {
  return glm::vec3(float(colour.red), float(colour.green), float(colour.blue)) / 255.0f;
}
/// Returns the background in sRGB with straight alpha.
glm::vec4 backgroundColour(Background background);
/// Returns the pen's colour: the style's own, else black. On a dark background the style's own is
/// lightened as far as lines need, else it is nearly white.
Colour inkColour(const model::ResolvedStyle& style, Background background);

/// Returns whether a structure hides what is behind and has no lines.
bool isOpaque(const model::ResolvedStyle& style);
bool hasFill(const model::ResolvedStyle& style);
/// Returns how much of what lies behind the fill hides where it is complete, 0 … 1.
float fillCover(const model::ResolvedStyle& style);
SurfaceFill surfaceFill(const DrawnStructure& shown, const PictureView& view,
                        Background background);

}  // namespace sline::render
