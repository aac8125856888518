// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer_content.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "model/base/parallel.h"
#include "render/drawn/face_patterns.h"
#include "render/picture/processor_drawing.h"

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
  // The mean n·v of the outermost three pixels of a sphere with a radius of 65: a sample there that
  // stands for so many would make a dark dot of them all.
  constexpr float outermost = 0.2f;
  SurfaceFill fill;
  if (input.parts.fills)
    fill = surfaceFill(shown, input.view, input.background);
  fill.leastFacing = input.surfaceStep > 1 ? outermost : 0.0f;
  return fill;
}

void completeSurfaces(const PictureInput& input, std::span<const Layer> layers,
                      std::span<const std::size_t> changed) {
  std::map<CachedSurface*, LineNeeds> needs;
  for (const std::size_t i : changed)
    for (const PreparedStructure& shown : layers[i].members) {
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

namespace {

/// What a layer is made of, one part after the other.
enum Part : std::size_t { linePart, strokePart, trianglePart };

/// Sums up how long all threads work on each part.
class PartTimes {
 public:
  using Clock = std::chrono::steady_clock;

  /// Counts the time since `from` as spent on the part; returns where it ends.
  Clock::time_point add(Part part, Clock::time_point from) {
    const Clock::time_point now = Clock::now();
    m_times[part] += std::chrono::nanoseconds(now - from).count();
    return now;
  }
  /// Returns the part's share of all that was counted.
  double share(Part part) const {
    const double all = double(m_times[linePart] + m_times[strokePart] + m_times[trianglePart]);
    return all > 0.0 ? double(m_times[part]) / all : 0.0;
  }

 private:
  std::array<std::atomic<std::int64_t>, 3> m_times{};
};

void findLines(const PictureInput& input, const PreparedStructure& shown, StructureLines& drawn) {
  drawn.lines =
      styledLines(*shown.prepared, input.view, shown.style, shown.gammaOffsets.get(), input.light);
}

/// Makes of the lines what a pen draws, and adds hatching and patterns.
void drawLines(const PictureInput& input, const PreparedStructure& shown, StructureLines& drawn) {
  if (hatches(input, shown))
    drawn.hatching = styledHatching(shown, input.view, input.light);
  if (shown.cut) {
    cutLines(*shown.cut, drawn);
    drawn.patterns = facePatterns(shown, input.view);
  }
  joinLines(shown.surface(), input.view, shown.style, input.light, drawn);
}

/// A structure whose lines are to be found.
struct AbsentLines {
  const PreparedStructure* shown;
  StructureLines* lines;
};

/// A layer to complete.
struct LayerWork {
  Layer* layer;
  std::vector<AbsentLines> absent;
  std::size_t clusters = 0;
};

/// Lists the layers, those of the largest surfaces first: so no thread is left with one of them
/// when all else is done.
std::vector<LayerWork> layerWork(const PictureInput& input, std::span<Layer> layers,
                                 std::span<const std::size_t> changed,
                                 std::map<model::NodeId, StructureLines>& lines) {
  std::vector<LayerWork> works;
  for (const std::size_t i : changed) {
    if (layers[i].covered)
      continue;
    LayerWork& work = works.emplace_back(LayerWork{.layer = &layers[i], .absent = {}});
    for (const PreparedStructure& shown : layers[i].members) {
      work.clusters += shown.surface().clusters.items.size();
      if (needsLines(input, shown))
        if (const auto [it, fresh] = lines.try_emplace(shown.id); fresh)
          work.absent.push_back({&shown, &it->second});
    }
  }
  std::stable_sort(works.begin(), works.end(),
                   [](const LayerWork& a, const LayerWork& b) { return a.clusters > b.clusters; });
  return works;
}

/// Draws the surfaces that may hide much, and has what they hide left out.
std::optional<Occlusion> leaveOutHidden(const PictureInput& input, const PixelRect& region,
                                        std::span<Layer> layers,
                                        std::span<const std::size_t> changed) {
  std::vector<Layer*> hiding;
  for (const std::size_t i : changed)
    if (hidesMuch(input, region, layers[i]))
      hiding.push_back(&layers[i]);
  if (hiding.empty())
    return std::nullopt;
  parallelFor(hiding.size(), 1, [&](std::size_t i) { sampleSurface(input, region, *hiding[i]); });
  Occlusion occlusion(input.view, region);
  for (const Layer* layer : hiding)
    if (layer->sampled)
      occlusion.add(layer->pixels);
  parallelFor(changed.size(), 1, [&](std::size_t i) {
    Layer& layer = layers[changed[i]];
    layer.covered = layer.partial = isHidden(layer, occlusion);
    if (!layer.covered)
      return;
    layer.onProcessor = layer.uploaded = true;
    layer.mask = TileMask(region, layer.area);
  });
  return occlusion;
}

}  // namespace

void completeLayers(const PictureInput& input, const PixelRect& region, std::span<Layer> layers,
                    std::span<const std::size_t> changed, Stopwatch& stopwatch) {
  std::map<model::NodeId, StructureLines> own;
  std::map<model::NodeId, StructureLines>& lines = input.lines ? *input.lines : own;
  const std::optional<Occlusion> occlusion = leaveOutHidden(input, region, layers, changed);
  if (input.isUnwanted())
    return;
  const std::vector<LayerWork> works = layerWork(input, layers, changed, lines);
  PartTimes times;
  std::atomic<std::size_t> next = 0;
  parallelFor(works.size(), 1, [&](std::size_t) {
    // Whichever thread is free takes the largest that is left.
    const LayerWork& work = works[next++];
    if (input.isUnwanted())
      return;
    const auto forEachAbsent = [&](const auto& body) {
      parallelFor(work.absent.size(), 1, [&](std::size_t i) {
        body(input, *work.absent[i].shown, *work.absent[i].lines);
      });
    };
    auto at = PartTimes::Clock::now();
    forEachAbsent(findLines);
    at = times.add(linePart, at);
    forEachAbsent(drawLines);
    completeLayer(*work.layer, input.view, region, lines, occlusion ? &*occlusion : nullptr);
    if (!input.lines)
      for (const AbsentLines& absent : work.absent)
        *absent.lines = {};
    at = times.add(strokePart, at);
    // A graphics card draws all triangles in less time than it takes to choose some, but hatching
    // pixel by pixel needs a list.
    if (!drawOnProcessor(input, region, *work.layer) &&
        (!input.card || work.layer->members.front().printedHatching))
      findTriangles(*work.layer, input.view, region);
    times.add(trianglePart, at);
  });
  stopwatch.shared(times.share(linePart),
                   {{"strokes", times.share(strokePart)},
                    {input.processor ? "surface" : "plan", times.share(trianglePart)}});
}

}  // namespace sline::render
