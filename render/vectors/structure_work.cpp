// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/structure_work.h"

#include <algorithm>
#include <utility>

#include "model/base/parallel.h"
#include "model/scene/visible_structures.h"
#include "render/drawn/coinciding.h"
#include "render/drawn/gamma_offsets.h"
#include "render/lines/techniques/line_technique.h"
#include "render/strokes/coverage.h"
#include "render/vectors/crumbs.h"
#include "render/vectors/ink_chains.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

PreparedSurface& KeptSurfaces::of(const model::Node& node) {
  const auto [place, fresh] = m_surfaces.try_emplace(node.mesh);
  if (fresh)
    place->second.take(node.mesh, node.provenance);
  return place->second;
}

std::vector<StructureWork> structureWork(const model::Scene& scene, KeptSurfaces& surfaces) {
  std::vector<model::VisibleStructure> structures = model::visibleStructures(scene);
  std::sort(structures.begin(), structures.end(),
            [](const auto& a, const auto& b) { return a.node->id < b.node->id; });
  surfaces.hulls().take(scene);
  std::vector<StructureWork> work;
  for (const model::VisibleStructure& structure : structures) {
    const model::Node& node = *structure.node;
    DrawnStructure shown{
        .id = node.id,
        .mesh = node.mesh,
        .style = structure.style,
        .prepared = &surfaces.of(node),
        .sections = sectionsThatCut(scene.sectionsOf(node.id), node.mesh->bounds()),
        .cut = nullptr};
    findGammaOffsets(scene, shown);
    if (!shown.sections.empty()) {
      shown.pattern = cutPattern(scene, node, &surfaces.hulls());
      shown.cut = surfaces.sections().at(shown.prepared->surface, shown.sections);
    }
    work.push_back({std::move(shown), {}, {}});
  }
  const auto hatched =
      std::size_t(std::count_if(work.begin(), work.end(), [](const StructureWork& each) {
        return showsHatching(each.shown.style);
      }));
  for (StructureWork& each : work)
    each.shown.hatchCells = hatchCellsEach(hatched);
  Coinciding coinciding;
  std::vector<bool> buried(work.size());
  for (std::size_t i = 0; i < work.size(); ++i)
    buried[i] = coinciding.isBuried(work[i].shown);
  std::size_t next = 0;
  std::erase_if(work, [&](const StructureWork&) { return buried[next++]; });
  return work;
}

void findAreas(std::span<StructureWork> work, const PictureView& view) {
  parallelFor(work.size(), 1, [&](std::size_t i) {
    const DrawnStructure& shown = work[i].shown;
    work[i].area = coveredArea(shown, view, grown(view.whole(), strokeReach(shown, view)));
  });
}

void prepareLines(std::span<const StructureWork> work) {
  // Structures of one mesh share what is made here.
  std::map<PreparedSurface*, LineNeeds> needs;
  for (const StructureWork& one : work) {
    LineNeeds& all = needs[one.shown.prepared];
    all.kinds.add(shownKinds(one.shown.style));
    all.hatching = all.hatching || showsHatching(one.shown.style);
  }
  const std::vector<std::pair<PreparedSurface*, LineNeeds>> each(needs.begin(), needs.end());
  parallelFor(each.size(), 1, [&](std::size_t i) { each[i].first->need(each[i].second); });
}

void findLines(StructureWork& work, const PictureView& view, const glm::vec3& light) {
  if (!work.hasLines())
    return;
  const DrawnStructure& shown = work.shown;
  work.lines.lines =
      styledLines(*shown.prepared, view, shown.style, shown.gammaOffsets.get(), light);
  if (showsHatching(shown.style))
    work.lines.hatching = styledHatching(shown, view, light);
  if (shown.cut) {
    cutLines(*shown.cut, work.lines);
    work.lines.patterns = facePatterns(shown, view);
  }
  joinLines(shown.surface(), view, shown.style, light, work.lines);
}

std::vector<LineLayer> takeLayers(StructureWork& work) {
  std::vector<LineLayer> layers;
  const float ink = evenInk(work.shown.style);
  const bool pens = ink > 0.0f && work.shown.style.penWeight > 0.0f;
  const auto add = [&layers](const char* kind, float opacity) -> StructureLines& {
    return layers.emplace_back(LineLayer{kind, opacity, {}}).lines;
  };
  if (pens)
    add(hatchingLayer, ink).hatching = std::move(work.lines.hatching);
  if (!work.lines.patterns.empty())
    add(cutTissueLayer, 1.0f).patterns = std::move(work.lines.patterns);
  for (const LineTechnique& technique : lineTechniques()) {
    // Cut edges stay outlined where other lines leave.
    const bool stays = technique.pen == LinePen::cutEdge;
    if (pens || stays)
      add(technique.layer, stays ? 1.0f : ink).lines[technique.kind] =
          std::move(work.lines.lines[technique.kind]);
  }
  return layers;
}

std::vector<VisibleStroke> seenLines(const StructureWork& work, const StructureLines& some,
                                     const StrokeScene& scene, const PictureView& view) {
  const model::ResolvedStyle& style = work.shown.style;
  std::vector<VisibleStroke> visible;
  for (const InkChain& chain :
       inkChains(strokes(work.shown.surface(), view, style, some, work.area)))
    for (VisibleStroke& stroke : withinPage(visibleStrokes(chain, scene), view.size()))
      visible.push_back(std::move(stroke));
  const bool hatched = !some.hatching.strokes.empty() || !some.patterns.empty();
  return hatched ? visible
                 : withoutCrumbs(std::move(visible), view.outputUnit(), style.shortestLine);
}

}  // namespace sline::render
