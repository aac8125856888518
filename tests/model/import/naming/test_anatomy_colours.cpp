// SPDX-License-Identifier: Apache-2.0
// Tests that the colours of the main systems stay apart for readers with and without colour
// blindness. Simulation: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A
// Physiologically-based Model for Simulation of Color Vision Deficiency" (TVCG 2009), severity 1.
// Difference: CIEDE2000 (G. Sharma, W. Wu, E. N. Dalal 2005), checked below against their published
// pairs.
#include <QtTest>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "model/anatomy/body_systems.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// Two colours this far apart are told apart at a glance, side by side or not.
constexpr double leastDifference = 15.0;

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Holds the rows of the matrices for linear RGB.
using Matrix = std::array<glm::dvec3, 3>;
constexpr double unit = 1.0;
const Matrix normalVision{glm::dvec3(unit, 0, 0), glm::dvec3(0, unit, 0), glm::dvec3(0, 0, unit)};
const Matrix protanopia{glm::dvec3(0.152286, 1.052583, -0.204868),
                        glm::dvec3(0.114503, 0.786281, 0.099216),
                        glm::dvec3(-0.003882, -0.048116, 1.051998)};
const Matrix deuteranopia{glm::dvec3(0.367322, 0.860646, -0.227968),
                          glm::dvec3(0.280085, 0.672501, 0.047413),
                          glm::dvec3(-0.011820, 0.042940, 0.968881)};

/// Returns CIE L*a*b*, D65.
glm::dvec3 lab(const Colour& colour, const Matrix& vision) {
  const glm::dvec3 rgb(linear(colour.red), linear(colour.green), linear(colour.blue));
  glm::dvec3 seen;
  for (int i = 0; i < 3; ++i)
    seen[i] = std::clamp(glm::dot(vision[std::size_t(i)], rgb), 0.0, 1.0);
  const double x = glm::dot(glm::dvec3(0.4124564, 0.3575761, 0.1804375), seen) / 0.95047;
  const double y = glm::dot(glm::dvec3(0.2126729, 0.7151522, 0.0721750), seen);
  const double z = glm::dot(glm::dvec3(0.0193339, 0.1191920, 0.9503041), seen) / 1.08883;
  const auto f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  return {116.0 * f(y) - 16.0, 500.0 * (f(x) - f(y)), 200.0 * (f(y) - f(z))};
}

double hueDegrees(double b, double a) {
  const double h = glm::degrees(std::atan2(b, a));
  return h < 0.0 ? h + 360.0 : h;
}

double ciede2000(const glm::dvec3& p, const glm::dvec3& q) {
  const double meanC7 = std::pow(0.5 * (std::hypot(p.y, p.z) + std::hypot(q.y, q.z)), 7.0);
  const double g = 0.5 * (1.0 - std::sqrt(meanC7 / (meanC7 + std::pow(25.0, 7.0))));
  const double a1 = (1.0 + g) * p.y;
  const double a2 = (1.0 + g) * q.y;
  const double c1 = std::hypot(a1, p.z);
  const double c2 = std::hypot(a2, q.z);
  const double h1 = hueDegrees(p.z, a1);
  const double h2 = hueDegrees(q.z, a2);
  const bool grey = c1 * c2 == 0.0;
  double dh = grey ? 0.0 : h2 - h1;
  dh += dh > 180.0 ? -360.0 : dh < -180.0 ? 360.0 : 0.0;
  double h = h1 + h2;
  if (!grey)
    h = std::abs(h1 - h2) <= 180.0 ? 0.5 * h : 0.5 * (h < 360.0 ? h + 360.0 : h - 360.0);
  const double dH = 2.0 * std::sqrt(c1 * c2) * std::sin(glm::radians(0.5 * dh));
  const double l = 0.5 * (p.x + q.x) - 50.0;
  const double c = 0.5 * (c1 + c2);
  const auto cosine = [](double degrees) { return std::cos(glm::radians(degrees)); };
  const double t = 1.0 - 0.17 * cosine(h - 30.0) + 0.24 * cosine(2.0 * h) +
                   0.32 * cosine(3.0 * h + 6.0) - 0.20 * cosine(4.0 * h - 63.0);
  const double c7 = std::pow(c, 7.0);
  const double turn = 60.0 * std::exp(-std::pow((h - 275.0) / 25.0, 2.0));
  const double rt =
      -2.0 * std::sqrt(c7 / (c7 + std::pow(25.0, 7.0))) * std::sin(glm::radians(turn));
  const double x = (q.x - p.x) / (1.0 + 0.015 * l * l / std::sqrt(20.0 + l * l));
  const double y = (c2 - c1) / (1.0 + 0.045 * c);
  const double z = dH / (1.0 + 0.015 * c * t);
  return std::sqrt(x * x + y * y + z * z + rt * y * z);
}

}  // namespace

class AnatomyColoursTest : public QObject {
  Q_OBJECT
 private slots:
  void formula();
  void apart_data();
  void apart();
};

void AnatomyColoursTest::formula() {
  // Sharma et al., table 1, pairs 1, 7, 17 and 25.
  QVERIFY(std::abs(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}) - 2.0425) < 1e-4);
  QVERIFY(std::abs(ciede2000({50, 0, 0}, {50, -1, 2}) - 2.3669) < 1e-4);
  QVERIFY(std::abs(ciede2000({50, 2.5, 0}, {73, 25, -18}) - 27.1492) < 1e-4);
  QVERIFY(std::abs(ciede2000({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}) - 1.2644) <
          1e-4);
}

void AnatomyColoursTest::apart_data() {
  QTest::addColumn<int>("vision");
  QTest::newRow("normal") << 0;
  QTest::newRow("protanopia") << 1;
  QTest::newRow("deuteranopia") << 2;
}

void AnatomyColoursTest::apart() {
  QFETCH(int, vision);
  const Matrix& matrix = vision == 0 ? normalVision : vision == 1 ? protanopia : deuteranopia;
  const AnatomyTable table;
  const std::array ids{"artery", "vein", "nerve", "bone", "muscle", "portal", "urinary", "bile"};
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double difference = ciede2000(lab(table.system(ids[i])->colour, matrix),
                                          lab(table.system(ids[j])->colour, matrix));
      QVERIFY2(difference >= leastDifference,
               qPrintable(QString("%1 and %2: %3").arg(ids[i], ids[j]).arg(difference)));
    }
}

SLINE_TEST(AnatomyColoursTest)
#include "test_anatomy_colours.moc"
