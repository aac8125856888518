// SPDX-License-Identifier: Apache-2.0
// Gathers whose work the surfaces of a picture are.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace sline::render {

/// What is said of so many structures: "BodyParts3D, DBCLS, CC BY 4.0". It names none of them.
struct SourceLine {
  std::string text;
  std::size_t structures = 0;
};

/// Returns what visible structures say of whose work they are, each line once, that of most
/// structures first.
std::vector<SourceLine> sourceLines(const model::Scene& scene);
/// Returns all of them in one line, parted by semicolons.
std::string sourcesInOne(const model::Scene& scene);

}  // namespace sline::render
