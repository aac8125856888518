// SPDX-License-Identifier: Apache-2.0
// Looks at where streamline hatching lies, how far apart and how strong it is.
#include "render/lines/techniques/streamline_hatching.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/lines/techniques/lines.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using render::LineKind;
using render::Segment;

namespace {

model::Camera hatchedFrom(float heightMm) {
  return {.projection = model::Projection::orthographic,
          .eye = {0, -200, 0},
          .target = {0, 0, 0},
          .up = {0, 0, 1},
          .heightMm = heightMm};
}

std::vector<Segment> hatching(const model::Surface& surface, const model::Camera& camera,
                              render::LineRequest request = {}) {
  request.kinds = {LineKind::hatchingStreamline};
  request.twoSided = render::needsTwoSides(surface, camera);
  return render::extractLines(surface, camera, request)[LineKind::hatchingStreamline];
}

double inkOf(const std::vector<Segment>& segments) {
  double ink = 0.0;
  for (const Segment& s : segments)
    ink += double(0.5f * (s.opacityA + s.opacityB) * glm::distance(s.a, s.b));
  return ink;
}

}  // namespace

class StreamlineHatchingTest : public QObject {
  Q_OBJECT
 private slots:
  void shadeOfLight() {
    const glm::vec3 n(0, 0, 1);
    QCOMPARE(render::hatchingShade(n, n, n), 0.0f);
    QCOMPARE(render::hatchingShade(n, -n, -n), 1.0f);
    const float aside = render::hatchingShade(n, n, {1, 0, 0});
    QVERIFY(aside > 0.5f && aside < 0.8f);
  }

  /// On a tube lit from the side, rings lie in the shade, none in the light.
  void ringsTheShadeOfATube() {
    const model::SurfacePtr tube = model::prepareSurface(test::cylinder(3, 20, 96, 120));
    render::LineRequest request;
    request.light = {-1, 0, 0};
    const std::vector<Segment> found = hatching(*tube, hatchedFrom(24), request);
    QVERIFY(found.size() > 200);
    double dark = 0.0;
    double light = 0.0;
    for (const Segment& s : found) {
      QVERIFY(std::abs(s.a.z - s.b.z) < 0.05f * glm::distance(s.a, s.b) + 0.01f);
      // The tube is open: behind its front one sees its inner side, lit the other way.
      if (s.a.y > 0.0f)
        continue;
      if (s.a.x > 2.0f)
        dark += inkOf({s});
      else if (s.a.x < -2.0f)
        light += inkOf({s});
    }
    QVERIFY2(dark > 20.0 * light, qPrintable(QString("%1 %2").arg(dark).arg(light)));
  }

  /// Along the tube lines lie as far apart as the threshold says, within a factor of two, at any
  /// size of the picture.
  void isEvenlySpaced_data() {
    QTest::addColumn<float>("height");
    QTest::newRow("whole") << 24.0f;
    QTest::newRow("near") << 12.0f;
  }
  void isEvenlySpaced() {
    QFETCH(float, height);
    const model::SurfacePtr tube = model::prepareSurface(test::cylinder(3, 20, 96, 120));
    render::LineRequest request;
    request.light = {-1, 0, 0};
    std::vector<float> heights;
    for (const Segment& s : hatching(*tube, hatchedFrom(height), request))
      if ((s.a.x - 2.0f) * (s.b.x - 2.0f) < 0.0f && s.a.y < 0.0f && std::abs(s.a.z) < 5.0f &&
          s.opacityA > 0.3f)
        heights.push_back(s.a.z);
    std::sort(heights.begin(), heights.end());
    QVERIFY(heights.size() > 10);
    const float spacing = render::streamlineHatchingThresholds[0].usual * height / 720.0f;
    const float mean = (heights.back() - heights.front()) / float(heights.size() - 1);
    QVERIFY2(mean > 0.8f * spacing && mean < 3.0f * spacing,
             qPrintable(QString::number(double(mean / spacing))));
    for (std::size_t i = 1; i < heights.size(); ++i)
      QVERIFY(heights[i] - heights[i - 1] > 0.2f * spacing);
  }

  void thresholdsDecide() {
    const model::SurfacePtr ring = model::prepareSurface(test::torus(10, 3, 240, 90));
    using enum render::StreamlineHatchingThreshold;
    const auto with = [](render::StreamlineHatchingThreshold which, float value) {
      render::LineRequest request;
      request.thresholds.set(LineKind::hatchingStreamline, which, value);
      return request;
    };
    const double usual = inkOf(hatching(*ring, hatchedFrom(30)));
    QVERIFY(inkOf(hatching(*ring, hatchedFrom(30), with(hatchingDistance, 9.0f))) < 0.7 * usual);
    QVERIFY(inkOf(hatching(*ring, hatchedFrom(30), with(leastShade, 0.6f))) < 0.8 * usual);
    QVERIFY(hatching(*ring, hatchedFrom(30), with(leastShade, 1.0f)).size() < 200);
  }

  /// A line is as strong when the camera has turned a little; none jumps.
  void staysWhileTheCameraTurns() {
    const model::SurfacePtr ring = model::prepareSurface(test::torus(10, 3, 240, 90));
    model::Camera camera = hatchedFrom(30);
    const double before = inkOf(hatching(*ring, camera));
    camera.eye = {1.0f, -200.0f, 0.0f};
    QVERIFY(std::abs(inkOf(hatching(*ring, camera)) / before - 1.0) < 0.05);
  }
};

SLINE_TEST(StreamlineHatchingTest)
#include "streamline_hatching_test.moc"
