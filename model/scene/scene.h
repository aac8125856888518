// SPDX-License-Identifier: Apache-2.0
// Defines the scene as a value: a tree of groups and structures with their styles, copied freely
// because meshes sit behind shared pointers. An edit is a function Scene → Scene (model/edit); undo
// is the previous value; code that draws or saves takes a copy and needs no lock.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/atom_set.h"
#include "model/geometry/mesh.h"
#include "model/geometry/paint.h"
#include "model/scene/annotation.h"
#include "model/scene/credit.h"
#include "model/scene/evidence.h"
#include "model/scene/focus.h"
#include "model/scene/light.h"
#include "model/scene/look.h"
#include "model/scene/node_id.h"
#include "model/scene/scan.h"
#include "model/scene/section.h"
#include "model/scene/source_trace.h"
#include "model/scene/style.h"
#include "model/scene/wording.h"

namespace sline::model {

/// Identifies a file's bytes, to see later whether the file has changed.
struct Fingerprint {
  std::uint64_t bytes = 0;  ///< the file's length
  std::uint32_t crc = 0;    ///< CRC-32 (IEEE 802.3)
  bool operator==(const Fingerprint&) const = default;
};

/// Holds the range of a scan's intensities from which a structure was made; a missing bound leaves
/// that side open.
struct IntensityRange {
  std::optional<float> low;
  std::optional<float> high;
  bool operator==(const IntensityRange&) const = default;
};

/// Holds what was measured on a structure before import changed it.
struct ReadExtent {
  std::optional<float> areaMm2;    ///< absent where there was no surface, but voxels
  std::optional<float> volumeMm3;  ///< absent where the surface was not closed
  bool operator==(const ReadExtent&) const = default;
};

/// Says where a structure came from and what import did to it.
struct Provenance {
  std::string file;   ///< file name without its folder, or "#" and a checksum of it
  std::string frame;  ///< how the file's coordinates were read, a name of `frames` (laterality.h)
  std::string frameReason;  ///< what decided the frame
  SideEvidence evidence;    ///< how sure that is
  /// Says how sure it is that the structure lies on the side that its name says.
  Evidence nameEvidence = Evidence::known;
  int smoothingSteps = 0;    ///< 0: the mesh is the file's own
  int refinementSteps = 0;   ///< Loop subdivisions
  int repairedFaces = 0;     ///< turned, removed as duplicates or without area
  float displacementMm = 0;  ///< the farthest any vertex moved
  float sliceMm = 0;       ///< between the slices it was cut from, whose steps drawings leave out;
                           ///< 0: none show
  float mmPerUnit = 1;     ///< the length taken for the file's unit
  std::string unitReason;  ///< what decided the unit
  Evidence unitEvidence = Evidence::known;  ///< how sure that is
  int decimatedFrom = 0;                    ///< triangles before decimation; 0: there was none
  float decimationMm = 0;  ///< the farthest that decimation moved the surface, as measured
  std::string part;        ///< which of the file's surfaces; empty if it has only one
  std::optional<Fingerprint> fingerprint;     ///< fingerprint of the file
  std::optional<IntensityRange> intensities;  ///< set where the file is a scan
  /// The transform that a scene around the file applied: the rows of an affine map of RAS
  /// millimetres.
  std::optional<std::array<float, 12>> transform;
  SourceCredit credit;  ///< as its file or the folder around it says, or as a person does
  /// Set where import smoothed, refined or decimated what it read; absent in older scenes, too.
  std::optional<ReadExtent> asRead;
  bool operator==(const Provenance&) const = default;
};

/// The colour that a drawing style gave a structure, and what the structure said of its colour
/// before: as long as it has the one, it can have the other back.
struct DrawnColour {
  Colour given;
  std::optional<Colour> had;  ///< absent: that of the group above
  bool operator==(const DrawnColour&) const = default;
};

/// A node is a group (no mesh) or a structure (a mesh).
struct Node {
  NodeId id;
  NodeId parent = rootId;
  std::string name;
  Style style;
  bool locked = false;  ///< true: this and everything below it cannot be picked or changed by hand
  MeshPtr mesh;         ///< null for a group
  PaintPtr paint;       ///< one value for each vertex of the mesh; null: nothing was painted
  Provenance provenance;
  KeptAtoms atoms;  ///< of a molecule's chain
  std::optional<DrawnColour> drawn;
  std::string unread;  ///< further keys of its scene file, as a JSON object; kept for saving

  bool isGroup() const { return !mesh; }
  bool operator==(const Node&) const = default;
};

/// What is said where a saved view is shown.
struct ViewWords {
  Wording title;                 ///< without one, the view's name is its title
  Wording text;                  ///< to be read with the picture, marked up as in markup.h
  Wording notes;                 ///< for who presents it, plain but for links
  Wording description;           ///< of the picture for who does not see it, plain; without one it
                                 ///< is made of what the picture shows (render/description)
  std::optional<float> seconds;  ///< how long it is shown; absent: as long as others
  bool operator==(const ViewWords&) const = default;
};
inline constexpr Limits<float> viewSecondsLimits{0.1f, 3600.0f};

/// A saved view leaves what it does not mention as the scene has it.
struct View {
  std::string name;
  Camera camera;
  std::optional<std::vector<Section>> sections;
  std::optional<std::vector<Look>> looks;                ///< at most one for each node
  std::optional<std::vector<AnnotationId>> annotations;  ///< those shown; all others are hidden
  std::optional<Focus> focus;                            ///< without targets: nothing is in focus
  ViewWords words;
  std::string unread;  ///< like Node::unread
  bool operator==(const View&) const = default;
};
/// Returns what a view is called where it is shown, in the language.
const std::string& titleIn(const View& view, const std::string& language);

/// A scene lists its nodes in tree order: a parent before its children, siblings in their order on
/// screen.
class Scene {
 public:
  const std::vector<Node>& nodes() const { return m_nodes; }
  const std::vector<View>& views() const { return m_views; }
  const std::vector<Section>& sections() const { return m_sections; }
  const std::vector<Annotation>& annotations() const { return m_annotations; }
  /// Returns the key light; where it is absent, the renderer decides.
  const std::optional<KeyLight>& keyLight() const { return m_keyLight; }
  const Focus& focus() const { return m_focus; }

  /// Returns the node, or null where there is none of that id (or for the root). As quick as a
  /// search in a sorted list.
  const Node* find(NodeId id) const;
  std::vector<NodeId> children(NodeId parent) const;
  /// Returns every structure at or below the node, in tree order; the root means all.
  std::vector<NodeId> structuresBelow(NodeId id) const;
  /// Returns every structure at or below any of the nodes, each once, in tree order.
  std::vector<NodeId> structuresBelow(std::span<const NodeId> ids) const;
  /// Tells whether the node is the ancestor itself or stands below it.
  bool isBelow(NodeId id, NodeId ancestor) const;
  /// Returns "Group / Subgroup" above the node; empty at the top.
  std::string groupPath(NodeId id) const;
  /// Returns the style with inheritance applied: the nearest answer upwards wins; a hidden group
  /// hides everything below it.
  ResolvedStyle resolve(NodeId id) const;
  /// Returns the structures and groups of that name (case and the difference between space, '_' and
  /// '-' are ignored).
  std::vector<NodeId> named(std::string_view name) const;
  /// Returns the box around all visible structures at or below the node; empty where there are
  /// none.
  Box visibleBounds(NodeId id = rootId) const;
  /// Tells whether the node itself or a group above it is locked.
  bool isLocked(NodeId id) const;
  /// Returns the enabled sections that cut the node, its own and those of the groups above it.
  std::vector<Section> sectionsOf(NodeId id) const;

  /// Appends a node after the last descendant of its parent and gives it a fresh id.
  NodeId append(Node node);
  /// Replaces the nodes; asserts that ids are unique and parents come first.
  void setNodes(std::vector<Node> nodes);
  void setViews(std::vector<View> views) { m_views = std::move(views); }
  /// Appends a section and gives it a fresh id.
  SectionId appendSection(Section section);
  /// Replaces the sections; asserts that ids are unique and planes without fault.
  void setSections(std::vector<Section> sections);
  /// Returns the place of the anchor in LPS, millimetres; absent where its structure or triangle is
  /// not in the scene.
  std::optional<glm::vec3> placeOf(const Anchor& anchor) const;
  /// Appends an annotation and gives it a fresh id.
  AnnotationId appendAnnotation(Annotation annotation);
  /// Replaces the annotations; asserts that ids are unique and annotations without fault.
  void setAnnotations(std::vector<Annotation> annotations);
  void setKeyLight(std::optional<KeyLight> light) { m_keyLight = std::move(light); }
  void setFocus(Focus focus) { m_focus = std::move(focus); }
  /// Returns the scans kept with the scene; each is without fault.
  const std::vector<Scan>& scans() const { return m_scans; }
  void setScans(std::vector<Scan> scans);
  /// Returns what tells whether further files are of the same patient.
  const std::vector<SourceTrace>& traces() const { return m_traces; }
  void setTraces(std::vector<SourceTrace> traces) { m_traces = std::move(traces); }
  /// Returns the unread keys of the file as a whole, like Node::unread.
  const std::string& unread() const { return m_unread; }
  void setUnread(std::string unread) { m_unread = std::move(unread); }

  bool operator==(const Scene&) const = default;

 private:
  /// Holds where a node is; places are sorted by id.
  struct NodeIndex {
    std::uint64_t id = 0;
    std::size_t index = 0;  ///< index in m_nodes
    auto operator<=>(const NodeIndex&) const = default;
  };
  std::vector<NodeIndex>::const_iterator placeBefore(std::uint64_t id) const;
  void index();

  std::vector<Node> m_nodes;
  std::vector<NodeIndex> m_places;
  std::vector<View> m_views;
  std::vector<Section> m_sections;
  std::vector<Annotation> m_annotations;
  std::optional<KeyLight> m_keyLight;
  Focus m_focus;
  std::vector<Scan> m_scans;
  std::vector<SourceTrace> m_traces;
  std::string m_unread;
  std::uint64_t m_lastId = 0;
  std::uint64_t m_lastSectionId = 0;
  std::uint64_t m_lastAnnotationId = 0;
};

/// Returns the meshes of all structures, each once.
std::set<MeshPtr> meshesOf(const Scene& scene);

/// Returns the name in the form in which names are compared: lower case, '_' and '-' as spaces,
/// runs of spaces as one.
std::string normalisedName(std::string_view name);

}  // namespace sline::model
