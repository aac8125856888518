// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/crumbs.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline::render {

class CrumbsTest : public QObject {
  Q_OBJECT

  static constexpr float unit = 3.0f;  // pixels to λ

  /// A straight stroke from `from` λ to `to` λ along a row.
  static VisibleStroke stroke(float from, float to, float row = 0.0f) {
    VisibleStroke one;
    constexpr int steps = 10;
    for (int i = 0; i <= steps; ++i)
      one.points.push_back(
          {unit * glm::vec2(from + (to - from) * float(i) / float(steps), row), 1.0f});
    return one;
  }
  static std::size_t kept(std::vector<VisibleStroke> strokes) {
    return withoutCrumbs(std::move(strokes), unit, 8.0f).size();
  }

 private slots:
  void isolatedCrumbsGo() {
    QCOMPARE(kept({stroke(0, 20), stroke(0, 7.5f, 10)}), std::size_t(1));
    QCOMPARE(kept({stroke(0, 20), stroke(0, 8.5f, 10)}), std::size_t(2));
  }
  void whatContinuesALineJoinsIt() {
    QCOMPARE(kept({stroke(0, 20), stroke(21.5f, 23)}), std::size_t(1));
    const auto one = withoutCrumbs({stroke(0, 20), stroke(23, 21.5f)}, unit, 8.0f);
    QCOMPARE(one.front().points.front().at.x, 0.0f);
    QCOMPARE(one.front().points.back().at.x, 23.0f * unit);
    QCOMPARE(kept({stroke(0, 20), stroke(22.5f, 35)}), std::size_t(2));
    QCOMPARE(kept({stroke(0, 20), stroke(22.5f, 24)}), std::size_t(1));
    // Crumbs in a row are one line with gaps.
    QCOMPARE(kept({stroke(0, 20, 50), stroke(0, 4), stroke(5, 9)}), std::size_t(2));
    QCOMPARE(kept({stroke(0, 20, 50), stroke(0, 3), stroke(4, 7)}), std::size_t(1));
  }
  void piecesInARowStay() {
    QCOMPARE(kept({stroke(0, 15), stroke(20, 27.5f), stroke(32, 37), stroke(42, 49)}),
             std::size_t(4));
    // Shorter ones go, and such as lie too far from the others, or beside the line.
    QCOMPARE(kept({stroke(0, 15), stroke(20, 24), stroke(28, 35)}), std::size_t(2));
    QCOMPARE(kept({stroke(0, 15), stroke(24, 31)}), std::size_t(1));
    QCOMPARE(kept({stroke(0, 15), stroke(20, 27.5f, 6)}), std::size_t(1));
    // A row that is short itself is a crumb in pieces.
    QCOMPARE(kept({stroke(0, 20, 50), stroke(0, 6), stroke(10, 16)}), std::size_t(1));
  }
  void spursGo() {
    VisibleStroke spur;
    for (int i = 0; i <= 10; ++i)
      spur.points.push_back({unit * glm::vec2(20.5f, 0.4f * float(i)), 1.0f});
    QCOMPARE(kept({stroke(0, 20), spur}), std::size_t(1));
  }
  void whatGoesOnBehindAVeilStays() {
    VisibleStroke veiled = stroke(20, 25);
    veiled.veil.transmittance = 0.5f;
    QCOMPARE(kept({stroke(0, 20), veiled}), std::size_t(2));
  }
  void theOnlyOneStays() {
    QCOMPARE(kept({stroke(0, 2)}), std::size_t(1));
    QCOMPARE(kept({stroke(0, 2), stroke(0, 3, 10)}), std::size_t(1));
    QCOMPARE(kept({}), std::size_t(0));
  }
  void closedLinesStay() {
    VisibleStroke ring = stroke(0, 2, 10);
    ring.closed = true;
    QCOMPARE(kept({stroke(0, 20), ring}), std::size_t(2));
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::CrumbsTest)
#include "crumbs_test.moc"
