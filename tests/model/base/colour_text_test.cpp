// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "model/base/colour_text.h"
#include "tests/support/suite.h"

namespace sline::test {

class ColourTextTest : public QObject {
  Q_OBJECT

 private slots:
  void colours_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("red");
    QTest::addColumn<int>("green");
    QTest::addColumn<int>("blue");
    QTest::newRow("small letters") << QByteArray("#a0523c") << 160 << 82 << 60;
    QTest::newRow("capitals") << QByteArray("#A0523C") << 160 << 82 << 60;
    QTest::newRow("black") << QByteArray("#000000") << 0 << 0 << 0;
    QTest::newRow("white") << QByteArray("#ffffff") << 255 << 255 << 255;
  }
  void colours() {
    QFETCH(QByteArray, text);
    QFETCH(int, red);
    QFETCH(int, green);
    QFETCH(int, blue);
    const std::optional<Colour> colour = colourFrom(text.toStdString());
    QVERIFY(colour.has_value());
    QVERIFY((*colour == Colour{std::uint8_t(red), std::uint8_t(green), std::uint8_t(blue)}));
    QCOMPARE(QByteArray::fromStdString(colourText(*colour)), text.toLower());
  }

  void othersAreNone() {
    for (const char* text : {"", "#", "a0523c", "#a0523", "#a0523c0", "#a0523g", "#-0523c",
                             "# a0523", "#0xa052", "red"})
      QVERIFY2(!colourFrom(text), text);
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::ColourTextTest)
#include "colour_text_test.moc"
