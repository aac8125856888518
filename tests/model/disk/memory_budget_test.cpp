// SPDX-License-Identifier: Apache-2.0
#include "model/disk/memory_budget.h"

#include <QtTest>

#include "tests/support/suite.h"

using namespace sline::model;

class MemoryBudgetTest : public QObject {
  Q_OBJECT
 private slots:
  void theSystemTells() {
    QVERIFY(availableMemory() > 10'000'000);
    QVERIFY(MemoryBudget().claim(1000).ok());
    QVERIFY(!MemoryBudget().claim(1'000'000'000'000).ok());
  }
  void whatIsTakenCounts() {
    MemoryBudget memory(100'000'000 * bytesPerTriangle);
    QVERIFY(memory.claim(60'000'000).ok());
    const sline::Status tooMuch = memory.claim(50'500'000);
    QVERIFY(!tooMuch.ok());
    QCOMPARE(
        tooMuch.error().reason,
        std::string("50.5 million triangles need at least 6.5 GB of memory, and 5.2 GB are left"));
    QVERIFY(!tooMuch.error().remedy.empty());
    // What was refused has taken nothing.
    QVERIFY(memory.claim(40'000'000).ok());
    QVERIFY(!memory.claim(1).ok());
  }
  void sizes() {
    QCOMPARE(gigabytes(0), std::string("0.0 GB"));
    QCOMPARE(gigabytes(12'345'000'000), std::string("12.3 GB"));
  }
};

SLINE_TEST(MemoryBudgetTest)
#include "memory_budget_test.moc"
