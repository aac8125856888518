// SPDX-License-Identifier: Apache-2.0
// Says which sides of the body lie towards a picture's edges.
#pragma once

#include <array>
#include <string>

#include "model/camera/camera.h"
#include "model/scene/known_frame.h"

namespace sline::render {

/// The sides of the body towards the picture's left, right, upper and lower edge, as radiologists
/// mark them: "R" or, where a view is oblique, the nearest first: "RA".
struct EdgeLetters {
  std::string left;
  std::string right;
  std::string top;
  std::string bottom;
  bool operator==(const EdgeLetters&) const = default;
};
/// Returns them, each that is in doubt with a question mark: "R?A?".
EdgeLetters edgeLetters(const model::Camera& camera, const model::KnownSides& sides);

}  // namespace sline::render
