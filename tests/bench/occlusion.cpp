// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/occlusion.h"

#include <array>
#include <cstdio>

#include "model/geometry/surface.h"
#include "model/scalars/occlusion.h"
#include "tests/bench/measure.h"

namespace sline::bench {

std::string measureOcclusion(const model::Scene& scene) {
  std::string text = "triangles        ms    ms per million\n";
  for (const model::NodeId id : scene.structuresBelow(model::rootId)) {
    const model::Node& node = *scene.find(id);
    const model::SurfacePtr surface = model::prepareSurface(node.mesh);
    const Stopwatch watch;
    const std::vector<float> field = model::ambientOcclusion(*surface);
    const double ms = watch.milliseconds();
    const std::size_t triangles = node.mesh->triangleCount();
    std::array<char, 80> line{};
    std::snprintf(line.data(), line.size(), "%9zu %9.0f %17.0f  ", triangles, ms,
                  triangles > 0 ? 1e6 * ms / double(triangles) : 0.0);
    text += line.data() + node.name + '\n';
  }
  return text;
}

}  // namespace sline::bench
