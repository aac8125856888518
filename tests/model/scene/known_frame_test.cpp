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
    QVERIFY(drawnUnit(scene) == DrawnUnit::millimetre);
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
    const NodeId organ = scene.append(
        structure("liver.stl", "LPS", std::string("assumed") + std::string(unlikelySizes)));
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
};

SLINE_TEST(KnownFrameTest)
#include "known_frame_test.moc"
