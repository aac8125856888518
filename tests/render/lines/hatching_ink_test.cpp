// SPDX-License-Identifier: Apache-2.0
// Tests how much ink hatching has: strokes grow evenly with zoom, density and tone, from nothing.
#include "render/lines/hatching/hatching.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "render/lines/ground/view_scale.h"
#include "tests/render/lines/hatched_subject.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

/// Returns where a stroke is widest.
glm::vec3 widest(std::span<const render::HatchPoint> points) {
  return std::max_element(points.begin(), points.end(),
                          [](const auto& a, const auto& b) { return a.halfWidth < b.halfWidth; })
      ->position;
}

using SeedKey = std::tuple<int, int, int, int>;
SeedKey keyOf(const render::HatchSeed& s) {
  return {s.axis, s.level, s.i, s.j};
}
}  // namespace

class HatchingInkTest : public QObject {
  Q_OBJECT
 private slots:
  // METHOD §6.7: zooming by 4 moves no seed, and all keep their strokes.
  void zoomingMovesNoSeed() {
    const Subject torus = torusSubject();
    // A lattice line may pierce the surface twice; the visible part of a stroke may be far from its
    // seed.
    std::multimap<SeedKey, std::array<glm::vec3, 2>> before;
    const model::Camera far = orthographic(slanted, 40.0f);
    const render::Hatching hatching = torus.hatched(far);
    for (const render::HatchStroke& s : hatching.strokes)
      before.emplace(keyOf(s.seed), std::array{s.seedPosition, widest(pointsOf(hatching, s))});
    QVERIFY(before.size() > 10);
    for (const float zoom : {1.3f, 2.0f, 4.0f}) {
      const model::Camera near = orthographic(slanted, 40.0f / zoom);
      const render::ViewScale scale(near);
      std::multimap<SeedKey, glm::vec3> after;
      for (const render::HatchStroke& s : torus.hatched(near).strokes)
        after.emplace(keyOf(s.seed), s.seedPosition);
      int found = 0;
      int expected = 0;
      for (const auto& [key, places] : before) {
        const glm::vec2 ink = scale.project(places[1]).at;
        if (std::abs(ink.x) > 600.0f || std::abs(ink.y) > 330.0f)
          continue;
        const glm::vec2 at = scale.project(places[0]).at;
        ++expected;
        const auto [first, last] = after.equal_range(key);
        found += std::any_of(first, last, [&](const auto& seed) {
          return glm::distance(scale.project(seed.second).at, at) < 0.01f;
        });
      }
      QVERIFY(expected > 3);
      QVERIFY2(found == expected,
               qPrintable(QString("zoom %1: %2 of %3").arg(zoom).arg(found).arg(expected)));
    }
  }

  // New strokes grow from nothing: over a zoom of 1 % the ink on the torus hardly changes, though
  // over a zoom of 2 many strokes come.
  void strokesGrowFromNothing() {
    const Subject torus = torusSubject();
    double last = 0.0;
    double largest = 0.0;
    for (int i = 0; i <= 70; ++i) {
      const model::Camera camera = orthographic(slanted, 40.0f * std::pow(0.99f, float(i)));
      const render::ViewScale scale(camera);
      const double now = ink(torus.hatched(camera), camera) /
                         std::pow(double(scale.project(glm::vec3(0.0f)).perMm), 2.0);
      if (i > 0)
        largest = std::max(largest, std::abs(now - last) / std::max(now, last));
      last = now;
    }
    QVERIFY2(largest < 0.12, qPrintable(QString::number(largest)));
  }

  // On a thin tube there is hardly room for strokes, and some are seen along their length: the rest
  // of them is still no dot.
  void strokesAreLongerThanWide() {
    const Subject tube(test::torus(10.0f, 0.8f, 200, 24));
    for (const float height : {24.0f, 60.0f}) {
      const model::Camera camera = orthographic(slanted, height);
      const render::ViewScale scale(camera);
      const render::Hatching hatching = tube.hatched(camera);
      QVERIFY(hatching.strokes.size() > 20);
      for (const render::HatchStroke& stroke : hatching.strokes) {
        float length = 0.0f;
        float widest = 0.0f;
        const auto points = pointsOf(hatching, stroke);
        for (std::size_t i = 0; i < points.size(); ++i) {
          widest = std::max(widest, 2.0f * points[i].halfWidth);
          if (i > 0)
            length += glm::distance(scale.project(points[i - 1].position).at,
                                    scale.project(points[i].position).at);
        }
        QVERIFY2(length > 2.0f * widest, qPrintable(QString("%1 %2").arg(length).arg(widest)));
      }
    }
  }

  // METHOD §7 ▲: ink grows evenly with T_H.
  void inkGrowsEvenly() {
    const Subject torus = torusSubject();
    const model::Camera camera = orthographic(slanted, 24.0f);
    const double all = ink(torus.hatched(camera), camera);
    QVERIFY(all > 0.0);
    for (const float t : {0.2f, 0.4f, 0.6f, 0.8f}) {
      const double share = ink(torus.hatched(camera, {.entered = t}), camera) / all;
      QVERIFY2(std::abs(share - double(t)) < 0.2,
               qPrintable(QString("T %1: %2").arg(t).arg(share)));
    }
    QVERIFY(torus.hatched(camera, {.entered = 0.0f}).strokes.empty());
  }

  void stipplingIsDots() {
    const Subject torus(test::torus(10.0f, 7.0f, 200, 100), 0.0f);
    const render::Hatching dots = torus.hatched(orthographic(slanted, 24.0f), {.spacing = 4.5f});
    QVERIFY(dots.strokes.size() > 50);
    for (const render::HatchStroke& s : dots.strokes)
      QCOMPARE(s.count, 1u);
  }

  // Twice the density gives twice the strokes, thinner ones, of the same ink.
  void densityIsTheNumberOfStrokes_data() {
    QTest::addColumn<float>("density");
    QTest::newRow("a quarter") << 0.25f;
    QTest::newRow("half") << 0.5f;
    QTest::newRow("a little less") << 0.9f;
    QTest::newRow("a little more") << 1.1f;
    QTest::newRow("twice") << 2.0f;
    QTest::newRow("most") << 4.0f;
  }
  void densityIsTheNumberOfStrokes() {
    QFETCH(float, density);
    const Subject torus = torusSubject();
    const model::Camera camera = orthographic(slanted, 22.0f);
    const render::Hatching usual = torus.hatched(camera);
    const render::Hatching other =
        torus.hatched(camera, {.spacing = render::spacingOf(HatchDensity::clamped(density))});
    const double strokes = double(other.strokes.size()) / double(usual.strokes.size());
    QVERIFY2(strokes > 0.7 * double(density) && strokes < 1.4 * double(density),
             qPrintable(QString::number(strokes)));
    const double tone = ink(other, camera) / ink(usual, camera);
    QVERIFY2(std::abs(tone - 1.0) < 0.12, qPrintable(QString::number(tone)));
  }

  // As with a zoom, no stroke moves while density is dragged, and each thickens evenly.
  void densityChangesEvenly() {
    const Subject torus = torusSubject();
    const model::Camera camera = orthographic(slanted, 22.0f);
    std::map<SeedKey, float> before;
    for (float density = 0.5f; density <= 2.0f; density *= 1.02f) {
      const render::Hatching hatching =
          torus.hatched(camera, {.spacing = render::spacingOf(HatchDensity::clamped(density))});
      std::map<SeedKey, float> now;
      for (const render::HatchStroke& s : hatching.strokes)
        for (const render::HatchPoint& p : pointsOf(hatching, s))
          now[keyOf(s.seed)] = std::max(now[keyOf(s.seed)], p.halfWidth);
      if (!before.empty())
        for (const auto& [seed, width] : now)
          QVERIFY(std::abs(width - (before.contains(seed) ? before[seed] : 0.0f)) < 0.35f);
      before = std::move(now);
    }
  }

  void toneIsInk() {
    const Subject torus = torusSubject();
    const model::Camera camera = orthographic(slanted, 22.0f);
    QVERIFY(torus.hatched(camera, {.tone = 0.0f}).strokes.empty());
    double before = 0.0;
    for (const float tone : {0.25f, 0.5f, 0.8f, 1.0f, 1.25f, 1.6f, 2.0f, 4.0f}) {
      const render::Hatching hatching = torus.hatched(camera, {.tone = tone});
      const double now = ink(hatching, camera);
      QVERIFY2(now > 1.02 * before, qPrintable(QString::number(now)));
      before = now;
      // Some white is left between the darkest strokes.
      for (const render::HatchPoint& p : hatching.points)
        QVERIFY(p.halfWidth < 0.451f * render::hatchSpacing);
    }
  }
};

SLINE_TEST(HatchingInkTest)
#include "hatching_ink_test.moc"
