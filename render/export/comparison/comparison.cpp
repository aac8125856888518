// SPDX-License-Identifier: Apache-2.0
#include "render/export/comparison/comparison.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>

#include "model/scene/resolved_styles.h"
#include "render/lines/techniques/technique_list.h"
#include "render/measures/ink_frames.h"

namespace sline::render {

namespace {

constexpr float penMm = 0.18f;
/// Pixels of the picture in which lines are found and measured: one to λ.
constexpr int cellPixels = 720;

double medianFrameMs(InkFrames& frames, const model::Camera& camera, int times) {
  std::vector<double> all;
  const auto nothing = [](const auto&...) {};
  frames.forEachCurve(camera, nothing);  // prepares
  for (int i = 0; i < std::max(times, 1); ++i) {
    const auto start = std::chrono::steady_clock::now();
    frames.forEachCurve(camera, nothing);
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    all.push_back(passed.count());
  }
  const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

double lengthOf(const InkFrame& frame, LineKinds kinds) {
  double length = 0.0;
  for (const StructureInk& ink : frame.structures)
    for (const InkLine& line : ink.lines)
      if (kinds.has(line.kind))
        for (std::size_t i = 1; i < line.points.size(); ++i)
          length += double(glm::distance(line.points[i - 1].at, line.points[i].at));
  return length;
}

/// Returns how many pixels of the picture the structures cover.
double areaOf(const InkFrame& frame) {
  std::vector<bool> covered(std::size_t(cellPixels) * cellPixels);
  for (const DepthLayer& layer : frame.layers)
    for (int y = std::max(layer.area.y, 0); y < std::min(layer.area.top(), cellPixels); ++y)
      for (int x = std::max(layer.area.x, 0); x < std::min(layer.area.right(), cellPixels); ++x)
        if (layer.depths[std::size_t(layer.index(x, y))] < 1.0f)
          covered[std::size_t(y) * cellPixels + std::size_t(x)] = true;
  return double(std::count(covered.begin(), covered.end(), true));
}

Result<ComparedCell> compare(const ComparedModel& model, model::Technique technique,
                             const ComparisonOrder& order) {
  const model::Scene scene = comparedScene(model.scene, technique, order.thresholds, order.cellMm);
  Result<VectorDrawing> drawing =
      drawVectors(scene, model.camera, {.sizeMm = glm::vec2(order.cellMm), .environment = {}});
  if (!drawing.ok()) {
    Error error = drawing.error();
    error.where = model.name;
    return error;
  }
  ComparedCell cell{.drawing = std::move(*drawing)};
  // Lines are cut already where something hides them, and paper on paper shows nothing.
  cell.drawing.background.reset();
  for (VectorStructure& structure : cell.drawing.structures) {
    structure.fills.clear();
    structure.tones.reset();
  }
  InkFrames frames(scene, cellPixels, cellPixels);
  cell.frameMs = medianFrameMs(frames, model.camera, order.timings);
  const InkFrame frame = frames.at(model.camera, InkRules::vectors);
  const double mmPerPixel = double(order.cellMm) / cellPixels;
  if (const double area = areaOf(frame); area > 0.0)
    cell.linesPerMm = lengthOf(frame, kindsOf(technique)) / (area * mmPerPixel);
  return cell;
}

}  // namespace

ComparedModel roughened(const ComparedModel& model, const Noise& noise) {
  ComparedModel rough = model;
  rough.note = noiseText(noise);
  std::vector<model::Node> nodes = model.scene.nodes();
  for (model::Node& node : nodes)
    if (!node.isGroup())
      node.mesh = withNoise(*node.mesh, noise);
  rough.scene.setNodes(std::move(nodes));
  return rough;
}

model::Scene comparedScene(const model::Scene& scene, model::Technique technique,
                           const model::ThresholdValues& thresholds, float cellMm) {
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  model::Scene compared;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const model::Node& node = scene.nodes()[i];
    if (node.isGroup() || !styles[i].visible)
      continue;
    compared.append({.name = node.name,
                     .style = {.gamma = factsOf(technique).whole,
                               .fill = model::Fill::paper,
                               .technique = technique,
                               .lineThresholds = thresholds,
                               .penWeight = penMm / (2.0f * cellMm / 720.0f)},
                     .mesh = node.mesh,
                     .provenance = node.provenance});
  }
  return compared;
}

Result<Comparison> compareTechniques(const ComparisonOrder& order, const ExportProgress& progress) {
  Comparison comparison{.order = order, .rows = {}};
  const double all = double(order.models.size() * order.techniques.size());
  double done = 0.0;
  for (const ComparedModel& model : order.models) {
    std::vector<ComparedCell>& row = comparison.rows.emplace_back();
    for (const model::Technique technique : order.techniques) {
      const std::string what = model.name + ", " + factsOf(technique).name;
      if (progress && !progress(done++ / all, what))
        return givenUp({});
      ComparedCell cell = TRY(compare(model, technique, order));
      row.push_back(std::move(cell));
    }
  }
  return comparison;
}

}  // namespace sline::render
