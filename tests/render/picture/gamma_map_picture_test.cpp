// SPDX-License-Identifier: Apache-2.0
// Tests that Γ may vary over a surface: each place is drawn as a whole structure of its Γ would be.
#include <QtTest>
#include <array>

#include "render/vectors/vector_drawing.h"
#include "tests/render/picture/scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Background;
using render::Image;

namespace {

constexpr int width = 400;
constexpr int height = 300;

model::Camera askewCamera() {
  model::Camera camera = frontal(180.0f);
  camera.eye = {0.0f, -800.0f, 600.0f};
  return camera;
}

/// Returns a map by curvature that adds the same everywhere.
model::GammaMap level(float offset) {
  return {.scalar = model::GammaScalar::curvature, .curve = {{-1.0f, offset}, {1.0f, offset}}};
}

/// Returns a ring around z, one for all scenes.
model::MeshPtr ringMesh() {
  static const model::MeshPtr mesh = torus(50.0f, 20.0f, 160, 64);
  return mesh;
}

/// Returns a ring to the left of the origin's plane x = 0 of which Γ steps to another within a
/// millimetre about a distance from something far on the left.
struct Halves {
  model::Scene scene;
  model::NodeId ring;
  model::NodeId far;

  Halves(float left, float right) {
    far = add(scene, moved(*sphere(1.0f, 2), 1.0f, {-100'000.0f, 0.0f, 0.0f}), gammaStyle(0.0f));
    model::Style style = gammaStyle(left);
    style.gammaMap = model::GammaMap{.scalar = model::GammaScalar::distance,
                                     .targets = {far},
                                     .curve = {{99'998.5f, 0.0f}, {99'999.5f, right - left}}};
    ring = add(scene, ringMesh(), style);
    std::vector<model::Node> nodes = scene.nodes();
    nodes[0].style.visible = false;
    scene.setNodes(nodes);
  }
};

model::Scene plainRing(float gamma) {
  model::Scene scene;
  add(scene, ringMesh(), gammaStyle(gamma));
  return scene;
}

}  // namespace

class GammaMapPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void levelMapsAreLikeOneGamma_data();
  void levelMapsAreLikeOneGamma();
  void vectorsOfLevelMapsAreLikeOneGamma_data() { levelMapsAreLikeOneGamma_data(); }
  void vectorsOfLevelMapsAreLikeOneGamma();
  void eachPlaceHasItsOwn_data();
  void eachPlaceHasItsOwn();
  void changesAreSeen();
  void meshesMayBeShared();
  void paintIsDrawnWhereItIs();
  void distancesMayBeFromAPlace();
  void sectionsCut();

 private:
  Image picture(const model::Scene& scene, Background background = Background::white);
  Studio m_studio;
};

void GammaMapPictureTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

Image GammaMapPictureTest::picture(const model::Scene& scene, Background background) {
  auto image = m_studio.picture->render(
      scene, askewCamera(),
      {.width = width, .height = height, .environment = {.background = background}});
  if (!image)
    qFatal("%s", image.error().text().c_str());
  return std::move(*image);
}

void GammaMapPictureTest::levelMapsAreLikeOneGamma_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<float>("offset");
  QTest::addColumn<int>("fill");
  for (const float seen : {0.0f, 0.5f, 1.0f, 1.4f, 2.0f, 2.6f, 3.3f, 3.9f, 4.3f, 5.0f})
    for (const float gamma : {0.5f, 4.5f})
      QTest::addRow("%g as %g", double(gamma), double(seen))
          << gamma << seen - gamma << int(model::Fill::none);
  QTest::newRow("tinted") << 1.0f << 2.5f << int(model::Fill::tint);
  QTest::newRow("beyond 5") << 3.0f << 4.0f << int(model::Fill::paper);
}

void GammaMapPictureTest::levelMapsAreLikeOneGamma() {
  QFETCH(float, gamma);
  QFETCH(float, offset);
  QFETCH(int, fill);
  model::Scene varying;
  model::Scene even;
  model::Style style = gammaStyle(gamma + offset);
  style.fill = model::Fill(fill);
  if (gamma + offset <= 4.0f) {
    // Halos and hidden outlines of one Γ keep their strength until lines have left.
    style.halo = 1.0f;
    style.hiddenLines = model::HiddenLines::thin;
  }
  add(even, ringMesh(), style);
  style.gamma = Gamma::clamped(gamma);
  style.gammaMap = level(offset);
  add(varying, ringMesh(), style);
  for (const Background background : {Background::white, Background::dark}) {
    const Difference apart = difference(picture(varying, background), picture(even, background));
    QVERIFY2(apart.largest <= 3, qPrintable(QString::number(apart.largest)));
  }
}

void GammaMapPictureTest::vectorsOfLevelMapsAreLikeOneGamma() {
  QFETCH(float, gamma);
  QFETCH(float, offset);
  QFETCH(int, fill);
  std::array<render::VectorDrawing, 2> drawn;
  for (const bool varies : {false, true}) {
    model::Scene scene;
    model::Style style = gammaStyle(varies ? gamma : gamma + offset);
    style.fill = model::Fill(fill);
    if (varies)
      style.gammaMap = level(offset);
    add(scene, ringMesh(), style);
    auto drawing = render::drawVectors(scene, askewCamera(), {.sizeMm = {80.0f, 60.0f}});
    QVERIFY(drawing.ok());
    drawn[varies ? 1 : 0] = std::move(*drawing);
  }
  QCOMPARE(drawn[1].structures.size(), drawn[0].structures.size());
  if (drawn[0].structures.empty())
    return;
  const render::VectorStructure& even = drawn[0].structures[0];
  const render::VectorStructure& varying = drawn[1].structures[0];
  QCOMPARE(varying.filled(), even.filled());
  QCOMPARE(varying.fills.size(), even.fills.size());
  // Where lines leave, one pen has their opacity, the other their width.
  if (gamma + offset > 4.0f)
    return;
  QCOMPARE(varying.lines.size(), even.lines.size());
  for (std::size_t i = 0; i < even.lines.size(); ++i) {
    QCOMPARE(varying.lines[i].shapes.size(), even.lines[i].shapes.size());
    QCOMPARE(varying.lines[i].opacity, even.lines[i].opacity);
  }
}

void GammaMapPictureTest::eachPlaceHasItsOwn_data() {
  QTest::addColumn<float>("left");
  QTest::addColumn<float>("right");
  QTest::newRow("silhouette and shading") << 0.0f << 5.0f;
  QTest::newRow("shading and contours") << 5.0f << 1.0f;
  QTest::newRow("suggestive contours and hatching") << 2.0f << 3.0f;
  QTest::newRow("contours and half shading") << 1.0f << 3.5f;
  QTest::newRow("lines that leave and none") << 4.5f << 0.0f;
}

void GammaMapPictureTest::eachPlaceHasItsOwn() {
  QFETCH(float, left);
  QFETCH(float, right);
  const Halves halves(left, right);
  const Image both = picture(halves.scene);
  const Image ofLeft = picture(plainRing(left));
  const Image ofRight = picture(plainRing(right));
  // Strokes reach a little beyond their place, and a pen varies along a curve.
  constexpr int seam = 30;
  int wrong = 0;
  int drawn = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (std::abs(x - width / 2) < seam)
        continue;
      const Pixel expected = pixelAt(x < width / 2 ? ofLeft : ofRight, x, y);
      const Pixel found = pixelAt(both, x, y);
      drawn += expected.grey() < 250 ? 1 : 0;
      wrong += std::abs(found.grey() - expected.grey()) > 40 ? 1 : 0;
    }
  QVERIFY(drawn > 500);
  QVERIFY2(wrong * 50 < drawn, qPrintable(QStringLiteral("%1 of %2").arg(wrong).arg(drawn)));
}

void GammaMapPictureTest::changesAreSeen() {
  // A target that moves, a curve, a Γ: what was kept of the picture before does not stay.
  Halves halves(0.0f, 5.0f);
  const Image first = picture(halves.scene);
  std::vector<model::Node> nodes = halves.scene.nodes();
  nodes[0].mesh = moved(*nodes[0].mesh, 1.0f, {30.0f, 0.0f, 0.0f});
  halves.scene.setNodes(nodes);
  const Image moved = picture(halves.scene);
  QVERIFY(difference(first, moved).share > 0.01);
  nodes[1].style.gammaMap->curve[1].offset = 2.0f;
  halves.scene.setNodes(nodes);
  const Image lower = picture(halves.scene);
  QVERIFY(difference(moved, lower).share > 0.01);
  // Without its target, or a curve, Γ is the structure's.
  for (const model::GammaMap& map : {model::GammaMap{.scalar = model::GammaScalar::distance,
                                    .targets = {{77}},
                                    .curve = nodes[1].style.gammaMap->curve},
                                     model::GammaMap{.scalar = model::GammaScalar::curvature}}) {
    nodes[1].style.gammaMap = map;
    halves.scene.setNodes(nodes);
    QCOMPARE(difference(picture(halves.scene), picture(plainRing(0.0f))).largest, 0);
  }
}

void GammaMapPictureTest::meshesMayBeShared() {
  const model::MeshPtr mesh = ringMesh();
  model::Scene scene;
  for (const float offset : {1.5f, 4.0f}) {
    model::Style style = gammaStyle(1.0f);
    style.gammaMap = level(offset);
    add(scene, mesh, style);
  }
  for (const std::size_t shown : {0, 1}) {
    std::vector<model::Node> nodes = scene.nodes();
    nodes[1 - shown].style.visible = false;
    model::Scene one = scene;
    one.setNodes(nodes);
    picture(scene);
    const Difference apart = difference(picture(one), picture(plainRing(shown == 0 ? 2.5f : 5.0f)));
    QVERIFY2(apart.largest <= 3, qPrintable(QString::number(apart.largest)));
  }
}

void GammaMapPictureTest::paintIsDrawnWhereItIs() {
  model::Scene scene = plainRing(1.0f);
  std::vector<model::Node> nodes = scene.nodes();
  nodes[0].style.gammaMap =
      model::GammaMap{.scalar = model::GammaScalar::painted, .curve = {{0.0f, 0.0f}, {1.0f, 4.0f}}};
  scene.setNodes(nodes);
  // Nothing is painted yet.
  const Image plain = picture(plainRing(1.0f));
  QCOMPARE(difference(picture(scene), plain).largest, 0);
  model::Paint paint;
  for (const glm::vec3& p : nodes[0].mesh->positions())
    paint.push_back(p.x > 0.0f ? 255 : 0);
  nodes[0].paint = std::make_shared<const model::Paint>(paint);
  scene.setNodes(nodes);
  const Image half = picture(scene);
  const Image shaded = picture(plainRing(5.0f));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (std::abs(x - width / 2) < 12)
        continue;  // where the one becomes the other
      const Image& like = x > width / 2 ? shaded : plain;
      const auto at = std::size_t(4 * (y * width + x));
      for (std::size_t k = 0; k < 3; ++k)
        QVERIFY2(std::abs(int(half.rgba[at + k]) - int(like.rgba[at + k])) < 60,
                 qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
    }
  // What is painted anew is drawn anew.
  std::fill(paint.begin(), paint.end(), std::uint8_t(255));
  nodes[0].paint = std::make_shared<const model::Paint>(paint);
  scene.setNodes(nodes);
  QVERIFY(difference(picture(scene), half).largest > 50);
}

void GammaMapPictureTest::distancesMayBeFromAPlace() {
  // A small ball in that place is as good as the place.
  const glm::vec3 place(70.0f, 0.0f, 0.0f);
  const std::vector<model::GammaPoint> curve{{30.0f, 5.0f}, {60.0f, 0.0f}};
  model::Scene scene;
  const model::NodeId ball = add(scene, moved(*sphere(0.01f, 2), 1.0f, place), gammaStyle(0.0f));
  model::Style style = gammaStyle(0.0f);
  style.gammaMap =
      model::GammaMap{.scalar = model::GammaScalar::distance, .targets = {ball}, .curve = curve};
  add(scene, ringMesh(), style);
  std::vector<model::Node> nodes = scene.nodes();
  nodes[0].style.visible = false;
  scene.setNodes(nodes);
  const Image fromBall = picture(scene);
  nodes[1].style.gammaMap =
      model::GammaMap{.scalar = model::GammaScalar::distance, .place = place, .curve = curve};
  scene.setNodes(nodes);
  const Image fromPlace = picture(scene);
  QVERIFY(difference(fromBall, fromPlace).share < 0.002);
  QVERIFY(difference(fromPlace, picture(plainRing(0.0f))).share > 0.01);
  // Far away from it there is no difference at all.
  nodes[1].style.gammaMap->place = glm::vec3(9000.0f, 0.0f, 0.0f);
  scene.setNodes(nodes);
  QCOMPARE(difference(picture(scene), picture(plainRing(0.0f))).largest, 0);
}

void GammaMapPictureTest::sectionsCut() {
  std::array<model::Scene, 2> scenes{plainRing(3.6f), plainRing(1.1f)};
  std::vector<model::Node> nodes = scenes[1].nodes();
  nodes[0].style.gammaMap = level(2.5f);
  scenes[1].setNodes(nodes);
  for (model::Scene& scene : scenes)
    scene.appendSection({.name = "cut",
                         .plane = {.normal = {1.0f, 0.0f, 0.0f}, .offset = 10.0f},
                         .faces = model::CutFaces::off});
  QVERIFY(difference(picture(scenes[0]), picture(plainRing(3.6f))).share > 0.01);
  // The cut faces themselves follow the structure's own Γ.
  QVERIFY(difference(picture(scenes[0]), picture(scenes[1])).share < 0.01);
}

SLINE_TEST(GammaMapPictureTest)
#include "gamma_map_picture_test.moc"
