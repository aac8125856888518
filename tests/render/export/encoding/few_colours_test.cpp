// SPDX-License-Identifier: Apache-2.0
// Tests small PNGs of few colours by reading them with another program's reader.
#include "render/export/encoding/few_colours.h"

#include <QImage>
#include <QSet>
#include <QTest>

#include "tests/support/suite.h"

namespace sline::test {

namespace {

/// Returns a picture whose colours run from black to red along x and to blue along y.
render::Image ramps(int width, int height) {
  render::Image image{.width = width, .height = height, .rgba = {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.rgba.insert(image.rgba.end(), {std::uint8_t(255 * x / (width - 1)), 40,
                                           std::uint8_t(255 * y / (height - 1)), 255});
  return image;
}

QImage read(const std::string& png) {
  return QImage::fromData(QByteArray::fromStdString(png), "PNG")
      .convertToFormat(QImage::Format_RGB32);
}

int worstDifference(const render::Image& image, const QImage& read) {
  int worst = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* own = &image.rgba[4 * std::size_t(y * image.width + x)];
      const QRgb other = read.pixel(x, y);
      worst = std::max({worst, std::abs(own[0] - qRed(other)), std::abs(own[1] - qGreen(other)),
                        std::abs(own[2] - qBlue(other))});
    }
  return worst;
}

}  // namespace

class FewColoursTest : public QObject {
  Q_OBJECT
 private slots:
  void fewAreKeptAsTheyAre() {
    const render::Image image = ramps(5, 3);
    const QImage back = read(render::pngOfFewColours(image, 16));
    QCOMPARE(back.size(), QSize(5, 3));
    QCOMPARE(worstDifference(image, back), 0);
  }

  void manyBecomeFew_data() {
    QTest::addColumn<int>("colours");
    QTest::addColumn<int>("tolerance");
    QTest::newRow("2") << 2 << 150;
    QTest::newRow("64") << 64 << 34;
    QTest::newRow("256") << 256 << 17;
  }
  void manyBecomeFew() {
    QFETCH(const int, colours);
    QFETCH(const int, tolerance);
    const render::Image image = ramps(128, 96);
    const QImage back = read(render::pngOfFewColours(image, colours));
    QSet<QRgb> all;
    for (int y = 0; y < back.height(); ++y)
      for (int x = 0; x < back.width(); ++x)
        all.insert(back.pixel(x, y));
    QCOMPARE(all.size(), qsizetype(colours));
    const int worst = worstDifference(image, back);
    QVERIFY2(worst <= tolerance, qPrintable(QString::number(worst)));
  }

  void oneColour() {
    const render::Image image{.width = 2, .height = 1, .rgba = {9, 8, 7, 255, 9, 8, 7, 255}};
    QCOMPARE(worstDifference(image, read(render::pngOfFewColours(image, 96))), 0);
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::FewColoursTest)
#include "few_colours_test.moc"
