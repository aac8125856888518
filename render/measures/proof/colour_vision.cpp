// SPDX-License-Identifier: Apache-2.0
#include "render/measures/proof/colour_vision.h"

#include <lcms2.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/base/parallel.h"
#include "model/base/srgb.h"

namespace sline::render {

namespace {

/// Returns a matrix by its rows, as printed in the paper's table for severity 1.
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
constexpr cmsCIEXYZ white{0.95047, 1.0, 1.08883};

cmsCIELab asLab(const glm::dvec3& lab) {
  return {lab.x, lab.y, lab.z};
}

}  // namespace

const char* nameOf(Vision vision) {
  static constexpr std::array<const char*, visionCount> names{"normal", "grey", "protanopia",
                                                              "deuteranopia", "tritanopia"};
  return names[std::size_t(vision)];
}

glm::vec3 linearLightOf(const Colour& colour) {
  return {lightFromSrgb(float(colour.red) / 255.0f), lightFromSrgb(float(colour.green) / 255.0f),
          lightFromSrgb(float(colour.blue) / 255.0f)};
}

Colour colourOf(const glm::vec3& light) {
  const auto channel = [](float value) {
    return std::uint8_t(std::lround(255.0f * srgbFromLight(glm::clamp(value, 0.0f, 1.0f))));
  };
  return {channel(light.r), channel(light.g), channel(light.b)};
}

glm::vec3 simulateVision(const glm::vec3& light, Vision vision) {
  return glm::clamp(matrixOf(vision) * light, 0.0f, 1.0f);
}

Image simulateVision(const Image& image, Vision vision) {
  Image result = image;
  if (vision == Vision::normal)
    return result;
  parallelFor(std::size_t(image.width) * std::size_t(image.height), 4096, [&](std::size_t i) {
    std::uint8_t* p = result.rgba.data() + 4 * i;
    const Colour colour = colourOf(simulateVision(linearLightOf({p[0], p[1], p[2]}), vision));
    p[0] = colour.red;
    p[1] = colour.green;
    p[2] = colour.blue;
  });
  return result;
}

glm::dvec3 labOf(const glm::vec3& light) {
  const glm::dvec3 xyz = toXyz() * glm::dvec3(light);
  const cmsCIEXYZ colour{xyz.x, xyz.y, xyz.z};
  cmsCIELab lab{};
  cmsXYZ2Lab(&white, &lab, &colour);
  return {lab.L, lab.a, lab.b};
}

glm::vec3 lightOf(const glm::dvec3& lab) {
  const cmsCIELab colour = asLab(lab);
  cmsCIEXYZ xyz{};
  cmsLab2XYZ(&white, &xyz, &colour);
  return glm::vec3(glm::inverse(toXyz()) * glm::dvec3(xyz.X, xyz.Y, xyz.Z));
}

double colourDifference(const glm::dvec3& lab, const glm::dvec3& other) {
  const cmsCIELab a = asLab(lab);
  const cmsCIELab b = asLab(other);
  return cmsCIE2000DeltaE(&a, &b, 1.0, 1.0, 1.0);
}

}  // namespace sline::render
