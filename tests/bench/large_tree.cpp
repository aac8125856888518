// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/large_tree.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>

#include "model/scene/resolved_styles.h"
#include "model/scene/visible_structures.h"
#include "tests/bench/measure.h"

namespace sline::bench {

namespace {

constexpr int perGroup = 10;

model::MeshPtr triangle() {
  auto mesh = model::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  return std::make_shared<const model::Mesh>(std::move(*mesh));
}

model::Scene treeOfMany(int structures) {
  const model::MeshPtr mesh = triangle();
  model::Scene scene;
  std::array<model::NodeId, 5> path{};
  for (int i = 0; i < structures; ++i) {
    if (i % perGroup == 0) {
      const std::size_t depth = std::size_t(i / perGroup) % path.size();
      model::Node group{.parent = depth == 0 ? model::rootId : path[depth - 1], .name = "group"};
      group.style.gamma = Gamma::clamped(float(depth));
      path[depth] = scene.append(std::move(group));
    }
    const std::size_t depth = std::size_t(i / perGroup) % path.size();
    scene.append({.parent = path[depth], .name = "structure", .mesh = mesh});
  }
  return scene;
}

double leastOf(const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 7; ++i) {
    const Stopwatch watch;
    work();
    least = std::min(least, watch.milliseconds());
  }
  return least;
}

std::string line(const char* what, double milliseconds) {
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "%-44s %9.3f ms\n", what, milliseconds);
  return text.data();
}

}  // namespace

std::string measureTree(int structures) {
  model::Scene scene;
  std::size_t seen = 0;
  std::string text =
      line("built, one after the other", leastOf([&] { scene = treeOfMany(structures); }));
  text += line("all styles resolved", leastOf([&] { seen += resolveAll(scene).size(); }));
  text += line("visible structures with their styles",
               leastOf([&] { seen += visibleStructures(scene).size(); }));
  text += line("each structure resolved alone", leastOf([&] {
                 for (const model::Node& node : scene.nodes())
                   seen += scene.resolve(node.id).visible;
               }));
  text +=
      line("bounds of what is visible", leastOf([&] { seen += !scene.visibleBounds().empty(); }));
  return text + std::to_string(scene.nodes().size()) + " nodes, " + std::to_string(seen) +
         " answers\n";
}

}  // namespace sline::bench
