// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/import/molecules/ball_and_stick.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

Atom atom(const char* symbol, glm::dvec3 place) {
  return {symbol, elementOf(symbol), place, 0};
}

bool goesOn() {
  return true;
}

}  // namespace

class TestBallAndStick : public QObject {
  Q_OBJECT

 private slots:
  void oneSurfaceAnElement() {
    // Formamide gives the skeleton, then O and N in the atoms' order.
    const std::vector<Atom> atoms = {atom("O", {1.22, 0, 0}), atom("C", {0, 0, 0}),
                                     atom("N", {-0.68, 1.19, 0})};
    const std::vector<ElementSurface> surfaces = ballAndStick(atoms, {}, goesOn);
    QCOMPARE(surfaces.size(), std::size_t(3));
    QCOMPARE(surfaces[0].element, elementOf("C"));
    QVERIFY(surfaces[0].withBonds && !surfaces[1].withBonds);
    QCOMPARE(surfaces[1].element, elementOf("O"));
    for (const ElementSurface& surface : surfaces)
      QVERIFY(isClosed(surface.mesh) && volumeOf(surface.mesh) > 0.0);
    const double radius = double(ballShare) * 1.52;
    const double ball = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    QVERIFY(std::abs(volumeOf(surfaces[1].mesh) / ball - 1.0) < 0.02);
  }

  void sticksReachTheBalls() {
    // The stick of a C–O bond ends within the oxygen's ball and does not come out behind it.
    const std::vector<Atom> atoms = {atom("C", {0, 0, 0}), atom("O", {1.43, 0, 0})};
    float farthest = 0.0f;
    const TriangleMesh carbon = ballAndStick(atoms, {}, goesOn).front().mesh;
    for (const glm::vec3& p : carbon.positions)
      farthest = std::max(farthest, p.x);
    const float near = 1.43f - ballShare * 1.52f;
    QVERIFY2(farthest > near && farthest < near + 0.25f, qPrintable(QString::number(farthest)));
  }

  void carbonsFlowIntoOne() {
    const std::vector<Atom> atoms = {atom("C", {0, 0, 0}), atom("C", {1.54, 0, 0})};
    const TriangleMesh mesh = ballAndStick(atoms, {}, goesOn).front().mesh;
    QVERIFY(isClosed(mesh));
    // One closed surface without handles: V − E + F = 2.
    QCOMPARE(mesh.positions.size() * 2, mesh.triangles.size() + 4);
  }

  void manyAtoms() {
    std::vector<Atom> atoms;
    for (int i = 0; i < 2000; ++i)
      atoms.push_back(atom("C", {1.5 * (i % 50), 1.5 * (i / 50), 0}));
    const std::vector<ElementSurface> surfaces = ballAndStick(atoms, {}, goesOn);
    QCOMPARE(surfaces.size(), std::size_t(1));
    QVERIFY(isClosed(surfaces.front().mesh));
  }

  void ions() {
    const std::vector<Atom> atoms = {atom("Mg", {0, 0, 0}), atom("Mg", {50, 0, 0})};
    const TriangleMesh mesh = balls(atoms, ionShare);
    QVERIFY(isClosed(mesh));
    for (const glm::vec3& p : mesh.positions)
      QVERIFY(std::abs(std::min(glm::length(p), glm::length(p - glm::vec3(50, 0, 0))) -
                       ionShare * 1.73f) < 1e-4f);
  }
};

SLINE_TEST_WITH_EVENTS(TestBallAndStick)
#include "test_ball_and_stick.moc"
