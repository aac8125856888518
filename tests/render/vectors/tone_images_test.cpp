// SPDX-License-Identifier: Apache-2.0
// Paints tones that let something through in the page's order and compares them with what the
// picture blends by depth.
#include "render/vectors/tone_images.h"

#include <QtTest>
#include <cmath>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

constexpr int width = 96;
constexpr int height = 48;
constexpr int steps = 32;

/// Returns a layer over the whole picture whose depth and opacity change along x, evenly from the
/// first values to the second.
DepthLayer slope(const glm::vec3& colour, glm::vec2 depths, glm::vec2 opacities) {
  DepthLayer layer;
  layer.area = {0, 0, width, height};
  for (int k = 0; k <= steps; ++k) {
    const float a = glm::mix(opacities.x, opacities.y, float(k) / float(steps));
    layer.colours.emplace_back(a * colour, a);
  }
  layer.firstCapTone = layer.colours.size();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float t = float(x) / float(width - 1);
      layer.depths.push_back(glm::mix(depths.x, depths.y, t));
      layer.tones.push_back(std::uint8_t(1 + std::lround(t * float(steps))));
    }
  return layer;
}

glm::vec4 pixelOf(const ToneImage& tones, const glm::ivec2& place) {
  const int cell = tones.area.width / tones.image.width;
  const int column = (place.x - tones.area.x) / cell;
  const int row = (tones.area.top() - 1 - place.y) / cell;
  const std::uint8_t* p =
      &tones.image
           .rgba[4 * (std::size_t(row) * std::size_t(tones.image.width) + std::size_t(column))];
  return glm::vec4(p[0], p[1], p[2], p[3]) / 255.0f;
}

}  // namespace

class ToneImagesTest : public QObject {
  Q_OBJECT
 private slots:
  // Two of the three pass through each other, so no order of the page is the picture's everywhere.
  void paintedByRankTheyAreThePicture() {
    const std::vector<DepthLayer> layers{
        slope({0.8f, 0.1f, 0.1f}, {0.2f, 0.8f}, {0.2f, 0.9f}),
        slope({0.1f, 0.2f, 0.9f}, {0.7f, 0.3f}, {0.95f, 0.3f}),
        slope({0.1f, 0.7f, 0.2f}, {0.5f, 0.5f}, {0.6f, 0.1f}),
    };
    const LayerStack stack(layers, {float(width), float(height)});
    const std::vector<std::size_t> ranks{1, 2, 0};
    std::vector<SeenTones> seen;
    for (std::size_t i = 0; i < layers.size(); ++i)
      seen.push_back(seenTones({layers[i], i, ranks}, stack));
    const std::vector<ToneImage> images = toneImages(stack, layers, seen, ranks);
    QCOMPARE(images.size(), layers.size());
    std::vector<SeenFill> fills;
    for (int y = 3; y < height; y += 9)
      for (int x = 2; x < width; x += 5) {
        glm::vec3 wanted(0.0f);
        float left = 1.0f;
        stack.seenAt(x, y, fills);
        for (const SeenFill& fill : fills) {
          wanted += left * glm::vec3(fill.colour);
          left *= 1.0f - fill.colour.a;
        }
        wanted += glm::vec3(left);
        glm::vec3 page(1.0f);
        for (const std::size_t layer : {2u, 0u, 1u}) {
          const glm::vec4 tone = pixelOf(images[layer], {x, y});
          page = glm::mix(page, glm::vec3(tone), tone.a);
        }
        for (int channel = 0; channel < 3; ++channel)
          QVERIFY2(std::abs(page[channel] - wanted[channel]) < 0.04f,
                   qPrintable(QString("%1 %2: %3 for %4")
                                  .arg(x)
                                  .arg(channel)
                                  .arg(double(page[channel]))
                                  .arg(double(wanted[channel]))));
      }
  }

  void evenFillsStayShapes() {
    const std::vector<DepthLayer> layers{slope({0.8f, 0.1f, 0.1f}, {0.2f, 0.2f}, {0.5f, 0.5f})};
    const LayerStack stack(layers, {float(width), float(height)});
    const std::vector<std::size_t> ranks{0};
    const std::vector<SeenTones> seen{seenTones({layers[0], 0, ranks}, stack)};
    const std::vector<ToneImage> images = toneImages(stack, layers, seen, ranks);
    QVERIFY(images.front().area.empty());
    QVERIFY(images.front().image.rgba.empty());
  }
};

SLINE_TEST(ToneImagesTest)
#include "tone_images_test.moc"
