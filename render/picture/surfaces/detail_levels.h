// SPDX-License-Identifier: Apache-2.0
// Keeps levels of detail of a mesh: where its triangles are far smaller than pixels, pictures show
// a coarser one (Luebke et al., "Level of Detail for 3D Graphics", 2003).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/scene/scene.h"
#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_settings.h"
#include "render/drawn/picture_view.h"

namespace sline::render {

struct CachedSurface;

/// Says how coarse a surface may be.
struct Coarseness {
  float edge = 0.0f;     ///< mm; what edges may be long on an average. 0: as it is
  bool hurried = false;  ///< a level that is not ready need not be made where another one is
};

/// Says how each level follows from the one before.
struct LevelStep {
  /// Edges shorter than the mean times this are collapsed, which about doubles the mean.
  static constexpr float collapsed = 1.6f;
  /// What the mean becomes longer by, as expected: a level is made where it will likely be allowed.
  static constexpr float growth = 2.0f;
  /// A level that has not fewer than this share of the triangles before is the last.
  static constexpr float worthwhile = 0.6f;
};

/// Returns how coarse the structure may be in that picture: edges of one and a half pixels where
/// it is nearest. Where Γ varies over the surface, or the surface may reach beside the eye, it
/// stays as it is.
Coarseness allowedCoarseness(const DrawnStructure& shown, const PictureView& view,
                             const PictureSettings& settings);

/// Returns how coarse the form of it may be of which such a picture takes samples of several
/// pixels: with edges three samples long.
Coarseness sampledCoarseness(const DrawnStructure& shown, const PictureView& view,
                             const PictureSettings& settings);

/// The levels of one mesh, each about a quarter of the one before. Normals and curvature of their
/// vertices are those of the mesh itself: its own triangles' would be less smooth.
class DetailLevels {
 public:
  /// Meshes of fewer triangles have no coarser level: little could be won.
  static constexpr std::size_t leastTriangles = 200'000;

  DetailLevels();
  ~DetailLevels();
  DetailLevels(DetailLevels&&) noexcept;
  DetailLevels& operator=(DetailLevels&&) noexcept;

  /// Tells whether nothing was asked of it yet.
  bool empty() const { return m_levels.empty(); }
  /// Returns the coarsest level allowed, prepared.
  CachedSurface& at(const model::MeshPtr& mesh, const model::Provenance& provenance,
                    const Coarseness& allowed);

 private:
  struct Level {
    model::MeshPtr mesh;
    std::vector<std::uint32_t> vertices;  ///< of the level before, one for each of the mesh's own
    float edge = 0.0f;                    ///< mean, mm
    std::unique_ptr<CachedSurface> cached;
  };

  static Level levelOf(model::MeshPtr mesh, std::vector<std::uint32_t> vertices);
  bool ready(std::size_t level) const;
  /// Appends the next level's mesh, or finds that there is none.
  void add();
  void prepare(std::size_t level, const model::Provenance& provenance);
  /// Returns the index of the level that is wanted, and makes the meshes up to it unless one is
  /// ready and `allowed.hurried`.
  std::size_t wanted(const Coarseness& allowed);

  std::vector<Level> m_levels;
  bool m_complete = false;  ///< there is no coarser one
};

}  // namespace sline::render
