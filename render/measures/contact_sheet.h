// SPDX-License-Identifier: Apache-2.0
// Draws measures for the eye: pictures of a ramp side by side, and its figures as a diagram.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/measures/ramp.h"
#include "render/raster/image.h"

namespace sline::render {

struct SheetPicture {
  std::string label;  ///< digits, '.', '-' and spaces; other characters stay blank
  Image image;
};

/// Returns the pictures in rows of `columns`, each with its label below, on white. All must be of
/// one size.
Image contactSheet(std::span<const SheetPicture> pictures, int columns);

/// Draws, above, a bar for each step's change as a multiple of its stage's mean, red where it
/// breaks a limit and pale where its stage is exempt, with lines at the mean and at the limit for
/// jumps; below, the mean luminance from 0 to 1 with a line at that of Γ = 5.
Image rampDiagram(const Ramp& ramp, int width, int height);

/// Returns an image with `below` under `above`, left edges aligned, on white.
Image stacked(const Image& above, const Image& below);

}  // namespace sline::render
