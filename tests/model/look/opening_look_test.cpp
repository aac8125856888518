// SPDX-License-Identifier: Apache-2.0
// Tests the look that a scene opens with on small scenes whose answer is plain to see.
#include "model/look/opening_look.h"

#include <QTest>

#include "model/base/contrast.h"
#include "model/edit/look.h"
#include "model/edit/visibility.h"
#include "model/focus/tissues.h"
#include "model/scene/resolved_styles.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

class OpeningLookTest : public QObject {
  Q_OBJECT

  static constexpr Colour ivory{248, 234, 214};

  static NodeId add(Scene& scene, const char* name, float radius, const glm::vec3& at,
                    const Colour& colour = {200, 120, 90}) {
    Node node{.name = name};
    node.mesh = test::moved(*test::sphere(radius, 3), 1.0f, at);
    node.style.colour = colour;
    return scene.append(std::move(node));
  }
  /// A liver with a tumour and its vein, a vertebra behind, ribs in front at either side.
  static Scene body() {
    Scene scene;
    add(scene, "liver", 40.0f, {0, 0, 0});
    add(scene, "portal vein", 6.0f, {0, 0, -47}, {40, 60, 180});
    add(scene, "vertebra L1", 20.0f, {0, 80, 0}, ivory);
    add(scene, "vertebra L2", 20.0f, {0, 80, -45}, ivory);
    add(scene, "left rib 9", 12.0f, {60, -20, 0}, ivory);
    add(scene, "right rib 9", 12.0f, {-60, -30, 10}, ivory);
    add(scene, "rectus abdominis muscle", 30.0f, {0, -90, 0}, {100, 42, 36});
    return scene;
  }
  static std::string firstTitle(const Scene& scene) { return subjectsOf(scene).front().title; }
  static OpeningLook look(const Scene& scene, const OpeningWishes& wishes = {}) {
    FormIndex forms;
    return *openingLook(scene, forms, wishes);
  }
  static ResolvedStyle styleOf(const Scene& scene, const char* name) {
    return scene.resolve(scene.named(name).front());
  }

 private slots:
  void subjects() {
    Scene scene = body();
    QCOMPARE(firstTitle(scene), std::string("organs"));
    add(scene, "liver tumour", 10.0f, {10, 0, 0});
    QCOMPARE(firstTitle(scene), std::string("lesions"));
    scene = withOnlyVisible(scene, scene.named("liver")).scene;
    QCOMPARE(firstTitle(scene), std::string("everything"));
    QVERIFY(subjectsOf(Scene()).empty());
  }
  /// Limbs as a whole are what the body is seen by, as its skin is, and not what a picture is
  /// about.
  void armsAreTheBodys() {
    Scene scene = body();
    for (const char* arm : {"left arm", "right arm"})
      add(scene, arm, 55.0f, {arm[0] == 'l' ? 200.0f : -200.0f, 0, 0});
    add(scene, "soft tissue of humerus", 30.0f, {200, 0, 90});
    QCOMPARE(firstTitle(scene), std::string("organs"));
    const OpeningLook opened = look(scene);
    const Tissues tissues = tissuesOf(scene);
    for (const char* name : {"left arm", "right arm", "soft tissue of humerus"}) {
      QCOMPARE(tissues.at(scene.named(name).front().value), Tissue::skin);
      QVERIFY(styleOf(opened.scene, name).gamma < styleOf(opened.scene, "liver").gamma);
    }
    // Nor do they make a subject of their own where nothing else is known.
    Scene alone;
    add(alone, "arms", 60.0f, {0, 0, 0});
    add(alone, "humerus", 20.0f, {0, 0, 0});
    QCOMPARE(firstTitle(alone), std::string("bones"));
  }
  /// A look that nobody asked for leaves nothing out, however far it lies and whatever it is.
  void leavesNothingOut_data() {
    QTest::addColumn<double>("far");
    QTest::addColumn<double>("size");
    for (const double far : {0.0, 45.0, 90.0, 300.0, 900.0})
      for (const double size : {4.0, 30.0, 120.0})
        QTest::addRow("%.0f mm at %.0f mm", size, far) << far << size;
  }
  void leavesNothingOut() {
    QFETCH(double, far);
    QFETCH(double, size);
    for (const bool sick : {true, false}) {
      Scene scene = body();
      if (sick)
        add(scene, "liver tumour", 10.0f, {10, 0, 0});
      add(scene, "screw", float(size), {0, 0.2f * float(far), float(far)});
      add(scene, "lesion of nobody knows what", float(size), {0, float(far), 0});
      const OpeningLook opened = look(scene);
      for (const Node& node : scene.nodes()) {
        const ResolvedStyle style = opened.scene.resolve(node.id);
        QVERIFY2(style.visible && style.opacity.value() > 0.0f, node.name.c_str());
      }
    }
  }
  void ligandsComeFirst() {
    Scene scene;
    const NodeId ligands = scene.append({.name = "Ligands"});
    add(scene, "ANP", 5.0f, {0, 0, 0});
    std::vector<Node> nodes = scene.nodes();
    nodes.back().parent = ligands;
    scene.setNodes(std::move(nodes));
    add(scene, "Chain A", 40.0f, {0, 0, 0});
    QCOMPARE(firstTitle(scene), std::string("ligands"));
  }
  /// What lines a ligand's pocket is hidden until the ligand is the subject, and then in detail;
  /// the view is one from where the chain does not hide the ligand.
  void pocketsOpen() {
    Scene scene;
    const NodeId chain = add(scene, "Chain A", 40.0f, {0, 0, 0});
    const NodeId ligand = add(scene, "ANP carbon", 5.0f, {30, 30, 30});
    const NodeId pocket = add(scene, "ANP pocket", 12.0f, {19, 19, 19});
    const NodeId ligands = scene.append({.name = "Ligands"});
    std::vector<Node> nodes = scene.nodes();
    nodes[2].style.visible = false;
    std::swap(nodes[1], nodes[3]);
    nodes[3].parent = ligands;
    scene.setNodes(std::move(nodes));
    const Subject subject = subjectsOf(scene).front();
    QCOMPARE(subject.structures, (std::vector{ligand, pocket}));
    QCOMPARE(subject.pockets, std::vector{pocket});
    const OpeningLook opened = look(scene);
    QVERIFY(styleOf(opened.scene, "ANP pocket").visible);
    QVERIFY(styleOf(opened.scene, "ANP pocket").gamma.value() > 4.0f);
    QVERIFY(styleOf(opened.scene, "Chain A").gamma.value() < 4.0f);
    QVERIFY(!opened.view);
    const glm::vec3 eye = glm::normalize(opened.camera.eye - opened.camera.target);
    QVERIFY(glm::dot(eye, glm::normalize(glm::vec3(1.0f))) > 0.0f);
    const Scene without = withHidden(scene, {&ligand, 1}).scene;
    QVERIFY(subjectsOf(without).front().pockets.empty());
    QVERIFY(styleOf(opened.scene, "Chain A").visible && scene.find(chain));
  }
  void theSecondVersionIsHidden() {
    Scene scene = body();
    const NodeId second = add(scene, "liver 2", 41.0f, {0, 0, 1});
    const OpeningLook opened = look(scene);
    QCOMPARE(opened.subject.structures, scene.named("liver"));
    QVERIFY(!styleOf(opened.scene, "liver 2").visible && styleOf(opened.scene, "liver").visible);
    std::vector<Node> nodes = scene.nodes();
    nodes.back().locked = true;
    scene.setNodes(std::move(nodes));
    QVERIFY(scene.find(second)->locked && styleOf(look(scene).scene, "liver 2").visible);
  }
  void vesselsInAnOrgan() {
    Scene scene;
    add(scene, "liver", 60.0f, {0, 0, 0});
    for (const char* vessel : {"portal vein", "hepatic artery", "middle hepatic vein"})
      add(scene, vessel, 8.0f, {float(scene.nodes().size()) * 9.0f - 25.0f, 0, 0});
    const Subject subject = subjectsOf(scene).front();
    QCOMPARE(subject.structures.size(), std::size_t(3));
    const OpeningLook opened = look(scene);
    QVERIFY(styleOf(opened.scene, "liver").gamma.value() < 1.0f);
  }
  /// Where names tell nothing, what lies inside another surface is what the picture is about.
  void hullsOfNamelessSurfaces() {
    Scene scene;
    const NodeId skin = add(scene, "surface 1", 60.0f, {0, 0, 0});
    const NodeId skull = add(scene, "surface 2", 50.0f, {0, 0, 0});
    const Subject subject = subjectsOf(scene).front();
    QCOMPARE(subject.title, std::string("what lies inside"));
    QCOMPARE(subject.structures, std::vector{skull});
    const OpeningLook opened = look(scene);
    QVERIFY(opened.scene.resolve(skin).gamma.value() < 1.0f);
    QVERIFY(opened.scene.resolve(skull).gamma.value() > 4.0f);
    // A copy is no hull, and neither is a neighbour; a name that says something decides.
    Scene copies;
    add(copies, "surface 1", 60.0f, {0, 0, 0});
    add(copies, "surface 2", 60.0f, {0, 0, 0});
    QCOMPARE(firstTitle(copies), std::string("everything"));
    Scene beside;
    add(beside, "surface 1", 60.0f, {0, 0, 0});
    add(beside, "surface 2", 20.0f, {90, 0, 0});
    QCOMPARE(firstTitle(beside), std::string("everything"));
    add(scene, "liver", 20.0f, {0, 0, 0});
    QCOMPARE(firstTitle(scene), std::string("organs"));
  }
  void subjectsAreNamedOnceEach() {
    const std::vector<Subject> all = subjectsOf(body());
    QVERIFY(all.back().everything && all.size() > 3);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        QVERIFY(all[i].structures != all[k].structures);
  }

  void subjectInDetailContextQuiet() {
    const OpeningLook opened = look(body());
    const ResolvedStyle liver = styleOf(opened.scene, "liver");
    QVERIFY(liver.gamma.value() > 4.0f && liver.fill == Fill::paper);
    // What is in front is a silhouette, what is behind is filled.
    QVERIFY(styleOf(opened.scene, "rectus abdominis muscle").gamma.value() < 0.5f);
    QVERIFY(styleOf(opened.scene, "rectus abdominis muscle").fill == Fill::none);
    const ResolvedStyle bone = styleOf(opened.scene, "vertebra L1");
    QVERIFY(bone.gamma.value() > 3.0f && bone.fill == Fill::paper);
    QVERIFY(opened.view == AnatomicalView::anterior);
  }
  void kinIsTreatedAlike() {
    const OpeningLook opened = look(body());
    for (const auto& [a, b] :
         {std::pair("left rib 9", "right rib 9"), std::pair("vertebra L1", "vertebra L2")}) {
      ResolvedStyle one = styleOf(opened.scene, a);
      ResolvedStyle other = styleOf(opened.scene, b);
      QCOMPARE(one, other);
    }
  }
  void inksAreLegible() {
    const OpeningLook opened = look(body());
    for (const ResolvedStructure& each : resolvedBelow(opened.scene, std::array{rootId})) {
      QVERIFY(each.style.inkColour);
      QVERIFY(contrastBetween({255, 255, 255}, *each.style.inkColour) >= 4.5);
    }
    Scene grey = body();
    std::vector<Node> nodes = grey.nodes();
    for (Node& node : nodes)
      node.style.colour = Colour{255, 255, 255};
    grey.setNodes(std::move(nodes));
    QVERIFY(!styleOf(look(grey).scene, "liver").inkColour);  // black where no colour tells anything
  }
  void viewThatShowsMost() {
    Scene scene;
    add(scene, "liver", 30.0f, {0, 0, 0});
    add(scene, "sternum", 80.0f, {0, -115, 0}, ivory);
    QVERIFY(look(scene).view != AnatomicalView::anterior);
    QVERIFY(look(scene, {.view = AnatomicalView::left}).view == AnatomicalView::left);
    const Camera camera = anatomicalCamera(AnatomicalView::superior, scene.visibleBounds(), 1.0f);
    QVERIFY(look(scene, {.camera = camera}).camera == camera);
  }
  void sameSceneSameLook() {
    const Scene scene = body();
    QVERIFY(look(scene).scene == look(scene).scene);
    QVERIFY(look(scene).camera == look(scene).camera);
  }
  void theUsersChoicesStay() {
    Scene scene = body();
    scene = withOnlyVisible(scene, std::vector{scene.named("liver").front(),
                                               scene.named("vertebra L1").front()})
                .scene;
    const OpeningLook opened = look(scene);
    QVERIFY(!styleOf(opened.scene, "portal vein").visible);
    QCOMPARE(styleOf(opened.scene, "liver").colour, (Colour{200, 120, 90}));
  }
  void onlyASceneWithoutALookIsDressed() {
    const Scene scene = body();
    const Scene opened = dressed(scene);
    QVERIFY(!hasNoLook(opened) && opened.nodes() == look(scene).scene.nodes());
    const NodeId liver = scene.named("liver").front();
    const Scene chosen = withLook(scene, {&liver, 1}, {.gamma = Gamma::clamped(2.0f)}).scene;
    QVERIFY(dressed(chosen) == chosen);
  }
  void aSceneThatSaysItsLook() {
    Scene scene = body();
    QVERIFY(hasNoLook(scene));
    const NodeId liver = scene.named("liver").front();
    QVERIFY(!hasNoLook(withLook(scene, {&liver, 1}, {.gamma = Gamma::clamped(2.0f)}).scene));
    QVERIFY(!hasNoLook(withLook(scene, {&liver, 1}, {.fill = Fill::none}).scene));
    QVERIFY(hasNoLook(withLook(scene, {&liver, 1}, {.colour = Colour{1, 2, 3}}).scene));
    QVERIFY(!hasNoLook(look(scene).scene));
    View view{.name = "front"};
    scene.setViews({view});
    QVERIFY(hasNoLook(scene));
    view.looks = std::vector<Look>{{.node = liver, .style = {.gamma = Gamma::clamped(1.0f)}}};
    scene.setViews({view});
    QVERIFY(!hasNoLook(scene));
  }
  void stops() {
    FormIndex forms;
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!openingLook(body(), forms, {}, stop.get_token()));
    QVERIFY(!openingLook(Scene(), forms));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::OpeningLookTest)
#include "opening_look_test.moc"
