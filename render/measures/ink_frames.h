// SPDX-License-Identifier: Apache-2.0
// Draws the lines of a scene from one camera after another, cut where they are hidden, as points
// that know where on the body they lie: what measures of steadiness compare.
#pragma once

#include <deque>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "model/scene/scene.h"
#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_view.h"
#include "render/lines/techniques/lines.h"
#include "render/strokes/structure_lines.h"
#include "render/vectors/depth_layer.h"

namespace sline::render {

struct InkPoint {
  glm::vec2 at{0.0f};     ///< pixels of the picture
  glm::vec3 place{0.0f};  ///< patient frame, mm
  float weight = 0.0f;    ///< width · opacity, λ
};

/// One stroke of a pen, with a point for each pixel along its way.
struct InkLine {
  LineKind kind = LineKind::contour;
  std::vector<InkPoint> points;
};

/// What is drawn of one structure: all lines but hatching.
struct StructureInk {
  std::string name;
  std::vector<InkLine> lines;
  std::vector<InkLine> dashes;  ///< of its outlines, also where nothing hides them
};

struct InkFrame {
  PictureView view;
  std::vector<StructureInk> structures;  ///< in the order of their ids
  std::vector<DepthLayer> layers;        ///< one for each structure

  float unit() const { return view.outputUnit(); }
};

/// Which rules lines follow: the picture's, or also those by which vector drawings leave crumbs
/// out.
enum class InkRules { picture, vectors };

class InkFrames {
 public:
  /// Takes the visible structures of the scene, which sections do not cut.
  InkFrames(const model::Scene& scene, int width, int height);

  InkFrame at(const model::Camera& camera, InkRules rules);

  /// Calls `body(structure, lines before they are joined, curves)` for each structure with lines.
  template <class Body>
  void forEachCurve(const model::Camera& camera, const Body& body) {
    const PictureView view(camera, m_bounds, m_width, m_height);
    for (Shown& shown : m_shown) {
      StructureLines curves;
      curves.lines = exactLines(shown, view);
      const LineSet exact = curves.lines;
      joinLines(shown.drawn.surface(), view, shown.drawn.style, m_light, curves);
      body(shown.name, view, exact, curves);
    }
  }

 private:
  struct Shown {
    std::string name;
    DrawnStructure drawn;
  };
  static LineSet exactLines(const Shown& shown, const PictureView& view);
  void addLines(const Shown& shown, std::size_t index, InkRules rules, InkFrame& frame) const;

  int m_width;
  int m_height;
  std::deque<PreparedSurface> m_surfaces;
  std::vector<Shown> m_shown;
  model::Box m_bounds;
  glm::vec3 m_light{0.0f};
};

}  // namespace sline::render
