// SPDX-License-Identifier: Apache-2.0
// Compares solvent-excluded surfaces with geometry in closed form.
#include <QTest>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <random>

#include "model/import/molecules/surface/excluded_surface.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

constexpr double pi = std::numbers::pi;

struct Measures {
  double area = 0.0;
  double volume = 0.0;
};

/// Returns the measures of two atoms of radius r at distance d (Connolly 1983): convex caps and the
/// saddle that the probe's arc sweeps, on a ring of radius ρ; if ρ < p the probe meets itself on
/// the axis and the saddle ends in two points.
Measures ofTwoAtoms(double r, double d) {
  const double p = probeRadius;
  const double grown = r + p;
  if (d >= 2.0 * grown)
    return {8.0 * pi * r * r, 8.0 / 3.0 * pi * r * r * r};
  const double ring = std::sqrt(grown * grown - d * d / 4.0);
  const double last = std::asin(d / 2.0 / grown);
  const double first = ring < p ? std::acos(ring / p) : 0.0;
  const double h = r * std::sin(last);
  Measures sum;
  sum.area = 4.0 * pi * r * (r + h) +
             4.0 * pi * p * (ring * (last - first) - p * (std::sin(last) - std::sin(first)));
  sum.volume = 2.0 * pi * (r * r * (h + r) - (h * h * h + r * r * r) / 3.0);
  constexpr int steps = 20'000;
  for (int i = 0; i < steps; ++i) {
    const double angle = first + (last - first) * (i + 0.5) / steps;
    const double y = ring - p * std::cos(angle);
    sum.volume += 2.0 * pi * y * y * p * std::cos(angle) * (last - first) / steps;
  }
  return sum;
}

SolventAccessible accessibleOf(const std::vector<glm::dvec3>& atoms, double radius) {
  std::vector<Ball> balls;
  for (const glm::dvec3& p : atoms)
    balls.push_back({p, radius + probeRadius});
  std::optional<SolventAccessible> surface =
      SolventAccessible::of(std::move(balls), [] { return true; });
  if (!surface)
    qFatal("no accessible surface");
  return std::move(*surface);
}

TriangleMesh surfaceOf(const std::vector<glm::dvec3>& atoms, double radius, double spacing,
                       const std::vector<glm::dvec3>& guests = {}) {
  return excludedSurface(accessibleOf(atoms, radius), guests, spacing, [] { return true; });
}

/// Returns atoms about as dense as in a protein, in a ball.
std::vector<glm::dvec3> cluster(int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const double radius = std::cbrt(count * 16.0 / (4.0 / 3.0 * pi));
  std::vector<glm::dvec3> atoms;
  while (int(atoms.size()) < count) {
    const glm::dvec3 p(coordinate(random), coordinate(random), coordinate(random));
    const bool apart = std::none_of(atoms.begin(), atoms.end(), [&](const glm::dvec3& q) {
      return glm::length(q - radius * p) < 1.2;
    });
    if (glm::length(p) < 1.0 && apart)
      atoms.push_back(radius * p);
  }
  return atoms;
}

}  // namespace

class TestExcludedSurface : public QObject {
  Q_OBJECT

 private slots:
  void oneAtom_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("spacing");
    QTest::newRow("carbon") << 1.7 << 0.5;
    QTest::newRow("hydrogen, fine") << 1.2 << 0.3;
    QTest::newRow("caesium, coarse") << 3.43 << 0.75;
  }
  void oneAtom() {
    QFETCH(double, radius);
    QFETCH(double, spacing);
    const glm::dvec3 centre(3.217, -41.9, 7.53);
    const TriangleMesh mesh = surfaceOf({centre}, radius, spacing);
    QVERIFY(isClosed(mesh));
    for (const glm::vec3& p : mesh.positions)
      QVERIFY(std::abs(glm::length(glm::dvec3(p) - centre) - radius) < 1e-4);
    QVERIFY(std::abs(volumeOf(mesh) / (4.0 / 3.0 * pi * std::pow(radius, 3)) - 1.0) < 0.08);
  }

  void twoAtoms_data() {
    QTest::addColumn<double>("distance");
    QTest::newRow("bonded") << 1.54;
    QTest::newRow("double bond") << 1.2;
    QTest::newRow("touching") << 3.4;
    QTest::newRow("the probe just passes") << 5.5;
    QTest::newRow("the probe's arc meets itself") << 5.9;
    QTest::newRow("apart") << 6.3;
    QTest::newRow("far apart") << 40.0;
  }
  void twoAtoms() {
    QFETCH(double, distance);
    constexpr double radius = 1.7;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.48, -0.6, 0.64));
    const TriangleMesh mesh =
        surfaceOf({{1.0, 2.0, 3.0}, glm::dvec3(1.0, 2.0, 3.0) + distance * axis}, radius, 0.3);
    const Measures expected = ofTwoAtoms(radius, distance);
    QVERIFY(isClosed(mesh));
    const double area = areaOf(mesh) / expected.area;
    const double volume = volumeOf(mesh) / expected.volume;
    qInfo("area %.4f, volume %.4f of the closed form", area, volume);
    QVERIFY2(std::abs(area - 1.0) < 0.02, qPrintable(QString::number(area)));
    QVERIFY2(std::abs(volume - 1.0) < 0.02, qPrintable(QString::number(volume)));
  }

  void turningChangesNothing() {
    const std::vector<glm::dvec3> atoms = cluster(60, 7);
    const TriangleMesh still = surfaceOf(atoms, 1.7, 0.5);
    QVERIFY(isClosed(still) && volumeOf(still) > 0.0);
    const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(0.3, -0.8, 0.4, 0.2)));
    std::vector<glm::dvec3> turned;
    for (const glm::dvec3& p : atoms)
      turned.push_back(turn * p + glm::dvec3(0.137, 5.71, -9.3));
    const TriangleMesh moved = surfaceOf(turned, 1.7, 0.5);
    QVERIFY(isClosed(moved));
    QVERIFY(std::abs(areaOf(moved) / areaOf(still) - 1.0) < 0.01);
    QVERIFY(std::abs(volumeOf(moved) / volumeOf(still) - 1.0) < 0.005);
  }

  void verticesLieOnTheSurface() {
    // No vertex is nearer to an atom than its radius, and each touches an atom or a free probe.
    const std::vector<glm::dvec3> atoms = cluster(60, 11);
    const TriangleMesh mesh = surfaceOf(atoms, 1.7, 0.6);
    for (const glm::vec3& v : mesh.positions)
      for (const glm::dvec3& atom : atoms)
        QVERIFY(glm::length(glm::dvec3(v) - atom) > 1.7 - 1e-3);
  }

  void manyClusters() {
    for (std::uint32_t seed = 1; seed <= 8; ++seed)
      for (const double spacing : {0.5, 1.1, 2.3})
        QVERIFY2(isClosed(surfaceOf(cluster(80, seed), 1.6, spacing)),
                 qPrintable(QString("seed %1").arg(seed)));
  }

  void regularPlaces() {
    // Four and more probes' spheres meet in one point, and atoms lie on lattice points.
    std::vector<glm::dvec3> atoms;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 2; ++z)
          atoms.emplace_back(3.0 * x, 3.0 * y, 3.0 * z);
    atoms.push_back(atoms.front());  // one atom occurs twice
    QVERIFY(isClosed(surfaceOf(atoms, 1.7, 0.5)));
    QVERIFY(isClosed(surfaceOf(atoms, 1.6, 0.75)));
  }

  void voids_data() {
    QTest::addColumn<bool>("guest");
    QTest::newRow("empty: filled") << false;
    QTest::newRow("with a guest: kept") << true;
  }
  void voids() {
    QFETCH(bool, guest);
    std::vector<glm::dvec3> shell;
    constexpr int count = 260;
    for (int i = 0; i < count; ++i) {
      const double z = 1.0 - (2.0 * i + 1.0) / count;
      const double r = std::sqrt(1.0 - z * z);
      shell.emplace_back(7.0 *
                         glm::dvec3(r * std::cos(2.39996323 * i), r * std::sin(2.39996323 * i), z));
    }
    std::vector<glm::dvec3> guests;
    if (guest)
      guests.emplace_back(0.4, -0.3, 0.2);
    const TriangleMesh mesh = surfaceOf(shell, 1.7, 0.6, guests);
    QVERIFY(isClosed(mesh));
    const double outer = 4.0 / 3.0 * pi * std::pow(8.6, 3);
    const double inner = 4.0 / 3.0 * pi * std::pow(5.4, 3);
    QVERIFY(std::abs(volumeOf(mesh) / (guest ? outer - inner : outer) - 1.0) < 0.05);
  }

  void tooDense() {
    std::vector<Ball> heap;
    for (int i = 0; i < 2000; ++i)
      heap.push_back({glm::dvec3(0.001 * i, 0.0, 0.0), 3.1});
    QVERIFY(!SolventAccessible::of(std::move(heap), [] { return true; }));
  }

  void givesUp() {
    const SolventAccessible surface = accessibleOf(cluster(60, 3), 1.7);
    QVERIFY(excludedSurface(surface, {}, 0.5, [] { return false; }).triangles.empty());
  }
};

SLINE_TEST_WITH_EVENTS(TestExcludedSurface)
#include "test_excluded_surface.moc"
