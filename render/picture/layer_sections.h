// SPDX-License-Identifier: Apache-2.0
// What section planes do to a layer: which planes cut a structure, its cut faces, and how they look
// (METHOD §7).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/scene/scene.h"
#include "render/lines/cut_faces.h"
#include "render/passes/cap/cap_pass.h"
#include "render/picture/picture_view.h"
#include "render/picture/tile_lists.h"

namespace sline::render {

struct Shown;
enum class Background;

/// A surface cut by planes; does not depend on the view.
struct SectionedSurface {
  model::SurfacePtr surface;
  std::vector<model::Plane> planes;
  std::vector<CutFace> faces;
  /// Of each face, once drawn.
  std::vector<std::unique_ptr<passes::CapGeometry>> caps;
};

/// Keeps what was cut while the planes stay where they are.
class SectionCache {
 public:
  std::shared_ptr<SectionedSurface> at(const model::SurfacePtr& surface,
                                       std::span<const model::Section> sections);
  /// Forgets what was not asked for since the last call.
  void forgetUnused();

 private:
  struct Entry {
    std::shared_ptr<SectionedSurface> cut;
    bool used = true;
  };
  std::vector<Entry> m_entries;
};

/// Those of the sections that take anything of the box away, at most `maximumSections`: a structure
/// that they all spare is drawn as if there were none.
std::vector<model::Section> sectionsThatCut(std::vector<model::Section> sections,
                                            const model::Box& box);
/// True where they have the same planes and look.
bool alike(std::span<const model::Section> a, std::span<const model::Section> b);

/// True where one of the planes takes all of the box or sphere away.
bool takenAway(const Shown& shown, const model::Box& box);
bool takenAway(const Shown& shown, const model::Sphere& sphere);
/// As sections.glsl wants them.
std::vector<glm::vec4> sectionVectors(std::span<const model::Plane> planes);

/// True where the structure has a cut face to fill.
bool hasCaps(const Shown& shown);
/// Pixels that cut faces and their outlines can touch, strokes not included.
gpu::Rect sectionArea(const Shown& shown, const PictureView& view);
void markCaps(const Shown& shown, const PictureView& view, TileMask& mask);

/// How far towards the eye (window depth) the outlines of cut faces lie, so that no face of the
/// same plane covers half of them.
inline constexpr float outlineLift = 6e-5f;

/// How a cut face looks; see cap.frag.glsl.
struct CapLook {
  glm::vec4 colour{0.0f};        ///< premultiplied
  glm::vec4 strokeColour{0.0f};  ///< premultiplied; alpha 0: no hatching
  glm::vec4 stripes{0.0f};
  float strokeHalfWidth = 0.0f;  ///< px
  glm::vec3 depthPlane{0.0f};
};
CapLook capLook(const Shown& shown, const PictureView& view, Background background,
                std::size_t face);

/// One draw per face; makes the geometry where it is not there yet. `area` and `slot` are the
/// layer's; the sections that clip each face point into `planes`.
struct CapDraws {
  std::vector<std::vector<glm::vec4>> planes;
  std::vector<passes::CapDraw> draws;
};
CapDraws capDraws(const Shown& shown, const PictureView& view, Background background,
                  const gpu::Rect& area, const gpu::Rect& slot);

}  // namespace sline::render
