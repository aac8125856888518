// SPDX-License-Identifier: Apache-2.0
// Tells what one sees at each place of a picture, and where to point at a structure so that the
// leader ends on what it names. It follows the rules by which layers become a picture (METHOD §10):
// each structure's nearest surface lets through what its fill does not cover.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/geometry/mesh_trees.h"
#include "render/labels/seen/seen_layer.h"

namespace sline::render {

/// A place for a label.
struct SeenPlace {
  model::Anchor anchor;   ///< on the structure, or on a cut face, which is a point in space
  glm::vec2 place{0.0f};  ///< millimetres of the output
  bool hidden = false;    ///< the structure is not what one sees there
  /// The place is the structure's beyond doubt: it is no sliver, and no tangle of several lines, of
  /// which one cannot say in general which is on top.
  bool sure = true;
};

/// How much of a picture shows a structure.
struct SeenShare {
  model::NodeId structure;
  float cells = 0.0f;      ///< how many of the map's it fills, by colour and outline
  glm::vec2 middle{0.0f};  ///< the middle of what shows, millimetres of the output
};
/// Tells that a structure hides a part of another, of which one sees the rest.
struct SeenCover {
  model::NodeId before;
  model::NodeId behind;
  float share = 0.0f;  ///< of what would be seen of the one behind if the other were away, 0 … 1
};

/// Which cells of a picture show something.
struct SeenArea {
  SeenGrid grid;
  std::vector<bool> cells;  ///< row by row

  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < grid.columns && y < grid.rows &&
           cells[std::size_t(y) * std::size_t(grid.columns) + std::size_t(x)];
  }
  /// Tells whether a cell that the box touches shows something.
  bool anyIn(const LabelBox& box) const;
};

class SeenMap {
 public:
  /// Draws the visible structures as the screen shows them. What takes long to make of their meshes
  /// is kept in `meshes`, which with the scene must outlive this object.
  SeenMap(const model::Scene& scene, const Screen& screen, model::MeshTrees* meshes = nullptr);

  /// Tells whether the structure is drawn, in the picture or not, and not wholly cut away.
  bool draws(model::NodeId structure) const;
  /// Returns where to point at the structure: on a cut face of its own that shows clearly, inside
  /// it; else on its own fill where nothing else shows, as far as
  /// possible from where that ends; else on its own fill where that is most of what one sees; else
  /// where a dot lies on its own ink and colour more than on others'; else inside it where only the
  /// ground shows. Where it shows nowhere the place is hidden. A place from before, or one that the
  /// user has chosen, is kept where it is as good. Nothing is returned where the structure is not
  /// in the picture.
  /// `near` asks for the nearest to the place before of all that are as good as any, as in films.
  std::optional<SeenPlace> find(model::NodeId structure,
                                const std::optional<model::Anchor>& before = {},
                                bool near = false) const;
  /// Returns a label that names the structure and has its place found anew in each picture, with
  /// the best place of this one; nothing where the structure is not in the picture.
  std::optional<model::Annotation> labelFor(model::NodeId structure) const;
  /// Returns the label with a place that `find` has returned.
  static model::Annotation labelAt(model::NodeId structure, const SeenPlace& place);
  /// Returns what the picture shows of each structure that shows anywhere, the most first.
  std::vector<SeenShare> shares() const;
  /// Returns which structure hides a part of which other, the largest parts first.
  std::vector<SeenCover> covers() const;
  /// Returns where one sees any of the structures rather than others: the one whose colour is
  /// strongest there, whatever lines pass before it; without any colour the nearest.
  SeenArea areaOf(std::span<const model::NodeId> structures) const;
  /// Returns where anything is drawn or surrounded by its outline.
  SeenArea drawnArea() const;
  /// Tells whether the structure is not what one sees at that place of its surface.
  bool hides(model::NodeId structure, const glm::vec3& p) const;
  /// Tells whether a dot at that place of its surface lies on the structure as one sees it, and not
  /// for the most part on what is beside or before it.
  bool showsDot(model::NodeId structure, const glm::vec3& p) const;

 private:
  /// One layer in one cell.
  struct Fragment {
    std::uint32_t layer = 0;
    float depth = 0.0f;
    float reach = 0.0f;   ///< how much of it comes through what is before it
    float colour = 0.0f;  ///< its share of the picture
    float ink = 0.0f;     ///< that of its outline
    float strokes = 0.0f;
    float most() const { return std::max(colour, std::max(ink, strokes)); }
  };
  /// What a structure's cell is worth as a place, and what is known of it.
  enum class Worth : std::uint8_t { none, hidden, slim, ground, outline, most, alone };
  struct Candidates;

  const SeenLayer* layerOf(model::NodeId id) const;
  /// λ (METHOD §4), millimetres of the output.
  float lambda() const { return m_screen.size().y / 720.0f; }
  void compose();
  /// Marks the cells over which something else lies (Screen::covered).
  void cover();
  bool covered(int x, int y) const {
    return !m_covered.empty() &&
           m_covered[std::size_t(y) * std::size_t(m_grid.columns) + std::size_t(x)];
  }
  std::span<const Fragment> fragments(int x, int y) const;
  const SeenCell& cellOf(const Fragment& one, int x, int y) const {
    return m_layers[one.layer].at(x, y);
  }
  Worth worthOf(std::uint32_t layer, int x, int y) const;
  Candidates candidates(std::uint32_t layer) const;
  /// Returns the place before where it is as good as any; `onFace` asks for one on a cut face.
  std::optional<SeenPlace> kept(const Candidates& candidates, const model::Anchor& before,
                                bool onFace) const;
  /// Draws another map's layers into cells of half the size, where outlines are as wide as pens,
  /// with the surfaces and curves that pictures have.
  SeenMap(const SeenMap& other, const SeenGrid& grid);
  void takeSurfaces();
  /// Returns that map, which is made when it is first needed.
  const SeenMap& fine() const;
  /// What a dot would lie on in a fine map.
  struct Dots;
  Dots dots(std::uint32_t layer) const;
  /// How much of a structure one sees in a cell, and of the other of which one sees most.
  struct Shares {
    float own = 0.0f;
    float others = 0.0f;
    float traces = 0.0f;  ///< of it, if it is in front of what it touches
    float rivals = 0.0f;  ///< the chance of another's line, if the structure were away
  };
  Shares sharesAt(const SeenLayer& own, std::uint32_t layer, int x, int y) const;
  /// Returns where a dot lies on the structure's own ink and colour; else, where it shows nowhere,
  /// a hidden place. Of equally good ones it is the one nearest to the place before.
  std::optional<SeenPlace> dotPlace(std::uint32_t layer, const std::optional<model::Anchor>& before,
                                    bool near) const;
  /// Returns the cell that is surest to be hidden.
  std::optional<glm::ivec2> hiddenCell(const Dots& dots) const;
  SeenPlace placeAt(const SeenLayer& own, int x, int y, bool hidden) const;

  const model::Scene& m_scene;
  Screen m_screen;
  SeenGrid m_grid;
  std::vector<SeenLayer> m_layers;  ///< those of visible structures
  std::map<model::NodeId, std::uint32_t> m_index;
  std::vector<std::uint32_t> m_first;  ///< of each cell's fragments, and their end
  std::vector<Fragment> m_fragments;   ///< of each cell from front to back
  std::vector<bool> m_covered;         ///< for each cell; empty where nothing is covered
  mutable std::unique_ptr<SeenMap> m_fine;
  model::MeshTrees* m_meshes;  ///< null: none of others
  mutable model::MeshTrees m_own;
};

}  // namespace sline::render
