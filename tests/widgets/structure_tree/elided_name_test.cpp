// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/elided_name.h"

#include <QFont>
#include <QSet>
#include <QTest>

#include "tests/support/suite.h"

namespace sline::widgets {

class ElidedNameTest : public QObject {
  Q_OBJECT

 private slots:
  void standsFor_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("may");
    QTest::newRow("whole") << "liver"
                           << "liver" << true;
    QTest::newRow("another") << "liver"
                             << "livers" << false;
    QTest::newRow("middle") << "le…ey"
                            << "left kidney" << true;
    QTest::newRow("other beginning") << "le…ey"
                                     << "right kidney" << false;
    QTest::newRow("other end") << "le…ey"
                               << "left lung" << false;
    QTest::newRow("ends do not overlap") << "abc…bcd"
                                         << "abcd" << false;
    QTest::newRow("two places") << "…upper lobe…"
                                << "left upper lobe of lung" << true;
    QTest::newRow("in the wrong order") << "…lobe…upper…"
                                        << "left upper lobe of lung" << false;
    QTest::newRow("nothing") << "…"
                             << "anything" << true;
  }
  void standsFor() {
    QFETCH(QString, text);
    QFETCH(QString, name);
    QFETCH(bool, may);
    QCOMPARE(mayStandFor(text, name), may);
  }

  /// Whatever the width, what is shown fits, belongs to its name and, as soon as there is room for
  /// a word, to no other.
  void alikeStayApart() {
    const QFontMetrics metrics{QFont()};
    QStringList names;
    for (const char* side : {"left", "right"})
      for (const char* lobe : {"upper", "middle", "lower"})
        for (const char* part : {"anterior", "posterior", "apical"})
          names << QStringLiteral("%1 %2 lobe of the lung, %3 segmental bronchus, wall of branch")
                       .arg(QLatin1String(side), QLatin1String(lobe), QLatin1String(part));
    const int whole = metrics.horizontalAdvance(names.front());
    for (int width = 20; width < whole + 60; width += 7) {
      QSet<QString> shown;
      for (const QString& name : names) {
        const QString text = elidedName(name, names, metrics, width);
        QVERIFY(mayStandFor(text, name));
        QVERIFY2(metrics.horizontalAdvance(text) <= width, qPrintable(text));
        QCOMPARE(text == name, metrics.horizontalAdvance(name) <= width);
        shown << text;
      }
      if (width > 2 * whole / 3)
        QCOMPARE(shown.size(), names.size());
    }
    QVERIFY(metrics.elidedText(names[0], Qt::ElideMiddle, whole / 2) !=
            elidedName(names[0], names, metrics, whole / 2));
    // Alone it is shortened as usual, and beside one of the same name.
    QCOMPARE(elidedName(names[0], {names[0], "liver"}, metrics, whole / 2),
             metrics.elidedText(names[0], Qt::ElideMiddle, whole / 2));
  }
};

}  // namespace sline::widgets

SLINE_TEST_WITH_GUI(sline::widgets::ElidedNameTest)
#include "elided_name_test.moc"
