// SPDX-License-Identifier: Apache-2.0
// Finds what drawings without OpenGL are made of: each structure's lines, and the parts of them
// that are seen.
#pragma once

#include <deque>
#include <map>
#include <span>
#include <vector>

#include "model/scene/scene.h"
#include "render/drawn/drawn_structure.h"
#include "render/drawn/face_patterns.h"
#include "render/strokes/structure_lines.h"
#include "render/vectors/visible_strokes.h"

namespace sline::render {

/// Keeps what is made once for each mesh, and for each section of one, from drawing to drawing.
class KeptSurfaces {
 public:
  PreparedSurface& of(const model::Node& node);
  SectionCache<SectionedSurface>& sections() { return m_sections; }
  Hulls& hulls() { return m_hulls; }

 private:
  std::map<model::MeshPtr, PreparedSurface> m_surfaces;
  SectionCache<SectionedSurface> m_sections;
  Hulls m_hulls;
};

/// Holds one structure on its way to the page.
struct StructureWork {
  DrawnStructure shown;
  PixelRect area;
  StructureLines lines;

  bool hasLines() const { return showsLines(shown.style) || shown.cut != nullptr; }
};

/// Returns the visible structures that add anything, in the order of their ids, without lines.
std::vector<StructureWork> structureWork(const model::Scene& scene, KeptSurfaces& surfaces);
/// Sets the areas that the structures take of the picture, a little beyond its edges, as lines
/// there look at pixels beside them.
void findAreas(std::span<StructureWork> work, const PictureView& view);
/// Makes what the structures' lines need of their surfaces.
void prepareLines(std::span<const StructureWork> work);
/// Finds the structure's lines, lit from there, a direction in the camera's frame.
void findLines(StructureWork& work, const PictureView& view, const glm::vec3& light);
/// The lines of one kind, which are drawn together.
struct LineLayer {
  const char* kind = "";  ///< `hatchingLayer` …, or a technique's layer
  float opacity = 1.0f;   ///< of all the lines together
  StructureLines lines;
};
/// Takes the structure's lines apart by kinds, in drawing order; none where pens draw none.
std::vector<LineLayer> takeLayers(StructureWork& work);
/// Returns what is seen of some of a structure's lines.
std::vector<VisibleStroke> seenLines(const StructureWork& work, const StructureLines& some,
                                     const StrokeScene& scene, const PictureView& view);

}  // namespace sline::render
