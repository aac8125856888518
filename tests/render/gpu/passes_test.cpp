// SPDX-License-Identifier: Apache-2.0
// Compares the resolve pass with a reference on the CPU that sorts every pixel's layers, and the
// ink pass with the capsules that it is to draw.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "render/gpu/headless/context.h"
#include "render/passes/hatching/hatching_pass.h"
#include "render/passes/ink/ink_batch.h"
#include "render/passes/ink/ink_pass.h"
#include "render/passes/plain_phong/plain_phong_pass.h"
#include "render/passes/resolve/resolve_pass.h"
#include "render/passes/surface/surface_pass.h"
#include "render/passes/surface/wipe_pass.h"
#include "render/picture/surfaces/tile_lists.h"
#include "render/strokes/stroke_maker.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;
using passes::ResolveLayer;
using passes::ResolvePass;

namespace {

constexpr int side = 96;
constexpr int atlasWidth = 256;
constexpr int atlasHeight = 512;

/// Holds the pixels of an atlas as the GPU holds them.
struct AtlasPixels {
  std::vector<std::uint8_t> colours = std::vector<std::uint8_t>(4 * atlasWidth * atlasHeight);
  std::vector<std::uint8_t> inks = std::vector<std::uint8_t>(atlasWidth * atlasHeight);
  std::vector<float> depths = std::vector<float>(atlasWidth * atlasHeight, 1.0f);
};

struct Case {
  AtlasPixels pixels;
  std::vector<ResolveLayer> layers;
};

Case randomCase(int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return int(random() % std::uint32_t(n)); };
  Case c;
  for (int i = 0; i < count; ++i) {
    const int width = 20 + below(44);
    const int height = 20 + below(28);
    const PixelRect slot{(i % 4) * 64, (i / 4) * 48, width, height};
    const PixelRect area{below(side - width), below(side - height), width, height};
    ResolveLayer layer{.area = area,
                       .offsetX = slot.x - area.x,
                       .offsetY = slot.y - area.y,
                       .ink = Colour{std::uint8_t(below(256)), 40, std::uint8_t(below(256))},
                       .filled = below(3) != 0,
                       .inked = below(3) != 0};
    for (int y = slot.y; y < slot.top(); ++y)
      for (int x = slot.x; x < slot.right(); ++x) {
        const std::size_t p = std::size_t(y) * atlasWidth + x;
        // There are few depths, so that ties happen everywhere; some pixels hold nothing.
        c.pixels.depths[p] = below(4) == 0 ? 1.0f : 0.125f * float(1 + below(6));
        const int alpha = below(3) == 0 ? 255 : below(256);
        for (std::size_t k = 0; k < 3; ++k)
          c.pixels.colours[4 * p + k] = std::uint8_t(below(alpha + 1));
        c.pixels.colours[4 * p + 3] = std::uint8_t(alpha);
        c.pixels.inks[p] = std::uint8_t(below(2) == 0 ? 0 : below(256));
      }
    c.layers.push_back(layer);
  }
  return c;
}

glm::vec4 layerColour(const AtlasPixels& pixels, const ResolveLayer& layer, std::size_t p) {
  glm::vec4 colour(0.0f);
  if (layer.filled)
    for (int k = 0; k < 4; ++k)
      colour[k] = float(pixels.colours[4 * p + k]) / 255.0f;
  if (layer.inked) {
    const float coverage = float(pixels.inks[p]) / 255.0f;
    const glm::vec4 ink(float(layer.ink.red) / 255.0f, float(layer.ink.green) / 255.0f,
                        float(layer.ink.blue) / 255.0f, 1.0f);
    colour = ink * coverage + colour * (1.0f - coverage);
  }
  return colour;
}

glm::vec4 reference(const Case& c, int x, int y, const glm::vec4& background) {
  struct Item {
    float depth;
    glm::vec4 colour;
  };
  std::vector<Item> items;
  for (const ResolveLayer& layer : c.layers) {
    if (intersection(layer.area, {x, y, 1, 1}).empty())
      continue;
    const std::size_t p = std::size_t(y + layer.offsetY) * atlasWidth + x + layer.offsetX;
    if (c.pixels.depths[p] < 1.0f)
      items.push_back({c.pixels.depths[p], layerColour(c.pixels, layer, p)});
  }
  std::ranges::stable_sort(items, {}, &Item::depth);
  glm::vec4 result = background;
  for (auto item = items.rbegin(); item != items.rend(); ++item)
    result = item->colour + result * (1.0f - item->colour.a);
  return result;
}

}  // namespace

class PassesTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void shadersSpeakBothDialects_data();
  void shadersSpeakBothDialects();
  void resolvesLikeTheReference_data();
  void resolvesLikeTheReference();
  void strokesHaveTheirWidth_data();
  void strokesHaveTheirWidth();
  void jointsDoNotDarken();
  void bendsStayClosed_data();
  void bendsStayClosed();
  void longStrokesAreOneCapsule();
  void linesEndWhereTheirSurfaceHidesThem_data();
  void linesEndWhereTheirSurfaceHidesThem();
  void moreStrokesThanABatchHolds();

 private:
  std::vector<std::uint8_t> resolved(const Case& c, const glm::vec4& background);
  /// Returns the ink's coverage, 0 … 255, where something nearer lies in the rectangle.
  std::vector<int> inked(std::span<const Stroke> segments, InkKind kind = InkKind::surfaceLines,
                         const PixelRect& nearer = {});
  std::unique_ptr<gpu::HeadlessContext> m_context;
  std::unique_ptr<gpu::Device> m_device;
};

void PassesTest::initTestCase() {
  auto context = gpu::HeadlessContext::create();
  if (!context)
    QSKIP(context.error().text().c_str());
  m_context = std::move(*context);
  m_device = std::move(gpu::Device::create().value());
}

void PassesTest::shadersSpeakBothDialects_data() {
  QTest::addColumn<int>("dialect");
  QTest::newRow("OpenGL 3.3") << int(gpu::Dialect::desktop330);
  QTest::newRow("OpenGL ES 3.0") << int(gpu::Dialect::es300);
}

void PassesTest::shadersSpeakBothDialects() {
  QFETCH(int, dialect);
  const auto d = gpu::Dialect(dialect);
  const auto check = [](const auto& pass) {
    QVERIFY2(pass.ok(), pass.ok() ? "" : pass.error().text().c_str());
  };
  check(passes::SurfacePass::create(d));
  check(passes::WipePass::create(d));
  check(passes::HatchingPass::create(d));
  check(passes::InkPass::create(d));
  check(ResolvePass::create(d));
  check(passes::PlainPhongPass::create(d));
}

std::vector<std::uint8_t> PassesTest::resolved(const Case& c, const glm::vec4& background) {
  const gpu::TextureSize size{atlasWidth, atlasHeight};
  gpu::Texture colours(gpu::TextureFormat::rgba8, size, "colours");
  gpu::Texture inks(gpu::TextureFormat::rg8, size, "inks");
  gpu::Texture depths(gpu::TextureFormat::depth32f, size, "depths");
  const auto put = [](const Status& done) {
    if (!done)
      qFatal("%s", done.error().text().c_str());
  };
  put(colours.upload(std::as_bytes(std::span(c.pixels.colours)), atlasHeight));
  std::vector<std::uint8_t> pairs;  // each with nothing hidden
  for (const std::uint8_t ink : c.pixels.inks)
    pairs.insert(pairs.end(), {ink, 0});
  put(inks.upload(std::as_bytes(std::span(pairs)), atlasHeight));
  // Depth comes from clears, as it cannot be uploaded.
  auto depthTarget = std::move(gpu::Target::create({{}, &depths}, "depths").value());
  m_device->clear(*depthTarget, {.depth = 1.0f});
  for (int y = 0; y < atlasHeight; ++y)
    for (int x = 0; x < atlasWidth; ++x)
      if (const float d = c.pixels.depths[std::size_t(y) * atlasWidth + x]; d < 1.0f)
        m_device->clear(*depthTarget, {.depth = d, .area = PixelRect{x, y, 1, 1}});
  const PixelRect region{0, 0, side, side};
  std::vector<TileMask> masks(c.layers.size(), TileMask(region));
  std::vector<ListedLayer> listed;
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    masks[i].mark(c.layers[i].area);
    listed.push_back({.mask = &masks[i], .layer = c.layers[i]});
  }
  TileMask wanted(region);
  wanted.markAll();
  const TileLists lists = tileLists(listed, wanted);
  gpu::Texture picture(gpu::TextureFormat::rgba8, {side, side}, "picture");
  auto target = std::move(gpu::Target::create({{&picture}, nullptr}, "picture").value());
  auto pass = std::move(ResolvePass::create(m_device->dialect()).value());
  put(pass->upload(lists.tiles, lists.entries));
  pass->draw(*m_device, *target,
             {.colours = colours, .inks = inks, .depths = depths, .background = background});
  std::vector<std::uint8_t> rgba(4 * side * side);
  put(m_device->read(*target, {0, 0, side, side}, std::as_writable_bytes(std::span(rgba))));
  return rgba;
}

void PassesTest::resolvesLikeTheReference_data() {
  QTest::addColumn<int>("layers");
  QTest::addColumn<bool>("transparent");
  QTest::newRow("one layer") << 1 << false;
  QTest::newRow("a few") << 5 << false;
  QTest::newRow("more than texture units") << 36 << false;
  QTest::newRow("on nothing") << 12 << true;
}

void PassesTest::resolvesLikeTheReference() {
  QFETCH(int, layers);
  QFETCH(bool, transparent);
  const glm::vec4 background = transparent ? glm::vec4(0.0f) : glm::vec4(1.0f, 0.9f, 0.8f, 1.0f);
  const Case c = randomCase(layers, 7u + std::uint32_t(layers));
  const std::vector<std::uint8_t> rgba = resolved(c, background);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::vec4 expected = 255.0f * reference(c, x, y, background);
      for (int k = 0; k < 4; ++k) {
        const float got = rgba[4 * (std::size_t(y) * side + x) + k];
        QVERIFY2(
            std::abs(got - expected[k]) <= 1.01f,
            qPrintable(
                QString("(%1, %2).%3: %4 for %5").arg(x).arg(y).arg(k).arg(got).arg(expected[k])));
      }
    }
}

std::vector<int> PassesTest::inked(std::span<const Stroke> segments, InkKind kind,
                                   const PixelRect& nearer) {
  const gpu::TextureSize size{64, 64};
  gpu::Texture ink(gpu::TextureFormat::rg8, size, "ink");
  gpu::Texture layerDepths(gpu::TextureFormat::depth32f, size, "layer");
  gpu::Texture surfaceDepths(gpu::TextureFormat::depth32f, size, "surface");
  auto target = std::move(gpu::Target::create({{&ink}, &layerDepths}, "ink").value());
  auto surface = std::move(gpu::Target::create({{}, &surfaceDepths}, "surface").value());
  m_device->clear(*target, {.colour = glm::vec4(0.0f), .depth = 1.0f});
  m_device->clear(*surface, {.depth = 1.0f});
  auto pass = std::move(passes::InkPass::create(m_device->dialect()).value());
  if (!nearer.empty())
    m_device->clear(*surface, {.depth = 0.3f, .area = nearer});
  const InkDraw draw{.kind = kind,
                     .strokes = segments,
                     .layer = {0, 0, 64, 64},
                     .slot = {0, 0, 64, 64},
                     .projection = {-1.0f, 0.0f, 0.0f, 1.0f}};
  const Status drawn = pass->draw(*m_device, {*target, *target}, {surfaceDepths}, {&draw, 1});
  if (!drawn)
    qFatal("%s", drawn.error().text().c_str());
  std::vector<std::uint8_t> rgba(4 * 64 * 64);
  if (const Status read =
          m_device->read(*target, {0, 0, 64, 64}, std::as_writable_bytes(std::span(rgba)));
      !read)
    qFatal("%s", read.error().text().c_str());
  std::vector<int> coverage;
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    coverage.push_back(rgba[i]);
  return coverage;
}

void PassesTest::strokesHaveTheirWidth_data() {
  QTest::addColumn<float>("halfWidth");
  QTest::addColumn<float>("slope");
  QTest::addColumn<float>("offset");
  for (const float halfWidth : {0.5f, 1.0f, 2.75f})
    for (const float slope : {0.0f, 0.4f, 1.0f})
      for (const float offset : {0.0f, 0.3f})
        QTest::addRow("%g px, slope %g, at %g", double(2.0f * halfWidth), double(slope),
                      double(offset))
            << halfWidth << slope << offset;
}

void PassesTest::strokesHaveTheirWidth() {
  QFETCH(float, halfWidth);
  QFETCH(float, slope);
  QFETCH(float, offset);
  const float y0 = 32.0f + offset - 32.0f * slope;
  const Stroke line{.a = {-10.0f, y0 - 10.0f * slope},
                    .b = {74.0f, y0 + 74.0f * slope},
                    .depthA = 0.5f,
                    .depthB = 0.5f,
                    .halfWidthA = halfWidth,
                    .halfWidthB = halfWidth};
  const std::vector<int> coverage = inked({&line, 1});
  // Down a column the ink adds up to the width, seen at that slope.
  const float expected = 2.0f * halfWidth * std::sqrt(1.0f + slope * slope);
  for (const std::size_t x : {24u, 30u, 37u}) {
    float sum = 0.0f;
    for (std::size_t y = 0; y < 64; ++y)
      sum += float(coverage[y * 64 + x]) / 255.0f;
    QVERIFY2(std::abs(sum - expected) < 0.13f + 0.05f * expected,
             qPrintable(QString("column %1: %2 for %3").arg(x).arg(sum).arg(expected)));
  }
}

void PassesTest::jointsDoNotDarken() {
  const auto piece = [](float from, float to) {
    return Stroke{.a = {from, 32.5f},
                  .b = {to, 32.5f},
                  .depthA = 0.5f,
                  .depthB = 0.5f,
                  .halfWidthA = 1.2f,
                  .halfWidthB = 1.2f,
                  .opacityA = 0.6f,
                  .opacityB = 0.6f};
  };
  const std::vector<Stroke> whole{piece(10.0f, 50.0f)};
  std::vector<Stroke> pieces;
  for (int i = 0; i < 16; ++i)
    pieces.push_back(piece(10.0f + 2.5f * float(i), 12.5f + 2.5f * float(i)));
  const std::vector<int> one = inked(whole);
  const std::vector<int> many = inked(pieces);
  for (std::size_t i = 0; i < one.size(); ++i)
    QVERIFY(std::abs(one[i] - many[i]) <= 1);
  QCOMPARE(one[32 * 64 + 30], 153);
  std::ranges::reverse(pieces);
  QCOMPARE(inked(pieces), many);
}

void PassesTest::bendsStayClosed_data() {
  QTest::addColumn<float>("turn");
  for (const float turn : {0.0f, 0.3f, 1.0f, 2.0f, 3.1f})
    QTest::addRow("%g", double(turn)) << turn;
}

void PassesTest::bendsStayClosed() {
  QFETCH(float, turn);
  const model::Surface surface{};
  const model::Camera camera{.projection = model::Projection::orthographic,
                             .eye = {0, -100, 0},
                             .target = {0, 0, 0},
                             .up = {0, 0, 1},
                             .heightMm = 64.0f};
  model::Box bounds;
  bounds.add(glm::vec3(-60.0f));
  bounds.add(glm::vec3(60.0f));
  const PictureView view(camera, bounds, 64, 64);
  StrokeMaker maker(surface, view, view.whole());
  glm::vec3 at(-10.0f, 0.0f, -10.0f);
  float angle = 0.4f;
  for (int i = 0; i < 4; ++i, angle += turn) {
    const glm::vec3 next = at + 8.0f * glm::vec3(std::cos(angle), 0.0f, std::sin(angle));
    maker.contour({.a = at, .b = next, .normalA = {0, 0, 1}, .normalB = {0, 0, 1}}, 5.0f, 1.0f,
                  1.0f);
    at = next;
  }
  const std::vector<Stroke> joined = maker.take();
  std::vector<Stroke> whole = joined;
  QCOMPARE(std::ranges::count(joined, Stroke::whole, &Stroke::capA), 1);
  for (Stroke& s : whole)
    s.capA = s.capB = Stroke::whole;
  const std::vector<int> one = inked(whole);
  const std::vector<int> other = inked(joined);
  QVERIFY(std::ranges::count(one, 255) > 30);
  for (std::size_t i = 0; i < one.size(); ++i)
    QVERIFY(std::abs(one[i] - other[i]) <= 2);
}

void PassesTest::longStrokesAreOneCapsule() {
  // So long that sight is found in several pieces, and with everything that varies along it.
  const Stroke s{.a = {6.3f, 8.1f},
                 .b = {57.2f, 51.4f},
                 .depthA = 0.5f,
                 .depthB = 0.6f,
                 .kind = StrokeKind::contour,
                 .moveA = {0.5f, -1.0f},
                 .moveB = {-2.0f, 1.5f},
                 .outwardA = {0.0f, 1.0f},
                 .outwardB = {-1.0f, 0.0f},
                 .halfWidthA = 0.7f,
                 .halfWidthB = 4.0f,
                 .opacityA = 0.9f,
                 .opacityB = 0.4f};
  QVERIFY(inkPieces(s) > 3);
  const std::vector<int> coverage = inked({&s, 1}, InkKind::contours);
  const glm::vec2 a = s.a + s.moveA + (s.halfWidthA - 0.5f) * s.outwardA;
  const glm::vec2 b = s.b + s.moveB + (s.halfWidthB - 0.5f) * s.outwardB;
  for (int i = 0; i < 64 * 64; ++i) {
    const glm::vec2 pixel(float(i % 64) + 0.5f, float(i / 64) + 0.5f);
    const float t = std::clamp(glm::dot(pixel - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
    const float away = glm::distance(pixel, glm::mix(a, b, t));
    const float expected =
        255.0f * glm::mix(s.opacityA, s.opacityB, t) *
        std::clamp(glm::mix(s.halfWidthA, s.halfWidthB, t) - away + 0.5f, 0.0f, 1.0f);
    QVERIFY2(std::abs(float(coverage[std::size_t(i)]) - expected) < 4.0f,
             qPrintable(QString("(%1, %2): %3 for %4")
                            .arg(i % 64)
                            .arg(i / 64)
                            .arg(coverage[std::size_t(i)])
                            .arg(expected)));
  }
}

void PassesTest::linesEndWhereTheirSurfaceHidesThem_data() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<float>("piece");
  for (const float piece : {44.0f, 11.0f, 2.75f, 0.5f}) {
    QTest::addRow("lines on the surface, %g px", double(piece))
        << int(InkKind::surfaceLines) << piece;
    QTest::addRow("contours, %g px", double(piece)) << int(InkKind::contours) << piece;
  }
}

void PassesTest::linesEndWhereTheirSurfaceHidesThem() {
  QFETCH(int, kind);
  QFETCH(float, piece);
  std::vector<Stroke> line;
  for (float x = 10.0f; x < 53.9f; x += piece)
    line.push_back(
        {.a = {x, 32.5f},
         .b = {x + piece, 32.5f},
         .depthA = 0.5f,
         .depthB = 0.5f,
         .kind = kind == int(InkKind::surfaceLines) ? StrokeKind::surfaceLine : StrokeKind::contour,
         .outwardA = {0.0f, 1.0f},
         .outwardB = {0.0f, 1.0f},
         .halfWidthA = 1.5f,
         .halfWidthB = 1.5f,
         .capA = 0.25f,
         .capB = 0.25f});
  const auto at = [&](const std::vector<int>& coverage, int x) {
    return coverage[33 * 64 + std::size_t(x)];
  };
  const auto inkKind = InkKind(kind);
  const auto all = inked(line, inkKind);
  const auto some = inked(line, inkKind, {30, 0, 17, 64});
  for (int x = 12; x < 52; ++x) {
    QCOMPARE(at(all, x), 255);
    // The surface itself ends at whole pixels, and sight is found a pixel apart.
    if (x < 29 || x > 47)
      QCOMPARE(at(some, x), 255);
    if (x > 30 && x < 46)
      QCOMPARE(at(some, x), 0);
  }
}

void PassesTest::moreStrokesThanABatchHolds() {
  const auto dot = [](float x) {
    return Stroke{.a = {x, 32.0f},
                  .b = {x + 2.0f, 32.0f},
                  .depthA = 0.5f,
                  .depthB = 0.5f,
                  .halfWidthA = 2.0f,
                  .halfWidthB = 2.0f};
  };
  constexpr std::size_t most =
      std::size_t(passes::InkBatch::perRow) * std::size_t(passes::InkBatch::mostRows);
  std::vector<Stroke> strokes(most, dot(20.0f));
  strokes.push_back(dot(40.0f));
  const std::vector<int> coverage = inked(strokes);
  QCOMPARE(coverage[32 * 64 + 21], 255);
  QCOMPARE(coverage[32 * 64 + 41], 255);
  QCOMPARE(coverage[32 * 64 + 31], 0);
}

SLINE_TEST_WITH_EVENTS(PassesTest)
#include "passes_test.moc"
