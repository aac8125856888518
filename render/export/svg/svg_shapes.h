// SPDX-License-Identifier: Apache-2.0
// Writes what every SVG document of ours begins with, and shapes.
#pragma once

#include <string>

#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Returns the start of a document that is so many millimetres wide and high, with further
/// attributes of its element.
std::string svgStart(const std::string& width, const std::string& height,
                     const std::string& more = {});

struct SvgPrecision {
  int decimals = 3;
  bool regions = false;  ///< regions have holes
};

/// Appends the shape as a path; nothing where it is too small for those decimals.
void appendShape(std::string& text, const VectorShape& shape, const SvgPrecision& precision);

}  // namespace sline::render
