// SPDX-License-Identifier: Apache-2.0
#include "model/scene/gamma_map.h"

#include <QtTest>
#include <limits>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

GammaMap occlusionMap(std::vector<GammaPoint> curve) {
  return {.scalar = GammaScalar::occlusion, .curve = std::move(curve)};
}

std::vector<GammaPoint> points(std::size_t count) {
  std::vector<GammaPoint> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back({float(i), 0.5f});
  return all;
}

}  // namespace

class GammaMapTest : public QObject {
  Q_OBJECT
 private slots:
  void offsetsLieOnStraightLines() {
    const GammaMap map = occlusionMap({{0.0f, 3.0f}, {1.0f, 1.0f}, {3.0f, -1.0f}});
    QCOMPARE(map.offsetAt(-7.0f), 3.0f);
    QCOMPARE(map.offsetAt(0.0f), 3.0f);
    QCOMPARE(map.offsetAt(0.5f), 2.0f);
    QCOMPARE(map.offsetAt(1.0f), 1.0f);
    QCOMPARE(map.offsetAt(2.0f), 0.0f);
    QCOMPARE(map.offsetAt(3.0f), -1.0f);
    QCOMPARE(map.offsetAt(std::numeric_limits<float>::infinity()), -1.0f);
    QCOMPARE(GammaMap().offsetAt(1.0f), 0.0f);
  }

  void faultsAreFound_data() {
    QTest::addColumn<GammaMap>("map");
    QTest::addColumn<QString>("fault");
    using Scalar = GammaScalar;
    QTest::newRow("nothing") << GammaMap() << QString();
    QTest::newRow("a curve of nothing")
        << GammaMap{.scalar = Scalar::none, .curve = points(2)} << "no scalar";
    QTest::newRow("two points") << occlusionMap(points(2)) << QString();
    QTest::newRow("eight points") << occlusionMap(points(8)) << QString();
    QTest::newRow("one point") << occlusionMap(points(1)) << "2 to 8";
    QTest::newRow("nine points") << occlusionMap(points(9)) << "2 to 8";
    QTest::newRow("the same scalar twice")
        << occlusionMap({{1.0f, 0.0f}, {1.0f, 1.0f}}) << "ascend";
    QTest::newRow("descending") << occlusionMap({{1.0f, 0.0f}, {0.0f, 1.0f}}) << "ascend";
    QTest::newRow("offset beyond 5") << occlusionMap({{0.0f, 0.0f}, {1.0f, 5.1f}}) << "-5 to 5";
    QTest::newRow("offset that is no number")
        << occlusionMap({{0.0f, NAN}, {1.0f, 0.0f}}) << "-5 to 5";
    QTest::newRow("scalar that is no number")
        << occlusionMap({{NAN, 0.0f}, {1.0f, 0.0f}}) << "1000000";
    QTest::newRow("targets of distances")
        << GammaMap{.scalar = Scalar::distance, .targets = {{3}}, .curve = points(2)} << QString();
    QTest::newRow("targets of others")
        << GammaMap{.scalar = Scalar::curvature, .targets = {{3}}, .curve = points(2)}
        << "only distances";
    QTest::newRow("many targets") << GammaMap{.scalar = Scalar::distance,
                                              .targets = std::vector<NodeId>(1001, NodeId{3}),
                                              .curve = points(2)}
                                  << "1000 targets";
    for (const Scalar scalar : {Scalar::occlusion, Scalar::curvature, Scalar::distance})
      QTest::addRow("usual %d", int(scalar))
          << GammaMap{.scalar = scalar, .curve = usualCurve(scalar)} << QString();
  }
  void faultsAreFound() {
    QFETCH(GammaMap, map);
    QFETCH(QString, fault);
    const auto found = gammaMapFault(map);
    QCOMPARE(found.has_value(), !fault.isEmpty());
    if (found)
      QVERIFY2(QString::fromUtf8(found->data(), qsizetype(found->size())).contains(fault),
               found->data());
  }

  void curvesAreRead_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("read");  // as it is written; or what the error says
    QTest::addColumn<bool>("fine");
    QTest::newRow("signs") << QByteArray("0:+3,40:-1") << QByteArray("0:+3,40:-1") << true;
    QTest::newRow("fractions") << QByteArray("-2.5:0.25,1e1:0") << QByteArray("-2.5:+0.25,10:0")
                               << true;
    QTest::newRow("empty") << QByteArray("") << QByteArray("point 1") << false;
    QTest::newRow("one point") << QByteArray("0:1") << QByteArray("2 to 8") << false;
    QTest::newRow("no colon") << QByteArray("0:1,7") << QByteArray("point 2") << false;
    QTest::newRow("a word") << QByteArray("0:1,x:2") << QByteArray("\"x:2\"") << false;
    QTest::newRow("two signs") << QByteArray("0:1,1:+-2") << QByteArray("point 2") << false;
    QTest::newRow("ends with a comma") << QByteArray("0:1,1:2,") << QByteArray("point 3") << false;
    QTest::newRow("descending") << QByteArray("1:1,0:2") << QByteArray("ascend") << false;
    QTest::newRow("too far") << QByteArray("0:1,1:6") << QByteArray("-5 to 5") << false;
    QTest::newRow("endless") << QByteArray("0:1,").repeated(1000) << QByteArray("point 10")
                             << false;
    QTest::newRow("infinite") << QByteArray("0:1,inf:2") << QByteArray("1000000") << false;
  }
  void curvesAreRead() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, read);
    QFETCH(bool, fine);
    const auto curve = curveFromText(text.toStdString());
    QCOMPARE(curve.ok(), fine);
    if (fine)
      QCOMPARE(QByteArray::fromStdString(curveText(*curve)), read);
    else
      QVERIFY2(curve.error().text().find(read.toStdString()) != std::string::npos,
               curve.error().text().c_str());
  }

  void mapsBlend_data() {
    QTest::addColumn<GammaMap>("from");
    QTest::addColumn<GammaMap>("to");
    const GammaMap one = occlusionMap({{0.0f, 0.0f}, {1.0f, 4.0f}});
    const GammaMap flat = occlusionMap({{0.5f, 1.0f}, {2.0f, 1.0f}});
    const GammaMap more = occlusionMap({{0.0f, 0.0f}, {0.5f, -2.0f}, {1.0f, 3.0f}});
    const GammaMap other{
        .scalar = GammaScalar::distance, .targets = {{4}}, .curve = {{0.0f, 3.0f}, {20.0f, -1.0f}}};
    QTest::newRow("alike") << one << flat;
    QTest::newRow("more points") << one << more;
    QTest::newRow("from none") << GammaMap() << one;
    QTest::newRow("to none") << other << GammaMap();
    QTest::newRow("another scalar") << one << other;
  }
  void mapsBlend() {
    QFETCH(GammaMap, from);
    QFETCH(GammaMap, to);
    QVERIFY(between(from, to, 0.0f) == from);
    QVERIFY(between(from, to, 1.0f) == to);
    QVERIFY(between(from, from, 0.3f) == from);
    // No offset jumps anywhere.
    constexpr int steps = 200;
    for (const float scalar : {-1.0f, 0.0f, 0.3f, 0.8f, 1.5f, 25.0f})
      for (int i = 0; i < steps; ++i) {
        const GammaMap before = between(from, to, float(i) / float(steps));
        const GammaMap after = between(from, to, float(i + 1) / float(steps));
        QVERIFY(!gammaMapFault(after));
        QVERIFY(std::abs(after.offsetAt(scalar) - before.offsetAt(scalar)) < 0.1f);
      }
  }
};

SLINE_TEST(GammaMapTest)
#include "gamma_map_test.moc"
