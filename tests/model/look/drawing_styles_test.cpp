// SPDX-License-Identifier: Apache-2.0
// Tests that each drawing style does what its description says, whatever look the scene has.
#include "model/look/drawing_styles.h"

#include <QTest>
#include <algorithm>

#include "model/base/contrast.h"
#include "model/edit/locks.h"
#include "model/edit/look.h"
#include "model/edit/visibility.h"
#include "model/scene/resolved_styles.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

class DrawingStylesTest : public QObject {
  Q_OBJECT

  static constexpr Colour reddish{200, 120, 90};

  static NodeId add(Scene& scene, const char* name, float radius, const glm::vec3& at,
                    const Colour& colour) {
    Node node{.name = name};
    node.mesh = test::moved(*test::sphere(radius, 3), 1.0f, at);
    node.style.colour = colour;
    return scene.append(std::move(node));
  }
  /// A liver, a vertebra behind it and a muscle before it, without a look.
  static Scene body() {
    Scene scene;
    add(scene, "liver", 40.0f, {0, 0, 0}, reddish);
    add(scene, "vertebra L1", 20.0f, {0, 80, 0}, {248, 234, 214});
    add(scene, "rectus abdominis muscle", 30.0f, {0, -90, 0}, {100, 42, 36});
    return scene;
  }
  static Edited drawn(const Scene& scene, std::string_view id) {
    FormIndex forms;
    return withDrawingStyle(scene, *drawingStyleNamed(id), forms,
                            {.view = AnatomicalView::anterior});
  }
  static ResolvedStyle styleOf(const Scene& scene, const char* name) {
    return scene.resolve(scene.named(name).front());
  }
  static bool isGrey(const std::optional<Colour>& ink) {
    return ink && std::max({ink->red, ink->green, ink->blue}) -
                          std::min({ink->red, ink->green, ink->blue}) <
                      20;
  }
  static void eachStyle() {
    QTest::addColumn<QString>("id");
    for (const DrawingStyle& style : drawingStyles())
      QTest::newRow(style.id.data()) << QString::fromUtf8(style.id.data(), int(style.id.size()));
  }

 private slots:
  void table() {
    QCOMPARE(drawingStyles().size(), std::size_t(7));
    QCOMPARE(drawingStyles().front().id, std::string_view("plate"));
    QVERIFY(!drawingStyleNamed("fresco"));
    for (const DrawingStyle& style : drawingStyles()) {
      QCOMPARE(drawingStyleNamed(style.id), &style);
      QVERIFY(style.description.ends_with('.'));
    }
    QCOMPARE(drawingStyleNamed("lecture-hall")->background, std::string_view("dark"));
    QCOMPARE(drawingStyleNamed("pencil")->background, std::string_view("paper"));
  }
  void emphasis() {
    Scene scene = body();
    const std::vector<NodeId> liver = scene.named("liver");
    QCOMPARE(emphasisedIn(scene), liver);  // by its name, as all is drawn alike
    const std::vector<NodeId> bone = scene.named("vertebra L1");
    scene = withLook(scene, bone, {.gamma = Gamma::clamped(3.0f)}).scene;
    QCOMPARE(emphasisedIn(scene), bone);
    scene = withLook(scene, liver, {.gamma = Gamma::clamped(4.0f)}).scene;
    scene = withLook(scene, bone, {.gamma = Gamma::clamped(3.9f)}).scene;
    QCOMPARE(emphasisedIn(scene), liver);
    // Surroundings are shaded, too, up to a little less than what is in focus.
    scene = withLook(scene, liver, {.gamma = Gamma::clamped(4.3f)}).scene;
    scene = withLook(scene, bone, {.gamma = Gamma::clamped(4.2f)}).scene;
    QCOMPARE(emphasisedIn(scene).size(), std::size_t(2));  // a person may shade as she likes
    scene = withLook(scene, bone, {.hatchTone = HatchTone::clamped(0.0f)}).scene;
    QCOMPARE(emphasisedIn(scene), liver);
    QVERIFY(emphasisedIn(Scene()).empty());
  }
  void plateIsTheOpeningLook() {
    FormIndex forms;
    const Scene scene = body();
    const auto look = openingLook(scene, forms, {.view = AnatomicalView::anterior});
    QVERIFY(look.has_value());
    QVERIFY(drawn(scene, "plate").scene == look->scene);
  }
  void evenPen() {
    const Scene scene = drawn(body(), "even-pen").scene;
    for (const ResolvedStructure& each : resolvedBelow(scene, std::vector{rootId})) {
      QCOMPARE(each.style.lineVariation, 0.0f);
      QCOMPARE(each.style.penWeight, styleOf(scene, "liver").penWeight);
      QVERIFY(each.style.gamma.value() <= 2.0f);
      QVERIFY(each.style.inkColour == Colour({0, 0, 0}));
    }
    QCOMPARE(styleOf(scene, "liver").gamma.value(), 2.0f);
    QCOMPARE(styleOf(scene, "liver").fill, Fill::paper);
  }
  void twoColours_data() {
    QTest::addColumn<QString>("id");
    QTest::newRow("textbook") << "textbook";
    QTest::newRow("operating note") << "operating-note";
  }
  void twoColours() {
    QFETCH(QString, id);
    const Scene scene = drawn(body(), id.toStdString()).scene;
    QVERIFY(!isGrey(styleOf(scene, "liver").inkColour));
    QVERIFY(isGrey(styleOf(scene, "vertebra L1").inkColour));
    QVERIFY(styleOf(scene, "vertebra L1").penWeight < styleOf(scene, "liver").penWeight);
    // A subject of several colours has one as well.
    Scene two = body();
    add(two, "spleen", 10.0f, {70, 0, 0}, {120, 60, 160});
    two = drawn(two, id.toStdString()).scene;
    QVERIFY(styleOf(two, "spleen").inkColour == styleOf(two, "liver").inkColour);
  }
  void operatingNoteHasFewLines() {
    const ResolvedStyle liver = styleOf(drawn(body(), "operating-note").scene, "liver");
    QCOMPARE(liver.shortestLine, 16.0f);
    QCOMPARE(liver.lineScale, 2.0f);
  }
  void woodcut() {
    Scene cut = body();
    cut.setSections({Section{.name = "axial"}});
    const Scene scene = drawn(cut, "woodcut").scene;
    const ResolvedStyle liver = styleOf(scene, "liver");
    QCOMPARE(liver.gamma.value(), 3.0f);
    QVERIFY(liver.hatchTone.value() > 2.0f);
    QVERIFY(liver.penWeight > 1.0f);
    QCOMPARE(liver.fill, Fill::paper);
    QVERIFY(liver.inkColour == Colour({0, 0, 0}));
    QVERIFY(scene.sections().front().hatched);
    QVERIFY(!drawn(cut, "pencil").scene.sections().front().hatched);
  }
  void pencil() {
    const ResolvedStyle liver = styleOf(drawn(body(), "pencil").scene, "liver");
    QVERIFY(liver.inkColour == Colour({70, 70, 76}));
    QVERIFY(liver.hatchDensity.value() > 2.0f);
    QVERIFY(liver.penWeight < 1.0f);
  }
  void lectureHall() {
    const Scene scene = drawn(body(), "lecture-hall").scene;
    const ResolvedStyle liver = styleOf(scene, "liver");
    QVERIFY(liver.gamma.value() > 4.0f);
    QVERIFY(liver.colour.red > reddish.red && liver.colour.blue < liver.colour.red);
    // What is around it is filled, too, but dim, and its lines can be seen on the ground.
    const ResolvedStyle bone = styleOf(scene, "vertebra L1");
    constexpr Colour ground{28, 30, 34};
    QVERIFY(bone.gamma.value() > 3.5f && bone.gamma < liver.gamma);
    QVERIFY(contrastBetween(bone.colour, ground) < 0.6 * contrastBetween(liver.colour, ground));
    QVERIFY(contrastBetween(*bone.inkColour, ground) >= 4.5);
    QCOMPARE(emphasisedIn(scene), scene.named("liver"));
  }
  void sameAgain_data() { eachStyle(); }
  void sameAgain() {
    QFETCH(QString, id);
    const std::string name = id.toStdString();
    const Scene opened = drawn(body(), "plate").scene;
    const Edited first = drawn(opened, name);
    QVERIFY(first.changed == (name != "plate"));
    QVERIFY(drawn(opened, name).scene == first.scene);
    QVERIFY(!drawn(first.scene, name).changed);
    QCOMPARE(emphasisedIn(first.scene), opened.named("liver"));
  }
  /// A style leaves nothing of the one before.
  void oneAfterAnother_data() { eachStyle(); }
  void oneAfterAnother() {
    QFETCH(QString, id);
    const Scene opened = drawn(body(), "plate").scene;
    const Scene through = drawn(drawn(opened, "operating-note").scene, "plate").scene;
    QVERIFY(through == opened);
    const Style straight =
        drawn(opened, id.toStdString()).scene.find(opened.named("liver").front())->style;
    const Scene detour = drawn(drawn(opened, "even-pen").scene, id.toStdString()).scene;
    QVERIFY(detour.find(opened.named("liver").front())->style == straight);
  }
  /// What a style of few colours takes away the next one has, in whatever program: the scene knows
  /// it. What was coloured by hand since keeps that.
  void coloursComeBack_data() { eachStyle(); }
  void coloursComeBack() {
    QFETCH(QString, id);
    const std::string name = id.toStdString();
    const Scene opened = drawn(body(), "plate").scene;
    const Scene white = drawn(opened, "woodcut").scene;
    QCOMPARE(styleOf(white, "liver").colour, (Colour{255, 255, 255}));
    QVERIFY(drawn(white, name).scene == drawn(opened, name).scene);
    QVERIFY(withOwnColours(withOwnColours(white)) == withOwnColours(white));
    QCOMPARE(styleOf(withOwnColours(white), "liver").colour, reddish);
    const Colour own{12, 200, 34};
    const Scene byHand = withLook(white, white.named("liver"), {.colour = own}).scene;
    QCOMPARE(styleOf(withOwnColours(byHand), "liver").colour, own);
    // A locked one stays as it is, and has its colour back once it is free.
    const Scene locked = withLocked(white, white.named("liver"), true).scene;
    const Scene after = drawn(locked, "plate").scene;
    QCOMPARE(styleOf(after, "liver").colour, (Colour{255, 255, 255}));
    const Scene freed = withLocked(after, after.named("liver"), false).scene;
    QCOMPARE(styleOf(withOwnColours(freed), "liver").colour, reddish);
  }
  void locksAndHidden_data() { eachStyle(); }
  void locksAndHidden() {
    QFETCH(QString, id);
    Scene scene = drawn(body(), "plate").scene;
    scene = withLocked(scene, scene.named("vertebra L1"), true).scene;
    scene = withHidden(scene, scene.named("rectus abdominis muscle")).scene;
    const Scene after = drawn(scene, id.toStdString()).scene;
    QVERIFY(styleOf(after, "vertebra L1") == styleOf(scene, "vertebra L1"));
    QVERIFY(!styleOf(after, "rectus abdominis muscle").visible);
    QVERIFY(!drawn(Scene(), id.toStdString()).changed);
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::DrawingStylesTest)
#include "drawing_styles_test.moc"
