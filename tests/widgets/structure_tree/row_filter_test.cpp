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
    QTest::newRow("one or the other") << "kidney or iliaca"
                                      << "left kidney;right kidney;Arteria iliaca" << 5;
    QTest::newRow("or, by a sign") << "left kid|iliaca"
                                   << "left kidney;Arteria iliaca" << 4;
    QTest::newRow("or, by a comma") << "left, venae, nothing"
                                    << "left kidney;ven\u00e6 renalis" << 4;
    QTest::newRow("or, and nothing yet") << "kidney or "
                                         << "left kidney;right kidney" << 3;
    QTest::newRow("or, and nothing before") << "| left"
                                            << "left kidney" << 2;
    QTest::newRow("or as the beginning of a word") << "or"
                                                   << "left kidney;right kidney" << 3;
    QTest::newRow("of a group or of another") << "organs left or vessels iliaca"
                                              << "left kidney;Arteria iliaca" << 4;
    QTest::newRow("not across wishes") << "left or iliaca vessels organs"
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

  void sidesAreWholeWords_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("matches");
    QTest::newRow("left") << "left"
                          << "left kidney;KidneyLeft;kidney_LEFT_2";
    QTest::newRow("left, with more") << "left kid 2"
                                     << "kidney_LEFT_2";
    QTest::newRow("right") << "right"
                           << "right kidney";
    QTest::newRow("begun") << "lef"
                           << "left kidney;cleft palate;KidneyLeft;kidney_LEFT_2";
    QTest::newRow("another word") << "cleft"
                                  << "cleft palate";
    QTest::newRow("in another language") << "links"
                                         << "kidney_LEFT_2";
    QTest::newRow("a letter") << "l"
                              << "left kidney;cleft palate;KidneyLeft;kidney_LEFT_2";
  }
  /// "left" does not ask for a cleft, nor "right" for what is bright.
  void sidesAreWholeWords() {
    QFETCH(QString, text);
    QFETCH(QString, matches);
    model::Scene scene = test::readTree("a b c d e f");
    const char* names[] = {"left kidney", "cleft palate", "KidneyLeft",
                           "bright spot", "right kidney", "kidney_LEFT_2"};
    std::vector<model::Node> nodes = scene.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes[i].name = names[i];
    scene.setNodes(nodes);
    RowFilter filter;
    filter.setNames({.shown = {}, .alsoCalled = [](const QString& name) {
                       return name.endsWith("2") ? QStringList{"Niere links"} : QStringList();
                     }});
    filter.setText(text);
    QStringList found;
    for (const model::NodeId id : filter.apply(scene).structures)
      found << QString::fromStdString(scene.find(id)->name);
    QCOMPARE(found.join(';'), matches);
  }
};

}  // namespace sline::widgets

SLINE_TEST(sline::widgets::RowFilterTest)
#include "row_filter_test.moc"
