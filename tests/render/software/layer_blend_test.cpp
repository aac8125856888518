// SPDX-License-Identifier: Apache-2.0
// Compares what is blended, several pixels at once, with each pixel by itself.
#include "render/software/layer_blend.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <random>
#include <vector>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

constexpr PixelRect region{3, 5, 83, 61};
/// Colours are rounded, and what opacity of 254.5 of 255 hides is left out.
constexpr float tolerance = 1.05f / 255.0f;
constexpr glm::vec4 ground(0.9f, 0.8f, 0.7f, 1.0f);

/// A layer of one picture, made up.
struct MadeLayer {
  LayerPixels pixels;
  TileMask mask;
  BlendLayer layer;
};

glm::vec4 unpacked(std::uint32_t word) {
  return glm::vec4(float(word & 255u), float((word >> 8) & 255u), float((word >> 16) & 255u),
                   float(word >> 24)) /
         255.0f;
}

class Maker {
 public:
  explicit Maker(unsigned seed) : m_random(seed) {}

  int whole(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(m_random);
  }
  float share() { return std::uniform_real_distribution<float>(0.0f, 1.0f)(m_random); }

  /// Makes a layer that lies about so deep, its depth varying by so much across the picture.
  MadeLayer layer(float depth, float slope, bool hiddenLines) {
    MadeLayer made;
    const int x = whole(region.x, region.right() - 30);
    const int y = whole(region.y, region.top() - 30);
    made.pixels.area = {x, y, whole(20, region.right() - x), whole(20, region.top() - y)};
    made.mask = TileMask(region, made.pixels.area);
    made.mask.markAll();
    made.layer.filled = whole(0, 3) > 0;
    made.layer.inked = whole(0, 3) > 0;
    made.layer.haloed = whole(0, 2) == 0;
    made.layer.hiddenInk = hiddenLines && whole(0, 1) == 0;
    made.layer.ink = {std::uint8_t(whole(0, 255)), std::uint8_t(whole(0, 255)), 20};
    const std::size_t count =
        std::size_t(made.pixels.area.width) * std::size_t(made.pixels.area.height);
    const bool opaque = whole(0, 1) == 0;
    const float perPixel = slope * (share() - 0.5f) / float(region.width);
    for (std::size_t i = 0; i < count; ++i) {
      const auto column = float(i % std::size_t(made.pixels.area.width));
      const bool there = whole(0, 5) > 0;
      made.pixels.depths.push_back(there ? std::clamp(depth + perPixel * column, 0.0f, 0.99f)
                                         : 1.0f);
      const std::uint32_t alpha = opaque ? 255u : std::uint32_t(whole(0, 255));
      std::uint32_t word = alpha << 24;
      for (int channel = 0; channel < 3; ++channel)
        word |= std::uint32_t(whole(0, int(alpha))) << (8 * channel);
      if (made.layer.filled)
        made.pixels.colours.push_back(word);
      const int ink = whole(0, 3) == 0 ? whole(0, 255) : 0;
      made.pixels.inks.push_back(
          std::uint16_t(ink | (whole(0, 9) == 0 ? 0xff00 : whole(0, 127) << 8)));
    }
    return made;
  }

 private:
  std::mt19937 m_random;
};

/// Returns what the picture shall have there (resolve.frag.glsl).
glm::vec4 expectedAt(std::span<const BlendLayer> layers, int x, int y) {
  struct Here {
    const BlendLayer* layer;
    std::size_t at;
  };
  std::vector<Here> found;
  std::vector<Here> all;
  for (const BlendLayer& layer : layers) {
    const PixelRect& area = layer.pixels->area;
    if (x < area.x || y < area.y || x >= area.right() || y >= area.top())
      continue;
    all.push_back({&layer, layer.pixels->at(x, y)});
    if (layer.pixels->depths[all.back().at] < 1.0f)
      found.push_back(all.back());
  }
  std::stable_sort(found.begin(), found.end(), [](const Here& a, const Here& b) {
    return a.layer->pixels->depths[a.at] < b.layer->pixels->depths[b.at];
  });
  const auto inkOf = [](const BlendLayer& layer) {
    return glm::vec4(float(layer.ink.red), float(layer.ink.green), float(layer.ink.blue), 255.0f) /
           255.0f;
  };
  glm::vec4 sum(0.0f);
  float lines = 1.0f;
  for (const Here& here : found) {
    const BlendLayer& layer = *here.layer;
    glm::vec4 colour = layer.filled ? unpacked(layer.pixels->colours[here.at]) : glm::vec4(0.0f);
    const int ink = layer.inked ? layer.pixels->inks[here.at] : 0;
    const float coverage = lines * float(ink & 0xff) / 255.0f;
    colour = coverage * inkOf(layer) + (1.0f - coverage) * colour;
    if (layer.haloed && ink >> 8 > 191)
      lines = 0.0f;
    sum += (1.0f - sum.a) * colour;
  }
  glm::vec4 colour = sum + (1.0f - sum.a) * ground;
  for (const Here& here : all) {
    const float stored = float(here.layer->pixels->inks[here.at] >> 8) / 255.0f;
    if (!here.layer->hiddenInk || stored > 0.75f)
      continue;
    const float coverage = 0.5f * std::min(2.0f * stored, 1.0f);
    colour = coverage * inkOf(*here.layer) + (1.0f - coverage) * colour;
  }
  return colour;
}

}  // namespace

class LayerBlendTest : public QObject {
  Q_OBJECT
 private slots:
  void eachPixelIsWhatItsLayersMake_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<float>("apart");
    QTest::addColumn<float>("slope");
    QTest::addColumn<bool>("hiddenLines");
    QTest::newRow("one") << 1 << 0.0f << 0.0f << false;
    QTest::newRow("in order") << 9 << 0.05f << 0.02f << false;
    QTest::newRow("through each other") << 9 << 0.01f << 0.9f << false;
    QTest::newRow("equally deep") << 6 << 0.0f << 0.0f << false;
    QTest::newRow("with hidden lines") << 7 << 0.05f << 0.3f << true;
  }

  void eachPixelIsWhatItsLayersMake() {
    QFETCH(int, count);
    QFETCH(float, apart);
    QFETCH(float, slope);
    QFETCH(bool, hiddenLines);
    for (unsigned seed = 0; seed < 20; ++seed) {
      Maker maker(seed);
      std::vector<MadeLayer> made;
      made.reserve(std::size_t(count));
      for (int i = 0; i < count; ++i)
        made.push_back(maker.layer(0.3f + apart * float((i * 5) % count), slope, hiddenLines));
      std::vector<BlendLayer> layers;
      for (MadeLayer& each : made) {
        each.layer.pixels = &each.pixels;
        each.layer.mask = &each.mask;
        layers.push_back(each.layer);
      }
      TileMask wanted(region);
      wanted.markAll();
      std::vector<std::uint32_t> picture(std::size_t(region.width) * std::size_t(region.height));
      blend({region, layers, wanted, ground}, picture);
      for (int y = region.y; y < region.top(); ++y)
        for (int x = region.x; x < region.right(); ++x) {
          const glm::vec4 found =
              unpacked(picture[std::size_t(y - region.y) * std::size_t(region.width) +
                               std::size_t(x - region.x)]);
          const glm::vec4 expected = expectedAt(layers, x, y);
          for (int channel = 0; channel < 4; ++channel)
            QVERIFY2(std::abs(found[channel] - expected[channel]) < tolerance,
                     qPrintable(QString("seed %1 at %2, %3, channel %4: %5 and not %6")
                                    .arg(seed)
                                    .arg(x)
                                    .arg(y)
                                    .arg(channel)
                                    .arg(255.0f * found[channel])
                                    .arg(255.0f * expected[channel])));
        }
    }
  }
};

SLINE_TEST(LayerBlendTest)
#include "layer_blend_test.moc"
