// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/slicer/slicer_folder.h"

#include <glm/geometric.hpp>

namespace sline::test {

QByteArray fiducial(const char* visible) {
  return QByteArray(
             "<AnnotationFiducials id=\"F\" name=\"tip\" ctrlPtsCoord=\"10 -20 30\" "
             "locked=\"1\" displayNodeRef=\"DF DT\" visible=\"") +
         visible +
         "\"/><AnnotationPointDisplay id=\"DF\" color=\"0 1 0\" selectedColor=\"1 1 0\"/>";
}

bool near(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(a - b) < 1e-4f;
}

}  // namespace sline::test
