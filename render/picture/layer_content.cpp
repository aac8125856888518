// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer_content.h"

#include <map>
#include <utility>
#include <vector>

#include "model/base/parallel.h"
#include "render/strokes/face_patterns.h"

namespace sline::render {

namespace {

bool needsLines(const PictureInput& input, const PreparedStructure& shown) {
  return ((input.parts.lines || input.parts.hatching) && showsLines(shown.style)) ||
         (input.parts.fills && showsEdges(shown.style)) || (input.parts.lines && shown.cut);
}

bool hatches(const PictureInput& input, const PreparedStructure& shown) {
  return input.parts.hatching && !shown.printedHatching && showsHatching(shown.style);
}

}  // namespace

SurfaceFill shownFill(const PictureInput& input, const PreparedStructure& shown) {
  return input.parts.fills ? surfaceFill(shown, input.view, input.background) : SurfaceFill{};
}

void completeSurfaces(const PictureInput& input, std::span<const Layer> layers,
                      std::span<const std::size_t> changed) {
  std::map<CachedSurface*, LineNeeds> needs;
  for (const std::size_t i : changed)
    for (const PreparedStructure& shown : layers[i].members) {
      if (shownFill(input, shown).byForm || shown.printedHatching)
        shown.cached->needShape();
      if (needsLines(input, shown)) {
        LineNeeds& own = needs[shown.cached];
        own.kinds.add(shownKinds(shown.style));
        own.hatching = own.hatching || hatches(input, shown);
      }
    }
  // Structures of one mesh share what is made here, so it is made before their lines.
  const std::vector<std::pair<CachedSurface*, LineNeeds>> each(needs.begin(), needs.end());
  parallelFor(each.size(), 1, [&](std::size_t i) { each[i].first->need(each[i].second); });
}

void findLines(const PictureInput& input, std::span<const Layer> layers,
               std::span<const std::size_t> changed, std::map<model::NodeId, StructureLines>& lines,
               Stopwatch& stopwatch) {
  struct Absent {
    const PreparedStructure* shown;
    StructureLines* lines;
  };
  std::vector<Absent> absent;
  for (const std::size_t i : changed)
    for (const PreparedStructure& shown : layers[i].members)
      if (needsLines(input, shown))
        if (const auto [it, fresh] = lines.try_emplace(shown.id); fresh)
          absent.push_back({&shown, &it->second});
  parallelFor(absent.size(), 1, [&](std::size_t i) {
    const PreparedStructure& shown = *absent[i].shown;
    absent[i].lines->lines = styledLines(*shown.prepared, input.view, shown.style,
                                         shown.gammaOffsets.get(), input.light);
  });
  stopwatch.lines();
  parallelFor(absent.size(), 1, [&](std::size_t i) {
    const PreparedStructure& shown = *absent[i].shown;
    StructureLines& drawn = *absent[i].lines;
    if (hatches(input, shown))
      drawn.hatching = styledHatching(*shown.cached->strokes, input.view, shown.style, input.light,
                                      shown.gammaOffsets.get());
    if (shown.cut) {
      cutLines(*shown.cut, drawn);
      drawn.patterns = facePatterns(shown, input.view);
    }
    joinLines(shown.surface(), input.view, shown.style, input.light, drawn);
  });
}

}  // namespace sline::render
