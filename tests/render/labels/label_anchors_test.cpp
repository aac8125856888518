// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <glm/geometric.hpp>

#include "model/edit/look.h"
#include "model/scene/cut_place.h"
#include "render/labels/anchors.h"
#include "render/labels/seen/seen_look.h"
#include "render/labels/seen/seen_map.h"
#include "tests/render/labels/shown_labels.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;
using sline::test::front;
using sline::test::paper;
using sline::test::point;
using sline::test::shown;

namespace {

/// Holds a large sphere and a small one before its middle, as seen from the front.
struct Two {
  model::Scene scene;
  model::NodeId large;
  model::NodeId small;
};

Two twoSpheres() {
  Two two;
  model::Node large{.name = "large", .mesh = test::sphere(40.0f, 4)};
  large.style.gamma = Gamma::clamped(5.0f);
  two.large = two.scene.append(large);
  model::Node small{.name = "small",
                    .mesh = test::moved(*test::sphere(1.0f, 3), 15.0f, {0.0f, -60.0f, 0.0f})};
  small.style.gamma = Gamma::clamped(5.0f);
  two.small = two.scene.append(small);
  return two;
}

/// Returns a plate across the line of sight: its ranges of x and z, and its y.
model::Node plate(const glm::vec2& x, const glm::vec2& z, float depth) {
  const auto mesh = model::Mesh::create(
      {{x[0], depth, z[0]}, {x[1], depth, z[0]}, {x[1], depth, z[1]}, {x[0], depth, z[1]}},
      {{0, 1, 2}, {0, 2, 3}});
  model::Node node{.name = "plate", .mesh = std::make_shared<const model::Mesh>(*mesh)};
  node.style.gamma = Gamma::clamped(5.0f);
  return node;
}

model::Scene styled(const model::Scene& scene, model::NodeId node, const model::Style& style) {
  return model::withLook(scene, std::vector{node}, style).scene;
}

}  // namespace

class LabelAnchorsTest : public QObject {
  Q_OBJECT
 private slots:
  void screenAndSightAgree() {
    for (const auto projection :
         {model::Projection::perspective, model::Projection::orthographic}) {
      model::Camera camera = front();
      camera.projection = projection;
      const Screen screen(camera, paper);
      const model::Ray ray = screen.sight({70.0f, 33.0f});
      const auto place = screen.place(ray.origin + 350.0f * ray.direction);
      QVERIFY(place);
      QVERIFY(glm::length(*place - glm::vec2(70.0f, 33.0f)) < 1e-3f);
    }
    QVERIFY(!Screen(front(), paper).place({0.0f, -500.0f, 0.0f}));
  }

  void hiddenByAnother() {
    Two two = twoSpheres();
    point(two.scene, two.large, {0.0f, -1.0f, 0.0f});
    point(two.scene, two.large, {0.6f, -0.8f, 0.0f});
    QVERIFY(shown(two.scene)[0].item.hidden);
    QVERIFY(!shown(two.scene)[1].item.hidden);
  }

  /// A label on the face of a cut points at that very place as long as the cut is there, and
  /// belongs to what was cut: without the cut its name points at the structure, other words into
  /// it.
  void onTheFaceOfACut() {
    const Two two = twoSpheres();
    const glm::vec3 place(12.0f, 0.0f, 9.0f);
    model::Scene scene = two.scene;
    for (const auto& [text, found] : {std::pair("large", true), {"core", false}})
      scene.appendAnnotation({.anchors = model::anchorsOnCut(*scene.find(two.large), place),
                              .text = text,
                              .found = found});
    const auto cut = [&scene](float y, float normal) {
      model::Scene now = scene;
      now.setSections(
          {{.id = {1}, .plane = {.normal = {0.0f, normal, 0.0f}, .offset = normal * y}}});
      return shown(now);
    };
    const Screen screen(front(), paper);
    const std::vector<ShownLabel> onFace = cut(0.0f, -1.0f);  // the front half is gone
    QCOMPARE(onFace.size(), std::size_t(2));
    for (const ShownLabel& label : onFace) {
      QVERIFY(!label.item.hidden);
      QVERIFY(glm::distance(label.item.places.front(), *screen.place(place)) < 1e-3f);
    }
    const std::vector<ShownLabel> whole = shown(scene);
    QCOMPARE(whole.size(), std::size_t(2));
    QVERIFY(!whole[0].item.hidden);
    QVERIFY(whole[1].item.hidden);
    QVERIFY(glm::distance(whole[1].item.places.front(), *screen.place(place)) < 1e-3f);
    // Another cut takes the place away: the name goes to what is left, other words go with it.
    const std::vector<ShownLabel> gone = cut(20.0f, -1.0f);
    QCOMPARE(gone.size(), std::size_t(1));
    QCOMPARE(gone[0].text, std::string("large"));
    QVERIFY(!gone[0].item.hidden);
  }

  /// A label is dashed on small paper if it is on large one: the picture is the same.
  void paperDoesNotDecideWhatIsSeen() {
    model::Scene scene;
    for (int i = 0; i < 24; ++i) {
      const float angle = 2.399963f * float(i);
      const float far = 5.0f * std::sqrt(float(i));
      model::Node node{.name = "body " + std::to_string(i),
                       .mesh = test::moved(*test::sphere(1.0f, 3), 1.0f + float(i % 5) * 3.0f,
                                           {far * std::cos(angle), float(i % 7) * 9.0f - 27.0f,
                                            far * std::sin(angle)})};
      node.style.gamma = Gamma::clamped(i % 3 == 0 ? 5.0f : 1.0f);
      scene.append(node);
    }
    const SeenMap usual(scene, Screen(front(), {254.0f, 190.5f}));
    for (const float times : {0.5f, 2.0f, 4.0f}) {
      const SeenMap map(scene, Screen(front(), times * glm::vec2(254.0f, 190.5f)));
      for (const model::NodeId id : scene.structuresBelow(model::rootId)) {
        const auto there = usual.find(id);
        const auto here = map.find(id);
        QVERIFY(there && here);
        QCOMPARE(here->hidden, there->hidden);
        QVERIFY(glm::distance(here->place, times * there->place) < times * 1.5f);
      }
    }
  }

  /// An offset made by hand counts in heights of the picture, whatever its size.
  void offsetsGoWithThePicture() {
    Two two = twoSpheres();
    point(two.scene, two.large, {0.6f, -0.8f, 0.0f});
    QVERIFY(!shown(two.scene)[0].item.offset);
    std::vector<model::Annotation> annotations = two.scene.annotations();
    annotations[0].offset = glm::vec2(0.5f, -0.25f);
    two.scene.setAnnotations(annotations);
    QVERIFY(*shown(two.scene)[0].item.offset == glm::vec2(90.0f, -45.0f));
  }

  /// Meshes that would have to be sorted first are named beforehand.
  void meshesWithoutATreeAreTold() {
    Two two = twoSpheres();
    model::MeshTrees trees;
    QCOMPARE(Sights(two.scene, trees).withoutTree().size(), std::size_t(2));
    trees.of(two.scene.find(two.large)->mesh);
    QCOMPARE(Sights(two.scene, trees).withoutTree().size(), std::size_t(1));
    model::Style clear;
    clear.opacity = Opacity::clamped(0.1f);
    QVERIFY(Sights(styled(two.scene, two.small, clear), trees).withoutTree().empty());
  }

  /// Where Γ varies, what may be shaded somewhere hides what is behind it.
  void whatIsShadedInPartsHides() {
    Two two = twoSpheres();
    point(two.scene, two.large, {0.0f, -1.0f, 0.0f});
    const auto hiddenWith = [&](float offset) {
      model::Style style{.gamma = Gamma::clamped(1.0f)};
      style.gammaMap = model::GammaMap{.scalar = model::GammaScalar::occlusion,
                                       .curve = {{0.0f, -1.0f}, {1.0f, offset}}};
      const model::Scene scene = styled(two.scene, two.small, style);
      const model::ResolvedStyle look = scene.resolve(two.small);
      return std::pair(shown(scene)[0].item.hidden, SeenLook(look).surface(1.0f).cover);
    };
    QVERIFY(!hiddenWith(1.0f).first);
    QCOMPARE(hiddenWith(1.0f).second, 0.0f);
    QVERIFY(hiddenWith(4.0f).first);
    QCOMPARE(hiddenWith(4.0f).second, 1.0f);
  }

  /// On a dark ground light enters first where a surface faces the eye, on paper shadow at its rim.
  void lightEntersOnADarkGround() {
    Two two = twoSpheres();
    model::Style style{.gamma = Gamma::clamped(3.3f)};
    style.fill = model::Fill::none;
    const model::ResolvedStyle look = styled(two.scene, two.small, style).resolve(two.small);
    constexpr float rim = 0.1f;
    const SeenLook onPaper(look);
    const SeenLook onDark(look, true);
    QVERIFY(onPaper.surface(1.0f).cover < 0.01f && onPaper.surface(rim).cover > 0.3f);
    QVERIFY(onDark.surface(1.0f).cover > 0.3f && onDark.surface(rim).cover < 0.1f);
    // What has entered of a rim is dark on either ground, of the middle light.
    QVERIFY(onDark.surface(1.0f).colour > 0.9f * onDark.surface(1.0f).cover);
  }

  void clearThingsHideNothing_data() {
    QTest::addColumn<float>("gamma");
    QTest::addColumn<float>("opacity");
    QTest::addColumn<int>("fill");
    QTest::addColumn<bool>("hides");
    using model::Fill;
    QTest::newRow("shaded") << 5.0f << 1.0f << int(Fill::none) << true;
    QTest::newRow("lines") << 2.0f << 1.0f << int(Fill::none) << false;
    QTest::newRow("paper") << 1.0f << 1.0f << int(Fill::paper) << true;
    QTest::newRow("tint") << 1.0f << 1.0f << int(Fill::tint) << false;
    QTest::newRow("veil") << 1.0f << 1.0f << int(Fill::veil) << false;
    QTest::newRow("glass") << 5.0f << 0.2f << int(Fill::none) << false;
  }
  void clearThingsHideNothing() {
    QFETCH(float, gamma);
    QFETCH(float, opacity);
    QFETCH(int, fill);
    Two two = twoSpheres();
    point(two.scene, two.large, {0.0f, -1.0f, 0.0f});
    model::Style style;
    style.gamma = Gamma::clamped(gamma);
    style.opacity = Opacity::clamped(opacity);
    style.fill = model::Fill(fill);
    QTEST(shown(styled(two.scene, two.small, style))[0].item.hidden, "hides");
  }

  /// An outline on which a solid structure shows through is no place for a label inside: its place
  /// is found on the outline, and one set by hand inside is hidden.
  void outlinesAreNamedWhereTheyAreDrawn() {
    Two two = twoSpheres();
    model::Style lines;
    lines.gamma = Gamma::clamped(1.0f);
    lines.fill = model::Fill::none;
    const model::Scene scene = styled(two.scene, two.small, lines);
    const Screen screen(front(), paper);
    const auto small = SeenMap(scene, screen).find(two.small);
    QVERIFY(small && !small->hidden);
    const glm::vec2 middle = *screen.place({0.0f, -60.0f, 0.0f});
    // The silhouette of a sphere of radius r at distance d is seen at the slope r / √(d² − r²).
    const float focal = 90.0f / std::tan(0.5f * 30.0f * 3.14159265f / 180.0f);
    const float radius = focal * 15.0f / std::sqrt(340.0f * 340.0f - 15.0f * 15.0f);
    const float off = glm::length(small->place - middle) - radius;
    QVERIFY2(std::abs(off) < 0.4f, qPrintable(QString::number(double(off))));
    model::Scene byHand = scene;
    point(byHand, two.small, {0.0f, -1.0f, 0.0f});
    QVERIFY(shown(byHand)[0].item.hidden);
    std::vector<model::Annotation> annotations = byHand.annotations();
    annotations[0].found = true;
    byHand.setAnnotations(annotations);
    QVERIFY(!shown(byHand)[0].item.hidden);
  }

  void hiddenByItself() {
    Two two = twoSpheres();
    point(two.scene, two.large, {0.7f, 0.7f, 0.0f});
    QVERIFY(shown(two.scene)[0].item.hidden);
  }

  void whatIsNotDrawnIsNotLabelled() {
    Two two = twoSpheres();
    point(two.scene, two.large, {-1.0f, -0.2f, 0.0f});
    point(two.scene, two.large, {1.0f, -0.2f, 0.0f});
    model::Style unseen;
    unseen.visible = false;
    QCOMPARE(shown(styled(two.scene, two.large, unseen)).size(), std::size_t(0));
    model::Scene cut = two.scene;
    cut.appendSection({.plane = model::anatomicalPlane(model::AnatomicalView::left, 0.0f)});
    // What the section takes away is gone, where it says more than what the structure is called.
    QCOMPARE(shown(cut).size(), std::size_t(1));
    std::vector<model::Annotation> annotations = cut.annotations();
    annotations[0].text = cut.find(two.large)->name;
    cut.setAnnotations(annotations);
    // A structure's own name moves to what is left of it.
    const auto left = shown(cut);
    QCOMPARE(left.size(), std::size_t(2));
    for (const ShownLabel& label : left)
      QVERIFY2(label.item.places[0].x >= 120.0f, "the patient's left is at the picture's right");
    QVERIFY(left[0].item.found && !left[0].item.hidden);
    QVERIFY(!left[1].item.found);
    model::Scene gone = two.scene;
    gone.appendSection({.plane = model::anatomicalPlane(model::AnatomicalView::left, 50.0f)});
    QCOMPARE(shown(gone).size(), std::size_t(0));
  }

  void languagesAndNumbers() {
    Two two = twoSpheres();
    point(two.scene, two.large, {-1.0f, -0.2f, 0.0f});
    point(two.scene, two.small, {0.0f, -1.0f, 0.0f});
    auto annotations = two.scene.annotations();
    annotations[1].texts["de"] = "klein";
    annotations[0].visible = false;
    two.scene.setAnnotations(annotations);
    const auto german = shown(two.scene, "de");
    QCOMPARE(german.size(), std::size_t(1));
    QCOMPARE(german[0].text, std::string("klein"));
    QCOMPARE(german[0].number, 1);
    QCOMPARE(shown(two.scene, "fr")[0].text, std::string("text"));
  }

  void bestPlaceIsSeen() {
    const Two two = twoSpheres();
    const Screen screen(front(), paper);
    const auto small = SeenMap(two.scene, screen).find(two.small);
    QVERIFY(small && !small->hidden);
    const glm::vec3 place = *two.scene.placeOf(small->anchor);
    QVERIFY2(glm::length(place - glm::vec3(0.0f, -75.0f, 0.0f)) < 4.0f, "not in its middle");
    // A ring of the large sphere is visible around the small one.
    const auto large = SeenMap(two.scene, screen).find(two.large);
    QVERIFY(large && !large->hidden);
    model::Scene scene = two.scene;
    scene.appendAnnotation({.anchors = {large->anchor}, .text = "ring"});
    QVERIFY(!shown(scene)[0].item.hidden);
  }

  void bestPlaceOfWhatIsHidden() {
    Two two = twoSpheres();
    model::Node inner{.name = "inner", .mesh = test::sphere(5.0f, 2)};
    const model::NodeId id = two.scene.append(inner);
    const auto best = SeenMap(two.scene, Screen(front(), paper)).find(id);
    QVERIFY(best && best->hidden);
    QVERIFY(two.scene.placeOf(best->anchor)->y < -4.0f);
  }

  /// A structure that lets another show through still draws lines over it.
  void bestPlaceIsNotUnderLines() {
    Two two = twoSpheres();
    model::Style lines;
    lines.gamma = Gamma::clamped(1.0f);
    lines.fill = model::Fill::none;
    const model::Scene scene = styled(two.scene, two.small, lines);
    const Screen screen(front(), paper);
    const auto best = SeenMap(scene, screen).find(two.large);
    QVERIFY(best && !best->hidden);
    const glm::vec2 place = *screen.place(*scene.placeOf(best->anchor));
    const glm::vec2 middle = *screen.place({0.0f, -60.0f, 0.0f});
    const glm::vec2 edge = *screen.place({15.0f, -60.0f, 0.0f});
    QVERIFY2(glm::length(place - middle) > glm::length(edge - middle) + 1.0f,
             "the dot lies under another structure's lines");
    // If the lines are over all of the structure, the place is in its middle.
    model::Node shell{.name = "shell", .mesh = test::sphere(45.0f, 3)};
    shell.style = lines;
    model::Scene under = scene;
    under.append(shell);
    const auto covered = SeenMap(under, screen).find(two.large);
    QVERIFY(covered && !covered->hidden);
    QVERIFY(glm::length(*screen.place(*under.placeOf(covered->anchor)) - middle) < 4.0f);
  }

  /// Where a caption or a mark lies over the picture one sees no structure: places are found beside
  /// it, one from before is given up for them, and what it covers wholly is hidden.
  void bestPlaceIsNotCovered() {
    Two two = twoSpheres();
    const Screen screen(front(), paper);
    const auto free = SeenMap(two.scene, screen).find(two.small);
    QVERIFY(free && !free->hidden);
    const LabelBox half{free->place - glm::vec2(50.0f, 1.0f), free->place + glm::vec2(50.0f)};
    const auto beside = SeenMap(two.scene, screen.coveredBy({half})).find(two.small, free->anchor);
    QVERIFY(beside && !beside->hidden);
    QVERIFY2(!half.contains(beside->place), "the dot lies under the caption");
    const glm::vec3 there = *two.scene.placeOf(beside->anchor);
    QVERIFY(glm::length(there - glm::vec3(0.0f, -60.0f, 0.0f)) < 15.1f);
    const LabelBox all{glm::vec2(-20.0f), paper - 60.0f};
    const auto under = SeenMap(two.scene, screen.coveredBy({all})).find(two.small);
    QVERIFY(under && under->hidden);
    const LabelBox outside{glm::vec2(-40.0f), glm::vec2(-10.0f)};
    const auto same = SeenMap(two.scene, screen.coveredBy({outside})).find(two.small);
    QVERIFY(same && same->anchor == free->anchor);
    // An outline alone is pointed at where one sees it.
    model::Style lines;
    lines.gamma = Gamma::clamped(1.0f);
    lines.fill = model::Fill::none;
    const model::Scene scene = styled(two.scene, two.small, lines);
    const auto outline = SeenMap(scene, screen).find(two.small);
    const LabelBox over{outline->place - 3.0f, outline->place + 3.0f};
    const auto elsewhere = SeenMap(scene, screen.coveredBy({over})).find(two.small);
    QVERIFY(elsewhere && !elsewhere->hidden && !over.contains(elsewhere->place));
  }

  /// A strip hardly wider than a pen is pointed at away from its ends, and a speck that alone looks
  /// out from behind another structure is seen all the same.
  void bestPlaceOfWhatIsNarrow() {
    model::Scene scene;
    const model::NodeId strip = scene.append(plate({-0.3f, 0.3f}, {-30, 30}, 0));
    const Screen screen(front(), paper);
    const auto best = SeenMap(scene, screen).find(strip);
    QVERIFY(best && !best->hidden);
    const float z = scene.placeOf(best->anchor)->z;
    QVERIFY2(std::abs(z) < 28.5f, qPrintable(QString::number(double(z))));
    scene.append(plate({-40, 40}, {-40, 40}, 20));
    const model::NodeId speck = scene.append(plate({30, 46}, {-0.5f, 0.5f}, 40));
    const auto seen = SeenMap(scene, screen).find(speck);
    QVERIFY(seen && !seen->hidden);
    QVERIFY(scene.placeOf(seen->anchor)->x > 41.0f);
    const model::NodeId behind = scene.append(plate({20, 36}, {-5, 5}, 40));
    QVERIFY(SeenMap(scene, screen).find(behind)->hidden);
  }

  /// Where two structures share a wall, which of them a picture shows is a matter of rounding.
  void bestPlaceIsNotOnASharedWall() {
    for (const float behind : {0.01f, 5.0f}) {
      model::Scene scene;
      const model::NodeId whole = scene.append(plate({-40, 40}, {-20, 20}, 0));
      scene.append(plate({-40, 20}, {-20, 20}, behind));
      const Screen screen(front(), paper);
      const auto best = SeenMap(scene, screen).find(whole);
      QVERIFY(best && !best->hidden);
      const float x = scene.placeOf(best->anchor)->x;
      QVERIFY2(behind < 1.0f ? x > 20.0f : std::abs(x) < 10.0f,
               qPrintable(QString::number(double(x))));
    }
  }

  /// If a near part of the structure ends before a far one, a place there is hidden from a little
  /// aside.
  void bestPlaceIsNotAtAFold() {
    const auto plate = [](float left, float depth) {
      return std::vector<glm::vec3>{{left, depth, -20.0f},
                                    {left + 40.0f, depth, -20.0f},
                                    {left + 40.0f, depth, 20.0f},
                                    {left, depth, 20.0f}};
    };
    std::vector<glm::vec3> positions = plate(-40.0f, -30.0f);
    const std::vector<glm::vec3> far = plate(0.0f, 30.0f);
    positions.insert(positions.end(), far.begin(), far.end());
    auto mesh = model::Mesh::create(positions, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
    QVERIFY(mesh.ok());
    model::Scene scene;
    model::Node node{.name = "steps", .mesh = std::make_shared<const model::Mesh>(*mesh)};
    node.style.gamma = Gamma::clamped(5.0f);
    const model::NodeId id = scene.append(node);
    model::Camera camera = front();  // the fold is in the middle of its picture
    camera.projection = model::Projection::orthographic;
    camera.heightMm = 100.0f;
    const auto best = SeenMap(scene, Screen(camera, paper)).find(id);
    QVERIFY(best && !best->hidden);
    const float x = scene.placeOf(best->anchor)->x;
    QVERIFY2(std::abs(x) > 10.0f && std::abs(x) < 30.0f, qPrintable(QString::number(double(x))));
  }

  void obstaclesAreWhereThingsAre() {
    const Two two = twoSpheres();
    const Screen screen(front(), paper);
    const ObstacleMask mask = obstaclesOf(two.scene, screen);
    QVERIFY(mask.extent);
    const float radius = 0.5f * mask.extent->size().x;
    QVERIFY(std::abs(mask.extent->middle().x - 120.0f) < 1.0f);
    // The outline has a radius of r/√(d² − r²) times the focal length.
    const float focal = 90.0f / std::tan(0.5f * 30.0f * 3.14159265f / 180.0f);
    const float expected = focal * 40.0f / std::sqrt(400.0f * 400.0f - 40.0f * 40.0f);
    QVERIFY2(std::abs(radius - expected) < 1.0f, qPrintable(QString::number(radius)));
    QVERIFY(mask.share({{110.0f, 80.0f}, {130.0f, 100.0f}}) > 0.99f);
    QCOMPARE(mask.share({{5.0f, 5.0f}, {40.0f, 20.0f}}), 0.0f);
  }
};

SLINE_TEST(LabelAnchorsTest)
#include "label_anchors_test.moc"
