// SPDX-License-Identifier: Apache-2.0
// Tests saved views, annotations and the key light as edits.
#include "model/edit/look.h"
#include "model/edit/views.h"
#include "model/scene/cut_place.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <limits>

#include "model/edit/annotations.h"
#include "model/edit/tree.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// Holds a group of two structures and one beside it, with a pin on each.
struct Sample {
  Scene scene;
  NodeId group, one, two, other;
  AnnotationId onOne, onTwo, free;

  Sample() {
    group = scene.append({.name = "G", .style = {.gamma = Gamma::clamped(3)}});
    one = scene.append({.parent = group, .name = "one", .mesh = test::sphere(10, 2)});
    two = scene.append({.parent = group, .name = "two", .mesh = test::sphere(20, 2)});
    other = scene.append({.name = "other", .mesh = test::sphere(30, 2)});
    onOne = pin(SurfacePoint{one, 3, {0.2f, 0.3f}});
    onTwo = pin(SurfacePoint{two, 5, {0, 0}});
    free = pin(glm::vec3(1, 2, 3));
    scene.appendSection({.name = "s", .scope = group});
    View view{.name = "V"};
    view.sections = scene.sections();
    view.looks = {{.node = one, .style = {.visible = false}},
                  {.node = group, .style = {.colour = Colour{1, 2, 3}}}};
    view.annotations = {onOne, free};
    scene.setViews({view});
  }
  AnnotationId pin(const Anchor& anchor) {
    return scene.appendAnnotation({.kind = AnnotationKind::pin, .anchors = {anchor}});
  }
  const View& view() const { return scene.views().front(); }
};

QList<quint64> visiblePins(const Scene& scene) {
  QList<quint64> ids;
  for (const Annotation& annotation : scene.annotations())
    if (annotation.visible)
      ids << annotation.id.value;
  return ids;
}

}  // namespace

class ViewsEditTest : public QObject {
  Q_OBJECT
 private slots:
  void viewShowsWhatItSaysAndLeavesTheRest();
  void viewSpeaksOfWhatIsGone();
  void looksBringBackWhatWasSeen();
  void removedNodesAreForgotten();
  void removedTargetsAreForgotten();
  void placeOnASurface();
  void annotationsThatCannotBe_data();
  void annotationsThatCannotBe();
  void changedAndRemoved();
  void shownInOneViewOrAll();
  void newOnesJoinViews();
  void madeForOneView();
  void viewsWithoutAListOwnNone();
  void onCutFaces();
  void tickedTogether();
  void keyLight();
};

void ViewsEditTest::viewShowsWhatItSaysAndLeavesTheRest() {
  Sample s;
  s.scene.setSections({});
  const AppliedView seen = withViewApplied(s.scene, s.view());
  QVERIFY(seen.absent.empty());
  QCOMPARE(seen.scene.sections(), *s.view().sections);
  QVERIFY(!seen.scene.resolve(s.one).visible);
  QVERIFY(seen.scene.resolve(s.two).visible);
  QCOMPARE(seen.scene.resolve(s.two).colour, (Colour{1, 2, 3}));
  QCOMPARE(seen.scene.resolve(s.two).gamma.value(), 3.0f);  // the view sets no Γ here
  QCOMPARE(visiblePins(seen.scene), (QList<quint64>{s.onOne.value, s.free.value}));
  const Scene plain = withViewApplied(s.scene, {.name = "only a camera"}).scene;
  QVERIFY(plain == s.scene);
}

void ViewsEditTest::viewSpeaksOfWhatIsGone() {
  const Sample s;
  View view = s.view();
  view.looks->push_back({.node = {77}, .style = {.visible = false}});
  view.annotations->push_back({88});
  const AppliedView seen = withViewApplied(s.scene, view);
  QCOMPARE(seen.absent, std::vector<NodeId>{NodeId{77}});
  QVERIFY(seen.scene == withViewApplied(s.scene, s.view()).scene);
}

void ViewsEditTest::looksBringBackWhatWasSeen() {
  Sample s;
  const View view{.name = "as it was", .looks = looksOf(s.scene)};
  Scene changed = withLook(s.scene, std::array{s.group, s.two, s.other},
                           {.colour = Colour{9, 9, 9},
                            .gamma = Gamma::clamped(5),
                            .opacity = Opacity::clamped(0.1f),
                            .fill = Fill::veil,
                            .visible = false,
                            .lineThresholds = ThresholdValues{{"ridges.curvature", 3.0f}},
                            .penWeight = 3.0f,
                            .hatchDensity = HatchDensity::clamped(2),
                            .hatchTone = HatchTone::clamped(0.5f),
                            .gammaMap = GammaMap{.scalar = GammaScalar::distance,
                                                 .targets = {s.one},
                                                 .curve = {{0, 1}, {1, 2}}}})
                      .scene;
  QVERIFY(!changed.resolve(s.two).visible);
  const Scene back = withViewApplied(changed, view).scene;
  for (const NodeId id : {s.one, s.two, s.other})
    QCOMPARE(back.resolve(id), s.scene.resolve(id));
}

void ViewsEditTest::removedTargetsAreForgotten() {
  Sample s;
  const auto toTargets = [](std::vector<NodeId> targets) {
    return Style{.gammaMap = GammaMap{.scalar = GammaScalar::distance,
                                      .targets = std::move(targets),
                                      .curve = {{0, 1}, {1, 2}}}};
  };
  s.scene = withLook(s.scene, std::array{s.other}, toTargets({s.one, s.two})).scene;
  std::vector<View> views = s.scene.views();
  views[0].looks = {{.node = s.other, .style = toTargets({s.one})}};
  s.scene.setViews(views);
  Focus focus;
  focus.given = {{.node = s.other, .style = toTargets({s.two, s.one})}};
  s.scene.setFocus(focus);
  const Scene after = removed(s.scene, std::array{s.one}).scene;
  QCOMPARE(after.find(s.other)->style.gammaMap->targets, std::vector<NodeId>{s.two});
  QVERIFY(!after.views()[0].looks->front().style.gammaMap);
  QCOMPARE(after.focus().given.front().style.gammaMap->targets, std::vector<NodeId>{s.two});
}

void ViewsEditTest::removedNodesAreForgotten() {
  const Sample s;
  const Edited one = removed(s.scene, std::array{s.one});
  QCOMPARE(one.scene.annotations().size(), std::size_t(2));
  QCOMPARE(*one.scene.views()[0].annotations, std::vector<AnnotationId>{s.free});
  QCOMPARE(one.scene.views()[0].looks->size(), std::size_t(1));
  QCOMPARE(one.scene.views()[0].sections->size(), std::size_t(1));
  const Edited all = removed(s.scene, std::array{s.group});
  QCOMPARE(all.scene.annotations().size(), std::size_t(1));
  QVERIFY(all.scene.views()[0].looks->empty() && all.scene.views()[0].sections->empty());
  QVERIFY(all.scene.sections().empty());
  QVERIFY(s.scene.annotations().size() == 3);  // the original value, which undo returns to
  const Edited none = removed(s.scene, std::array{NodeId{99}});
  QVERIFY(!none.changed && none.scene == s.scene);
}

void ViewsEditTest::placeOnASurface() {
  const Sample s;
  const Mesh& mesh = *s.scene.find(s.one)->mesh;
  const Triangle t = mesh.triangles()[3];
  const auto place = s.scene.placeOf(s.scene.annotations()[0].anchors[0]);
  QVERIFY(place);
  const glm::vec3 expected =
      0.5f * mesh.positions()[t[0]] + 0.2f * mesh.positions()[t[1]] + 0.3f * mesh.positions()[t[2]];
  QVERIFY(glm::length(*place - expected) < 1e-5f);
  QVERIFY(!s.scene.placeOf(SurfacePoint{s.group, 0, {}}));
  QVERIFY(!s.scene.placeOf(SurfacePoint{s.one, 1'000'000, {}}));
  QCOMPARE(s.scene.placeOf(glm::vec3(1, 2, 3)), std::optional(glm::vec3(1, 2, 3)));
}

void ViewsEditTest::annotationsThatCannotBe_data() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<int>("anchors");
  QTest::addColumn<float>("number");
  QTest::addColumn<bool>("possible");
  QTest::newRow("a pin") << int(AnnotationKind::pin) << 1 << 0.5f << true;
  QTest::newRow("a pin of no place") << int(AnnotationKind::pin) << 0 << 0.5f << false;
  QTest::newRow("a label of two") << int(AnnotationKind::label) << 2 << 0.5f << false;
  QTest::newRow("a distance") << int(AnnotationKind::distance) << 2 << 0.5f << true;
  QTest::newRow("a distance of one") << int(AnnotationKind::distance) << 1 << 0.5f << false;
  QTest::newRow("beyond its triangle") << int(AnnotationKind::pin) << 1 << 1.5f << false;
  QTest::newRow("before its triangle") << int(AnnotationKind::pin) << 1 << -0.5f << false;
  QTest::newRow("nowhere") << int(AnnotationKind::pin) << 1
                           << std::numeric_limits<float>::quiet_NaN() << false;
}

void ViewsEditTest::annotationsThatCannotBe() {
  QFETCH(int, kind);
  QFETCH(int, anchors);
  QFETCH(float, number);
  QFETCH(bool, possible);
  const Sample s;
  Annotation annotation{.kind = AnnotationKind(kind)};
  for (int i = 0; i < anchors; ++i)
    annotation.anchors.emplace_back(SurfacePoint{s.one, 0, {number, 0}});
  QCOMPARE(!annotationFault(annotation), possible);
  const Edited edited = withAnnotation(s.scene, annotation);
  QCOMPARE(edited.changed, possible);
  QCOMPARE(edited.scene.annotations().size(), std::size_t(possible ? 4 : 3));
  for (Anchor& anchor : annotation.anchors)
    anchor = glm::vec3(number, 1e30f, 0);
  QCOMPARE(withAnnotation(s.scene, annotation).changed,
           std::size_t(anchors) == anchorCount(AnnotationKind(kind)) && !std::isnan(number));
}

void ViewsEditTest::changedAndRemoved() {
  const Sample s;
  Annotation note = s.scene.annotations()[1];
  QVERIFY(!withAnnotationChanged(s.scene, s.onTwo, note).changed);
  note.texts["la"] = "Duo";
  const Edited said = withAnnotationChanged(s.scene, s.onTwo, note);
  QVERIFY(said.changed);
  QCOMPARE(textIn(said.scene.annotations()[1], "la"), std::string("Duo"));
  QCOMPARE(textIn(said.scene.annotations()[1], "en"), note.text);
  note.anchors = {SurfacePoint{s.group, 0, {}}};
  QVERIFY(!withAnnotationChanged(s.scene, s.onTwo, note).changed);
  const Edited gone = withoutAnnotations(s.scene, std::array{s.free, AnnotationId{99}});
  QVERIFY(gone.changed);
  QCOMPARE(*gone.scene.views()[0].annotations, std::vector<AnnotationId>{s.onOne});
  QVERIFY(!withoutAnnotations(s.scene, std::array{AnnotationId{99}}).changed);
}

void ViewsEditTest::shownInOneViewOrAll() {
  Sample s;
  // The second view has no list of annotations: it shows what is visible.
  s.scene.setViews({s.view(), {.name = "W"}});
  using Places = std::vector<std::size_t>;
  QCOMPARE(viewsShowing(s.scene, s.onTwo), (Places{1}));
  QCOMPARE(viewsShowing(s.scene, s.onOne), (Places{0, 1}));
  QVERIFY(!withAnnotationShownIn(s.scene, s.onOne, std::nullopt).changed);
  QVERIFY(!withAnnotationShownIn(s.scene, s.onTwo, 1).changed);
  const Edited second = withAnnotationShownIn(s.scene, s.onOne, 1);
  QVERIFY(second.changed);
  QCOMPARE(viewsShowing(second.scene, s.onOne), (Places{1}));
  const Edited first = withAnnotationShownIn(second.scene, s.onOne, 0);
  QCOMPARE(viewsShowing(first.scene, s.onOne), (Places{0}));
  // The other views do not change, nor does what is seen without a view.
  QCOMPARE(viewsShowing(first.scene, s.onTwo), (Places{1}));
  QCOMPARE(viewsShowing(first.scene, s.free), (Places{0, 1}));
  QCOMPARE(visiblePins(first.scene), visiblePins(s.scene));
  QCOMPARE(viewsShowing(withAnnotationShownIn(first.scene, s.onOne, std::nullopt).scene, s.onOne),
           (Places{0, 1}));
  QVERIFY(findAnnotation(s.scene, s.free)->id == s.free);
  QVERIFY(!findAnnotation(s.scene, AnnotationId{99}));
}

void ViewsEditTest::newOnesJoinViews() {
  Sample s;
  using Places = std::vector<std::size_t>;
  // The first view leaves one out, the second none, the third shows whatever is visible.
  s.scene.setViews(
      {s.view(), {.name = "All", .annotations = {{s.onOne, s.onTwo, s.free}}}, {.name = "W"}});
  const Annotation pin{.kind = AnnotationKind::pin, .anchors = {glm::vec3(4, 5, 6)}};
  const Edited made = withAnnotationForAll(s.scene, pin);
  QVERIFY(made.changed);
  const AnnotationId id = made.scene.annotations().back().id;
  QCOMPARE(viewsShowing(made.scene, id), (Places{1, 2}));
  QVERIFY(!made.scene.views()[2].annotations);
  // This view was saved before there were any annotations.
  Scene bare;
  bare.setViews({viewOf(bare, Camera{}, "V")});
  const Edited first = withAnnotationForAll(bare, pin);
  QCOMPARE(viewsShowing(first.scene, first.scene.annotations().back().id), (Places{0}));
  const Annotation faulty{.kind = AnnotationKind::pin};
  QVERIFY(!withAnnotationMade(s.scene, faulty, 0).changed);
  QVERIFY(!withAnnotationForAll(s.scene, faulty).changed);
}

void ViewsEditTest::madeForOneView() {
  Sample s;
  using Places = std::vector<std::size_t>;
  s.scene.setViews(
      {s.view(), {.name = "All", .annotations = {{s.onOne, s.onTwo, s.free}}}, {.name = "W"}});
  const Places whole = viewsShowing(s.scene, s.onOne);
  const Annotation pin{.kind = AnnotationKind::pin, .anchors = {glm::vec3(4, 5, 6)}};
  for (const std::size_t view : {0, 1, 2}) {
    const Edited made = withAnnotationMade(s.scene, pin, view);
    QCOMPARE(viewsShowing(made.scene, made.scene.annotations().back().id), (Places{view}));
    QCOMPARE(viewsShowing(made.scene, s.onOne), whole);
  }
  // What is made for none is the next view's, and that one's alone.
  const Edited free = withAnnotationMade(s.scene, pin, std::nullopt);
  const AnnotationId id = free.scene.annotations().back().id;
  QCOMPARE(viewsShowing(free.scene, id), Places{});
  QCOMPARE(unclaimedAnnotations(free.scene), std::vector<AnnotationId>{id});
  const Edited added = withNewView(free.scene, Camera{}, "New");
  QVERIFY(added.changed);
  QCOMPARE(*added.scene.views()[3].annotations, std::vector<AnnotationId>{id});
  QCOMPARE(viewsShowing(added.scene, s.onOne), whole);
  for (const Annotation& annotation : added.scene.annotations())
    QCOMPARE(annotation.visible, annotation.id == id);
  QVERIFY(unclaimedAnnotations(added.scene).empty());
  QVERIFY(withNewView(added.scene, Camera{}, "Next").scene.views()[4].annotations->empty());
  // The first view of a scene takes all.
  Scene fresh = s.scene;
  fresh.setViews({});
  QCOMPARE(withNewView(fresh, Camera{}, "First").scene.views()[0].annotations->size(),
           unclaimedAnnotations(fresh).size());
}

/// Where no view chooses among the labels, as in scenes of other programs, a new view has them all;
/// one that is made for such a view is that one's alone.
void ViewsEditTest::viewsWithoutAListOwnNone() {
  Sample s;
  const std::vector<AnnotationId> all = {s.onOne, s.onTwo, s.free};
  s.scene.setViews({{.name = "A"}, {.name = "B"}});
  QCOMPARE(unclaimedAnnotations(s.scene), all);
  const Edited added = withNewView(s.scene, Camera{}, "New");
  QVERIFY(added.changed);
  QCOMPARE(*added.scene.views()[2].annotations, all);
  QCOMPARE(visiblePins(added.scene).size(), all.size());
  QVERIFY(unclaimedAnnotations(added.scene).empty());
  // What one view lists is that one's, and the others' without a list is free.
  s.scene.setViews({{.name = "A"}, {.name = "B", .annotations = {{s.onTwo}}}});
  QCOMPARE(unclaimedAnnotations(s.scene), (std::vector<AnnotationId>{s.onOne, s.free}));
  const Annotation pin{.kind = AnnotationKind::pin, .anchors = {glm::vec3(4, 5, 6)}};
  const Edited made = withAnnotationMade(s.scene, pin, 0);
  const AnnotationId id = made.scene.annotations().back().id;
  QCOMPARE(viewsShowing(made.scene, id), std::vector<std::size_t>{0});
  QVERIFY(unclaimedAnnotations(made.scene).empty());
}

/// A label on the face of a cut belongs to what was cut.
void ViewsEditTest::onCutFaces() {
  const Sample s;
  const Node& one = *s.scene.find(s.one);
  const glm::vec3 place = one.mesh->bounds().centre();
  const Annotation label{.anchors = anchorsOnCut(one, place), .text = "within"};
  QVERIFY(!annotationFault(label));
  QCOMPARE(std::get<SurfacePoint>(label.anchors.front()).structure, s.one);
  QVERIFY(cutPlaceOf(label) && *cutPlaceOf(label) == place);
  QVERIFY(pointedAt(label).size() == 1 && pointedAt(label).front() == Anchor(place));
  QVERIFY(withAnnotation(s.scene, label).changed);
  Annotation wrong = label;
  std::swap(wrong.anchors.front(), wrong.anchors.back());
  QVERIFY(annotationFault(wrong));
  wrong.anchors = {place, place};
  QVERIFY(annotationFault(wrong));
  const Annotation distance{.kind = AnnotationKind::distance, .anchors = label.anchors};
  QVERIFY(!annotationFault(distance) && !cutPlaceOf(distance));
  QCOMPARE(pointedAt(distance).size(), std::size_t(2));
  // The plane through the place cuts there, one beside it does not, one that takes it away neither.
  for (const auto& [shift, cut] : {std::pair(0.0f, true), {50.0f, false}, {-50.0f, false}}) {
    Scene scene = s.scene;
    scene.setSections(
        {{.id = {1}, .plane = {.normal = {1.0f, 0.0f, 0.0f}, .offset = place.x + shift}}});
    QCOMPARE(cutsThrough(scene, s.one, place), cut);
  }
  Scene whole = s.scene;
  whole.setSections({});
  QVERIFY(!cutsThrough(whole, s.one, place));
}

void ViewsEditTest::tickedTogether() {
  Sample s;
  using Places = std::vector<std::size_t>;
  s.scene.setViews({s.view(), {.name = "W"}, {.name = "X"}});
  const std::array both{s.onTwo, s.free};
  const Edited off = withAnnotationsTicked(s.scene, both, std::array<std::size_t, 2>{0, 1}, false);
  QVERIFY(off.changed);
  QCOMPARE(viewsShowing(off.scene, s.onTwo), (Places{2}));
  QCOMPARE(viewsShowing(off.scene, s.free), (Places{2}));
  QCOMPARE(viewsShowing(off.scene, s.onOne), (Places{0, 1, 2}));
  QCOMPARE(visiblePins(off.scene), visiblePins(s.scene));
  QVERIFY(!off.scene.views()[2].annotations);
  const Edited on = withAnnotationsTicked(off.scene, both, std::array<std::size_t, 1>{0}, true);
  QCOMPARE(viewsShowing(on.scene, s.onTwo), (Places{0, 2}));
  QVERIFY(!withAnnotationsTicked(on.scene, both, std::array<std::size_t, 2>{0, 2}, true).changed);
}

void ViewsEditTest::keyLight() {
  const Sample s;
  QVERIFY(!withKeyLight(s.scene, std::nullopt).changed);
  const Edited lit = withKeyLight(s.scene, KeyLight{.shades = true});
  QVERIFY(lit.changed && lit.scene.keyLight()->shades);
  QVERIFY(!withKeyLight(lit.scene, KeyLight{.shades = true}).changed);
  QVERIFY(!withKeyLight(s.scene, KeyLight{.towards = {0, 0, 2}}).changed);
  QVERIFY(!withKeyLight(s.scene, KeyLight{.towards = {NAN, 0, 1}}).changed);
}

SLINE_TEST(ViewsEditTest)
#include "views_edit_test.moc"
