// SPDX-License-Identifier: Apache-2.0
// Tests section planes and layers: which structures a cut affects, what is kept, pieces of large
// pictures.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/render/picture/section_scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using model::AnatomicalView;
using render::Image;
using render::PictureSettings;

class SectionLayersTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void scopeLimitsTheCut();
  void othersStayBitForBit_data();
  void othersStayBitForBit();
  void keepsLayersThatThePlaneSpares();
  void keptLayersGiveTheSamePicture();
  void piecesGiveTheSamePicture();
  void orderOfStructuresChangesNothing();

 private:
  Image picture(const model::Scene& scene, const model::Camera& camera);
  static constexpr PictureSettings square{.width = 400, .height = 400};
  Studio m_studio;
};

void SectionLayersTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

Image SectionLayersTest::picture(const model::Scene& scene, const model::Camera& camera) {
  auto image = m_studio.picture->render(scene, camera, square);
  if (!image.ok())
    qFatal("%s", image.error().text().c_str());
  return std::move(*image);
}

void SectionLayersTest::scopeLimitsTheCut() {
  model::Scene scene;
  model::Node group;
  group.name = "group";
  const model::NodeId groupId = scene.append(group);
  model::Node ball;
  ball.name = "ball";
  ball.parent = groupId;
  ball.mesh = sphere(40.0f, 5);
  ball.style = styled(5.0f, red);
  scene.append(ball);
  // A vessel through the ball, from front to back, stays whole.
  add(scene, moved(*sphere(9.0f, 4), 1.0f, {0, -12, 0}), styled(5.0f, blue));
  cut(scene, AnatomicalView::posterior, 0.0f, groupId);
  tintFaces(scene);
  const Spot whole = spot(picture(scene, frontal(100.0f)), bluish);
  QVERIFY(std::abs(whole.count / (std::numbers::pi * 36.0 * 36.0) - 1.0) < 0.03);
  model::Scene all = scene;
  all.setSections({});
  cut(all, AnatomicalView::posterior, 0.0f);
  QCOMPARE(spot(picture(all, frontal(100.0f)), bluish).count, 0);
}

void SectionLayersTest::othersStayBitForBit_data() {
  QTest::addColumn<float>("gamma");
  QTest::newRow("contours") << 1.0f;
  QTest::newRow("half filled") << 3.5f;
  QTest::newRow("shaded") << 5.0f;
}

void SectionLayersTest::othersStayBitForBit() {
  QFETCH(float, gamma);
  model::Scene scene;
  const model::NodeId ball =
      add(scene, moved(*sphere(20.0f, 4), 1.0f, {-26, 0, 0}), styled(gamma, red));
  add(scene, moved(*torus(15.0f, 6.0f, 60, 30), 1.0f, {26, 0, 0}), styled(gamma, blue));
  const Image before = picture(scene, frontal(100.0f));
  const auto half = [](const Image& image, int first, int end) {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < image.height; ++y)
      pixels.insert(pixels.end(),
                    image.rgba.begin() + 4 * (std::ptrdiff_t(y) * image.width + first),
                    image.rgba.begin() + 4 * (std::ptrdiff_t(y) * image.width + end));
    return pixels;
  };
  // One plane meets the ball alone, one is the ball's own, one meets nothing.
  model::Scene plane = scene;
  cut(plane, AnatomicalView::left, -20.0f);
  model::Scene scoped = scene;
  cut(scoped, AnatomicalView::posterior, 0.0f, ball);
  model::Scene spared = scene;
  cut(spared, AnatomicalView::posterior, -90.0f);
  QVERIFY(picture(spared, frontal(100.0f)) == before);
  for (const model::Scene& changed : {plane, scoped}) {
    const Image image = picture(changed, frontal(100.0f));
    QVERIFY(half(image, 200, 400) == half(before, 200, 400));
    QVERIFY(half(image, 0, 200) != half(before, 0, 200));
  }
}

void SectionLayersTest::keepsLayersThatThePlaneSpares() {
  model::Scene scene;
  add(scene, moved(*sphere(20.0f, 4), 1.0f, {-26, 0, 0}), styled(2.0f, red));
  add(scene, moved(*sphere(20.0f, 4), 1.0f, {26, 0, 0}), styled(2.0f, blue));
  const auto layersDrawn = [&](float mm) {
    model::Scene moved = scene;
    cut(moved, AnatomicalView::left, mm);
    picture(moved, frontal(100.0f));
    return m_studio.picture->timings().layersDrawn;
  };
  picture({}, frontal(100.0f));
  picture(scene, frontal(100.0f));
  QCOMPARE(layersDrawn(-80.0f), 0);
  QCOMPARE(layersDrawn(-30.0f), 1);
  QCOMPARE(layersDrawn(-30.0f), 0);
  QCOMPARE(layersDrawn(-25.0f), 1);
  QCOMPARE(layersDrawn(0.0f), 0);  // one ball is gone, the other whole
  QCOMPARE(layersDrawn(20.0f), 1);
  // A new name is no new picture; hatching is.
  model::Scene named = scene;
  cut(named, AnatomicalView::left, 20.0f);
  std::vector<model::Section> sections = named.sections();
  sections.front().name = "another";
  named.setSections(sections);
  picture(named, frontal(100.0f));
  QCOMPARE(m_studio.picture->timings().layersDrawn, 0);
  sections.front().hatched = true;
  named.setSections(sections);
  picture(named, frontal(100.0f));
  QCOMPARE(m_studio.picture->timings().layersDrawn, 1);
}

void SectionLayersTest::keptLayersGiveTheSamePicture() {
  model::Camera camera;
  camera.eye = {-150.0f, -280.0f, 90.0f};
  for (const float mm : {-20.0f, -4.0f, 9.0f, 33.0f, -20.0f}) {
    model::Scene scene = crowd(3.4f);
    cut(scene, AnatomicalView::left, mm);
    cut(scene, AnatomicalView::inferior, 12.0f);
    const Image kept = picture(scene, camera);
    auto fresh = render::Picture::create();
    QVERIFY(fresh.ok());
    const auto anew = (*fresh)->render(scene, camera, square);
    QVERIFY(anew.ok());
    QVERIFY(difference(kept, *anew).largest <= 2);
  }
}

void SectionLayersTest::piecesGiveTheSamePicture() {
  model::Scene scene = crowd(2.5f);
  cut(scene, AnatomicalView::left, -18.0f);
  cut(scene, AnatomicalView::posterior, -4.0f);
  tintFaces(scene);
  model::Camera camera;
  camera.eye = {-180.0f, -260.0f, 90.0f};
  const Image whole = picture(scene, camera);
  QVERIFY(spot(whole, reddish).count > 1000);
  auto pieces = render::Picture::create({.maximumSide = 110});
  QVERIFY(pieces.ok());
  const auto tiled = (*pieces)->render(scene, camera, square);
  QVERIFY(tiled.ok());
  const Difference d = difference(whole, *tiled);
  QVERIFY2(d.largest <= 2, qPrintable(QString::number(d.largest)));
}

void SectionLayersTest::orderOfStructuresChangesNothing() {
  model::Scene scene = crowd(5.0f);
  cut(scene, AnatomicalView::posterior, 1.0f);
  const Image first = picture(scene, frontal(120.0f));
  std::vector<model::Node> nodes = scene.nodes();
  std::reverse(nodes.begin(), nodes.end());
  scene.setNodes(nodes);
  QCOMPARE(difference(first, picture(scene, frontal(120.0f))).largest, 0);
}

SLINE_TEST_WITH_EVENTS(SectionLayersTest)
#include "section_layers_test.moc"
