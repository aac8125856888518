// SPDX-License-Identifier: Apache-2.0
#include "model/look/subjects.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include "model/anatomy/body_systems.h"
#include "model/anatomy/name_words.h"
#include "model/focus/twins.h"
#include "model/look/hulls.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

struct Member {
  NodeId id;
  std::string name;
  Tissue tissue = Tissue::unknown;
  std::string system;  ///< the title of its system, or empty
  MeshPtr mesh;
  bool ligand = false;
};

bool says(const std::string& name, std::string_view word) {
  const std::vector<std::string> words = nameWords(name);
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<Member> membersOf(const Scene& scene) {
  static const AnatomyTable table;
  const Tissues tissues = tissuesOf(scene);
  const std::vector<Twins> twins = twinsOf(scene);
  std::vector<Member> members;
  for (const VisibleStructure& visible : visibleStructures(scene)) {
    const Node& node = *visible.node;
    if (std::any_of(twins.begin(), twins.end(),
                    [&node](const Twins& each) { return each.second == node.id; }))
      continue;
    Member member{.id = node.id,
                  .name = node.name,
                  .tissue = tissues.at(node.id.value),
                  .system = {},
                  .mesh = node.mesh,
                  .ligand = false};
    std::vector<const Node*> above{&node};
    while (const Node* parent = scene.find(above.back()->parent))
      above.push_back(parent);
    for (const Node* each : above) {
      member.ligand = member.ligand || says(each->name, "ligand");
      if (const auto match = table.match(each->name); match && member.system.empty())
        member.system = table.systems()[match->system].title;
    }
    members.push_back(std::move(member));
  }
  return members;
}

double volumeOf(const Box& box) {
  const glm::dvec3 size(box.high - box.low);
  return size.x * size.y * size.z;
}

bool isInside(const Box& box, const Box& around) {
  return glm::all(glm::lessThanEqual(around.low, box.low)) &&
         glm::all(glm::lessThanEqual(box.high, around.high));
}

/// Returns the structures that line the pocket of a ligand which is visible, hidden or not; both
/// begin with the ligand's code.
std::vector<NodeId> pocketsOf(const Scene& scene, const std::vector<Member>& members) {
  std::vector<NodeId> pockets;
  for (const Node& node : scene.nodes()) {
    constexpr std::string_view ending = " pocket";
    if (node.isGroup() || !node.name.ends_with(ending))
      continue;
    const std::string code = node.name.substr(0, node.name.size() - ending.size() + 1);
    if (std::any_of(members.begin(), members.end(),
                    [&](const Member& m) { return m.ligand && m.name.starts_with(code); }))
      pockets.push_back(node.id);
  }
  return pockets;
}

class Finder {
 public:
  Finder(std::vector<Member> members, std::vector<NodeId> pockets)
      : m_members(std::move(members)), m_pockets(std::move(pockets)) {}

  std::vector<Subject> find() {
    addLigands();
    add("lesions", [](const Member& m) { return m.tissue == Tissue::lesion; });
    addOrgans();
    addWhatLiesInside();
    add("joints", [](const Member& m) { return m.tissue == Tissue::joint; });
    add("vessels and nerves", isVessel);
    add("bones", [](const Member& m) { return m.tissue == Tissue::bone; });
    addSystems();
    addEverything();
    return std::move(m_subjects);
  }

 private:
  /// Adds the members that `wanted` picks, unless they are all or none, or a subject already.
  void add(const std::string& title, const std::function<bool(const Member&)>& wanted) {
    Subject subject{.title = title, .structures = {}, .everything = false};
    for (const Member& member : m_members)
      if (wanted(member))
        subject.structures.push_back(member.id);
    const bool known = std::any_of(m_subjects.begin(), m_subjects.end(), [&](const Subject& s) {
      return s.structures == subject.structures;
    });
    if (!subject.structures.empty() && subject.structures.size() < m_members.size() && !known)
      m_subjects.push_back(std::move(subject));
  }

  void addLigands() {
    const auto isPocket = [this](const Member& m) {
      return std::find(m_pockets.begin(), m_pockets.end(), m.id) != m_pockets.end();
    };
    const auto others =
        std::size_t(std::count_if(m_members.begin(), m_members.end(),
                                  [&](const Member& m) { return !m.ligand && !isPocket(m); }));
    if (others == 0)
      return;
    add("ligands", [](const Member& m) { return m.ligand; });
    if (m_subjects.empty())
      return;
    Subject& ligands = m_subjects.front();
    ligands.pockets = m_pockets;
    ligands.structures.insert(ligands.structures.end(), m_pockets.begin(), m_pockets.end());
  }

  void addEverything() {
    Subject all{.title = "everything", .structures = {}, .everything = true};
    for (const Member& member : m_members)
      all.structures.push_back(member.id);
    const bool known = std::any_of(m_subjects.begin(), m_subjects.end(),
                                   [](const Subject& subject) { return subject.everything; });
    if (!all.structures.empty() && !known)
      m_subjects.push_back(std::move(all));
  }

  static bool isVessel(const Member& m) {
    return m.tissue == Tissue::vessel || m.tissue == Tissue::nerve;
  }

  /// Organs are what a scene is about, unless they are the hull of what it shows: then it is about
  /// the vessels in them, or about one organ with its parts.
  void addOrgans() {
    const auto isOrgan = [](const Member& m) { return m.tissue == Tissue::organ; };
    Box organs;
    for (const Member& member : m_members)
      if (isOrgan(member))
        organs.add(member.mesh->bounds());
    Box whole = organs;
    std::size_t others = 0;
    std::size_t inside = 0;
    for (const Member& member : m_members)
      if (!isOrgan(member)) {
        whole.add(member.mesh->bounds());
        ++others;
        inside += isInside(member.mesh->bounds(), organs);
      }
    constexpr double most = 0.8;
    if (others > 0 && double(inside) > most * double(others) &&
        volumeOf(organs) > most * volumeOf(whole)) {
      const auto vessels = std::count_if(m_members.begin(), m_members.end(), isVessel);
      if (2 * std::size_t(vessels) > others)
        add("what lies in the organs", [&](const Member& m) { return !isOrgan(m); });
      else
        addEverything();
    }
    add("organs", isOrgan);
  }

  /// Where no name tells what a structure is, hulls are around what the scene is about.
  void addWhatLiesInside() {
    const auto isKnown = [](const Member& m) { return m.tissue != Tissue::unknown || m.ligand; };
    if (std::any_of(m_members.begin(), m_members.end(), isKnown))
      return;
    std::vector<MeshPtr> meshes;
    for (const Member& member : m_members)
      meshes.push_back(member.mesh);
    const std::vector<std::size_t> hulls = hullsAmong(meshes);
    add("what lies inside", [&](const Member& m) {
      return std::none_of(hulls.begin(), hulls.end(),
                          [&](std::size_t hull) { return m_members[hull].id == m.id; });
    });
  }

  void addSystems() {
    std::vector<std::string> titles;
    for (const Member& member : m_members)
      if (!member.system.empty() &&
          std::find(titles.begin(), titles.end(), member.system) == titles.end())
        titles.push_back(member.system);
    for (const std::string& title : titles)
      add(title, [&](const Member& m) { return m.system == title; });
  }

  std::vector<Member> m_members;
  std::vector<NodeId> m_pockets;
  std::vector<Subject> m_subjects;
};

}  // namespace

std::vector<Subject> subjectsOf(const Scene& scene) {
  std::vector<Member> members = membersOf(scene);
  std::vector<NodeId> pockets = pocketsOf(scene, members);
  return Finder(std::move(members), std::move(pockets)).find();
}

}  // namespace sline::model
