// SPDX-License-Identifier: Apache-2.0
// Reads the triangles of a file that is given as bytes.
#pragma once

#include <QByteArray>
#include <QString>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::test {

std::vector<model::Triangle> trianglesOf(const QString& extension, const QByteArray& bytes);

}  // namespace sline::test
