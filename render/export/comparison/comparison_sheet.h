// SPDX-License-Identifier: Apache-2.0
// Lays a comparison out as a figure: models as rows, techniques as columns, and below each picture
// its thresholds and measures. SVG, PDF and pictures show this same layout.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/export/comparison/comparison.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// The words of a sheet, so that the window can say them in the person's language.
struct ComparisonWords {
  std::string triangles = "%1 triangles";
  std::string time =
      "ms: median time to find and join the lines of a view, contours among them, once the surface "
      "is prepared.";
  std::string length =
      "mm⁻¹: length of the technique's visible lines, without contours, per area that the model "
      "covers, as drawn here.";
  std::string sizes =
      "F: radius of the model's bounding sphere; F_c: its median radius of curvature, at most F; "
      "H, κ1: mean curvature, the stronger principal curvature; f: light from the eye.";
  std::vector<std::string> techniques;  ///< their names by `model::Technique`; empty: English
  /// Translates what a threshold means; empty: English.
  std::function<std::string(const char* meaning)> meaning;
};

struct SheetCell {
  std::string id;    ///< "cell-1-2": row and column, from 1
  std::string name;  ///< "Liver, ConFIS"
  const VectorDrawing* drawing = nullptr;
  glm::vec2 at{0.0f};  ///< upper left corner, mm
};

struct ComparisonSheet {
  glm::vec2 sizeMm{0.0f};
  std::vector<SheetCell> cells;
  Lettering lettering;  ///< heads, captions and notes
};

/// Lays the comparison out, which must outlive the sheet. It needs a QGuiApplication.
ComparisonSheet comparisonSheet(const Comparison& comparison, const ComparisonWords& words = {});

}  // namespace sline::render
