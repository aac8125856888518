// SPDX-License-Identifier: Apache-2.0
#include "render/measures/proof/colour_vision.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/export/encoding/colour_profile.h"
#include "tests/support/suite.h"

namespace sline::render {
namespace {

double differenceOf(const Colour& a, const Colour& b, Vision vision) {
  return colourDifference(labOf(simulateVision(linearLightOf(a), vision)),
                          labOf(simulateVision(linearLightOf(b), vision)));
}

}  // namespace

class ColourVisionTest : public QObject {
  Q_OBJECT

 private slots:
  void publishedDifferences_data();
  void publishedDifferences();
  void asBefore_data();
  void asBefore();
  void profiles();
  void labGoesThereAndBack();
  void greyStaysGrey();
  void whatEachEyeLoses_data();
  void whatEachEyeLoses();
  void pictures();
};

void ColourVisionTest::publishedDifferences_data() {
  QTest::addColumn<double>("l1");
  QTest::addColumn<double>("a1");
  QTest::addColumn<double>("b1");
  QTest::addColumn<double>("l2");
  QTest::addColumn<double>("a2");
  QTest::addColumn<double>("b2");
  QTest::addColumn<double>("expected");
  // These are from table 1 of Sharma, Wu, Dalal 2005, the rows where programs go wrong.
  QTest::newRow("1") << 50.0 << 2.6772 << -79.7751 << 50.0 << 0.0 << -82.7485 << 2.0425;
  QTest::newRow("4") << 50.0 << -1.3802 << -84.2814 << 50.0 << 0.0 << -82.7485 << 1.0000;
  QTest::newRow("7") << 50.0 << 0.0 << 0.0 << 50.0 << -1.0 << 2.0 << 2.3669;
  QTest::newRow("9") << 50.0 << 2.49 << -0.001 << 50.0 << -2.49 << 0.0009 << 7.1792;
  QTest::newRow("11") << 50.0 << 2.49 << -0.001 << 50.0 << -2.49 << 0.0011 << 7.2195;
  QTest::newRow("17") << 50.0 << 2.5 << 0.0 << 73.0 << 25.0 << -18.0 << 27.1492;
  QTest::newRow("20") << 50.0 << 2.5 << 0.0 << 58.0 << 24.0 << 15.0 << 19.4535;
  QTest::newRow("25") << 60.2574 << -34.0099 << 36.2677 << 60.4626 << -34.1751 << 39.4387 << 1.2644;
  QTest::newRow("29") << 22.7233 << 20.0904 << -46.6940 << 23.0331 << 14.9730 << -42.5619 << 2.0373;
  QTest::newRow("34") << 2.0776 << 0.0795 << -1.1350 << 0.9033 << -0.0636 << -0.5514 << 0.9082;
}

void ColourVisionTest::publishedDifferences() {
  QFETCH(double, l1);
  QFETCH(double, a1);
  QFETCH(double, b1);
  QFETCH(double, l2);
  QFETCH(double, a2);
  QFETCH(double, b2);
  QFETCH(double, expected);
  const double found = colourDifference({l1, a1, b1}, {l2, a2, b2});
  QVERIFY2(std::abs(found - expected) < 5e-5, qPrintable(QString::number(found, 'f', 5)));
  QVERIFY(std::abs(found - colourDifference({l2, a2, b2}, {l1, a1, b1})) < 1e-9);
}

void ColourVisionTest::asBefore_data() {
  QTest::addColumn<QList<int>>("a");
  QTest::addColumn<QList<int>>("b");
  QTest::addColumn<double>("expected");
  const auto row = [](const QList<int>& a, const QList<int>& b, double expected) {
    QTest::addRow("%d %d %d, %d %d %d", a[0], a[1], a[2], b[0], b[1], b[2]) << a << b << expected;
  };
  row({200, 30, 30}, {30, 160, 60}, 71.703806);
  row({0, 0, 0}, {255, 255, 255}, 100.000004);
  row({255, 255, 255}, {250, 250, 244}, 3.231605);
  row({3, 2, 1}, {10, 8, 9}, 1.444208);
  row({60, 120, 200}, {74, 128, 158}, 8.773749);
  row({128, 128, 128}, {128, 128, 130}, 1.204548);
  row({255, 0, 255}, {0, 255, 0}, 111.414331);
  row({20, 40, 250}, {90, 10, 240}, 4.808757);
  row({0, 0, 255}, {10, 0, 245}, 1.195431);
  row({128, 128, 128}, {200, 40, 40}, 29.325576);
}

/// The values are those written here by the formulas before Little CMS was used.
void ColourVisionTest::asBefore() {
  QFETCH(QList<int>, a);
  QFETCH(QList<int>, b);
  QFETCH(double, expected);
  const auto colour = [](const QList<int>& c) {
    return Colour{std::uint8_t(c[0]), std::uint8_t(c[1]), std::uint8_t(c[2])};
  };
  const double found = differenceOf(colour(a), colour(b), Vision::normal);
  QVERIFY2(std::abs(found - expected) < 1e-4, qPrintable(QString::number(found, 'f', 6)));
}

/// The numbers in the profiles are those of IEC 61966-2-1 under D50, and there is no time of day in
/// them.
void ColourVisionTest::profiles() {
  const std::string srgb = srgbProfile();
  const auto number = [](const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | std::uint8_t(bytes[at + i]);
    return value;
  };
  for (const auto& [tag, expected] : {std::pair("rXYZ", glm::dvec3(0.43607, 0.22249, 0.01392)),
                                      std::pair("gXYZ", glm::dvec3(0.38515, 0.71687, 0.09708)),
                                      std::pair("bXYZ", glm::dvec3(0.14307, 0.06061, 0.71410))}) {
    const std::size_t entry = srgb.find(tag, 128);
    QVERIFY(entry != std::string::npos);
    const std::size_t at = number(srgb, entry + 4) + 8;
    for (int i = 0; i < 3; ++i) {
      const double found = double(std::int32_t(number(srgb, at + 4 * std::size_t(i)))) / 65536.0;
      QVERIFY2(std::abs(found - expected[i]) < 2e-4, qPrintable(QString::number(found)));
    }
  }
  for (const std::string& profile : {srgb, greyProfile()}) {
    QCOMPARE(number(profile, 0), std::uint32_t(profile.size()));
    QCOMPARE(number(profile, 8) >> 16, 0x0210u);
    QCOMPARE(profile.substr(24, 12), std::string("\x07\xD0\0\x01\0\x01\0\0\0\0\0\0", 12));
  }
  QVERIFY(srgb.find("RGB XYZ ") == 16 && greyProfile().find("GRAYXYZ ") == 16);
}

void ColourVisionTest::labGoesThereAndBack() {
  QVERIFY(glm::distance(labOf(glm::vec3(1.0f)), glm::dvec3(100.0, 0.0, 0.0)) < 0.02);
  QVERIFY(glm::distance(labOf(glm::vec3(0.0f)), glm::dvec3(0.0)) < 1e-9);
  for (const Colour colour : {Colour{200, 30, 30}, Colour{3, 2, 1}, Colour{90, 180, 250}})
    QCOMPARE(colourOf(lightOf(labOf(linearLightOf(colour)))), colour);
}

void ColourVisionTest::greyStaysGrey() {
  for (const int value : {0, 40, 128, 200, 255}) {
    const auto byte = std::uint8_t(value);
    const Colour grey{byte, byte, byte};
    for (const Vision vision : visions) {
      const Colour found = colourOf(simulateVision(linearLightOf(grey), vision));
      QVERIFY(std::abs(found.red - value) <= 1 && std::abs(found.green - value) <= 1 &&
              std::abs(found.blue - value) <= 1);
    }
  }
}

void ColourVisionTest::whatEachEyeLoses_data() {
  QTest::addColumn<int>("vision");
  QTest::addColumn<QList<int>>("a");
  QTest::addColumn<QList<int>>("b");
  QTest::newRow("red and green") << int(Vision::deuteranopia) << QList<int>{190, 70, 60}
                                 << QList<int>{72, 136, 48};
  QTest::newRow("red and green again")
      << int(Vision::protanopia) << QList<int>{190, 70, 60} << QList<int>{92, 98, 62};
  QTest::newRow("blue and green") << int(Vision::tritanopia) << QList<int>{60, 120, 200}
                                  << QList<int>{74, 128, 158};
  QTest::newRow("equally light") << int(Vision::grey) << QList<int>{200, 80, 80}
                                 << QList<int>{92, 128, 98};
}

void ColourVisionTest::whatEachEyeLoses() {
  QFETCH(int, vision);
  QFETCH(QList<int>, a);
  QFETCH(QList<int>, b);
  const auto colour = [](const QList<int>& c) {
    return Colour{std::uint8_t(c[0]), std::uint8_t(c[1]), std::uint8_t(c[2])};
  };
  const double normal = differenceOf(colour(a), colour(b), Vision::normal);
  const double left = differenceOf(colour(a), colour(b), Vision(vision));
  QVERIFY2(normal > 8.0 && left < 10.0 && left < 0.5 * normal,
           qPrintable(QString("%1, left %2").arg(normal).arg(left)));
}

void ColourVisionTest::pictures() {
  const Image image{2, 1, {255, 0, 0, 255, 10, 200, 30, 77}};
  QCOMPARE(simulateVision(image, Vision::normal), image);
  const Image grey = simulateVision(image, Vision::grey);
  for (std::size_t i = 0; i < 8; i += 4) {
    QCOMPARE(grey.rgba[i], grey.rgba[i + 1]);
    QCOMPARE(grey.rgba[i], grey.rgba[i + 2]);
    QCOMPARE(grey.rgba[i + 3], image.rgba[i + 3]);
  }
  // Luminance 0.2126 is 127 in sRGB.
  QVERIFY(std::abs(grey.rgba[0] - 127) <= 1);
}

}  // namespace sline::render

SLINE_TEST(sline::render::ColourVisionTest)
#include "colour_vision_test.moc"
