// SPDX-License-Identifier: Apache-2.0
// Makes a small labelled body for the tests, and imports volumes that are given as bytes.
#pragma once

#include <QByteArray>
#include <QString>
#include <QTemporaryDir>
#include <glm/vec3.hpp>

#include "model/import/plan/import.h"
#include "tests/model/import/volumes/written_volumes.h"

namespace sline::test {

/// Returns a body with different things at left, in front and at the head, so that no turn or
/// reflection leaves it as it is, in LPS millimetres.
int labelledBodyAt(const glm::dvec3& p);

/// Returns a smaller body for rows in which only the numbers matter.
const WrittenVolume& smallBody();

Result<model::Imported> importBytes(const QTemporaryDir& folder, const QString& name,
                                    const QByteArray& bytes,
                                    model::Smoothing::Mode mode = model::Smoothing::Mode::off);

}  // namespace sline::test
