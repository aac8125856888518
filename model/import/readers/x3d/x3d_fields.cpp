// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/x3d/x3d_fields.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

glm::dmat4 rotationOf(const std::array<double, 4>& r) {
  const glm::dvec3 axis(r[0], r[1], r[2]);
  return glm::length(axis) > 0.0 ? glm::rotate(glm::dmat4(1.0), r[3], glm::normalize(axis))
                                 : glm::dmat4(1.0);
}

}  // namespace

std::vector<double> numbersIn(std::string_view field) {
  std::string plain(field);
  bool comment = false;
  for (char& c : plain) {
    comment = (comment || c == '#') && !TextCursor::isLineEnd(c);
    if (comment || c == ',')
      c = ' ';
  }
  std::vector<double> numbers;
  TextCursor cursor(plain);
  for (double value = 0.0; cursor.skipSpace(), cursor.number(value);)
    numbers.push_back(value);
  return numbers;
}

glm::dmat4 transformOf(const X3dNode& node) {
  const auto vector = [&](std::string_view key, double otherwise) {
    const auto v = fixedNumbers<3>(node, key, {otherwise, otherwise, otherwise});
    return glm::dvec3(v[0], v[1], v[2]);
  };
  const glm::dvec3 centre = vector("center", 0.0);
  const glm::dmat4 turned = rotationOf(fixedNumbers<4>(node, "scaleOrientation", {0, 0, 1, 0}));
  glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), vector("translation", 0.0) + centre);
  matrix *= rotationOf(fixedNumbers<4>(node, "rotation", {0, 0, 1, 0})) * turned;
  matrix = glm::scale(matrix, vector("scale", 1.0)) * glm::transpose(turned);
  return glm::translate(matrix, -centre);
}

}  // namespace sline::model
