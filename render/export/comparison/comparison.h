// SPDX-License-Identifier: Apache-2.0
// Compares the techniques that draw lines: each model by each technique from one camera, and what
// each picture takes and draws.
#pragma once

#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/comparison/noisy_mesh.h"
#include "render/export/order/export_order.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// What a row shows. Its visible structures are drawn, whole and each as the technique has it.
struct ComparedModel {
  std::string name;
  std::string note;  ///< below the name; may be empty
  model::Scene scene;
  model::Camera camera;
};

struct ComparisonOrder {
  std::vector<ComparedModel> models;
  std::vector<model::Technique> techniques;
  model::ThresholdValues thresholds;
  float cellMm = 42.0f;  ///< either side of a picture
  int timings = 5;       ///< how often each frame is timed
};
inline constexpr Limits<float> cellLimitsMm{15.0f, 300.0f};

struct ComparedCell {
  VectorDrawing drawing;  ///< lines alone
  /// The median of the time in which a view's lines were found and joined, contours among them,
  /// milliseconds; what all views of a surface share was computed before.
  double frameMs = 0.0;
  /// The length of the technique's own lines, without contours, as far as nothing hides them, per
  /// area that the model covers, both as they are drawn: 1/mm.
  double linesPerMm = 0.0;
};

struct Comparison {
  ComparisonOrder order;
  std::vector<std::vector<ComparedCell>> rows;  ///< of each model, by technique
};

/// Returns the same model with a rough surface, as the next row shows it.
ComparedModel roughened(const ComparedModel& model, const Noise& noise);

/// Returns the row's scene as the technique draws it: at the Γ at which all of its lines have
/// entered, on paper that hides what is behind, with a pen of 0.18 mm in a picture that high.
model::Scene comparedScene(const model::Scene& scene, model::Technique technique,
                           const model::ThresholdValues& thresholds, float cellMm);

/// Draws and measures everything. The error names the model whose camera cannot be.
Result<Comparison> compareTechniques(const ComparisonOrder& order, const ExportProgress& progress);

}  // namespace sline::render
