// SPDX-License-Identifier: Apache-2.0
// Paints fills again as shapes by a plain rule and compares them with what shading gives.
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "render/sight/rules.h"
#include "render/vectors/vector_drawing.h"
#include "tests/render/vectors/path_points.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

constexpr float viewHeight = 60.0f;

model::Camera frontal() {
  return {.projection = model::Projection::orthographic,
          .eye = {0.0f, -400.0f, 0.0f},
          .target = {0.0f, 0.0f, 0.0f},
          .up = {0.0f, 0.0f, 1.0f},
          .heightMm = viewHeight};
}

struct Ball {
  glm::vec3 middle;
  float radius;
  float gamma;
  Colour colour;
  float opacity = 1.0f;
};

render::VectorDrawing drawing(const std::vector<Ball>& balls) {
  model::Scene scene;
  for (const Ball& ball : balls) {
    model::Node node;
    node.name = "ball";
    node.mesh = test::moved(*test::sphere(ball.radius, 5), 1.0f, ball.middle);
    node.style.gamma = Gamma::clamped(ball.gamma);
    node.style.colour = ball.colour;
    node.style.opacity = Opacity::clamped(ball.opacity);
    scene.append(std::move(node));
  }
  const auto drawn = render::drawVectors(scene, frontal(), {});
  if (!drawn.ok())
    qFatal("%s", drawn.error().text().c_str());
  return *drawn;
}

bool inside(const render::Path& path, const glm::vec2& p) {
  bool odd = false;
  for (const render::Curve& curve : path) {
    const std::vector<glm::vec2> points = test::pointsOn(curve);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::vec2& a = points[i];
      const glm::vec2& b = points[(i + 1) % points.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
        odd = !odd;
    }
  }
  return odd;
}

/// Returns red, green and blue, 0 … 255, and opacity of the tones at a point of the page.
glm::vec4 toneAt(const render::VectorTones& tones, const glm::vec2& p) {
  const render::Image& image = tones.image;
  const glm::vec2 pixels(image.width, image.height);
  const glm::ivec2 at(glm::floor((p - tones.at) / tones.sizeMm * pixels));
  if (!inside(tones.edge, p) || at.x < 0 || at.y < 0 || at.x >= image.width || at.y >= image.height)
    return glm::vec4(0.0f);
  const std::uint8_t* rgba =
      &image.rgba[4 * (std::size_t(at.y) * std::size_t(image.width) + std::size_t(at.x))];
  return {rgba[0], rgba[1], rgba[2], float(rgba[3]) / 255.0f};
}

/// Returns red, green and blue of the fills at a point of the scene, painted on white; 0 … 255.
glm::vec3 paintedAt(const render::VectorDrawing& drawn, float x, float z) {
  const glm::vec2 p = 0.5f * drawn.sizeMm + drawn.sizeMm.y / viewHeight * glm::vec2(x, -z);
  glm::vec3 page(255.0f);
  for (const render::VectorStructure& structure : drawn.structures) {
    if (structure.tones) {
      const glm::vec4 tone = toneAt(*structure.tones, p);
      page = glm::mix(page, glm::vec3(tone), tone.a);
    }
    glm::vec4 group(0.0f);
    for (const render::VectorShape& shape : structure.fills)
      if (inside(shape.path, p)) {
        const glm::vec3 colour(shape.colour.red, shape.colour.green, shape.colour.blue);
        group = glm::vec4(colour * shape.opacity, shape.opacity) + group * (1.0f - shape.opacity);
      }
    group *= structure.fillOpacity;
    page = glm::vec3(group) + page * (1.0f - group.a);
  }
  return page;
}

/// Returns the colour that a lamp at the eye gives a ball of that radius.
glm::vec3 shaded(const Colour& own, float radius, float x, float z) {
  const glm::vec3 colour = glm::vec3(own.red, own.green, own.blue) / 255.0f;
  const float facing = std::sqrt(std::max(0.0f, 1.0f - (x * x + z * z) / (radius * radius)));
  const glm::vec3 shadow = render::rule::inShadow(colour);
  glm::vec3 value(0.0f);
  for (int c = 0; c < 3; ++c)
    value[c] = render::rule::shaded(shadow[c], colour[c], render::rule::headlight(facing),
                                    render::rule::highlight(facing));
  return 255.0f * glm::min(value, 1.0f);
}

float largest(const glm::vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

class VectorFillsTest : public QObject {
  Q_OBJECT
 private slots:
  void tonesFollowTheShading() {
    const Colour colour{180, 90, 70};
    const auto drawn = drawing({{{0.0f, 0.0f, 0.0f}, 20.0f, 5.0f, colour}});
    QCOMPARE(drawn.structures.size(), std::size_t(1));
    QVERIFY(drawn.structures.front().fills.size() > 10);
    for (float x = -18.0f; x <= 18.0f; x += 1.5f)
      QVERIFY2(largest(paintedAt(drawn, x, 2.0f) - shaded(colour, 20.0f, x, 2.0f)) < 10.0f,
               qPrintable(QString::number(double(x))));
    QCOMPARE(paintedAt(drawn, 21.0f, 0.0f), glm::vec3(255.0f));
  }

  // Where Γ falls from 5 to 2 within a ball, its opaque part keeps its light and shade.
  void shadingStaysWhereGammaVaries() {
    const Colour colour{180, 90, 70};
    model::Scene scene;
    const model::NodeId far = scene.append(
        {.name = "far",
         .style = {.visible = false},
         .mesh = test::moved(*test::sphere(1.0f, 2), 1.0f, {-100'000.0f, 0.0f, 0.0f})});
    scene.append(
        {.name = "ball",
         .style = {.colour = colour,
                   .gamma = Gamma::clamped(5.0f),
                   .gammaMap = model::GammaMap{.scalar = model::GammaScalar::distance,
                                               .targets = {far},
                                               .curve = {{99'995.0f, 0.0f}, {100'003.0f, -3.0f}}}},
         .mesh = test::sphere(20.0f, 5)});
    const auto drawn = render::drawVectors(scene, frontal(), {});
    QVERIFY(drawn.ok());
    for (float x = -18.0f; x <= -6.0f; x += 1.5f)
      QVERIFY2(largest(paintedAt(*drawn, x, 2.0f) - shaded(colour, 20.0f, x, 2.0f)) < 10.0f,
               qPrintable(QString::number(double(x))));
    for (float x = 6.0f; x <= 18.0f; x += 1.5f)
      QVERIFY2(largest(paintedAt(*drawn, x, 2.0f) - 255.0f) < 4.0f,
               qPrintable(QString::number(double(x))));
  }

  void shadingEntersFromTheRim() {
    const auto drawn = drawing({{{0.0f, 0.0f, 0.0f}, 20.0f, 4.0f, {180, 90, 70}}});
    float before = paintedAt(drawn, 0.0f, 0.0f).g;
    QVERIFY(before > 240.0f);  // nothing there yet
    for (float x = 3.0f; x <= 18.0f; x += 3.0f) {
      const float here = paintedAt(drawn, x, 0.0f).g;
      QVERIFY(here < before);
      before = here;
    }
  }

  // The nearer ball is seen whole, the farther one where it is not hidden.
  void nearHidesFar() {
    const Colour red{200, 40, 40};
    const Colour blue{40, 40, 200};
    const auto drawn = drawing(
        {{{-6.0f, -20.0f, 0.0f}, 10.0f, 5.0f, red}, {{6.0f, 20.0f, 0.0f}, 14.0f, 5.0f, blue}});
    QVERIFY(paintedAt(drawn, -6.0f, 0.0f).r > 150.0f);
    QVERIFY(paintedAt(drawn, 2.0f, 0.0f).r > paintedAt(drawn, 2.0f, 0.0f).b);
    QVERIFY(paintedAt(drawn, 8.0f, 0.0f).b > 150.0f);
    QVERIFY(largest(paintedAt(drawn, 8.0f, 0.0f) - shaded(blue, 14.0f, 2.0f, 0.0f)) < 10.0f);
  }

  // A ball within a see-through one lies nearer on the whole, but shows through it.
  void whatShowsThroughIsPaintedFirst() {
    const Colour red{200, 60, 60};
    const Colour blue{60, 60, 200};
    const auto drawn = drawing(
        {{{0.0f, 30.0f, 0.0f}, 25.0f, 5.0f, red, 0.5f}, {{0.0f, 12.0f, 0.0f}, 4.0f, 5.0f, blue}});
    const glm::vec3 wanted =
        0.5f * shaded(red, 25.0f, 2.0f, 0.0f) + 0.5f * shaded(blue, 4.0f, 2.0f, 0.0f);
    QVERIFY(largest(paintedAt(drawn, 2.0f, 0.0f) - wanted) < 10.0f);
  }

  // Between neighbours there is neither paper nor a third colour.
  void noSeamsBetweenNeighbours() {
    const Colour red{200, 40, 40};
    const auto drawn = drawing({{{0.0f, -20.0f, 0.0f}, 8.0f, 5.0f, red},
                                {{0.0f, 20.0f, 0.0f}, 20.0f, 5.0f, {40, 40, 200}}});
    for (float x = 7.0f; x <= 9.0f; x += 0.02f)
      QVERIFY(paintedAt(drawn, x, 0.0f).g < 80.0f);
  }

  void opacityIsKept() {
    const Colour colour{180, 90, 70};
    const auto drawn = drawing({{{0.0f, 0.0f, 0.0f}, 20.0f, 5.0f, colour, 0.5f}});
    const glm::vec3 wanted = 0.5f * shaded(colour, 20.0f, 9.0f, 0.0f) + 0.5f * glm::vec3(255.0f);
    QVERIFY(largest(paintedAt(drawn, 9.0f, 0.0f) - wanted) < 8.0f);
  }
};

SLINE_TEST(VectorFillsTest)
#include "vector_fills_test.moc"
