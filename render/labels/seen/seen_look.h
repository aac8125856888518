// SPDX-License-Identifier: Apache-2.0
// Tells how much of a picture's place a structure takes: by its fill, its cut face and its lines
// (METHOD §7, §10), as far as that follows from its style and from how its surface stands there.
#pragma once

#include "model/scene/scene.h"
#include "render/drawn/drawn_structure.h"

namespace sline::render {

/// How a layer shows at one place, each 0 … 1.
struct SeenFill {
  float colour = 0.0f;  ///< the share of its own colour; what is dark shows less of it
  float cover = 0.0f;   ///< how much it hides of what is behind it
};

class SeenLook {
 public:
  explicit SeenLook(const model::ResolvedStyle& style, bool onDark = false);

  /// Returns the fill where the surface has that cosine between its normal and the line of sight.
  /// While shading enters, it does so first where the surface is bent (METHOD §7): the share of
  /// that is `bent`, 0 … 1, of which pictures alone know. Where Γ varies over the surface, it shows
  /// what its own Γ says and hides as much as anywhere, so that no leader ends on what it hides.
  SeenFill surface(float facing, float bent = 0.0f) const;
  /// Returns the fill of a cut face.
  SeenFill cutFace(model::CutFaces faces, model::CutPattern pattern) const;
  /// The strength of its outlines.
  float outline() const { return m_lines; }
  /// The width of the pen that draws them, in λ.
  float pen() const { return m_pen; }
  /// Returns the share that suggestive contours, hatching and unevenness of the shade take of a
  /// place on the surface, which nobody knows before they are drawn: about as much as they do on
  /// the average.
  float strokes() const { return m_strokes; }
  /// Returns the share that lines alone take.
  float lines() const { return m_surfaceLines; }

 private:
  SeenFill surfaceAt(float shading, float complete, float facing, float bent) const;

  model::Fill m_fill;
  float m_gamma;
  float m_onDark;  ///< 1: drawn as with chalk on a dark ground, else 0
  float m_opacity;
  float m_shading;
  float m_complete;
  float m_mostShading;  ///< anywhere on the structure
  float m_mostComplete;
  float m_lines;
  float m_pen;
  float m_surfaceLines;
  float m_strokes;
};

}  // namespace sline::render
