// SPDX-License-Identifier: Apache-2.0
// Tests the CPU's share of a picture: places in the atlas, lists of tiles, projected bounds.
#include <QtTest>
#include <random>

#include "render/drawn/picture_view.h"
#include "render/lines/ground/stages.h"
#include "render/picture/shelf_packer.h"
#include "render/picture/surfaces/tile_lists.h"
#include "render/raster/image.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

class LayoutTest : public QObject {
  Q_OBJECT
 private slots:
  void packsWithoutOverlap();
  void refusesWhatDoesNotFit();
  void coarserRectanglesHoldAll();
  void listsLayersInOrder();
  void cutsSquaresAtEdgesOfAreas();
  void masksReachBeyondTheRegion();
  void sphereBoundsHoldTheSphere_data();
  void sphereBoundsHoldTheSphere();
  void stagesOfGamma_data();
  void stagesOfGamma();
  void averagesWeighAlpha();
};

void LayoutTest::packsWithoutOverlap() {
  ShelfPacker packer({512, 2048});
  std::mt19937 random(1);
  std::vector<PixelRect> placed;
  for (int i = 0; i < 60; ++i) {
    const auto place = packer.place(10 + int(random() % 200), 10 + int(random() % 60));
    QVERIFY(place.has_value());
    QVERIFY(place->x >= 0 && place->right() <= 512 && place->top() <= packer.usedHeight());
    for (const PixelRect& other : placed)
      QVERIFY(intersection(*place, other).empty());
    placed.push_back(*place);
  }
}

void LayoutTest::refusesWhatDoesNotFit() {
  ShelfPacker packer({100, 100});
  QVERIFY(!packer.place(101, 10));
  QVERIFY(packer.place(60, 60));
  QVERIFY(!packer.place(60, 60));
  QVERIFY(packer.place(40, 60));
}

void LayoutTest::coarserRectanglesHoldAll() {
  QCOMPARE(coarser({-4, 3, 9, 6}, 3), (PixelRect{-2, 1, 4, 2}));
  for (int step = 1; step <= 4; ++step)
    for (int x = -9; x < 9; ++x)
      for (int width = 1; width < 9; ++width) {
        const PixelRect c = coarser({x, 0, width, 1}, step);
        QVERIFY(step * c.x <= x && x < step * (c.x + 1));
        QVERIFY(step * c.right() >= x + width && step * (c.right() - 1) < x + width);
      }
}

void LayoutTest::listsLayersInOrder() {
  constexpr int square = passes::ResolvePass::tileSide;
  const PixelRect region{100, 0, 3 * square, 2 * square};
  std::array<TileMask, 3> masks{TileMask(region), TileMask(region), TileMask(region)};
  masks[0].mark({100, 0, 1, 1});                             // first tile only
  masks[1].mark({100 + square / 2, square / 4, square, 4});  // first and second
  masks[2].mark({-500, -500, 5, 5});                         // outside of the region
  masks[2].mark({99 + square, square - 1, 2, 2});            // where four tiles meet
  std::vector<ListedLayer> layers;
  for (const TileMask& mask : masks)
    layers.push_back({.mask = &mask,
                      .layer = {.area = {0, 0, 3 * square, 2 * square},
                                .offsetX = int(layers.size()),
                                .inked = true}});
  TileMask wanted(region);
  for (const TileMask& mask : masks)
    wanted.mark(mask);
  const TileLists lists = tileLists(layers, wanted);
  QCOMPARE(lists.tiles.size(), std::size_t(4));
  const auto offsets = [&](std::size_t tile) {
    QList<int> found;
    for (int i = 0; i < lists.tiles[tile].count; ++i)
      found.append((lists.entries[std::size_t(lists.tiles[tile].first + i)].offset & 0xffff) -
                   32768);
    return found;
  };
  QCOMPARE(offsets(0), (QList<int>{0, 1, 2}));
  QCOMPARE(offsets(1), (QList<int>{1, 2}));
  QCOMPARE(offsets(2), (QList<int>{2}));
  QCOMPARE(lists.tiles[2].corner >> 16, square);
  // Squares that are not wanted are left out, and wanted ones without layers are not.
  TileMask some(region);
  some.mark({100, 0, 1, 1});
  const TileLists first = tileLists(layers, some);
  QCOMPARE(first.tiles.size(), std::size_t(1));
  QCOMPARE(first.tiles.front().count, 3);
  const TileLists bare = tileLists({}, some);
  QCOMPARE(bare.tiles.size(), std::size_t(1));
  QCOMPARE(bare.tiles.front().count, 0);
}

void LayoutTest::cutsSquaresAtEdgesOfAreas() {
  constexpr int square = passes::ResolvePass::tileSide;
  const PixelRect region{0, 0, square, square};
  TileMask mask(region);
  mask.markAll();
  const std::vector<ListedLayer> layers{{.mask = &mask, .layer = {.area = {0, 0, 5, square}}},
                                        {.mask = &mask, .layer = {.area = region, .offsetX = 7}}};
  const TileLists lists = tileLists(layers, mask);
  QCOMPARE(lists.tiles.size(), std::size_t(2));
  QCOMPARE(lists.tiles[0].size & 0xffff, 5);
  QCOMPARE(lists.tiles[0].count, 2);
  QCOMPARE(lists.tiles[1].corner & 0xffff, 5);
  QCOMPARE(lists.tiles[1].size & 0xffff, square - 5);
  QCOMPARE(lists.tiles[1].count, 1);
  QCOMPARE(lists.tiles[1].offsets[0], lists.entries.back().offset);
  QCOMPARE(lists.entries.back().offset & 0xffff, 32768 + 7);
}

void LayoutTest::masksReachBeyondTheRegion() {
  constexpr int square = passes::ResolvePass::tileSide;
  const PixelRect region{50, 60, 4 * square, 4 * square};
  const PixelRect area{50 - 3, 60 + 3, 2 * square, 2 * square};
  TileMask mask(region, area);
  QVERIFY(mask.rectangles().empty());
  QVERIFY(!mask.marksAny(area));
  mask.mark({0, 0, 49, 70});
  QVERIFY(mask.marked(-1, 0));
  QVERIFY(!mask.marked(0, 0));
  QVERIFY(mask.marksAny({47, 63, 1, 1}));
  QVERIFY(!mask.marksAny({50, 63, 1, 1}));
  QCOMPARE(mask.rectangles(), (std::vector<PixelRect>{{47, 63, 3, square - 3}}));
  // Squares one above the other are one rectangle, and the area cuts it.
  mask.markAll();
  QCOMPARE(mask.rectangles(), std::vector<PixelRect>{area});
  TileMask whole(region);
  whole.mark(mask);
  QVERIFY(whole.marked(1, 2) && !whole.marked(2, 0) && !whole.marked(0, 3));
  QCOMPARE(whole.square(1, 2), (PixelRect{square, 2 * square, square, square}));
}

void LayoutTest::sphereBoundsHoldTheSphere_data() {
  QTest::addColumn<int>("projection");
  QTest::newRow("perspective") << int(model::Projection::perspective);
  QTest::newRow("parallel") << int(model::Projection::orthographic);
}

void LayoutTest::sphereBoundsHoldTheSphere() {
  QFETCH(int, projection);
  model::Camera camera;
  camera.projection = model::Projection(projection);
  camera.eye = {100.0f, -400.0f, 50.0f};
  const PictureView view(camera, {glm::vec3(-300.0f), glm::vec3(300.0f)}, 640, 480);
  std::mt19937 random(9);
  const auto number = [&] { return float(random() % 2001) / 1000.0f - 1.0f; };
  for (int i = 0; i < 200; ++i) {
    const model::Sphere sphere{150.0f * glm::vec3(number(), number(), number()),
                               10.0f + 5.0f * number()};
    const PixelRect bounds = view.bounds(sphere);
    for (int k = 0; k < 50; ++k) {
      const glm::vec3 direction =
          glm::normalize(glm::vec3(number(), number(), number()) + glm::vec3(1e-4f));
      const glm::vec2 p = view.project(sphere.centre + sphere.radius * direction).pixel;
      QVERIFY(p.x >= float(bounds.x) && p.x <= float(bounds.right()));
      QVERIFY(p.y >= float(bounds.y) && p.y <= float(bounds.top()));
    }
    const float unit = view.millimetresPerPixel(sphere.centre);
    const float expected = model::millimetresPerPixel(camera, sphere.centre, 480.0f);
    QVERIFY(std::abs(unit - expected) < 1e-4f * expected);
    QVERIFY(float(bounds.width) < 4.0f * 15.0f * 720.0f / 200.0f);
  }
}

void LayoutTest::stagesOfGamma_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<QList<float>>("stages");
  QTest::newRow("0") << 0.0f << QList<float>{0.0f, 0.0f, 0.0f, 0.0f, 1.0f};
  QTest::newRow("0.5") << 0.5f << QList<float>{0.5f, 0.0f, 0.0f, 0.0f, 1.0f};
  QTest::newRow("1.25") << 1.25f << QList<float>{1.0f, 0.25f, 0.0f, 0.0f, 1.0f};
  QTest::newRow("3.5") << 3.5f << QList<float>{1.0f, 1.0f, std::pow(0.5f, 0.45f), 0.0f, 1.0f};
  QTest::newRow("4") << 4.0f << QList<float>{1.0f, 1.0f, 1.0f, 0.0f, 1.0f};
  QTest::newRow("4.75") << 4.75f << QList<float>{1.0f, 1.0f, 1.0f, 0.75f, 0.25f};
  QTest::newRow("5") << 5.0f << QList<float>{1.0f, 1.0f, 1.0f, 1.0f, 0.0f};
}

void LayoutTest::stagesOfGamma() {
  QFETCH(float, gamma);
  QFETCH(QList<float>, stages);
  const Transitions t = transitions(Gamma::clamped(gamma));
  QCOMPARE((QList<float>{t.contours, t.suggestive, t.shading, t.complete, t.lines}), stages);
}

void LayoutTest::averagesWeighAlpha() {
  // 4 × 2 pixels: red beside nothing, then four opaque greys.
  const Image image{.width = 4,
                    .height = 2,
                    .rgba = {200, 0, 0, 255, 0, 9, 9, 0, 10, 10, 10, 255, 20, 20, 20, 255,
                             200, 0, 0, 255, 7, 7, 7, 0, 30, 30, 30, 255, 41, 41, 41, 255}};
  const Image expected{.width = 2, .height = 1, .rgba = {200, 0, 0, 128, 25, 25, 25, 255}};
  QCOMPARE(averaged(image, 2), expected);
  QCOMPARE(averaged(image, 1).rgba[0], image.rgba[0]);
  const Image nothing{.width = 2, .height = 2, .rgba = std::vector<std::uint8_t>(16, 0)};
  QCOMPARE(averaged(nothing, 2).rgba, std::vector<std::uint8_t>(4, 0));
}

SLINE_TEST(LayoutTest)
#include "layout_test.moc"
