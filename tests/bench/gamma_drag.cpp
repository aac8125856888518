// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/gamma_drag.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iomanip>
#include <map>
#include <sstream>

#include "model/edit/look.h"

namespace sline::bench {

namespace {

/// Returns the largest structures, and an even selection of the rest from large to small.
std::vector<model::NodeId> chosen(const model::Scene& scene, int count) {
  std::vector<model::NodeId> ids;
  for (const model::NodeId id : scene.structuresBelow(model::rootId))
    if (scene.resolve(id).visible)
      ids.push_back(id);
  std::sort(ids.begin(), ids.end(), [&](model::NodeId a, model::NodeId b) {
    return scene.find(a)->mesh->triangleCount() > scene.find(b)->mesh->triangleCount();
  });
  const std::size_t large = std::min(ids.size(), std::size_t(count + 1) / 2);
  std::vector<model::NodeId> some(ids.begin(), ids.begin() + std::ptrdiff_t(large));
  const std::size_t rest = ids.size() - large;
  const std::size_t more = std::min(rest, std::size_t(count) - large);
  for (std::size_t i = 0; i < more; ++i)
    some.push_back(ids[large + i * rest / more]);
  return some;
}

class Drag {
 public:
  Drag(render::Picture& picture, const GammaDragPlan& plan) : m_picture(picture), m_plan(plan) {}

  Result<DraggedStructure> of(model::NodeId id) {
    const model::Node& node = *m_plan.scene.find(id);
    m_dragged = {.name = node.name, .triangles = node.mesh->triangleCount()};
    m_steps.clear();
    m_full.clear();
    m_passes.clear();
    const int steps = int(5.0f / m_plan.step + 0.5f);
    constexpr int fullEvery = 10;
    // The first round is not timed: what is computed once per structure is no part of a step.
    for (const bool warm : {true, false})
      for (int i = 0; i <= steps; ++i) {
        if (i % fullEvery == 0)
          if (const Status drawn = full(!warm); !drawn)
            return drawn.error();
        if (const Status drawn = step(id, float(i) * m_plan.step, warm); !drawn)
          return drawn.error();
      }
    m_dragged.step = spreadOf(m_steps);
    m_dragged.full = spreadOf(m_full);
    for (const auto& [name, times] : m_passes)
      m_dragged.passes.emplace_back(name, spreadOf(times).median);
    return m_dragged;
  }

 private:
  /// Draws all layers from a place hardly different, then again from the drag's own.
  Status full(bool counts) {
    model::Camera aside = m_plan.camera;
    aside.eye += 1e-3f * glm::length(aside.eye - aside.target) * glm::vec3(1.0f, 0.0f, 0.0f);
    for (const model::Camera& camera : {aside, m_plan.camera}) {
      const Stopwatch watch;
      if (Status drawn = m_picture.draw(m_plan.scene, camera, m_plan.settings); !drawn)
        return drawn;
      if (counts)
        m_full.push_back(watch.milliseconds());
    }
    return Unit{};
  }

  Status step(model::NodeId id, float gamma, bool warm) {
    const model::Style patch{.gamma = Gamma::clamped(gamma)};
    const model::Scene scene = model::withLook(m_plan.scene, std::span(&id, 1), patch).scene;
    const Stopwatch watch;
    if (Status drawn = m_picture.draw(scene, m_plan.camera, m_plan.settings); !drawn)
      return drawn;
    const double milliseconds = watch.milliseconds();
    if (warm) {
      m_dragged.firstMs = std::max(m_dragged.firstMs, milliseconds);
      return Unit{};
    }
    m_steps.push_back(milliseconds);
    const render::PictureTimings& timings = m_picture.timings();
    m_dragged.mostLayers = std::max(m_dragged.mostLayers, timings.layersDrawn);
    double rest = milliseconds - timings.lines;
    m_passes["lines"].push_back(timings.lines);
    for (const auto& pass : timings.passes) {
      m_passes[pass.name].push_back(pass.milliseconds);
      rest -= pass.milliseconds;
    }
    m_passes["other"].push_back(rest);
    return Unit{};
  }

  render::Picture& m_picture;
  const GammaDragPlan& m_plan;
  DraggedStructure m_dragged;
  std::vector<double> m_steps;
  std::vector<double> m_full;
  std::map<std::string, std::vector<double>> m_passes;
};

}  // namespace

Result<std::vector<DraggedStructure>> dragGamma(render::Picture& picture,
                                                const GammaDragPlan& plan) {
  std::vector<DraggedStructure> all;
  for (const model::NodeId id : chosen(plan.scene, plan.structures)) {
    Result<DraggedStructure> one = Drag(picture, plan).of(id);
    if (!one)
      return one.error();
    all.push_back(std::move(*one));
  }
  return all;
}

std::string asText(const std::vector<DraggedStructure>& dragged) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1)
      << "\nΓ drags                       triangles      step       p95      full     ratio  layers"
         "     dearest first step\n";
  std::vector<double> ratios;
  for (const DraggedStructure& d : dragged) {
    ratios.push_back(d.ratio());
    out << std::left << std::setw(28) << d.name.substr(0, 27) << std::right << std::setw(11)
        << d.triangles << std::setw(10) << d.step.median << std::setw(10) << d.step.p95
        << std::setw(10) << d.full.median << std::setprecision(2) << std::setw(10) << d.ratio()
        << std::setprecision(1) << std::setw(8) << d.mostLayers << std::setw(10) << d.firstMs
        << "\n    ";
    for (const auto& [name, time] : d.passes)
      out << name << ' ' << time << "  ";
    out << '\n';
  }
  const Spread all = spreadOf(ratios);
  out << std::setprecision(2) << "step / full frame: median " << all.median << ", worst "
      << (ratios.empty() ? 0.0 : *std::max_element(ratios.begin(), ratios.end())) << '\n';
  return out.str();
}

}  // namespace sline::bench
