// SPDX-License-Identifier: Apache-2.0
// Tests the thresholds that a style sets.
#include "model/scene/threshold_values.h"

#include <QtTest>
#include <cmath>
#include <limits>

#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class ThresholdValuesTest : public QObject {
  Q_OBJECT
 private slots:
  void theOrderOfSettingDoesNotMatter() {
    ThresholdValues one{{"b", 2.0f}, {"a", 1.0f}};
    ThresholdValues other{{"a", 7.0f}, {"c", 3.0f}};
    other.set("b", 2.0f);
    other.set("a", 1.0f);
    QVERIFY(one != other);
    other.reset("c");
    other.reset("unknown");
    QVERIFY(one == other);
    QVERIFY(one.of("a") == 1.0f && one.of("b") == 2.0f && !one.of("c"));
    QVERIFY(!one.empty() && ThresholdValues().empty());
  }
  void faults_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<float>("value");
    QTest::addColumn<bool>("fine");
    QTest::newRow("usual") << QByteArray("ridges.curvature") << 2.0f << true;
    QTest::newRow("zero") << QByteArray("sline.t_d") << 0.0f << true;
    QTest::newRow("no name") << QByteArray() << 1.0f << false;
    QTest::newRow("long name") << QByteArray(65, 'a') << 1.0f << false;
    QTest::newRow("spaces") << QByteArray("a b") << 1.0f << false;
    QTest::newRow("negative") << QByteArray("a") << -1.0f << false;
    QTest::newRow("too large") << QByteArray("a") << 1e7f << false;
    QTest::newRow("no number") << QByteArray("a") << std::numeric_limits<float>::quiet_NaN()
                               << false;
  }
  void faults() {
    QFETCH(QByteArray, name);
    QFETCH(float, value);
    QFETCH(bool, fine);
    QCOMPARE(!thresholdFault(name.toStdString(), value), fine);
  }
};

SLINE_TEST(ThresholdValuesTest)
#include "threshold_values_test.moc"
