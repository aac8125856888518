// SPDX-License-Identifier: Apache-2.0
// Tests that names stand as people count: by numbers, whatever their case.
#include "model/base/natural_order.h"

#include <QTest>
#include <algorithm>
#include <random>

#include "tests/support/suite.h"

namespace sline {

class NaturalOrderTest : public QObject {
  Q_OBJECT
 private slots:
  void order_data() {
    QTest::addColumn<QStringList>("ordered");
    QTest::newRow("ribs") << QStringList{"rib 1", "rib 7", "rib 10", "rib 12"};
    QTest::newRow("numbers in a word") << QStringList{"L1", "L2", "L10", "T9", "T12"};
    QTest::newRow("case") << QStringList{"aorta", "Bladder", "colon", "Femur"};
    QTest::newRow("zeros in front") << QStringList{"slice 007", "slice 8", "slice 09", "slice 10"};
    QTest::newRow("a part first") << QStringList{"liver", "liver 2", "liver 10", "liver cyst"};
    QTest::newRow("two numbers") << QStringList{"C2-C3", "C2-C10", "C10-C2"};
    QTest::newRow("longer than any integer")
        << QStringList{"x9", "x99999999999999999998", "x99999999999999999999"};
    QTest::newRow("equal but for their writing") << QStringList{"Rib 1", "rib 01", "rib 1"};
  }
  void order() {
    QFETCH(QStringList, ordered);
    std::vector<std::string> names;
    for (const QString& name : ordered)
      names.push_back(name.toStdString());
    std::vector<std::string> mixed = names;
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round) {
      std::shuffle(mixed.begin(), mixed.end(), random);
      std::sort(mixed.begin(), mixed.end(),
                [](const std::string& a, const std::string& b) { return naturallyBefore(a, b); });
      QCOMPARE(mixed, names);
    }
    for (const std::string& name : names)
      QVERIFY(!naturallyBefore(name, name));
  }
  void folderByFolder() {
    QVERIFY(pathNaturallyBefore("ribs/rib 7.obj", "ribs/rib 10.obj"));
    QVERIFY(pathNaturallyBefore("part 2/z.obj", "part 10/a.obj"));
    QVERIFY(pathNaturallyBefore("a/z.obj", "a b/a.obj"));
    QVERIFY(!pathNaturallyBefore("a b/a.obj", "a/z.obj"));
  }
};

}  // namespace sline

SLINE_TEST(sline::NaturalOrderTest)
#include "natural_order_test.moc"
