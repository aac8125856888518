// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "tests/model/edit/written_tree.h"
#include "tests/support/suite.h"
#include "widgets/structure_tree/row_filter.h"

namespace sline::widgets {

class RowFilterTest : public QObject {
  Q_OBJECT

 private slots:
  void leaves_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("matches");
    QTest::addColumn<int>("rows");
    QTest::newRow("nothing typed")
        << ""
        << "left kidney;right kidney;Arteria iliaca;ven\u00e6 renalis" << 6;
    QTest::newRow("part of a word") << "idn"
                                    << "left kidney;right kidney" << 3;
    QTest::newRow("words in any order") << "kid left"
                                        << "left kidney" << 2;
    QTest::newRow("case") << "KIDNEY"
                          << "left kidney;right kidney" << 3;
    QTest::newRow("a group speaks for what is in it") << "vessels"
                                                      << "Arteria iliaca;ven\u00e6 renalis" << 3;
    QTest::newRow("group and name") << "iliaca vess"
                                    << "Arteria iliaca" << 2;
    QTest::newRow("accents typed") << QString::fromUtf8("árteriä") << "Arteria iliaca" << 2;
    QTest::newRow("another name") << "niere"
                                  << "left kidney;right kidney" << 3;
    QTest::newRow("another name, without its accent") << "rognon dr"
                                                      << "right kidney" << 2;
    QTest::newRow("a side in another language, begun") << "lin"
                                                       << "" << 0;
    QTest::newRow("a side in another language") << "linke"
                                                << "left kidney" << 2;
    QTest::newRow("joined letters") << "venae"
                                    << "ven\u00e6 renalis" << 2;
    QTest::newRow("words of different names") << "left niere"
                                              << "left kidney" << 2;
    QTest::newRow("one word too many") << "left kidney stone"
                                       << "" << 0;
    QTest::newRow("blanks") << "  left   kidney "
                            << "left kidney" << 2;
    QTest::newRow("dashes") << "left_kid-ney"
                            << "left kidney" << 2;
  }
  void leaves() {
    QFETCH(QString, text);
    QFETCH(QString, matches);
    QFETCH(int, rows);
    model::Scene scene = test::readTree("A(a b) B(c d)");
    const char* names[] = {"Organs",  "left kidney",    "right kidney",
                           "Vessels", "Arteria iliaca", "ven\u00e6 renalis"};
    std::vector<model::Node> nodes = scene.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes[i].name = names[i];
    scene.setNodes(nodes);
    RowFilter filter;
    filter.setNames({.shown = {}, .alsoCalled = [](const QString& name) {
                       QStringList also;
                       if (name.contains("kidney"))
                         also << "Niere";
                       if (name == "left kidney")
                         also << "linke Niere";
                       if (name == "right kidney")
                         also << QString::fromUtf8("rognon dróit");
                       return also;
                     }});
    QCOMPARE(filter.setText(text), !text.isEmpty());
    QVERIFY(!filter.setText(text + ' '));
    QCOMPARE(filter.active(), !text.isEmpty());
    const RowFilter::Left left = filter.apply(scene);
    QStringList found;
    for (const model::NodeId id : left.structures)
      found << QString::fromStdString(scene.find(id)->name);
    QCOMPARE(found.join(';'), matches);
    QCOMPARE(int(left.rows.size()), rows);
  }
};

}  // namespace sline::widgets

SLINE_TEST(sline::widgets::RowFilterTest)
#include "row_filter_test.moc"
