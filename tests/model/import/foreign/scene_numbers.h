// SPDX-License-Identifier: Apache-2.0
// Writes the numbers of scenes, in text and in binary, and lists those of the kidney.
#pragma once

#include <QByteArray>
#include <cstring>
#include <vector>

#include "tests/model/import/foreign/written_scenes.h"

namespace sline::test {

inline QByteArray text(double value) {
  return QByteArray::number(value, 'g', 9);
}

template <class T>
QByteArray joined(const std::vector<T>& values, const char* between) {
  QByteArray line;
  for (const T& value : values)
    line += (line.isEmpty() ? "" : between) + text(double(value));
  return line;
}

inline std::vector<double> kidneyCoordinates() {
  std::vector<double> numbers;
  for (const glm::vec3& p : kidneyPositions())
    numbers.insert(numbers.end(), {double(p.x), double(p.y), double(p.z)});
  return numbers;
}

/// Returns the corners face by face; the last one of each face is passed through `last`.
template <class Last>
std::vector<int> kidneyCorners(const Last& last) {
  std::vector<int> corners;
  for (const model::Triangle& t : kidneyTriangles())
    corners.insert(corners.end(), {int(t[0]), int(t[1]), last(int(t[2]))});
  return corners;
}

template <class T>
void put(QByteArray& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace sline::test
