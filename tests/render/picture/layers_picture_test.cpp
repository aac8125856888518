// SPDX-License-Identifier: Apache-2.0
// Tests layers: order, what is kept between pictures, pieces of large pictures, refusals.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "tests/render/picture/scenes.h"
#include "tests/render/picture/target_pixels.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::PictureSettings;

class LayersPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void orderOfStructuresChangesNothing();
  void keepsWhatDidNotChange();
  void keptLayersGiveTheSamePicture();
  void dragOfGammaDrawsOneLayer_data();
  void dragOfGammaDrawsOneLayer();
  void keptSurfacesGiveTheSamePicture_data();
  void keptSurfacesGiveTheSamePicture();
  void whatLeavesIsGoneFromThePicture();
  void partsAlone_data();
  void partsAlone();
  void piecesGiveTheSamePicture_data();
  void piecesGiveTheSamePicture();
  void targetsGetTheSamePicture_data();
  void targetsGetTheSamePicture();
  void refinedTargetsAreReduced();
  void drawsWhatIsLeftOfNothing();
  void whatTouchesHidesNoOutline();
  void refusesBadRequests();

 private:
  Studio m_studio;
};

namespace {

const PictureSettings settings{.width = 640, .height = 480};

/// Returns a heap of shapes that overlap, in every stage of Γ.
std::vector<model::Node> heap(bool linesOnly = false) {
  std::vector<model::Node> nodes;
  std::mt19937 random(5);
  const auto offset = [&random] { return float(random() % 81) - 40.0f; };
  for (std::uint64_t i = 0; i < 14; ++i) {
    model::Node node;
    node.id = {i + 1};
    node.name = "shape " + std::to_string(i);
    const model::MeshPtr base = i % 2 ? torus(30.0f, 12.0f, 64, 32) : sphere(28.0f, 4);
    node.mesh = moved(*base, 1.0f, {offset(), offset(), offset()});
    node.style = gammaStyle(linesOnly ? 0.25f * float(i % 13) : 5.0f * float(i) / 13.0f);
    node.style.colour = Colour{std::uint8_t(60 + 13 * i), 120, std::uint8_t(220 - 13 * i)};
    if (!linesOnly && i % 5 == 2)
      node.style.opacity = Opacity::clamped(0.6f);
    if (!linesOnly && i % 4 == 1)
      node.style.fill = i % 8 == 1 ? model::Fill::paper : model::Fill::tint;
    nodes.push_back(node);
  }
  return nodes;
}

model::Scene sceneOf(std::vector<model::Node> nodes) {
  model::Scene scene;
  scene.setNodes(std::move(nodes));
  return scene;
}

model::Camera camera() {
  model::Camera c;
  c.eye = {60.0f, -420.0f, 90.0f};
  return c;
}

}  // namespace

void LayersPictureTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

void LayersPictureTest::orderOfStructuresChangesNothing() {
  std::vector<model::Node> nodes = heap();
  // Two structures in one place: ties must not depend on the order either.
  nodes.push_back(nodes[6]);
  nodes.back().id = {99};
  nodes.back().style.colour = Colour{0, 255, 0};
  const auto first = m_studio.picture->render(sceneOf(nodes), camera(), settings);
  QVERIFY(first.ok());
  std::mt19937 random(3);
  for (int i = 0; i < 3; ++i) {
    std::shuffle(nodes.begin(), nodes.end(), random);
    auto fresh = render::Picture::create();
    QVERIFY(fresh.ok());
    const auto again = (*fresh)->render(sceneOf(nodes), camera(), settings);
    QVERIFY(again.ok());
    QCOMPARE(difference(*first, *again).largest, 0);
  }
}

void LayersPictureTest::keepsWhatDidNotChange() {
  render::Picture& picture = *m_studio.picture;
  std::vector<model::Node> nodes = heap(true);
  const auto drawn = [&](const model::Camera& c, const PictureSettings& s) {
    if (auto status = picture.draw(sceneOf(nodes), c, s); !status)
      qFatal("%s", status.error().text().c_str());
    return picture.timings().layersDrawn;
  };
  model::Camera c = camera();
  c.eye.x += 1.0f;
  QCOMPARE(drawn(c, settings), 14);
  QCOMPARE(drawn(c, settings), 0);
  nodes[3].style.gamma = Gamma::clamped(2.5f);
  QCOMPARE(drawn(c, settings), 1);
  nodes[4].style.visible = false;
  QCOMPARE(drawn(c, settings), 0);
  nodes[4].style.visible = true;
  nodes[5].style.penWeight = 3.0f;
  // The heap's bounds shrank and grew with the hidden structure only where it stuck out.
  QVERIFY(drawn(c, settings) <= 14);
  QCOMPARE(drawn(c, settings), 0);
  c.eye.x += 1.0f;
  QCOMPARE(drawn(c, settings), 14);
  PictureSettings larger = settings;
  larger.width += 10;
  QCOMPARE(drawn(c, larger), 14);
}

void LayersPictureTest::keptLayersGiveTheSamePicture() {
  std::vector<model::Node> nodes = heap();
  render::Picture& picture = *m_studio.picture;
  QVERIFY(picture.render(sceneOf(nodes), camera(), settings).ok());
  for (const auto& [index, gamma] : {std::pair{2, 4.5f}, {9, 1.2f}, {13, 0.0f}, {4, 5.0f}}) {
    nodes[std::size_t(index)].style.gamma = Gamma::clamped(gamma);
    // A bolder pen needs a larger place, and may need all places laid out anew.
    const bool bolder = index == 13;
    if (bolder)
      nodes[std::size_t(index)].style.penWeight = 2.5f;
    const auto kept = picture.render(sceneOf(nodes), camera(), settings);
    QVERIFY(kept.ok());
    QVERIFY(bolder || picture.timings().layersDrawn <= 3);
    auto fresh = render::Picture::create();
    QVERIFY(fresh.ok());
    const auto anew = (*fresh)->render(sceneOf(nodes), camera(), settings);
    QVERIFY(anew.ok());
    const Difference d = difference(*kept, *anew);
    // Another place in the atlas may round shading otherwise.
    QVERIFY2(d.largest <= 2, qPrintable(QString("%1, %2 of pixels").arg(d.largest).arg(d.share)));
  }
}

void LayersPictureTest::dragOfGammaDrawsOneLayer_data() {
  QTest::addColumn<int>("index");
  QTest::addColumn<float>("from");
  QTest::addColumn<float>("to");
  QTest::newRow("lines") << 3 << 0.0f << 2.0f;
  QTest::newRow("hatching") << 8 << 2.0f << 3.0f;
  QTest::newRow("shading") << 5 << 3.0f << 4.95f;
  QTest::newRow("back again") << 5 << 4.95f << 0.0f;
}

void LayersPictureTest::dragOfGammaDrawsOneLayer() {
  QFETCH(int, index);
  QFETCH(float, from);
  QFETCH(float, to);
  std::vector<model::Node> nodes = heap(true);
  nodes[std::size_t(index)].style.gamma = Gamma::clamped(from);
  render::Picture& picture = *m_studio.picture;
  QVERIFY(picture.render(sceneOf(nodes), camera(), settings).ok());
  constexpr int steps = 12;
  for (int i = 1; i <= steps; ++i) {
    nodes[std::size_t(index)].style.gamma =
        Gamma::clamped(from + (to - from) * float(i) / float(steps));
    const auto kept = picture.render(sceneOf(nodes), camera(), settings);
    QVERIFY(kept.ok());
    QCOMPARE(picture.timings().layersDrawn, 1);
    if (i % 4 != 0)
      continue;
    auto fresh = render::Picture::create();
    QVERIFY(fresh.ok());
    const auto anew = (*fresh)->render(sceneOf(nodes), camera(), settings);
    QVERIFY(anew.ok());
    QVERIFY(difference(*kept, *anew).largest <= 2);
  }
}

void LayersPictureTest::keptSurfacesGiveTheSamePicture_data() {
  QTest::addColumn<int>("surfaceStep");
  QTest::addColumn<bool>("cut");
  QTest::addColumn<bool>("varies");
  QTest::newRow("whole") << 1 << false << false;
  QTest::newRow("coarse samples") << 3 << false << false;
  QTest::newRow("cut") << 1 << true << false;
  QTest::newRow("Γ varies") << 1 << false << true;
}

/// One changes a structure step by step: each picture is as if there had been none before.
void LayersPictureTest::keptSurfacesGiveTheSamePicture() {
  QFETCH(int, surfaceStep);
  QFETCH(bool, cut);
  QFETCH(bool, varies);
  model::Scene scene = sceneOf(heap());
  if (cut)
    scene.setSections(
        {{.id = {1}, .plane = model::anatomicalPlane(model::AnatomicalView::posterior, 4.0f)}});
  PictureSettings asked = settings;
  asked.surfaceStep = surfaceStep;
  constexpr std::size_t own = 5;
  model::Style style = scene.nodes()[own].style;
  if (varies)
    style.gammaMap = {.scalar = model::GammaScalar::occlusion,
                      .curve = {{0.0f, -1.5f}, {1.0f, 1.5f}}};
  const std::vector<std::function<void(model::Style&)>> steps = {
      [](model::Style& s) { s.gamma = Gamma::clamped(2.0f); },
      [](model::Style& s) { s.gamma = Gamma::clamped(1.0f); },
      [](model::Style& s) { s.gamma = Gamma::clamped(4.9f); },
      [](model::Style& s) { s.gamma = Gamma::clamped(3.4f); },
      [](model::Style& s) { s.gamma = Gamma::clamped(4.2f); },
      [](model::Style& s) {
        s.colour = Colour{20, 200, 90};
      },
      [](model::Style& s) { s.opacity = Opacity::clamped(0.4f); },
      [](model::Style& s) { s.fill = model::Fill::paper; },
      [](model::Style& s) { s.gamma = Gamma::clamped(2.5f); },
      [](model::Style& s) { s.penWeight = 2.0f; },
      [](model::Style& s) { s.gamma = Gamma::clamped(3.9f); },
      [](model::Style& s) { s.gamma = Gamma::clamped(5.0f); },
      [](model::Style& s) { s.gamma = Gamma::clamped(4.0f); },
  };
  render::Picture& picture = *m_studio.picture;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::vector<model::Node> nodes = scene.nodes();
    steps[i](style);
    nodes[own].style = style;
    // Another one is changed in between.
    if (i % 4 == 3)
      nodes[8].style.gamma = Gamma::clamped(3.0f + 0.1f * float(i));
    scene.setNodes(std::move(nodes));
    const auto kept = picture.render(scene, camera(), asked);
    const auto fresh = render::Picture::create();
    QVERIFY(fresh.ok());
    const auto anew = (*fresh)->render(scene, camera(), asked);
    QVERIFY(kept.ok() && anew.ok());
    const Difference d = difference(*kept, *anew);
    QVERIFY2(d.largest == 0,
             qPrintable(QString("step %1: %2, %3 of pixels").arg(i).arg(d.largest).arg(d.share)));
  }
}

void LayersPictureTest::whatLeavesIsGoneFromThePicture() {
  // Only squares that change are blended anew: where a structure stood alone, nothing else would.
  model::Scene scene;
  add(scene, moved(*sphere(20.0f, 3), 1.0f, {-60.0f, 0.0f, 0.0f}), gammaStyle(2.0f));
  const model::NodeId id =
      add(scene, moved(*sphere(20.0f, 3), 1.0f, {60.0f, 0.0f, 0.0f}), gammaStyle(4.0f));
  add(scene, moved(*sphere(80.0f, 3), 1.0f, {0.0f, 0.0f, 0.0f}), gammaStyle(1.0f));
  render::Picture& picture = *m_studio.picture;
  QVERIFY(picture.render(scene, camera(), settings).ok());
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (node.id == id)
      node.style.visible = false;
  const auto without = picture.render(sceneOf(nodes), camera(), settings);
  QVERIFY(without.ok());
  QCOMPARE(picture.timings().layersDrawn, 0);
  auto fresh = render::Picture::create();
  QVERIFY(fresh.ok());
  const auto anew = (*fresh)->render(sceneOf(nodes), camera(), settings);
  QVERIFY(anew.ok());
  QCOMPARE(difference(*without, *anew).largest, 0);
}

void LayersPictureTest::partsAlone_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<bool>("lines");
  QTest::addColumn<bool>("fills");
  QTest::addColumn<bool>("drawsInk");
  QTest::addColumn<bool>("drawsColour");
  QTest::newRow("lines of a drawing") << 2.0f << true << false << true << false;
  QTest::newRow("fills of a drawing: none") << 2.0f << false << true << false << false;
  QTest::newRow("lines while the fill closes") << 4.5f << true << false << true << false;
  QTest::newRow("fills while lines leave") << 4.5f << false << true << false << true;
  QTest::newRow("lines of a shaded surface: none") << 5.0f << true << false << false << false;
  QTest::newRow("fills of a shaded surface") << 5.0f << false << true << false << true;
  QTest::newRow("nothing") << 4.5f << false << false << false << false;
}

void LayersPictureTest::partsAlone() {
  QFETCH(float, gamma);
  QFETCH(bool, lines);
  QFETCH(bool, fills);
  model::Scene scene;
  model::Style style = gammaStyle(gamma);
  style.colour = Colour{250, 60, 60};
  add(scene, torus(30.0f, 12.0f, 96, 48), style);
  PictureSettings asked = settings;
  // The whole picture is drawn first: nothing kept from it may show in the parts.
  const auto whole = m_studio.picture->render(scene, camera(), asked);
  QVERIFY(whole.ok());
  asked.parts = {.lines = lines, .hatching = false, .fills = fills};
  const auto part = m_studio.picture->render(scene, camera(), asked);
  QVERIFY(part.ok());
  std::size_t ink = 0;
  std::size_t colour = 0;
  for (std::size_t i = 0; i < part->rgba.size(); i += 4) {
    const int red = part->rgba[i];
    const int blue = part->rgba[i + 2];
    ink += red == blue && red < 230;
    colour += red > blue + 40;
  }
  QTEST(ink > 100, "drawsInk");
  QTEST(colour > 1000, "drawsColour");
  if (!lines && !fills)
    QCOMPARE(ink + colour, std::size_t(0));
}

void LayersPictureTest::piecesGiveTheSamePicture_data() {
  QTest::addColumn<bool>("linesOnly");
  QTest::addColumn<int>("side");
  QTest::addColumn<int>("atlasPixels");
  QTest::addColumn<int>("tolerance");
  // Interpolated shading may round to the other side; lines are equal byte for byte.
  QTest::newRow("lines, small pieces") << true << 100 << 20'000'000 << 0;
  QTest::newRow("lines, small atlas") << true << 0 << 200'000 << 0;
  QTest::newRow("all stages, small pieces") << false << 150 << 20'000'000 << 2;
}

void LayersPictureTest::piecesGiveTheSamePicture() {
  QFETCH(bool, linesOnly);
  QFETCH(int, side);
  QFETCH(int, atlasPixels);
  QFETCH(int, tolerance);
  const model::Scene scene = sceneOf(heap(linesOnly));
  const auto whole = m_studio.picture->render(scene, camera(), settings);
  QVERIFY(whole.ok());
  auto pieces =
      render::Picture::create({.maximumSide = side, .atlasPixels = std::size_t(atlasPixels)});
  QVERIFY(pieces.ok());
  const auto tiled = (*pieces)->render(scene, camera(), settings);
  QVERIFY2(tiled.ok(), tiled.ok() ? "" : tiled.error().text().c_str());
  QVERIFY((*pieces)->timings().layersDrawn > 14);
  const Difference d = difference(*whole, *tiled);
  QVERIFY2(d.largest <= tolerance,
           qPrintable(QString("%1, %2 of pixels").arg(d.largest).arg(d.share)));
}

void LayersPictureTest::targetsGetTheSamePicture_data() {
  QTest::addColumn<int>("maximumSide");
  QTest::newRow("whole") << 0;
  QTest::newRow("in pieces") << 200;
}

void LayersPictureTest::targetsGetTheSamePicture() {
  QFETCH(int, maximumSide);
  const auto drawn = render::Picture::create({.maximumSide = maximumSide});
  QVERIFY(drawn.ok());
  render::Picture& picture = **drawn;
  const model::Scene scene = sceneOf(heap());
  const auto image = picture.render(scene, camera(), settings);
  QVERIFY(image.ok());

  TargetPixels pixels(settings);
  QVERIFY(pixels.ok());
  pixels.clear();
  // The picture is given up before it is done, and then it is not.
  std::atomic<bool> unwanted = true;
  model::Camera other = camera();
  other.eye.x += 5.0f;
  const auto none = picture.drawInto({pixels.target(), &unwanted}, scene, other, settings);
  QVERIFY(none.ok() && !*none);
  unwanted = false;
  const auto done = picture.drawInto({pixels.target(), &unwanted}, scene, camera(), settings);
  QVERIFY(done.ok() && *done);
  QCOMPARE(difference(pixels.image(), *image).largest, 0);
}

/// It is the picture of four samples a pixel, as exports have it, and what was kept stays.
void LayersPictureTest::refinedTargetsAreReduced() {
  const auto drawn = render::Picture::create();
  QVERIFY(drawn.ok());
  render::Picture& picture = **drawn;
  const model::Scene scene = sceneOf(heap());
  const auto expected = picture.render(scene, camera(), settings, 2);
  const auto plain = picture.render(scene, camera(), settings);
  QVERIFY(expected.ok() && plain.ok());

  TargetPixels pixels(settings);
  QVERIFY(pixels.ok());
  std::atomic<bool> unwanted = true;
  const auto none = picture.refineInto({pixels.target(), &unwanted}, scene, camera(), settings);
  QVERIFY(none.ok() && !*none);
  unwanted = false;
  const auto done = picture.refineInto({pixels.target(), &unwanted}, scene, camera(), settings);
  QVERIFY(done.ok() && *done);
  const Image refined = pixels.image();
  QVERIFY(difference(refined, *expected).largest <= 1);
  QVERIFY(difference(refined, *plain).largest > 32);
  QVERIFY(picture.draw(scene, camera(), settings).ok());
  QCOMPARE(picture.timings().layersDrawn, 0);
}

void LayersPictureTest::drawsWhatIsLeftOfNothing() {
  const auto empty = m_studio.picture->render({}, camera(), settings);
  QVERIFY(empty.ok());
  QCOMPARE(pixelAt(*empty, 320, 240).grey(), 255);
  // A structure behind the eye leaves the picture empty too.
  model::Scene behind;
  add(behind, moved(*sphere(20.0f, 3), 1.0f, {0.0f, -2000.0f, 0.0f}), gammaStyle(2.0f));
  const auto image = m_studio.picture->render(behind, camera(), settings);
  QVERIFY(image.ok());
  QCOMPARE(difference(*empty, *image).largest, 0);
}

/// Structures of one label map share the surface at which they touch: here a ring of paper that
/// begins where a ball's contour lies, a little nearer to the eye.
void LayersPictureTest::whatTouchesHidesNoOutline() {
  constexpr int around = 256;
  std::vector<glm::vec3> positions;
  std::vector<model::Triangle> triangles;
  for (std::uint32_t i = 0; i < around; ++i) {
    const float angle = 2.0f * 3.14159265f * float(i) / float(around);
    for (const float radius : {30.0f, 45.0f})
      positions.emplace_back(radius * std::cos(angle), -0.5f, radius * std::sin(angle));
    const std::uint32_t next = 2 * ((i + 1) % around);
    triangles.push_back({2 * i, 2 * i + 1, next + 1});
    triangles.push_back({2 * i, next + 1, next});
  }
  model::Node ball{.id = {1}, .name = "ball", .style = gammaStyle(1.0f), .mesh = sphere(30, 5)};
  ball.style.fill = model::Fill::paper;
  ball.style.lineVariation = 0.0f;
  model::Node ring{.id = {2}, .name = "ring", .style = gammaStyle(1.0f)};
  ring.mesh = std::make_shared<const model::Mesh>(
      std::move(*model::Mesh::create(std::move(positions), std::move(triangles))));
  ring.style.fill = model::Fill::paper;
  ring.style.penWeight = 0.0f;
  const model::Camera front = frontal(120.0f);
  const auto ink = [&](std::vector<model::Node> nodes) {
    const auto image = m_studio.picture->render(sceneOf(std::move(nodes)), front, settings);
    double sum = 0.0;
    for (std::size_t i = 1; image.ok() && i < image->rgba.size(); i += 4)
      sum += 255.0 - image->rgba[i];
    return sum;
  };
  const double alone = ink({ball});
  QVERIFY(alone > 100'000.0);
  const double touched = ink({ball, ring});
  QVERIFY2(touched > 0.97 * alone, qPrintable(QString::number(touched / alone)));
  // The ring does cover what lies behind it; a stroke begins half a pixel within its contour.
  ball.mesh = moved(*ball.mesh, 1.0f, {0.0f, 20.0f, 0.0f});
  const double behind = ink({ball, ring});
  QVERIFY2(behind < 0.5 * alone, qPrintable(QString::number(behind / alone)));
}

void LayersPictureTest::refusesBadRequests() {
  const model::Scene scene = sceneOf(heap());
  QVERIFY(!m_studio.picture->render(scene, camera(), {.width = 0, .height = 10}).ok());
  QVERIFY(!m_studio.picture->render(scene, camera(), {.width = 10, .height = -4}).ok());
  model::Camera blind = camera();
  blind.eye = blind.target;
  const auto image = m_studio.picture->render(scene, blind, settings);
  QVERIFY(!image.ok());
  QCOMPARE(image.error().where, std::string("camera"));
}

SLINE_TEST_WITH_EVENTS(LayersPictureTest)
#include "layers_picture_test.moc"
