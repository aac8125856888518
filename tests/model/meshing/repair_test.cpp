// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/fairing/half_edges.h"
#include "model/meshing/repair.h"
#include "tests/support/process_memory.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

struct Soup {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  bool operator==(const Soup&) const = default;
};

Soup soup(const Mesh& mesh) {
  return {{mesh.positions().begin(), mesh.positions().end()},
          {mesh.triangles().begin(), mesh.triangles().end()}};
}

void append(Soup& to, const Soup& more) {
  const auto offset = std::uint32_t(to.positions.size());
  to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
  for (Triangle t : more.triangles) {
    for (std::uint32_t& v : t)
      v += offset;
    to.triangles.push_back(t);
  }
}

void turn(Soup& s) {
  for (Triangle& t : s.triangles)
    std::swap(t[1], t[2]);
}

double volume(const Soup& s, std::size_t first, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = first; i < first + count; ++i) {
    const Triangle& t = s.triangles[i];
    sum += double(glm::dot(s.positions[t[0]], glm::cross(s.positions[t[1]], s.positions[t[2]])));
  }
  return sum / 6.0;
}

RepairReport repaired(Soup& s) {
  return repair(s.positions, s.triangles);
}

}  // namespace

class RepairTest : public QObject {
  Q_OBJECT
 private slots:
  void cleanStaysBitEqual_data();
  void cleanStaysBitEqual();
  void insideOutTurns();
  void someTurnedFacesAgree();
  void cavityFacesInward();
  void bodiesOfManyTrianglesKnowWhatIsInside();
  void needlesKnowWhatIsInside();
  void partsSideBySideFaceOutward();
  void openShellKeepsItsSide();
  void facesWithoutAreaGo();
  void flatFacesThatHoldTheSurfaceStay();
  void duplicatesGo();
  void seamsClose();
  void moebiusStripStays();
  void nothing();
};

void RepairTest::cleanStaysBitEqual_data() {
  QTest::addColumn<int>("shape");
  QTest::newRow("sphere") << 0;
  QTest::newRow("torus") << 1;
  QTest::newRow("open tube") << 2;
  QTest::newRow("open saddle") << 3;
}

void RepairTest::cleanStaysBitEqual() {
  QFETCH(int, shape);
  const MeshPtr mesh = shape == 0   ? test::sphere(10, 4)
                       : shape == 1 ? test::torus(10, 3, 60, 30)
                       : shape == 2 ? test::cylinder(5, 20, 30, 20)
                                    : test::paraboloid(0.1f, -0.1f, 10, 30);
  Soup s = soup(*mesh);
  const RepairReport report = repaired(s);
  QCOMPARE(report.faces(), 0);
  QCOMPARE(report.mergedVertices, 0);
  QVERIFY(s == soup(*mesh));
}

void RepairTest::insideOutTurns() {
  const Soup good = soup(*test::sphere(10, 3));
  Soup s = good;
  turn(s);
  QCOMPARE(repaired(s).turnedFaces, int(good.triangles.size()));
  QVERIFY(s == good);
}

void RepairTest::someTurnedFacesAgree() {
  const Soup good = soup(*test::torus(10, 3, 40, 20));
  Soup s = good;
  int turned = 0;
  for (std::size_t i = 0; i < s.triangles.size(); i += 7, ++turned)
    std::swap(s.triangles[i][1], s.triangles[i][2]);
  QCOMPARE(repaired(s).turnedFaces, turned);
  QVERIFY(s == good);
}

void RepairTest::cavityFacesInward() {
  for (const bool innerInsideOut : {false, true}) {
    Soup s = soup(*test::sphere(10, 3));
    const std::size_t outer = s.triangles.size();
    Soup inner = soup(*test::moved(*test::sphere(3, 2), 1.0f, {4, 0, 1}));
    const std::size_t count = inner.triangles.size();
    if (innerInsideOut)
      turn(inner);
    append(s, inner);
    const Soup core = soup(*test::moved(*test::sphere(1, 1), 1.0f, {4, 0, 1}));
    append(s, core);
    const RepairReport report = repaired(s);
    QCOMPARE(report.turnedFaces, innerInsideOut ? 0 : int(count));
    QVERIFY(volume(s, 0, outer) > 0.0);
    QVERIFY(volume(s, outer, count) < 0.0);
    // A body inside two others is solid again.
    QVERIFY(volume(s, outer + count, core.triangles.size()) > 0.0);
  }
}

void RepairTest::bodiesOfManyTrianglesKnowWhatIsInside() {
  // Balls turned inside out around the torus and within its tube: those within stay as they are.
  const auto ball = test::sphere(1.0f, 1);
  Soup s = soup(*test::torus(40, 10, 1600, 400));
  const std::size_t all = s.triangles.size();
  std::vector<bool> within;
  for (int i = 0; i < 60; ++i) {
    const float angle = 0.37f * float(i);
    const float away = 40.0f + float(i % 5 - 2) * (i % 2 ? 3.5f : 7.5f);
    Soup inner = soup(
        *test::moved(*ball, 1.0f, {away * std::cos(angle), away * std::sin(angle), float(i % 3)}));
    turn(inner);
    append(s, inner);
    within.push_back(std::hypot(away - 40.0f, float(i % 3)) < 9.0f);
  }
  QVERIFY(std::count(within.begin(), within.end(), true) > 20);
  QVERIFY(std::count(within.begin(), within.end(), false) > 10);
  test::resetPeak();
  const double before = test::residentMiB();
  repaired(s);
  QVERIFY(volume(s, 0, all) > 0.0);
  for (std::size_t i = 0; i < within.size(); ++i) {
    const std::size_t count = ball->triangleCount();
    Soup one{s.positions, {}};
    const auto first = s.triangles.begin() + std::ptrdiff_t(all + i * count);
    one.triangles.assign(first, first + std::ptrdiff_t(count));
    // About its own middle, as the volume of a small ball far away is not exact.
    const glm::vec3 middle = s.positions[one.triangles[0][0]];
    for (glm::vec3& p : one.positions)
      p -= middle;
    QCOMPARE(volume(one, 0, count) < 0.0, bool(within[i]));
  }
  const double took = test::peakResidentMiB() - before;
  qInfo("%.0f MiB for %zu triangles", took, s.triangles.size());
  QVERIFY(test::sanitized || took < 150.0);
}

void RepairTest::needlesKnowWhatIsInside() {
  // Each triangle of the cylinder's sides is as long as it; caps are fans.
  Soup s;
  constexpr std::uint32_t around = 3000;
  for (std::uint32_t i = 0; i < around; ++i) {
    const float angle = 6.2831853f * float(i) / float(around);
    s.positions.emplace_back(20.0f * std::cos(angle), 20.0f * std::sin(angle), 0.0f);
    s.positions.emplace_back(20.0f * std::cos(angle), 20.0f * std::sin(angle), 100.0f);
  }
  s.positions.emplace_back(0.0f, 0.0f, 0.0f);
  s.positions.emplace_back(0.0f, 0.0f, 100.0f);
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    s.triangles.push_back({2 * i, 2 * next, 2 * next + 1});
    s.triangles.push_back({2 * i, 2 * next + 1, 2 * i + 1});
    s.triangles.push_back({2 * next, 2 * i, 2 * around});
    s.triangles.push_back({2 * i + 1, 2 * next + 1, 2 * around + 1});
  }
  const std::size_t all = s.triangles.size();
  const auto ball = test::sphere(3.0f, 2);
  append(s, soup(*test::moved(*ball, 1.0f, {11, 5, 30})));
  append(s, soup(*test::moved(*ball, 1.0f, {11, 17, 30})));  // half of it is outside
  repaired(s);
  QVERIFY(volume(s, 0, all) > 0.0);
  QVERIFY(volume(s, all, ball->triangleCount()) < 0.0);
  QVERIFY(volume(s, all + ball->triangleCount(), ball->triangleCount()) > 0.0);
}

void RepairTest::partsSideBySideFaceOutward() {
  Soup s = soup(*test::sphere(10, 3));
  Soup other = soup(*test::moved(*test::sphere(5, 3), 1.0f, {20, 0, 0}));
  turn(other);
  append(s, other);
  QCOMPARE(repaired(s).turnedFaces, int(other.triangles.size()));
}

void RepairTest::openShellKeepsItsSide() {
  Soup s = soup(*test::cylinder(5, 20, 30, 20));
  turn(s);
  const Soup inward = s;
  std::swap(s.triangles[10][1], s.triangles[10][2]);
  QCOMPARE(repaired(s).turnedFaces, 1);
  QVERIFY(s == inward);
}

void RepairTest::facesWithoutAreaGo() {
  const Soup good = soup(*test::sphere(10, 2));
  Soup s = good;
  s.triangles.push_back({3, 3, 5});
  const auto end = std::uint32_t(s.positions.size());
  s.positions.insert(s.positions.end(), {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  s.triangles.push_back({end, end + 1, end + 2});
  const RepairReport report = repaired(s);
  QCOMPARE(report.degenerateFaces, 2);
  QCOMPARE(report.turnedFaces, 0);
  QVERIFY(s.triangles == good.triangles);
}

void RepairTest::flatFacesThatHoldTheSurfaceStay() {
  // A tetrahedron with a point on the middle of one edge: a face without area closes it.
  Soup s{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
         {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}}};
  QCOMPARE(HalfEdges(5, s.triangles).openCount(), std::size_t(0));
  const Soup before = s;
  QCOMPARE(repaired(s).faces(), 0);
  QVERIFY(s == before);
}

void RepairTest::duplicatesGo() {
  const Soup good = soup(*test::sphere(10, 2));
  Soup s = good;
  Triangle same = s.triangles[7];
  std::rotate(same.begin(), same.begin() + 1, same.end());
  s.triangles.push_back(same);
  std::swap(same[0], same[1]);
  s.triangles.push_back(same);
  QCOMPARE(repaired(s).duplicateFaces, 2);
  QVERIFY(s == good);

  Soup twice{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 0, 1}}};
  QCOMPARE(repaired(twice).duplicateFaces, 1);
  QCOMPARE(twice.triangles.size(), std::size_t(1));
}

void RepairTest::seamsClose() {
  // Every triangle has its own three vertices, as in STL.
  const Soup good = soup(*test::sphere(10, 2));
  Soup s;
  for (const Triangle& t : good.triangles) {
    const auto at = std::uint32_t(s.positions.size());
    for (const std::uint32_t v : t)
      s.positions.push_back(good.positions[v]);
    s.triangles.push_back({at, at + 1, at + 2});
  }
  const RepairReport report = repaired(s);
  QCOMPARE(s.positions.size(), good.positions.size());
  QCOMPARE(report.mergedVertices, int(3 * good.triangles.size() - good.positions.size()));
  QCOMPARE(HalfEdges(s.positions.size(), s.triangles).openCount(), std::size_t(0));
  QCOMPARE(report.faces(), 0);
}

void RepairTest::moebiusStripStays() {
  Soup s;
  const std::uint32_t count = 24;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float u = 6.2831853f * float(i) / float(count);
    for (const float side : {-1.0f, 1.0f}) {
      const float r = 5.0f + side * std::cos(0.5f * u);
      s.positions.emplace_back(r * std::cos(u), r * std::sin(u), side * std::sin(0.5f * u));
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = a + 1;
    const bool last = i + 1 == count;
    const std::uint32_t c = last ? 1 : a + 2;
    const std::uint32_t d = last ? 0 : a + 3;
    s.triangles.push_back({a, c, b});
    s.triangles.push_back({b, c, d});
  }
  const Soup before = s;
  const RepairReport report = repaired(s);
  QVERIFY(report.notOrientable);
  QVERIFY(s == before);
}

void RepairTest::nothing() {
  Soup s;
  QCOMPARE(repaired(s).faces(), 0);
  s.positions.push_back({1, 2, 3});
  QCOMPARE(repaired(s).faces(), 0);
}

SLINE_TEST(RepairTest)
#include "repair_test.moc"
