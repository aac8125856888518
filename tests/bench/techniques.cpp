// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/techniques.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "model/edit/look.h"
#include "model/scene/visible_structures.h"
#include "render/drawn/prepared_surface.h"
#include "render/lines/techniques/line_technique.h"
#include "render/lines/techniques/technique_list.h"
#include "tests/bench/measure.h"

namespace sline::bench {

namespace {

struct Cost {
  std::size_t triangles = 0;
  double prepareMs = 0.0;
  std::size_t lines = 0;
  std::size_t bytes = 0;
  std::vector<double> findMs;  ///< of each camera
  std::size_t segments = 0;    ///< of all cameras

  void add(const Cost& other) {
    triangles += other.triangles;
    prepareMs += other.prepareMs;
    lines += other.lines;
    bytes += other.bytes;
    segments += other.segments;
    findMs.resize(other.findMs.size());
    for (std::size_t i = 0; i < findMs.size(); ++i)
      findMs[i] += other.findMs[i];
  }
};

std::string asText(const std::string& name, const Cost& cost) {
  std::ostringstream text;
  const Spread find = spreadOf(cost.findMs);
  text << std::fixed << std::setprecision(1) << name << ": " << cost.triangles
       << " triangles, prepared in " << cost.prepareMs << " ms, " << cost.lines << " lines, "
       << cost.bytes << " bytes, "
       << double(cost.bytes) / double(std::max<std::size_t>(cost.triangles, 1))
       << " a triangle; found in " << std::setprecision(2) << find.median
       << " ms (95 %: " << find.p95 << " ms), "
       << cost.segments / std::max<std::size_t>(cost.findMs.size(), 1) << " segments\n";
  return text.str();
}

Cost costOf(const model::Surface& surface, const TechniqueRun& run) {
  Cost cost{.triangles = surface.mesh->triangleCount()};
  render::LinePreparations preparations;
  render::LineKinds kinds{};
  for (const render::LineTechnique& technique : render::lineTechniques())
    if (technique.drawnBy == run.technique)
      kinds.add(technique.kind);
  const Stopwatch watch;
  preparations.make(kinds, surface);
  cost.prepareMs = watch.milliseconds();
  for (const render::LineTechnique& technique : render::lineTechniques())
    if (technique.prepare && kinds.has(technique.kind)) {
      const auto made = preparations.of(technique.kind, surface);
      cost.lines += made->count();
      cost.bytes += made->bytes();
    }
  for (const model::Camera& camera : run.cameras) {
    const render::LineRequest request{.kinds = kinds,
                                      .twoSided = render::needsTwoSides(surface, camera),
                                      .aspect = run.aspect,
                                      .preparations = &preparations};
    const Stopwatch finding;
    const render::LineSet lines = render::extractLines(surface, camera, request);
    cost.findMs.push_back(finding.milliseconds());
    for (const render::LineTechnique& technique : render::lineTechniques())
      cost.segments += lines[technique.kind].size();
  }
  return cost;
}

}  // namespace

std::string measureTechnique(const TechniqueRun& run) {
  std::string text;
  Cost all;
  const std::vector<model::VisibleStructure> structures = model::visibleStructures(run.scene);
  for (const model::VisibleStructure& structure : structures) {
    const model::Node& node = *structure.node;
    const Cost cost = costOf(*render::pictureSurface(node.mesh, node.provenance), run);
    if (structures.size() <= 12)
      text += asText(node.name, cost);
    all.add(cost);
  }
  return text + asText("all", all);
}

model::Scene drawnBy(const model::Scene& scene, model::Technique technique) {
  const model::Style look{.gamma = render::factsOf(technique).whole,
                          .fill = model::Fill::paper,
                          .technique = technique};
  return model::withLook(scene, scene.structuresBelow(model::rootId), look).scene;
}

}  // namespace sline::bench
