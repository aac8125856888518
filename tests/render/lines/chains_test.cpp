// SPDX-License-Identifier: Apache-2.0
#include "render/lines/ground/chains.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/lines/techniques/lines.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

class ChainsTest : public QObject {
  Q_OBJECT
 private slots:
  // A torus from above has two contours: circles of the outer and the inner radius.
  void torusFromAbove() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 400, 160));
    const model::Camera camera{
        .projection = model::Projection::orthographic, .eye = {0.7f, 0.3f, 80}, .up = {0, 1, 0}};
    const auto lines = render::extractLines(*surface, camera, {});
    const render::Chains chains = render::connectedChains(lines[render::LineKind::contour]);
    QCOMPARE(chains.count(), std::size_t(2));
    const auto lengths = render::chainLengths(chains, lines[render::LineKind::contour]);
    const float inner = std::min(lengths[0], lengths[1]);
    const float outer = std::max(lengths[0], lengths[1]);
    QVERIFY(std::abs(inner - float(2 * M_PI * 7)) < 0.2f);
    QVERIFY(std::abs(outer - float(2 * M_PI * 13)) < 0.2f);
  }

  void suggestiveContoursHangTogether() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 400, 160));
    const model::Camera camera{.projection = model::Projection::orthographic, .eye = {14, -72, 28}};
    const auto lines = render::extractLines(*surface, camera, {});
    QVERIFY(lines[render::LineKind::suggestive].size() > 50);
    QVERIFY(render::connectedChains(lines[render::LineKind::suggestive]).count() <= 4);
  }

  void everySegmentIsDrawnOnceInOrder() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 100, 40));
    const model::Camera camera{.projection = model::Projection::orthographic, .eye = {14, -72, 28}};
    const auto lines = render::extractLines(*surface, camera, {})[render::LineKind::contour];
    const render::Chains chains = render::connectedChains(lines);
    std::vector<int> seen(lines.size());
    for (std::size_t chain = 0; chain < chains.count(); ++chain)
      for (std::uint32_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i) {
        ++seen[chains.links[i].segment];
        if (i == chains.first[chain])
          continue;
        const auto& last = chains.links[i - 1];
        const auto& now = chains.links[i];
        QCOMPARE(last.reversed ? lines[last.segment].a : lines[last.segment].b,
                 now.reversed ? lines[now.segment].b : lines[now.segment].a);
      }
    QVERIFY(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  }

  void crossingsEndChains() {
    const auto from = [](const glm::vec3& a, const glm::vec3& b) {
      return render::Segment{.a = a, .b = b};
    };
    const std::vector<render::Segment> star{from({0, 0, 0}, {1, 0, 0}), from({0, 1, 0}, {0, 0, 0}),
                                            from({0, 0, 0}, {-1, 0, 0}),
                                            from({0, -1, 0}, {0, 0, 0})};
    QCOMPARE(render::connectedChains(star).count(), std::size_t(4));
    QCOMPARE(render::connectedChains({}).count(), std::size_t(0));
  }

  // A finely cut circle keeps its shape to the tolerance and its length, with far fewer segments.
  void simplifyingKeepsTheLine() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 1200, 200));
    const model::Camera camera{
        .projection = model::Projection::orthographic, .eye = {0.7f, 0.3f, 80}, .up = {0, 1, 0}};
    const auto lines = render::extractLines(*surface, camera, {})[render::LineKind::contour];
    const auto chains = render::connectedChains(lines);
    const auto fewer = render::simplified(lines, chains, 0.01f, 2.0f);
    QVERIFY(fewer.size() * 5 < lines.size());
    double before = 0.0;
    double after = 0.0;
    for (const auto& s : lines)
      before += double(glm::distance(s.a, s.b));
    for (const auto& s : fewer) {
      after += double(glm::distance(s.a, s.b));
      QVERIFY(glm::distance(s.a, s.b) <= 2.0f);
    }
    QVERIFY(std::abs(after / before - 1.0) < 0.002);
    QCOMPARE(render::connectedChains(fewer).count(), chains.count());
  }

  void shortChainsFade() {
    const auto at = [](float x, float length) {
      return render::Segment{.a = {x, 0, 0}, .b = {x, length, 0}};
    };
    std::vector<render::Segment> segments{at(0, 1), at(1, 3), at(2, 9)};
    segments.push_back({.a = {0, 1, 0}, .b = {0, 6, 0}});  // continues the first: 6 mm together
    const render::Chains chains = render::connectedChains(segments);
    const std::vector<float> lengths = render::chainLengths(chains, segments);
    render::fadeShortChains(segments, chains, lengths, {2.0f, 6.0f});
    QCOMPARE(segments[0].opacityA, 1.0f);
    QCOMPARE(segments[1].opacityB, 0.25f);
    QCOMPARE(segments[2].opacityA, 1.0f);
    QCOMPARE(segments[3].opacityA, 1.0f);
    render::fadeShortChains(segments, chains, lengths, {4.0f, 6.0f});
    QCOMPARE(segments[1].opacityA, 0.0f);
  }
};

SLINE_TEST(ChainsTest)
#include "chains_test.moc"
