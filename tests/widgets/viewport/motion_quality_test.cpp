// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "tests/support/suite.h"
#include "widgets/viewport/motion_quality.h"

using sline::widgets::MotionQuality;

class MotionQualityTest : public QObject {
  Q_OBJECT
 private slots:
  void scale_data() {
    QTest::addColumn<double>("milliseconds");
    QTest::addColumn<float>("at");
    QTest::addColumn<float>("scale");
    QTest::newRow("fast") << 20.0 << 1.0f << 1.0f;
    QTest::newRow("just fluent") << 60.0 << 1.0f << 1.0f;
    QTest::newRow("a little slow") << 75.0 << 1.0f << 0.75f;
    QTest::newRow("slow") << 120.0 << 1.0f << 0.5f;
    QTest::newRow("very slow") << 1000.0 << 1.0f << 1.0f / 3.0f;
    // The coarse picture is fast, but a full one would not be.
    QTest::newRow("coarse and slow") << 59.0 << 0.5f << 0.5f;
    QTest::newRow("coarse and fast") << 10.0 << 0.5f << 1.0f;
  }
  void scale() {
    QFETCH(double, milliseconds);
    QFETCH(float, at);
    QFETCH(float, scale);
    MotionQuality quality;
    QCOMPARE(quality.scale(), 0.5f);
    quality.took(milliseconds, at);
    QCOMPARE(quality.scale(), scale);
  }
};

SLINE_TEST(MotionQualityTest)
#include "motion_quality_test.moc"
