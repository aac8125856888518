// SPDX-License-Identifier: Apache-2.0
// Tests that names of all languages tell how large a structure is, and only those that name one.
#include "model/anatomy/expected_sizes.h"

#include <QTest>

#include "model/anatomy/systems_table.h"
#include "model/anatomy/table_rows.h"
#include "tests/support/suite.h"

namespace sline::model {

class ExpectedSizesTest : public QObject {
  Q_OBJECT
 private slots:
  void sizes_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("fits");  // mm; 0: the table does not know the name
    QTest::newRow("English") << "liver" << 190.0;
    QTest::newRow("file") << "kidney_left" << 110.0;
    QTest::newRow("German") << "rechte Niere" << 110.0;
    QTest::newRow("Latin") << "ren sinister" << 110.0;
    QTest::newRow("Norwegian") << "lever" << 190.0;
    QTest::newRow("lobe") << "lung_upper_lobe_left" << 200.0;
    QTest::newRow("vertebra") << "vertebrae_L3" << 90.0;
    QTest::newRow("rib") << "rib_left_7" << 250.0;
    QTest::newRow("lesion") << "liver lesion 2" << 12.0;
    QTest::newRow("volume of a plan") << "GTV_primary" << 40.0;
    QTest::newRow("mouse") << "mouse brain" << 15.0;
    QTest::newRow("stone") << "kidney stone" << 0.0;
    QTest::newRow("vein of the liver") << "left hepatic vein" << 0.0;
    QTest::newRow("no anatomy") << "bunny" << 0.0;
    QTest::newRow("nothing") << "" << 0.0;
  }
  void sizes() {
    QFETCH(QString, name);
    QFETCH(double, fits);
    static const ExpectedSizes sizes;
    const auto expected = sizes.of(name.toStdString());
    QCOMPARE(expected.has_value(), fits > 0.0);
    if (expected)
      QVERIFY(expected->contain(float(fits)));
  }
  /// A factor of a thousand must be seen, so no row may hold both.
  void tableIsSound() {
    static const ExpectedSizes sizes;
    QCOMPARE(sizes.badRows(), std::size_t(0));
    for (const auto& fields : tableRows(sizesText()))
      for (const std::string_view name : cutAt(fields[0], '|')) {
        const std::string plain(name.substr(name.starts_with('=') ? 1 : 0));
        const auto expected = sizes.of(plain);
        QVERIFY2(expected, plain.c_str());
        QVERIFY2(expected->high < 1000.0f * expected->low, plain.c_str());
      }
  }
  void badRowsAreCounted() {
    const ExpectedSizes sizes("liver\t60\t340\nspleen\t90\nheart\tten\t20\nlung\t300\t20\n");
    QCOMPARE(sizes.badRows(), std::size_t(3));
    QVERIFY(sizes.of("liver") && !sizes.of("spleen") && !sizes.of("heart") && !sizes.of("lung"));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::ExpectedSizesTest)
#include "expected_sizes_test.moc"
