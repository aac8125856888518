// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "render/vectors/vector_drawing.h"

namespace sline::render {

std::vector<VeiledLines> veiledLines(const VectorDrawing& drawing) {
  std::vector<VeiledLines> found;
  for (const VectorStructure& structure : drawing.structures)
    for (const VectorLines& lines : structure.lines) {
      const std::span<const VectorShape> all(lines.shapes);
      const std::size_t veiled = all.size() - plainShapes(lines).size();
      for (std::size_t from = 0; from < veiled;) {
        std::size_t to = from + 1;
        while (to < veiled && all[to].light == all[from].light)
          ++to;
        found.push_back({&structure, &lines, all.subspan(from, to - from)});
        from = to;
      }
    }
  std::stable_sort(found.begin(), found.end(), [](const VeiledLines& a, const VeiledLines& b) {
    return a.light() != b.light() ? a.light() < b.light() : a.structure->depth > b.structure->depth;
  });
  return found;
}

std::span<const VectorShape> plainShapes(const VectorLines& lines) {
  const auto first = std::find_if(lines.shapes.begin(), lines.shapes.end(),
                                  [](const VectorShape& shape) { return shape.light >= 1.0f; });
  return std::span(lines.shapes).subspan(std::size_t(first - lines.shapes.begin()));
}

}  // namespace sline::render
