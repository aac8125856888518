// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "model/import/molecules/superposition.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// Returns a chain that wanders in steps of 3.8 Å, with a sequence drawn by the seed.
BackboneChain wandering(const char* id, int length, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> step;
  const std::string alphabet = "ARNDCQEGHILKMFPSTWYV";
  BackboneChain chain;
  chain.id = id;
  glm::dvec3 at(0.0);
  for (int i = 0; i < length; ++i) {
    chain.letters += alphabet[random() % alphabet.size()];
    chain.places.push_back(at);
    at += 3.8 * glm::normalize(glm::dvec3(step(random), step(random), step(random)));
  }
  return chain;
}

const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(0.2, 0.7, -0.4, 0.5)));
const glm::dvec3 shift(31.0, -12.5, 77.7);

BackboneChain moved(BackboneChain chain) {
  for (glm::dvec3& p : chain.places)
    p = turn * p + shift;
  return chain;
}

/// Returns the farthest that the motion leaves any place from where it belongs.
double farthest(const RigidMotion& motion, const BackboneChain& from, const BackboneChain& to) {
  double most = 0.0;
  for (std::size_t i = 0; i < from.places.size(); ++i)
    most = std::max(most, glm::length(motion(from.places[i]) - to.places[i]));
  return most;
}

}  // namespace

class TestSuperposition : public QObject {
  Q_OBJECT

 private slots:
  void aligns_data() {
    QTest::addColumn<QString>("a");
    QTest::addColumn<QString>("b");
    QTest::addColumn<QString>("pairs");
    QTest::newRow("equal") << "ACDE"
                           << "ACDE"
                           << "0-0 1-1 2-2 3-3";
    QTest::newRow("free ends") << "WWHKDEWW"
                               << "HKDE"
                               << "2-0 3-1 4-2 5-3";
    QTest::newRow("one letter differs") << "ACDEW"
                                        << "ACDQW"
                                        << "0-0 1-1 2-2 3-3 4-4";
    QTest::newRow("gap of two") << "WWWWCCHHHHFFFF"
                                << "WWWWHHHHFFFF"
                                << "0-0 1-1 2-2 3-3 6-4 7-5 8-6 9-7 10-8 11-9 12-10 13-11";
    QTest::newRow("gap in the first") << "WWWWHHHHFFFF"
                                      << "WWWWCCHHHHFFFF"
                                      << "0-0 1-1 2-2 3-3 4-6 5-7 6-8 7-9 8-10 9-11 10-12 11-13";
  }
  void aligns() {
    QFETCH(QString, a);
    QFETCH(QString, b);
    const auto alignment = aligned(a.toStdString(), b.toStdString(), false);
    QVERIFY(alignment);
    QStringList pairs;
    for (const auto& [i, k] : alignment->pairs)
      pairs << QString("%1-%2").arg(i).arg(k);
    QTEST(pairs.join(' '), "pairs");
  }
  void bounded() {
    const std::string longest(13'000, 'A');
    QVERIFY(!aligned(longest, longest + "C", false));
    QVERIFY(aligned(longest, longest, false));
    QVERIFY(!aligned("", "A", false));
  }

  void fitsExactly() {
    const BackboneChain chain = wandering("A", 120, 5);
    const BackboneChain away = moved(chain);
    std::vector<std::pair<glm::dvec3, glm::dvec3>> pairs;
    for (std::size_t i = 0; i < chain.places.size(); ++i)
      pairs.emplace_back(away.places[i], chain.places[i]);
    const RigidMotion motion = rigidFit(pairs);
    QVERIFY(farthest(motion, away, chain) < 1e-9);
    QVERIFY(std::abs(glm::determinant(motion.rotation) - 1.0) < 1e-12);
  }

  void neverMirrors() {
    const BackboneChain chain = wandering("A", 60, 9);
    std::vector<std::pair<glm::dvec3, glm::dvec3>> pairs;
    for (const glm::dvec3& p : chain.places)
      pairs.emplace_back(glm::dvec3(-p.x, p.y, p.z), p);
    QVERIFY(glm::determinant(rigidFit(pairs).rotation) > 0.0);
  }

  void findsTheBestChains() {
    const BackboneChain wanted = wandering("B", 80, 2);
    const Backbone fixed{"1ABC", {wandering("A", 200, 1), wanted}};
    BackboneChain copy = moved(wanted);
    copy.id = "X";
    const Backbone moving{"2ABC", {moved(wandering("Y", 150, 3)), copy}};
    const auto fit = superposition(moving, fixed);
    QVERIFY(fit);
    QCOMPARE(fit->chain, std::string("X"));
    QCOMPARE(fit->ontoChain, std::string("B"));
    QCOMPARE(fit->kept, std::size_t(80));
    QVERIFY(fit->rmsd < 1e-6 && fit->identity == 1.0);
    QVERIFY(farthest(fit->motion, copy, wanted) < 1e-6);
  }

  void aMovedDomainIsLeftOut() {
    const BackboneChain chain = wandering("A", 200, 4);
    BackboneChain other = moved(chain);
    for (std::size_t i = 150; i < 200; ++i)
      other.places[i] += glm::dvec3(0.0, 15.0, 9.0);
    const auto fit = superposition({"m", {other}}, {"f", {chain}});
    QVERIFY(fit);
    QVERIFY2(fit->kept >= 150 && fit->kept <= 153, qPrintable(QString::number(fit->kept)));
    for (std::size_t i = 0; i < 140; ++i)
      QVERIFY(glm::length(fit->motion(other.places[i]) - chain.places[i]) < 0.3);
  }

  void strangersStayApart_data() {
    QTest::addColumn<int>("length");
    QTest::addColumn<bool>("nucleic");
    QTest::newRow("other sequence") << 150 << false;
    QTest::newRow("a nucleic acid") << 100 << true;
    QTest::newRow("a few residues") << 4 << false;
  }
  void strangersStayApart() {
    QFETCH(int, length);
    QFETCH(bool, nucleic);
    BackboneChain chain = wandering("A", length, 77);
    chain.nucleic = nucleic;
    QVERIFY(!superposition({"m", {chain}}, {"f", {wandering("A", 100, 78)}}));
    QVERIFY(!superposition({"m", {}}, {"f", {wandering("A", 100, 78)}}));
  }
};

SLINE_TEST_WITH_EVENTS(TestSuperposition)
#include "test_superposition.moc"
