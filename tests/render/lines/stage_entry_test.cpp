// SPDX-License-Identifier: Apache-2.0
// Tests that lines enter evenly (METHOD §7): at any time as much is in as that time says, and none
// stands still.
#include "render/lines/ground/stage_entry.h"
#include "tests/support/suite.h"

#include <QtTest>
#include <cmath>

using namespace sline::render;

class StageEntryTest : public QObject {
  Q_OBJECT
 private slots:
  void meanIsTheTime_data();
  void meanIsTheTime();
  void everyLineGrowsAllTheTime();
  void theFirstAreAhead();
};

void StageEntryTest::meanIsTheTime_data() {
  QTest::addColumn<float>("t");
  for (const float t : {0.0f, 0.05f, 0.25f, 0.4f, 0.5f, 0.75f, 0.9f, 1.0f})
    QTest::addRow("T = %g", double(t)) << t;
}

void StageEntryTest::meanIsTheTime() {
  QFETCH(float, t);
  constexpr int ranks = 2000;
  double sum = 0.0;
  for (int i = 0; i < ranks; ++i)
    sum += entered(t, (float(i) + 0.5f) / float(ranks));
  QVERIFY2(std::abs(sum / ranks - t) < 1e-4, qPrintable(QString::number(sum / ranks)));
}

void StageEntryTest::everyLineGrowsAllTheTime() {
  // They grow at a fifth of the mean rate or more, METHOD's limit for a dead stretch, in case all
  // but one rank are hidden.
  constexpr float step = 0.1f;
  for (const float rank : {0.0f, 0.1f, 0.5f, 0.9f, 1.0f}) {
    QCOMPARE(entered(0.0f, rank), 0.0f);
    QCOMPARE(entered(1.0f, rank), 1.0f);
    for (int i = 0; i < 10; ++i) {
      const float grown = entered(step * float(i + 1), rank) - entered(step * float(i), rank);
      QVERIFY2(grown >= 0.2f * step,
               qPrintable(QString("rank %1, T %2: %3").arg(rank).arg(0.1 * i).arg(grown)));
    }
  }
}

void StageEntryTest::theFirstAreAhead() {
  for (int i = 1; i < 20; ++i) {
    const float t = 0.05f * float(i);
    for (int j = 1; j <= 20; ++j)
      QVERIFY(entered(t, 0.05f * float(j)) <= entered(t, 0.05f * float(j - 1)));
    QVERIFY(entered(t, 0.0f) > entered(t, 1.0f) + 0.1f * t * (1.0f - t));
  }
}

SLINE_TEST_WITH_EVENTS(StageEntryTest)
#include "stage_entry_test.moc"
