// SPDX-License-Identifier: Apache-2.0
#include "model/import/foreign/assimp_convention.h"

#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>

namespace sline::model {

namespace {

/// Returns a whole number among the metadata, else `otherwise`.
int metadata(const aiScene& scene, const char* key, int otherwise) {
  std::int32_t value = otherwise;
  return scene.mMetaData && scene.mMetaData->Get(key, value) ? int(value) : otherwise;
}

/// Returns a real number among the metadata, which assimp keeps as float or double.
double metadata(const aiScene& scene, const char* key, double otherwise) {
  float single = 0.0f;
  double real = otherwise;
  if (scene.mMetaData && scene.mMetaData->Get(key, single))
    return double(single);
  return scene.mMetaData && scene.mMetaData->Get(key, real) ? real : otherwise;
}

/// Returns a unit vector along an axis of the file, or nothing where the numbers name none.
std::optional<glm::dvec3> axisIn(const aiScene& scene, const std::string& key, int otherwise) {
  const int axis = metadata(scene, key.c_str(), otherwise);
  const int sign = metadata(scene, (key + "Sign").c_str(), 1);
  if (axis < 0 || axis > 2 || (sign != 1 && sign != -1))
    return std::nullopt;
  glm::dvec3 along(0.0);
  along[axis] = sign;
  return along;
}

/// Writes the number with as few digits as determine it.
std::string numberText(double value) {
  std::array<char, 32> text{};
  const auto [end, code] = std::to_chars(text.data(), text.data() + text.size(), float(value),
                                         std::chars_format::general);
  return {text.data(), end};
}

AssimpConvention inLengths(double millimetres, const std::string& reason) {
  AssimpConvention convention;
  if (std::isfinite(millimetres) && millimetres > 0.0 && millimetres < 1e12) {
    convention.millimetresPerUnit = float(millimetres);
    convention.unitReason = reason + numberText(millimetres) + " mm";
  }
  return convention;
}

}  // namespace

glm::dmat4 matrixOf(const aiMatrix4x4& m) {
  return {glm::dvec4(m.a1, m.b1, m.c1, m.d1), glm::dvec4(m.a2, m.b2, m.c2, m.d2),
          glm::dvec4(m.a3, m.b3, m.c3, m.d3), glm::dvec4(m.a4, m.b4, m.c4, m.d4)};
}

AssimpConvention fbxConvention(const aiScene& scene) {
  AssimpConvention convention =
      inLengths(10.0 * metadata(scene, "UnitScaleFactor", 1.0), "FBX: a unit is ");
  const auto right = axisIn(scene, "CoordAxis", 0);
  const auto up = axisIn(scene, "UpAxis", 1);
  const auto front = axisIn(scene, "FrontAxis", 2);
  const bool told =
      right && up && front && std::abs(glm::determinant(glm::dmat3(*right, *up, *front))) == 1.0;
  const glm::dvec3 x(1.0, 0.0, 0.0);
  const glm::dvec3 y(0.0, 1.0, 0.0);
  const glm::dvec3 z(0.0, 0.0, 1.0);
  convention.yUp = !told || (*right == x && *up == y && *front == z);
  if (!convention.yUp && !(*right == x && *up == z && *front == -y))
    convention.below = glm::dmat4(glm::transpose(glm::dmat3(*right, -*front, *up)));
  return convention;
}

AssimpConvention colladaConvention(const aiScene& scene) {
  const glm::dmat4 root = matrixOf(scene.mRootNode->mTransformation);
  const double metres = glm::length(glm::dvec3(root[0]));
  AssimpConvention convention = inLengths(1000.0 * metres, "COLLADA: a unit is ");
  if (!(metres > 0.0) || !std::isfinite(metres))
    return convention;
  // The columns say where the file's axes have gone: axes of a file with y up have stayed, z up has
  // become y up.
  const auto goesUp = [&](int axis) { return root[axis].y > 0.5 * metres; };
  convention.yUp = !goesUp(2);
  if (goesUp(0))
    convention.below = glm::dmat4(glm::dmat3(root) / metres);
  return convention;
}

AssimpConvention blendConvention(const aiScene& scene) {
  AssimpConvention convention;
  convention.below = matrixOf(scene.mRootNode->mTransformation);
  convention.light = true;
  return convention;
}

}  // namespace sline::model
