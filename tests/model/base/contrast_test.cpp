// SPDX-License-Identifier: Apache-2.0
#include "model/base/contrast.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline {

class ContrastTest : public QObject {
  Q_OBJECT
 private slots:
  void knownRatios() {
    QCOMPARE(contrastBetween({0, 0, 0}, {255, 255, 255}), 21.0);
    QCOMPARE(contrastBetween({9, 9, 9}, {9, 9, 9}), 1.0);
    // The guidelines' own example of a grey that is just legible on white.
    QVERIFY(std::abs(contrastBetween({118, 118, 118}, {255, 255, 255}) - 4.54) < 0.01);
    QCOMPARE(contrastBetween({10, 200, 30}, {90, 20, 70}),
             contrastBetween({90, 20, 70}, {10, 200, 30}));
  }
  void coloursBecomeLegible_data() {
    QTest::addColumn<int>("red");
    QTest::addColumn<int>("green");
    QTest::addColumn<int>("blue");
    QTest::addColumn<bool>("dark");
    QTest::newRow("ivory on white") << 248 << 234 << 214 << false;
    QTest::newRow("yellow on white") << 255 << 225 << 30 << false;
    QTest::newRow("white on white") << 255 << 255 << 255 << false;
    QTest::newRow("brown on black") << 60 << 30 << 20 << true;
    QTest::newRow("black on black") << 0 << 0 << 0 << true;
  }
  void coloursBecomeLegible() {
    QFETCH(int, red);
    QFETCH(int, green);
    QFETCH(int, blue);
    QFETCH(bool, dark);
    const Colour ground = dark ? Colour{28, 30, 34} : Colour{255, 255, 255};
    const Colour colour{std::uint8_t(red), std::uint8_t(green), std::uint8_t(blue)};
    for (const double ratio : {3.0, 4.5, 9.0}) {
      const Colour ink = legibleOn(ground, colour, ratio);
      const double reached = contrastBetween(ground, ink);
      QVERIFY2(reached >= ratio && reached < 1.08 * ratio, qPrintable(QString::number(reached)));
      if (!dark)
        QVERIFY(ink.red >= ink.green && ink.green >= ink.blue);  // the hue's order stays
    }
  }
  void legibleColoursStay() {
    const Colour ink{90, 20, 10};
    QCOMPARE(legibleOn({255, 255, 255}, ink, 4.5), ink);
  }
};

}  // namespace sline

SLINE_TEST(sline::ContrastTest)
#include "contrast_test.moc"
