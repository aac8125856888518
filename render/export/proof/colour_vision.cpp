// SPDX-License-Identifier: Apache-2.0
#include "render/export/proof/colour_vision.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "model/base/parallel.h"
#include "render/export/pixels/colour_profile.h"

namespace sline::render {

namespace {

/// Rows as printed in the paper's table for severity 1.
glm::mat3 rows(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return glm::transpose(glm::mat3(a, b, c));
}

const glm::mat3& matrixOf(Vision vision) {
  static const glm::mat3 protanopia =
      rows({0.152286f, 1.052583f, -0.204868f}, {0.114503f, 0.786281f, 0.099216f},
           {-0.003882f, -0.048116f, 1.051998f});
  static const glm::mat3 deuteranopia =
      rows({0.367322f, 0.860646f, -0.227968f}, {0.280085f, 0.672501f, 0.047413f},
           {-0.011820f, 0.042940f, 0.968881f});
  static const glm::mat3 tritanopia =
      rows({1.255528f, -0.076749f, -0.178779f}, {-0.078411f, 0.930809f, 0.147602f},
           {0.004733f, 0.691367f, 0.303900f});
  static const glm::mat3 grey =
      rows(glm::vec3(0.2126f, 0.7152f, 0.0722f), glm::vec3(0.2126f, 0.7152f, 0.0722f),
           glm::vec3(0.2126f, 0.7152f, 0.0722f));
  static const glm::mat3 normal(1.0f);
  switch (vision) {
    case Vision::grey:
      return grey;
    case Vision::protanopia:
      return protanopia;
    case Vision::deuteranopia:
      return deuteranopia;
    case Vision::tritanopia:
      return tritanopia;
    case Vision::normal:
      break;
  }
  return normal;
}

// IEC 61966-2-1, and its white.
const glm::dmat3& toXyz() {
  static const glm::dmat3 matrix = glm::transpose(glm::dmat3(
      glm::dvec3(0.4124564, 0.3575761, 0.1804375), glm::dvec3(0.2126729, 0.7151522, 0.0721750),
      glm::dvec3(0.0193339, 0.1191920, 0.9503041)));
  return matrix;
}
constexpr glm::dvec3 white(0.95047, 1.0, 1.08883);
constexpr double darkEnd = 216.0 / 24389.0;
constexpr double darkSlope = 24389.0 / 27.0;

double degrees(double radians) {
  const double angle = radians * 180.0 / std::numbers::pi;
  return angle < 0.0 ? angle + 360.0 : angle;
}
double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}
double pow7(double value) {
  return std::pow(value, 7.0);
}

/// A colour as CIEDE2000 takes it: lightness, chroma, hue in degrees.
struct Hued {
  double lightness;
  double chroma;
  double hue;
};

Hued hued(const glm::dvec3& lab, double redder) {
  const double a = (1.0 + redder) * lab.y;
  const double chroma = std::hypot(a, lab.z);
  return {lab.x, chroma, chroma == 0.0 ? 0.0 : degrees(std::atan2(lab.z, a))};
}

double hueStep(const Hued& a, const Hued& b) {
  if (a.chroma * b.chroma == 0.0)
    return 0.0;
  const double step = b.hue - a.hue;
  return step > 180.0 ? step - 360.0 : step < -180.0 ? step + 360.0 : step;
}

double meanHue(const Hued& a, const Hued& b) {
  const double sum = a.hue + b.hue;
  if (a.chroma * b.chroma == 0.0)
    return sum;
  if (std::abs(a.hue - b.hue) <= 180.0)
    return 0.5 * sum;
  return sum < 360.0 ? 0.5 * (sum + 360.0) : 0.5 * (sum - 360.0);
}

}  // namespace

const char* nameOf(Vision vision) {
  static constexpr std::array<const char*, visionCount> names{"normal", "grey", "protanopia",
                                                              "deuteranopia", "tritanopia"};
  return names[std::size_t(vision)];
}

glm::vec3 linearLightOf(const Colour& colour) {
  return {toLinearLight(float(colour.red) / 255.0f), toLinearLight(float(colour.green) / 255.0f),
          toLinearLight(float(colour.blue) / 255.0f)};
}

Colour colourOf(const glm::vec3& light) {
  const auto channel = [](float value) {
    return std::uint8_t(std::lround(255.0f * fromLinearLight(glm::clamp(value, 0.0f, 1.0f))));
  };
  return {channel(light.r), channel(light.g), channel(light.b)};
}

glm::vec3 seen(const glm::vec3& light, Vision vision) {
  return glm::clamp(matrixOf(vision) * light, 0.0f, 1.0f);
}

Image seen(const Image& image, Vision vision) {
  Image result = image;
  if (vision == Vision::normal)
    return result;
  parallelFor(std::size_t(image.width) * std::size_t(image.height), 4096, [&](std::size_t i) {
    std::uint8_t* p = result.rgba.data() + 4 * i;
    const Colour colour = colourOf(seen(linearLightOf({p[0], p[1], p[2]}), vision));
    p[0] = colour.red;
    p[1] = colour.green;
    p[2] = colour.blue;
  });
  return result;
}

glm::dvec3 labOf(const glm::vec3& light) {
  const auto f = [](double t) {
    return t > darkEnd ? std::cbrt(t) : (darkSlope * t + 16.0) / 116.0;
  };
  const glm::dvec3 xyz = toXyz() * glm::dvec3(light) / white;
  const double y = f(xyz.y);
  return {116.0 * y - 16.0, 500.0 * (f(xyz.x) - y), 200.0 * (y - f(xyz.z))};
}

glm::vec3 lightOf(const glm::dvec3& lab) {
  const auto inverse = [](double f) {
    const double cube = f * f * f;
    return cube > darkEnd ? cube : (116.0 * f - 16.0) / darkSlope;
  };
  const double y = (lab.x + 16.0) / 116.0;
  const glm::dvec3 xyz(inverse(y + lab.y / 500.0), inverse(y), inverse(y - lab.z / 200.0));
  return glm::vec3(glm::inverse(toXyz()) * (xyz * white));
}

double colourDifference(const glm::dvec3& lab, const glm::dvec3& other) {
  const double meanChroma = 0.5 * (std::hypot(lab.y, lab.z) + std::hypot(other.y, other.z));
  const double far = pow7(25.0);
  const double redder = 0.5 * (1.0 - std::sqrt(pow7(meanChroma) / (pow7(meanChroma) + far)));
  const Hued a = hued(lab, redder);
  const Hued b = hued(other, redder);
  const double lightness = b.lightness - a.lightness;
  const double chroma = b.chroma - a.chroma;
  const double hue = 2.0 * std::sqrt(a.chroma * b.chroma) * std::sin(radians(0.5 * hueStep(a, b)));
  const double midLightness = 0.5 * (a.lightness + b.lightness) - 50.0;
  const double midChroma = 0.5 * (a.chroma + b.chroma);
  const double mid = meanHue(a, b);
  const double t = 1.0 - 0.17 * std::cos(radians(mid - 30.0)) +
                   0.24 * std::cos(radians(2.0 * mid)) + 0.32 * std::cos(radians(3.0 * mid + 6.0)) -
                   0.20 * std::cos(radians(4.0 * mid - 63.0));
  const double bend = 30.0 * std::exp(-std::pow((mid - 275.0) / 25.0, 2.0));
  const double turn =
      -std::sin(radians(2.0 * bend)) * 2.0 * std::sqrt(pow7(midChroma) / (pow7(midChroma) + far));
  const double l = lightness / (1.0 + 0.015 * midLightness * midLightness /
                                          std::sqrt(20.0 + midLightness * midLightness));
  const double c = chroma / (1.0 + 0.045 * midChroma);
  const double h = hue / (1.0 + 0.015 * midChroma * t);
  return std::sqrt(std::max(l * l + c * c + h * h + turn * c * h, 0.0));
}

}  // namespace sline::render
