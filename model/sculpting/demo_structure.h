// SPDX-License-Identifier: Apache-2.0
// Describes a demo scene as a list of shapes: each structure is a field with the box that holds its
// surface, the names of the groups above it, and the structures to which it gives way, so that no
// two overlap.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "model/scene/scene.h"
#include "model/sculpting/implicit.h"
#include "model/sculpting/remesh.h"

namespace sline::model {

/// Selects the anatomy where the sexes differ; also the scene's name in messages.
enum class Sex { female, male };

/// Context is drawn in the ink of its kind, so that black is left to the structures in focus.
inline constexpr Colour boneInk{94, 79, 56};
inline constexpr Colour muscleInk{122, 44, 34};
inline constexpr Colour bowelInk{112, 70, 44};
inline constexpr Colour bowelColour{217, 160, 124};
inline constexpr Colour urinaryColour{226, 178, 96};
inline constexpr Colour arteryInk{168, 28, 20};
inline constexpr Colour veinInk{31, 70, 143};
inline constexpr Colour portalInk{86, 67, 156};

/// Makes a closed mesh of a body, negative inside, from triangles with that mean edge.
using Mesher = std::function<MeshPtr(const Field& solid, float edge)>;

struct DemoStructure {
  std::string name;                 ///< "left ureter"
  std::vector<std::string> groups;  ///< outermost first
  Colour colour;
  Gamma gamma = Gamma::clamped(1.0f);
  std::optional<Fill> fill;
  std::optional<Colour> inkColour;      ///< like Style::inkColour
  Field field;                          ///< mm, patient frame (LPS); negative inside
  Box box;                              ///< contains the surface field = 0 with room to spare
  float edge = 1.5f;                    ///< mm: mean edge of its triangles
  std::optional<Facets> pattern;        ///< triangles near the surface, in place of a lattice's
  std::vector<std::string> givesWayTo;  ///< names; their bodies, grown by `gap`, are cut out of it
  float gap = 0.5f;                     ///< mm kept clear of the structures it gives way to
  float rounding = 1.0f;                ///< mm: radius of the edge that cutting leaves
  float smoothing = 0.0f;  ///< mm: width of the smoothing after cutting, as by a thumb; 0: none
  float wall = 0.0f;       ///< mm: a hollow body's wall, measured inward after cutting; 0: solid
  /// Cut out last: the way into a hollow body, or all of a cavity that is open to the outside. A
  /// hollow body without an opening has a closed cavity, whose surface is a separate part of the
  /// mesh that faces into the cavity.
  Field opening;
  /// For a closed cavity, mm by which its wall is thicker here than `wall`; at most 3.
  Field folds;
  Mesher mesher;  ///< replaces polygonising, for the body and for its closed cavity
};

/// Meshes all structures in parallel, each closed and smooth, and builds the tree in list order;
/// asserts that names are unique and that each name in `givesWayTo` exists. Throws ModellingStopped
/// if `stop` is requested on the way.
Scene demoScene(std::vector<DemoStructure> structures, const std::stop_token& stop = {});

}  // namespace sline::model
