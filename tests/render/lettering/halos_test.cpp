// SPDX-License-Identifier: Apache-2.0
// Tests that halos have the very colour that the picture has behind what is drawn, and are gaps
// where it has none.
#include <QImage>
#include <QPainter>
#include <QtTest>
#include <cmath>

#include "render/drawn/surface_fill.h"
#include "render/lettering/lettering.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

class HalosTest : public QObject {
  Q_OBJECT

  /// Returns what a letter in the middle leaves of a red picture, beside its ink.
  static QColor besideLetter(Background ground, QImage::Format format) {
    QImage image(200, 200, format);
    image.fill(Qt::red);
    const LetteringColours colours = letteringColours(ground);
    Lettering lettering{.ground = colours.ground, .clear = colours.clear, .items = {}};
    LetteringItem bar{.name = "bar", .shapes = {}, .text = {}};
    bar.shapes.push_back({.path = polyline({{2.0f, 10.0f}, {18.0f, 10.0f}}),
                          .pen = 1.0f,
                          .ink = colours.ink,
                          .fill = {},
                          .dashed = false,
                          .halo = 1.0f});
    lettering.items.push_back(bar);
    QPainter painter(&image);
    painter.scale(10.0, 10.0);
    paintLettering(painter, lettering);
    painter.end();
    return image.pixelColor(100, 110);
  }

 private slots:
  void haveTheGroundsColour_data() {
    QTest::addColumn<int>("ground");
    QTest::newRow("white") << int(Background::white);
    QTest::newRow("paper") << int(Background::paper);
    QTest::newRow("dark") << int(Background::dark);
  }
  void haveTheGroundsColour() {
    QFETCH(int, ground);
    const glm::vec4 colour = 255.0f * backgroundColour(Background(ground));
    const QColor beside = besideLetter(Background(ground), QImage::Format_ARGB32_Premultiplied);
    QCOMPARE(beside.red(), int(std::lround(colour.r)));
    QCOMPARE(beside.green(), int(std::lround(colour.g)));
    QCOMPARE(beside.blue(), int(std::lround(colour.b)));
    QCOMPARE(beside.alpha(), 255);
  }

  void areGapsWithoutGround() {
    QCOMPARE(besideLetter(Background::transparent, QImage::Format_ARGB32_Premultiplied).alpha(), 0);
    QCOMPARE(besideLetter(Background::transparent, QImage::Format_RGBA64_Premultiplied).alpha(), 0);
    // What cannot be clear is white, not black.
    QCOMPARE(besideLetter(Background::transparent, QImage::Format_RGB32), QColor(Qt::white));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::HalosTest)
#include "halos_test.moc"
