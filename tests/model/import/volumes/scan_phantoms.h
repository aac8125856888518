// SPDX-License-Identifier: Apache-2.0
// Makes scans of a ball and of a body for the tests, and writes them.
#pragma once

#include <QByteArray>
#include <QTemporaryDir>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "model/import/plan/import.h"
#include "tests/model/import/volumes/written_volumes.h"

namespace sline::test {

inline constexpr glm::dvec3 ballCentre{12.0, 3.0, -2.0};

inline constexpr double ballRadius = 11.3;

/// Returns a ball to the left, as dense as bone in soft tissue: its edge is as soft as a scanner
/// makes it.
int ballAt(const glm::dvec3& p);

glm::dmat4 gridOf(double side, const glm::ivec3& size);

WrittenVolume ball();

/// Returns a body of fat and muscle around a lung, a bone in it, specks of bone, on a table apart
/// from it.
int bodyAt(const glm::dvec3& p);

WrittenVolume body();

std::filesystem::path written(const QTemporaryDir& folder, const char* name,
                              const QByteArray& bytes);

model::ImportOptions with(std::vector<model::Threshold> thresholds);

}  // namespace sline::test
