// SPDX-License-Identifier: Apache-2.0
#include "model/scene/known_frame.h"

#include <QtTest>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

Node structure(const char* file, const char* frame, std::string_view unitReason) {
  Node node;
  node.name = file;
  node.mesh = test::sphere(10.0f, 1);
  node.provenance.file = file;
  node.provenance.frame = frame;
  node.provenance.unitReason = unitReason;
  return node;
}

Node molecule() {
  return structure("1crn.pdb", "file", angstromReason);
}

}  // namespace

class KnownFrameTest : public QObject {
  Q_OBJECT
 private slots:
  void moleculesAreDrawnInAngstroms() {
    Scene scene;
    QVERIFY(drawnUnit(scene) == DrawnUnit::millimetre);
    scene.append(molecule());
    QVERIFY(drawnUnit(scene) == DrawnUnit::angstrom);
    QVERIFY(!hasSides(scene));
    // What the program made beside it changes nothing.
    scene.append(structure("", "file", ""));
    QVERIFY(drawnUnit(scene) == DrawnUnit::angstrom);
  }

  void besideAnOrganNobodyMeasuresInAngstroms() {
    Scene scene;
    scene.append(molecule());
    const NodeId organ = scene.append(structure("liver.stl", "LPS", "the file says so"));
    QVERIFY(drawnUnit(scene) == DrawnUnit::doubtedMillimetre);
    QVERIFY(hasSides(scene));
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes)
      if (node.id == organ)
        node.style.visible = false;
    scene.setNodes(std::move(nodes));
    QVERIFY(drawnUnit(scene) == DrawnUnit::angstrom);
    QVERIFY(!hasSides(scene));
  }

  void aDoubtedUnitIsSaidWithEachLength() {
    Scene scene;
    scene.append(structure("spleen.stl", "LPS", "the file says so"));
    Node liver = structure("liver.stl", "LPS", "assumed");
    liver.provenance.unitEvidence = Evidence::conflict;
    const NodeId organ = scene.append(std::move(liver));
    QVERIFY(drawnUnit(scene) == DrawnUnit::doubtedMillimetre);
    QCOMPARE(symbolOf(drawnUnit(scene)), std::string_view("mm?"));
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes)
      if (node.id == organ)
        node.style.visible = false;
    scene.setNodes(std::move(nodes));
    QVERIFY(drawnUnit(scene) == DrawnUnit::millimetre);
  }

  void sidesAreThoseOfFilesThatSayThem() {
    Scene scene;
    QVERIFY(hasSides(scene));
    scene.append(structure("bone.obj", "file", ""));
    QVERIFY(!hasSides(scene));
    QVERIFY(drawnUnit(scene) == DrawnUnit::millimetre);
  }

  void theLeastSureCounts() {
    Scene scene;
    QVERIFY(!knownSides(scene).inDoubt());
    scene.append(structure("liver.ply", "LPS", ""));
    QVERIFY(!knownSides(scene).inDoubt());
    Node guessed = structure("growth.stl", "LPS", "");
    guessed.provenance.evidence = {Evidence::assumed, Evidence::known};
    const NodeId growth = scene.append(guessed);
    QVERIFY(knownSides(scene).inDoubt());
    QVERIFY(knownSides(scene).inDoubt(0));
    QVERIFY(!knownSides(scene).inDoubt(1));
    QVERIFY(!knownSides(scene).inDoubt(2));
    // What is not seen does not count.
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes)
      if (node.id == growth)
        node.style.visible = false;
    scene.setNodes(std::move(nodes));
    QVERIFY(!knownSides(scene).inDoubt());
    Scan scan{.name = "MR", .size = {1, 1, 1}, .evidence = {Evidence::assumed, Evidence::known}};
    scan.voxels = std::make_shared<const std::vector<std::int16_t>>(1);
    scene.setScans({scan});
    QVERIFY(knownSides(scene).inDoubt(0));
  }

  /// Files of older programs give only the reason.
  void reasonsOfOlderFiles() {
    const auto sides = [](std::string_view reason) { return evidenceOfReason(reason).sides; };
    QVERIFY(sides("header: SPACE in a comment") == Evidence::known);
    QVERIFY(sides("") == Evidence::known);
    QVERIFY(sides("modelled in it") == Evidence::known);
    QVERIFY(sides("chosen by the user") == Evidence::settled);
    QVERIFY(sides("no header and no left/right names: LPS assumed") == Evidence::assumed);
    QVERIFY(sides("vote: 20 of 22 left/right names") == Evidence::voted);
    QVERIFY(sides("vote: 3 of 4 left/right names") == Evidence::voted);
    QVERIFY(sides("vote: 2 of 3 left/right names") == Evidence::assumed);
    QVERIFY(sides("vote: 1 of 1 left/right names") == Evidence::assumed);
  }
};

SLINE_TEST(KnownFrameTest)
#include "known_frame_test.moc"
