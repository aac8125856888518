// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "render/picture/motion_quality.h"
#include "tests/support/suite.h"

using sline::render::Fineness;
using sline::render::MotionQuality;

class MotionQualityTest : public QObject {
  Q_OBJECT
 private slots:
  void fineness_data() {
    QTest::addColumn<double>("milliseconds");
    QTest::addColumn<Fineness>("at");
    QTest::addColumn<Fineness>("fineness");
    const Fineness full;
    const Fineness half{.surfaceStep = 2};
    const Fineness third{.surfaceStep = 3};
    QTest::newRow("fast") << 20.0 << full << full;
    QTest::newRow("just fluent") << 60.0 << full << full;
    QTest::newRow("a little slow") << 70.0 << full << half;
    QTest::newRow("slow") << 120.0 << full << third;
    // Lines stay sharp for long.
    QTest::newRow("very slow") << 300.0 << full << third;
    QTest::newRow("too slow") << 340.0 << full << Fineness{0.75f, 3};
    QTest::newRow("hopeless") << 9000.0 << full << Fineness{1.0f / 3.0f, 3};
    // The coarse picture is fast, but a full one would not be.
    QTest::newRow("coarse and slow") << 59.0 << half << half;
    QTest::newRow("coarse and fast") << 10.0 << third << full;
    QTest::newRow("small and fast") << 10.0 << Fineness{0.5f, 3} << full;
  }
  void fineness() {
    QFETCH(double, milliseconds);
    QFETCH(Fineness, at);
    QFETCH(Fineness, fineness);
    MotionQuality quality;
    QCOMPARE(quality.fineness(), (Fineness{1.0f, 3}));
    quality.took(milliseconds, at);
    QCOMPARE(quality.fineness(), fineness);
  }
  void refinesOnlyAtRest() {
    QVERIFY(Fineness{}.full());
    QVERIFY(!(Fineness{.surfaceStep = 2}.full()));
    QVERIFY(!(Fineness{.scale = 0.5f}.full()));
  }
};

SLINE_TEST(MotionQualityTest)
#include "motion_quality_test.moc"
