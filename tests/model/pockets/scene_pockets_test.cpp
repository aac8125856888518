// SPDX-License-Identifier: Apache-2.0
// Tests the pockets of molecules in a scene: what lies in them, which are the same, and one in
// focus.
#include "model/pockets/scene_pockets.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/edit/tree.h"
#include "model/pockets/pocket_focus.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

bool goesOn() {
  return true;
}

/// Returns atoms around hollows of those radii, 25 mm from each other along x.
KeptAtoms hollows(const std::vector<double>& radii, const std::string& chain) {
  auto set = std::make_shared<AtomSet>();
  for (std::size_t i = 0; i < radii.size(); ++i) {
    for (const double layer : {1.5, 2.7}) {
      const double reach = radii[i] + layer;
      const int count = int(4.0 * M_PI * reach * reach / 0.5);
      for (int k = 0; k < count; ++k) {
        const double z = 1.0 - 2.0 * (k + 0.5) / count;
        const double turn = 2.39996323 * k;
        const double across = std::sqrt(1.0 - z * z);
        set->atoms.push_back({glm::vec3(25.0 * double(i) + reach * across * std::cos(turn),
                                        reach * across * std::sin(turn), reach * z),
                              1.5f, std::uint32_t(i)});
      }
    }
    set->residues.push_back("GLY " + chain + " " + std::to_string(i + 1));
  }
  return {std::move(set)};
}

struct Made {
  Scene scene;
  NodeId entry, chain, ligand;
};

/// Returns a molecule with a ligand of two structures in its first hollow.
Made molecule(const std::vector<double>& radii) {
  Made made;
  made.entry = made.scene.append({.name = "1ABC – Made up"});
  Node chain{.parent = made.entry, .name = "Chain A", .mesh = test::sphere(8, 3)};
  chain.atoms = hollows(radii, "A");
  made.chain = made.scene.append(chain);
  const NodeId ligands = made.scene.append({.parent = made.entry, .name = "Ligands"});
  made.ligand = made.scene.append({.parent = ligands, .name = "ATP"});
  for (const float at : {-1.0f, 1.0f})
    made.scene.append({.parent = made.ligand,
                       .name = "element",
                       .mesh = test::moved(*test::sphere(1, 2), 1.0f, glm::vec3(at, 0, 0))});
  return made;
}

double volumeOf(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles())
    sum += double(glm::dot(mesh.positions()[t[0]],
                           glm::cross(mesh.positions()[t[1]], mesh.positions()[t[2]]))) /
           6.0;
  return sum;
}

}  // namespace

class ScenePocketsTest : public QObject {
  Q_OBJECT
 private slots:
  void guestsAndLining() {
    const Made made = molecule({4.0, 3.0});
    const auto found = pocketsIn(made.scene, {}, goesOn);
    QVERIFY(found.ok());
    QCOMPARE(found->pockets.size(), std::size_t(2));
    QCOMPARE(found->pockets[0].number, 1);
    QCOMPARE(found->pockets[0].guests, std::vector<NodeId>{made.ligand});
    QCOMPARE(found->lining(found->pockets[0]), std::vector<std::string>{"GLY A 1"});
    QVERIFY(found->pockets[1].guests.empty());
    QCOMPARE(found->lining(found->pockets[1]), std::vector<std::string>{"GLY A 2"});
  }

  void needsAtoms() {
    Scene scene;
    scene.append({.name = "liver", .mesh = test::sphere(8, 3)});
    const auto found = pocketsIn(scene, {}, goesOn);
    QVERIFY(!found.ok());
    QVERIFY(found.error().reason.find("keeps the atoms") != std::string::npos);
  }

  /// Of two molecules laid over each other, hollows in the same place have the same number, though
  /// their order by volume is another; a hollow that only one has gets a number of its own.
  void laidOverEachOther() {
    Made made = molecule({4.0, 3.5});
    const NodeId second = made.scene.append({.name = "2ABC – Other state"});
    Node chain{.parent = second, .name = "Chain B", .mesh = test::sphere(8, 3)};
    chain.atoms = hollows({3.0, 4.2, 2.8}, "B");
    made.scene.append(chain);
    const auto found = pocketsIn(made.scene, {}, goesOn);
    QVERIFY(found.ok());
    QCOMPARE(found->molecules.size(), std::size_t(2));
    std::vector<std::tuple<int, std::size_t, int>> rows;
    for (const ScenePocket& pocket : found->pockets)
      rows.emplace_back(pocket.number, pocket.molecule,
                        int(std::lround(pocket.pocket.centre.x / 25.0)));
    const std::vector<std::tuple<int, std::size_t, int>> expected{
        {1, 0, 0}, {1, 1, 0}, {2, 0, 1}, {2, 1, 1}, {3, 1, 2}};
    QVERIFY(rows == expected);
  }

  /// A pocket that has moved is the same where the residues at its wall are.
  void knownByItsResidues() {
    Made made = molecule({4.0});
    const NodeId second = made.scene.append({.name = "2ABC"});
    Node chain{.parent = second, .name = "Chain A", .mesh = test::sphere(8, 3)};
    auto moved = std::make_shared<AtomSet>(*hollows({4.0}, "A").set);
    for (AtomBall& atom : moved->atoms)
      atom.place.y += 40.0f;
    chain.atoms.set = moved;
    const NodeId other = made.scene.append(chain);
    auto found = pocketsIn(made.scene, {}, goesOn);
    QCOMPARE(found->pockets.back().number, 1);
    auto renamed = std::make_shared<AtomSet>(*moved);
    renamed->residues = {"TRP C 7"};
    std::vector<Node> nodes = made.scene.nodes();
    for (Node& node : nodes)
      if (node.id == other)
        node.atoms.set = renamed;
    made.scene.setNodes(nodes);
    found = pocketsIn(made.scene, {}, goesOn);
    QCOMPARE(found->pockets.back().number, 2);
  }

  void roomIsClosedAndAsLarge() {
    const Made made = molecule({4.0});
    const auto found = pocketsIn(made.scene, {}, goesOn);
    const MeshPtr room = pocketBody(found->molecules[0].grid, found->pockets[0].pocket);
    QVERIFY(room);
    const double share = volumeOf(*room) / found->pockets[0].pocket.volume;
    QVERIFY2(std::abs(share - 1.0) < 0.08, qPrintable(QString::number(share)));
  }

  void inFocus() {
    const Made made = molecule({4.0, 3.0});
    const auto found = pocketsIn(made.scene, {}, goesOn);
    const MeshPtr room = pocketBody(found->molecules[0].grid, found->pockets[0].pocket);
    const Edited edited = withPocketInFocus(made.scene, *found, 0, room);
    QVERIFY(edited.changed);
    const auto rooms = edited.scene.named("Pocket 1");
    QCOMPARE(rooms.size(), std::size_t(1));
    QVERIFY(!edited.scene.resolve(rooms[0]).visible);
    const ResolvedStyle wall = edited.scene.resolve(made.chain);
    QCOMPARE(wall.gammaMap.scalar, GammaScalar::distance);
    QCOMPARE(wall.gammaMap.targets, rooms);
    QVERIFY(wall.gamma.value() + wall.gammaMap.offsetAt(0.0f) > 4.0f);
    QVERIFY(wall.gamma.value() + wall.gammaMap.offsetAt(6.0f) < 2.0f);
    QCOMPARE(edited.scene.resolve(edited.scene.structuresBelow(made.ligand)[0]).gamma.value(),
             5.0f);
    // Another pocket takes its place; the same one again makes no second room.
    const Edited again = withPocketInFocus(edited.scene, *found, 0, room);
    QCOMPARE(again.scene.nodes().size(), edited.scene.nodes().size());
    const Edited without =
        withPocketInFocus(removed(made.scene, std::vector{made.entry}).scene, *found, 0, room);
    QVERIFY(!without.changed);
  }

  void viewLooksThroughTheMouth() {
    ScenePocket pocket;
    pocket.pocket.volume = 500.0;
    pocket.pocket.centre = {1, 2, 3};
    pocket.pocket.outwards = {0, 0, 1};
    const Camera camera = viewIntoPocket(pocket, {});
    QVERIFY(!cameraFault(camera));
    QVERIFY(camera.eye.z > 3.0f && std::abs(camera.eye.x - 1.0f) < 1e-3f);
    QCOMPARE(camera.target, glm::vec3(1, 2, 3));
  }
};

SLINE_TEST(ScenePocketsTest)
#include "scene_pockets_test.moc"
