// SPDX-License-Identifier: Apache-2.0
// Tests that vessels are known to serve what anatomists name them after, on the same side.
#include "model/anatomy/vessel_supply.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline::model {

class VesselSupplyTest : public QObject {
  Q_OBJECT
 private slots:
  void serves_data() {
    QTest::addColumn<QString>("vessel");
    QTest::addColumn<QString>("structure");
    QTest::addColumn<bool>("serves");
    QTest::newRow("same side") << "left renal artery"
                               << "left kidney" << true;
    QTest::newRow("other side") << "left renal artery"
                                << "right kidney" << false;
    QTest::newRow("structure without side") << "left renal vein"
                                            << "kidney" << true;
    QTest::newRow("branch of one organ") << "right hepatic artery"
                                         << "liver" << true;
    QTest::newRow("another organ") << "right hepatic artery"
                                   << "left kidney" << false;
    QTest::newRow("two names in one") << "portal vein and superior mesenteric vein"
                                      << "liver" << true;
    QTest::newRow("the second of them") << "portal vein and superior mesenteric vein"
                                        << "small bowel" << true;
    QTest::newRow("all words") << "superior rectal artery"
                               << "ileum" << false;
    QTest::newRow("pelvis") << "internal_iliac_artery_L"
                            << "urinary bladder" << true;
    QTest::newRow("leg") << "left external iliac artery"
                         << "urinary bladder" << false;
    QTest::newRow("German") << "linke Nierenarterie"
                            << "linke Niere" << true;
    QTest::newRow("Latin and English") << "arteria splenica"
                                       << "spleen" << true;
    QTest::newRow("tells nothing") << "aorta"
                                   << "liver" << false;
  }
  void serves() {
    QFETCH(QString, vessel);
    QFETCH(QString, structure);
    static const VesselSupply supply;
    const auto understood = [](const QString& name) {
      return supply.understood(name.toStdString());
    };
    QTEST(supply.serves(understood(vessel), understood(structure)), "serves");
  }
  void badRowsAreCounted() {
    QCOMPARE(VesselSupply().badRows(), std::size_t(0));
    const VesselSupply supply("# remark\nrenal\tkidney\nno organ\n\tliver\nhepatic\tliver|\n");
    QCOMPARE(supply.badRows(), std::size_t(3));
    QVERIFY(supply.serves(supply.understood("renal artery"), supply.understood("kidney")));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::VesselSupplyTest)
#include "vessel_supply_test.moc"
