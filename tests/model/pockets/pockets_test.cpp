// SPDX-License-Identifier: Apache-2.0
// Tests pockets between atoms that leave rooms of known volume and mouth.
#include "model/pockets/pockets.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

constexpr float atomRadius = 1.5f;

/// Returns atoms around a ball of that radius, so dense that they leave no crevices; those whose
/// centres lie above z = `top` are left out.
std::vector<AtomBall> atomsAround(double radius, double top, const glm::dvec3& middle = {0, 0, 0}) {
  std::vector<AtomBall> atoms;
  for (const double layer : {0.0, 1.2}) {
    const double reach = radius + double(atomRadius) + layer;
    const int count = int(4.0 * M_PI * reach * reach / 0.5);
    for (int i = 0; i < count; ++i) {
      const double z = 1.0 - 2.0 * (i + 0.5) / count;
      const double turn = 2.39996323 * i;
      const double across = std::sqrt(1.0 - z * z);
      if (reach * z <= top)
        atoms.push_back({glm::vec3(middle + reach * glm::dvec3(across * std::cos(turn),
                                                               across * std::sin(turn), z)),
                         atomRadius, std::uint32_t(z > 0.0 ? 1 : 0)});
    }
  }
  return atoms;
}

bool goesOn() {
  return true;
}

Pockets pocketsOf(const std::vector<AtomBall>& atoms, const PocketOptions& options = {}) {
  Result<Pockets> found = findPockets(atoms, options, goesOn);
  return found ? std::move(*found) : Pockets{};
}

}  // namespace

class PocketsTest : public QObject {
  Q_OBJECT
 private slots:
  /// A hollow has the volume of its ball, within 4 %, wherever it lies on the lattice.
  void closedHollow_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("step");
    QTest::newRow("3 Å") << 3.0 << 0.5;
    QTest::newRow("4 Å") << 4.0 << 0.5;
    QTest::newRow("5 Å") << 5.0 << 0.5;
    QTest::newRow("5 Å, finer") << 5.0 << 0.3;
  }
  void closedHollow() {
    QFETCH(double, radius);
    QFETCH(double, step);
    const Pockets found = pocketsOf(atomsAround(radius, 1e9, {0.13, -7.21, 40.4}),
                                    {.largeProbe = 6.0f, .step = float(step)});
    QCOMPARE(found.list.size(), std::size_t(1));
    const double expected = 4.0 / 3.0 * M_PI * radius * radius * radius;
    QVERIFY2(std::abs(found.list[0].volume / expected - 1.0) < 0.04,
             qPrintable(QString::number(found.list[0].volume / expected)));
    QCOMPARE(found.list[0].mouth, 0.0);
    QCOMPARE(found.list[0].outwards, glm::dvec3(0.0));
    QVERIFY(found.list[0].burial > 0.99f);
    QVERIFY(glm::distance(found.list[0].centre, glm::dvec3(0.13, -7.21, 40.4)) < 0.1);
  }

  /// A bowl of 5 Å with its rim's atoms at z = 2: a large ball of 7 Å rests on the rim. The mouth
  /// is the cap of that ball between the circle where they touch, within 10 %, and the volume what
  /// of the bowl's ball the large one leaves, less what the small one cannot fill.
  void bowl() {
    const double rim = std::sqrt(6.5 * 6.5 - 2.0 * 2.0);
    const double height = std::sqrt(8.5 * 8.5 - rim * rim);
    const double cap = 2.0 * M_PI * 7.0 * 7.0 * (1.0 - height / 8.5);
    const double d = 2.0 + height;
    const double lens = M_PI * (12.0 - d) * (12.0 - d) *
                        (d * d + 10.0 * d - 75.0 + 14.0 * d + 210.0 - 147.0) / (12.0 * d);
    const double left = 4.0 / 3.0 * M_PI * 125.0 - lens;
    const Pockets found = pocketsOf(atomsAround(5.0, 2.0), {.largeProbe = 7.0f});
    QCOMPARE(found.list.size(), std::size_t(1));
    const Pocket& pocket = found.list[0];
    QVERIFY2(std::abs(pocket.mouth / cap - 1.0) < 0.1, qPrintable(QString::number(pocket.mouth)));
    QVERIFY2(pocket.volume < left && pocket.volume > 0.9 * left,
             qPrintable(QString::number(pocket.volume)));
    QVERIFY(pocket.outwards.z > 0.99);
    QVERIFY(pocket.burial > 0.7f && pocket.burial < 0.95f);
    QCOMPARE(pocket.residues, (std::vector<std::uint32_t>{0, 1}));
  }

  /// Of a room with two mouths the middle of both is a wall; one looks in through one of them.
  void looksInThroughAMouth() {
    std::vector<AtomBall> atoms = atomsAround(5.0, 2.0);
    const auto rest = [](const AtomBall& atom) { return atom.place.x > 3.5f; };
    std::erase_if(atoms, rest);
    const Pockets found = pocketsOf(atoms, {.largeProbe = 9.0f});
    QVERIFY(!found.list.empty());
    const glm::dvec3& out = found.list[0].outwards;
    QVERIFY(std::abs(glm::length(out) - 1.0) < 1e-6);
    for (const AtomBall& atom : atoms) {
      const glm::dvec3 to = glm::dvec3(atom.place) - found.list[0].centre;
      const double along = glm::dot(to, out);
      QVERIFY(along < 0.0 || glm::length(to - along * out) > 1.5);
    }
  }

  void probesDecide() {
    // A small ball that is too large for the hollow finds none, one that goes through the mouth
    // leaves the hollow to what is outside.
    const auto hollow = atomsAround(3.0, 1e9);
    QVERIFY(pocketsOf(hollow, {.smallProbe = 3.2f}).list.empty());
    QVERIFY(pocketsOf(hollow, {.leastVolume = 200.0f}).list.empty());
    QVERIFY(pocketsOf(atomsAround(5.0, 2.0), {.largeProbe = 3.0f}).list.empty());
  }

  void largestFirst() {
    std::vector<AtomBall> atoms = atomsAround(3.0, 1e9);
    const auto larger = atomsAround(4.0, 1e9, {25, 0, 0});
    atoms.insert(atoms.end(), larger.begin(), larger.end());
    const Pockets found = pocketsOf(atoms);
    QCOMPARE(found.list.size(), std::size_t(2));
    QVERIFY(found.list[0].volume > found.list[1].volume);
    QVERIFY(found.list[0].centre.x > 20.0);
  }

  void saysWhyNot() {
    const std::vector<AtomBall> apart{{{0, 0, 0}, 1.7f, 0}, {{40'000, 40'000, 40'000}, 1.7f, 0}};
    QVERIFY(findPockets(apart, {}, goesOn).error().reason.find("too far apart") !=
            std::string::npos);
    const std::vector<AtomBall> heap(1000, {{0, 0, 0}, 1.7f, 0});
    QVERIFY(findPockets(heap, {}, goesOn).error().reason.find("closer together") !=
            std::string::npos);
    const std::vector<AtomBall> many(1'000'001, {{0, 0, 0}, 1.7f, 0});
    QVERIFY(findPockets(many, {}, goesOn).error().reason.find("more than 1000000") !=
            std::string::npos);
    QVERIFY(!findPockets(heap, {.smallProbe = 6.0f}, goesOn).ok());
    QVERIFY(!findPockets(heap, {.step = std::nanf("")}, goesOn).ok());
    const auto bowl = atomsAround(5.0, 2.0);
    QVERIFY(findPockets(bowl, {}, [] { return false; }).error().reason.find("cancelled") !=
            std::string::npos);
    QVERIFY(findPockets({}, {}, goesOn)->list.empty());
  }

  /// However large the molecule, the lattice has no more places than fit into memory.
  void latticeIsBounded() {
    const std::vector<AtomBall> wide{{{0, 0, 0}, 1.7f, 0}, {{150, 150, 150}, 1.7f, 0}};
    const auto grid = gridAround(wide, {.margin = 6.0, .step = 0.25, .mostPlaces = 1'000'000});
    QVERIFY(!grid || grid->count() <= 1'000'000);
    const auto coarser = gridAround(wide, {.margin = 6.0, .step = 0.25});
    QVERIFY(coarser && coarser->step > 0.25 && coarser->count() <= std::size_t(16) << 20);
  }

  /// Nearest places against a search through all of them.
  void nearestPlaces() {
    const ProbeGrid grid{.first = {-3, 2, 0}, .size = {13, 9, 11}, .step = 1.0};
    std::vector<std::uint32_t> nearest(grid.count(), noPlace);
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t i = 5; i < grid.count(); i += 97) {
      nearest[i] = i;
      seeds.push_back(i);
    }
    QVERIFY(spreadToNearest(grid, nearest, goesOn));
    for (std::uint32_t i = 0; i < grid.count(); ++i) {
      double least = 1e9;
      for (const std::uint32_t seed : seeds)
        least = std::min(least, distanceBetween(grid, i, seed));
      QCOMPARE(distanceBetween(grid, i, nearest[i]), least);
    }
    std::vector<std::uint32_t> none(grid.count(), noPlace);
    QVERIFY(spreadToNearest(grid, none, goesOn));
    QCOMPARE(none, std::vector<std::uint32_t>(grid.count(), noPlace));
  }
};

SLINE_TEST(PocketsTest)
#include "pockets_test.moc"
