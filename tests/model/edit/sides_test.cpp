// SPDX-License-Identifier: Apache-2.0
// Tests that sides are settled, mirrored and turned with all that belongs to them.
#include "model/edit/sides.h"

#include <QtTest>
#include <glm/geometric.hpp>

#include "model/scene/known_frame.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

constexpr SideEvidence guess{Evidence::assumed, Evidence::assumed};

Node bodyAt(const char* name, const glm::vec3& place, const SideEvidence& evidence) {
  Node node;
  node.name = name;
  node.mesh = test::moved(*test::sphere(10.0f, 1), 1.0f, place);
  node.provenance.file = "body.stl";
  node.provenance.frame = "LPS";
  node.provenance.frameReason = nothingTellsFrame;
  node.provenance.evidence = evidence;
  return node;
}

/// Returns a scene in which everything that has a place has one.
Scene furnished(const SideEvidence& evidence) {
  Scene scene;
  const NodeId id = scene.append(bodyAt("left kidney", {-50, 30, 20}, evidence));
  scene.appendAnnotation({.kind = AnnotationKind::label,
                          .anchors = {SurfacePoint{id, 3, {0.25f, 0.5f}}},
                          .text = "on it"});
  scene.appendAnnotation(
      {.kind = AnnotationKind::label, .anchors = {glm::vec3(-40, 20, 10)}, .text = "beside it"});
  scene.appendSection({.name = "cut", .plane = anatomicalPlane(AnatomicalView::left, -48.0f)});
  View view{.name = "mine", .camera = anatomicalCamera(AnatomicalView::left, {}, 1.0f)};
  view.camera.target = {-50, 30, 20};
  view.sections = scene.sections();
  view.focus = Focus{.targets = {id}, .nearness = FocusNearness{.place = glm::vec3(-45, 1, 2)}};
  scene.setViews({view});
  Scan scan{.name = "CT", .size = {1, 1, 2}, .evidence = evidence};
  scan.toLps[3] = {-60, 10, 5, 1};
  scan.voxels = std::make_shared<const std::vector<std::int16_t>>(2);
  scene.setScans({scan});
  return scene;
}

const Node& only(const Scene& scene) {
  return scene.nodes().front();
}

bool facesOutward(const Mesh& mesh) {
  const glm::vec3 middle = mesh.bounds().centre();
  for (const Triangle& t : mesh.triangles()) {
    const auto p = mesh.positions();
    const glm::vec3 normal = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    if (glm::dot(normal, p[t[0]] - middle) <= 0.0f)
      return false;
  }
  return true;
}

}  // namespace

class SidesTest : public QObject {
  Q_OBJECT
 private slots:
  void confirmingMovesNothing() {
    const Scene scene = furnished(guess);
    QVERIFY(hasDoubtedSides(scene));
    QVERIFY(knownSides(scene).inDoubt());
    const Edited edited = withSidesSettled(scene, SideAnswer::right);
    QVERIFY(edited.changed);
    QVERIFY(!hasDoubtedSides(edited.scene));
    QVERIFY(only(edited.scene).mesh == only(scene).mesh);
    QVERIFY(only(edited.scene).provenance.evidence.sides == Evidence::settled);
    QCOMPARE(only(edited.scene).provenance.frame, std::string("LPS"));
    QVERIFY(!withSidesSettled(edited.scene, SideAnswer::right).changed);
  }

  /// Where names have told the sides, a mirror image has its front at the back.
  void onlyTheFrontIsMirrored() {
    const Scene scene = furnished({Evidence::voted, Evidence::assumed});
    QVERIFY(isOnlyFrontDoubted(scene));
    QVERIFY(!isOnlyFrontDoubted(furnished(guess)));
    QVERIFY(!isOnlyFrontDoubted(furnished({})));
    const Scene lying = furnished({Evidence::voted, Evidence::voted, Evidence::assumed});
    QVERIFY(isOnlyUpDoubted(lying) && !isOnlyFrontDoubted(lying));
    QVERIFY(!isOnlyUpDoubted(scene));
    QVERIFY(!hasDoubtedSides(withSidesSettled(lying, SideAnswer::right).scene));
    const Edited edited = withSidesSettled(scene, SideAnswer::mirror);
    QVERIFY(edited.changed);
    const Node& node = only(edited.scene);
    QVERIFY(glm::length(node.mesh->bounds().centre() - glm::vec3(-50, -30, 20)) < 1e-3f);
    QVERIFY(facesOutward(*node.mesh));
    QCOMPARE(node.provenance.frame, std::string("LAS"));
    QVERIFY(!hasDoubtedSides(edited.scene));
  }

  void everythingMoves_data() {
    QTest::addColumn<int>("answer");
    QTest::addColumn<float>("y");  // the sign of y afterwards
    QTest::addColumn<QString>("frame");
    QTest::newRow("mirror") << int(SideAnswer::mirror) << 1.0f << "RPS";
    QTest::newRow("turn") << int(SideAnswer::turn) << -1.0f << "RAS";
  }
  void everythingMoves() {
    QFETCH(int, answer);
    QFETCH(float, y);
    QFETCH(QString, frame);
    const Scene scene = furnished(guess);
    const Scene after = withSidesSettled(scene, SideAnswer(answer)).scene;
    const auto moved = [y](const glm::vec3& p) { return p * glm::vec3(-1.0f, y, 1.0f); };
    const auto isAt = [&](const glm::vec3& now, const glm::vec3& before) {
      return glm::length(now - moved(before)) < 1e-4f;
    };
    QVERIFY(isAt(only(after).mesh->bounds().centre(), {-50, 30, 20}));
    QVERIFY(facesOutward(*only(after).mesh));
    QCOMPARE(QString::fromStdString(only(after).provenance.frame), frame);
    for (std::size_t i = 0; i < 2; ++i)
      QVERIFY(isAt(*after.placeOf(after.annotations()[i].anchors[0]),
                   *scene.placeOf(scene.annotations()[i].anchors[0])));
    // What was kept of the body is kept.
    const glm::vec3 inside(-49, 30, 20);
    QVERIFY(scene.sections()[0].plane.keeps(inside) ==
            after.sections()[0].plane.keeps(moved(inside)));
    QVERIFY(after.views()[0].sections == after.sections());
    QVERIFY(isAt(after.views()[0].camera.target, {-50, 30, 20}));
    QVERIFY(isAt(after.views()[0].camera.eye, scene.views()[0].camera.eye));
    QVERIFY(isAt(*after.views()[0].focus->nearness->place, {-45, 1, 2}));
    const glm::dvec4 corner = after.scans()[0].toLps * glm::dvec4(0, 0, 1, 1);
    QVERIFY(isAt(glm::vec3(corner), {-60, 10, 6}));
    QVERIFY(!hasDoubtedSides(after));
  }

  void twiceIsNothing() {
    constexpr SideEvidence settled{Evidence::settled, Evidence::settled};
    for (const SideAnswer answer : {SideAnswer::mirror, SideAnswer::turn}) {
      const Scene scene = furnished(settled);
      const Edited once = withSidesSettled(scene, answer);
      QVERIFY(once.changed);
      Scene twice = withSidesSettled(once.scene, answer).scene;
      QVERIFY(*only(twice).mesh == *only(scene).mesh);
      QVERIFY(twice.annotations() == scene.annotations());
      QVERIFY(twice.sections() == scene.sections());
      QVERIFY(twice.views() == scene.views());
      QVERIFY(twice.scans()[0].toLps == scene.scans()[0].toLps);
      QCOMPARE(only(twice).provenance.frame, only(scene).provenance.frame);
    }
  }

  /// What is sure of its sides stays, and all that belongs to no structure stays with it.
  void onlyWhatIsInDoubtMoves() {
    Scene scene = furnished(guess);
    scene.setScans({});
    scene.append(bodyAt("liver", {-70, -20, 0}, {}));
    const Scene after = withSidesSettled(scene, SideAnswer::mirror).scene;
    QCOMPARE(after.nodes()[0].mesh->bounds().centre().x, 50.0f);
    QVERIFY(after.nodes()[1].mesh == scene.nodes()[1].mesh);
    QVERIFY(after.sections() == scene.sections());
    QVERIFY(after.annotations()[1] == scene.annotations()[1]);
    QVERIFY(glm::length(*after.placeOf(after.annotations()[0].anchors[0]) -
                        *scene.placeOf(scene.annotations()[0].anchors[0]) * glm::vec3(-1, 1, 1)) <
            1e-4f);
    QVERIFY(after.views()[0].camera == scene.views()[0].camera);
  }

  void moleculesHaveNoSides() {
    Scene scene;
    Node node = bodyAt("chain", {10, 0, 0}, {});
    node.provenance.frame = fileFrame;
    scene.append(node);
    scene.appendAnnotation(
        {.kind = AnnotationKind::label, .anchors = {glm::vec3(1, 2, 3)}, .text = "there"});
    for (const SideAnswer answer : {SideAnswer::right, SideAnswer::mirror, SideAnswer::turn})
      QVERIFY(!withSidesSettled(scene, answer).changed);
  }
};

SLINE_TEST(SidesTest)
#include "sides_test.moc"
