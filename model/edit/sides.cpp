// SPDX-License-Identifier: Apache-2.0
#include "model/edit/sides.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "model/scene/cut_place.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

constexpr SideEvidence settledSides{Evidence::settled, Evidence::settled, Evidence::settled};

bool hasOwnSides(const Provenance& from) {
  return from.frame != fileFrame;
}

bool isDoubted(const Node& node) {
  return !node.isGroup() && hasOwnSides(node.provenance) && !node.provenance.evidence.isSure();
}

/// Tells whether its frame was taken for want of anything clear. What leaves only the side open is
/// read in other axes than its frame names.
bool isAssumed(const Node& node) {
  const Provenance& from = node.provenance;
  return !node.isGroup() && hasOwnSides(from) && !from.transform &&
         from.evidence.sides == Evidence::assumed && from.evidence.front != Evidence::known &&
         from.evidence.front != Evidence::conflict;
}

/// Changes the signs of x, or of y where only the front is in doubt, and of both for a turn.
class Flip {
 public:
  Flip(SideAnswer answer, bool onlyFront)
      : m_signs(answer == SideAnswer::turn || (answer == SideAnswer::mirror && !onlyFront) ? -1.0f
                                                                                           : 1.0f,
                answer == SideAnswer::turn || (answer == SideAnswer::mirror && onlyFront) ? -1.0f
                                                                                          : 1.0f,
                1.0f) {}

  bool changes() const { return m_signs.x < 0.0f || m_signs.y < 0.0f; }
  bool mirrors() const { return m_signs.x * m_signs.y < 0.0f; }
  glm::vec3 of(const glm::vec3& p) const { return p * m_signs; }

  /// Returns the mesh moved; one that structures share is shared afterwards, too.
  MeshPtr of(const MeshPtr& mesh) {
    MeshPtr& moved = m_meshes[mesh];
    if (moved)
      return moved;
    std::vector<glm::vec3> positions(mesh->positions().begin(), mesh->positions().end());
    std::vector<Triangle> triangles(mesh->triangles().begin(), mesh->triangles().end());
    for (glm::vec3& p : positions)
      p = of(p);
    if (mirrors())
      for (Triangle& triangle : triangles)
        std::swap(triangle[1], triangle[2]);
    moved = std::make_shared<const Mesh>(
        Mesh::create(std::move(positions), std::move(triangles)).value());
    return moved;
  }

  KeptAtoms of(const KeptAtoms& atoms) const {
    if (!atoms.set)
      return atoms;
    auto moved = std::make_shared<AtomSet>(*atoms.set);
    for (AtomBall& atom : moved->atoms)
      atom.place = of(atom.place);
    return {std::move(moved)};
  }

  /// Changes what is told of the file, so that reading it again leads to the same place.
  void tell(Provenance& from) const {
    const auto swap = [&from](std::size_t letter, char one, char other) {
      if (from.frame.size() > letter)
        from.frame[letter] = from.frame[letter] == one ? other : one;
    };
    if (m_signs.x < 0.0f)
      swap(0, 'L', 'R');
    if (m_signs.y < 0.0f)
      swap(1, 'P', 'A');
    if (from.transform)
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
          (*from.transform)[std::size_t(row) * 4 + std::size_t(column)] *=
              m_signs[row] * (column < 3 ? m_signs[column] : 1.0f);
  }

  void move(Camera& camera) const {
    camera.eye = of(camera.eye);
    camera.target = of(camera.target);
    camera.up = of(camera.up);
  }
  void move(Style& style) const {
    if (style.gammaMap && style.gammaMap->place)
      style.gammaMap->place = of(*style.gammaMap->place);
  }
  void move(Focus& focus) const {
    if (focus.seenFrom)
      move(*focus.seenFrom);
    if (focus.nearness && focus.nearness->place)
      focus.nearness->place = of(*focus.nearness->place);
    for (Look& look : focus.given)
      move(look.style);
  }
  void move(Scan& scan) const {
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        scan.toLps[column][row] *= double(m_signs[row]);
  }
  void move(Plane& plane) const { plane.normal = of(plane.normal); }

 private:
  glm::vec3 m_signs;
  std::map<MeshPtr, MeshPtr> m_meshes;
};

/// Moves, and marks as settled, what an answer is about.
class Settling {
 public:
  Settling(const Scene& scene, SideAnswer answer)
      : m_scene(scene), m_flip(answer, isOnlyFrontDoubted(scene)) {}
  /// Decides anew of what was assumed alone.
  Settling(const Scene& scene, SideAnswer answer, const FrameAnew& anew)
      : m_scene(scene), m_flip(answer, false), m_anew(&anew) {}

  Scene run() {
    findMoved();
    if (m_moved.empty() && m_scene.scans().empty())
      return m_scene;
    Scene after = m_scene;
    if (m_flip.changes()) {
      after.setAnnotations(annotations());
      after.setSections(sections(m_scene.sections()));
      if (m_whole)
        moveWhole(after);
      else
        after.setViews(viewsWithSections());
    }
    after.setNodes(nodes());
    after.setScans(scans());
    return after;
  }

 private:
  void findMoved() {
    const bool all = !m_anew && !hasDoubtedSides(m_scene);
    const auto isMeant = [&](const Node& node) {
      return all ? hasOwnSides(node.provenance) : m_anew ? isAssumed(node) : isDoubted(node);
    };
    m_whole = true;
    for (const Node& node : m_scene.nodes()) {
      if (node.isGroup())
        continue;
      if (isMeant(node))
        m_moved.insert(node.id);
      else
        m_whole = m_whole && !hasOwnSides(node.provenance);
    }
    for (const Scan& scan : m_scene.scans())
      m_whole = m_whole && (all || !scan.evidence.isSure());
    m_all = all;
  }

  std::vector<Node> nodes() {
    std::vector<Node> nodes = m_scene.nodes();
    for (Node& node : nodes) {
      if (m_whole)
        m_flip.move(node.style);
      if (!m_moved.contains(node.id))
        continue;
      if (m_flip.changes()) {
        node.mesh = m_flip.of(node.mesh);
        node.atoms = m_flip.of(node.atoms);
        m_flip.tell(node.provenance);
      }
      tell(node.provenance);
    }
    return nodes;
  }

  void tell(Provenance& from) const {
    from.evidence = evidence();
    from.frameReason = m_anew             ? std::string_view(m_anew->reason)
                       : m_flip.mirrors() ? mirroredFrame
                       : m_flip.changes() ? turnedFrame
                                          : confirmedFrame;
  }
  SideEvidence evidence() const { return m_anew ? m_anew->evidence : settledSides; }

  std::vector<Scan> scans() const {
    std::vector<Scan> scans = m_scene.scans();
    for (Scan& scan : scans)
      if (m_all || !scan.evidence.isSure()) {
        m_flip.move(scan);
        scan.evidence = evidence();
      }
    return scans;
  }

  /// Places on surfaces go with these; their weights change with the triangles' corners.
  std::vector<Annotation> annotations() const {
    std::vector<Annotation> annotations = m_scene.annotations();
    for (Annotation& annotation : annotations) {
      // The place on a cut face goes with what is cut there.
      const auto* cut =
          cutPlaceOf(annotation) ? std::get_if<SurfacePoint>(&annotation.anchors.front()) : nullptr;
      const bool goesAlong = m_whole || (cut && m_moved.contains(cut->structure));
      for (Anchor& anchor : annotation.anchors) {
        auto* point = std::get_if<SurfacePoint>(&anchor);
        if (point && m_flip.mirrors() && m_moved.contains(point->structure))
          std::swap(point->weights[0], point->weights[1]);
        else if (!point && goesAlong)
          anchor = m_flip.of(std::get<glm::vec3>(anchor));
      }
    }
    return annotations;
  }

  std::vector<Section> sections(std::vector<Section> sections) const {
    for (Section& section : sections)
      if (m_whole || cutsOnlyMoved(section))
        m_flip.move(section.plane);
    return sections;
  }

  bool cutsOnlyMoved(const Section& section) const {
    if (section.scope == rootId)
      return false;
    const std::vector<NodeId> cut = m_scene.structuresBelow(section.scope);
    return !cut.empty() &&
           std::all_of(cut.begin(), cut.end(), [this](NodeId id) { return m_moved.contains(id); });
  }

  std::vector<View> viewsWithSections() const {
    std::vector<View> views = m_scene.views();
    for (View& view : views)
      if (view.sections)
        view.sections = sections(std::move(*view.sections));
    return views;
  }

  void moveWhole(Scene& scene) const {
    std::vector<View> views = viewsWithSections();
    for (View& view : views) {
      m_flip.move(view.camera);
      if (view.focus)
        m_flip.move(*view.focus);
      if (view.looks)
        for (Look& look : *view.looks)
          m_flip.move(look.style);
    }
    scene.setViews(std::move(views));
    Focus focus = scene.focus();
    m_flip.move(focus);
    scene.setFocus(std::move(focus));
  }

  const Scene& m_scene;
  Flip m_flip;
  const FrameAnew* m_anew = nullptr;
  std::set<NodeId> m_moved;
  bool m_whole = false;  ///< nothing else is sure of its sides
  bool m_all = false;    ///< nothing is in doubt: everything is moved
};

Edited withNamesSettled(const Scene& scene) {
  std::vector<Node> nodes = scene.nodes();
  bool changed = false;
  for (Node& node : nodes)
    if (isNameDoubted(node)) {
      node.provenance.nameEvidence = Evidence::settled;
      changed = true;
    }
  if (!changed)
    return {scene, false};
  Scene after = scene;
  after.setNodes(std::move(nodes));
  return {std::move(after), true};
}

/// Returns the least sure of each direction in all that has sides, visible or not.
SideEvidence leastSure(const Scene& scene) {
  SideEvidence least;
  const auto add = [&least](const SideEvidence& more) {
    least.sides = std::max(least.sides, more.sides);
    least.front = std::max(least.front, more.front);
    least.up = std::max(least.up, more.up);
  };
  for (const Node& node : scene.nodes())
    if (isDoubted(node))
      add(node.provenance.evidence);
  for (const Scan& scan : scene.scans())
    add(scan.evidence);
  return least;
}

}  // namespace

bool hasDoubtedSides(const Scene& scene) {
  const auto& nodes = scene.nodes();
  const auto& scans = scene.scans();
  return std::any_of(nodes.begin(), nodes.end(), isDoubted) ||
         std::any_of(scans.begin(), scans.end(),
                     [](const Scan& scan) { return !scan.evidence.isSure(); });
}

bool hasDoubtedNames(const Scene& scene) {
  const auto& nodes = scene.nodes();
  return std::any_of(nodes.begin(), nodes.end(), isNameDoubted);
}

bool isOnlyFrontDoubted(const Scene& scene) {
  const SideEvidence least = leastSure(scene);
  return isSure(least.sides) && !isSure(least.front);
}

bool isOnlyUpDoubted(const Scene& scene) {
  const SideEvidence least = leastSure(scene);
  return isSure(least.sides) && isSure(least.front) && !isSure(least.up);
}

Edited withSidesSettled(const Scene& scene, SideAnswer answer) {
  if (answer == SideAnswer::right && !hasDoubtedSides(scene))
    return withNamesSettled(scene);
  Scene after = Settling(scene, answer).run();
  const bool changed = !(after == scene);
  return {std::move(after), changed};
}

std::vector<const Node*> withAssumedFrame(const Scene& scene) {
  std::vector<const Node*> assumed;
  for (const Node& node : scene.nodes())
    if (isAssumed(node))
      assumed.push_back(&node);
  const auto isOther = [&assumed](const Node* node) {
    return node->provenance.frame != assumed.front()->provenance.frame;
  };
  if (std::any_of(assumed.begin(), assumed.end(), isOther))
    assumed.clear();
  return assumed;
}

std::optional<SideAnswer> answerBetween(std::string_view frame, std::string_view other) {
  if (frame.size() != 3 || other.size() != 3)
    return std::nullopt;
  const bool left = frame[0] != other[0];
  const bool back = frame[1] != other[1];
  if (back)
    return left ? std::optional(SideAnswer::turn) : std::nullopt;
  return left ? SideAnswer::mirror : SideAnswer::right;
}

Edited withFrameAnew(const Scene& scene, const FrameAnew& anew) {
  const std::vector<const Node*> assumed = withAssumedFrame(scene);
  const auto answer =
      assumed.empty() ? std::nullopt : answerBetween(assumed.front()->provenance.frame, anew.frame);
  if (!answer)
    return {scene, false};
  Scene after = Settling(scene, *answer, anew).run();
  const bool changed = !(after == scene);
  return {std::move(after), changed};
}

}  // namespace sline::model
