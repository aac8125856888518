// SPDX-License-Identifier: Apache-2.0
#include "render/measures/ink_frames.h"

#include <algorithm>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model/base/parallel.h"
#include "model/scene/visible_structures.h"
#include "render/lines/ground/chains.h"
#include "render/lines/ground/stages.h"
#include "render/lines/techniques/line_technique.h"
#include "render/strokes/coverage.h"
#include "render/strokes/hidden_lines.h"
#include "render/vectors/crumbs.h"
#include "render/vectors/ink_chains.h"
#include "render/vectors/visible_strokes.h"

namespace sline::render {

namespace {

/// Finds the place of a pixel at a depth.
class Unprojection {
 public:
  explicit Unprojection(const PictureView& view)
      : m_size(view.size()), m_toWorld(glm::inverse(glm::dmat4(view.viewProjection()))) {}

  glm::vec3 placeOf(const glm::vec2& pixel, float depth) const {
    const glm::dvec2 at = 2.0 * glm::dvec2(pixel) / m_size - 1.0;
    const glm::dvec4 p = m_toWorld * glm::dvec4(at, 2.0 * double(depth) - 1.0, 1.0);
    return glm::vec3(glm::dvec3(p) / p.w);
  }

 private:
  glm::dvec2 m_size;
  glm::dmat4 m_toWorld;
};

InkLine inkOf(const VisibleStroke& stroke, const Unprojection& world, float perHalfWidth) {
  InkLine line;
  line.points.reserve(stroke.points.size());
  for (const StrokePoint& p : stroke.points)
    line.points.push_back({p.at, world.placeOf(p.at, p.depth), perHalfWidth * p.halfWidth});
  return line;
}

/// Returns the dashes as points half a pixel apart and less.
std::vector<InkLine> inkOf(const std::vector<Segment>& dashes, const PictureView& view) {
  const Chains chains = connectedChains(dashes);
  std::vector<InkLine> lines(chains.count());
  for (std::size_t chain = 0; chain < chains.count(); ++chain)
    for (std::uint32_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i) {
      const Segment& s = dashes[chains.links[i].segment];
      const glm::vec3 a = s.a + s.moveA;
      const glm::vec3 b = s.b + s.moveB;
      const float length = glm::distance(view.project(a).pixel, view.project(b).pixel);
      const int steps = std::max(1, int(2.0f * length));
      for (int k = 0; k <= steps; ++k) {
        const glm::vec3 p = a + float(k) / float(steps) * (b - a);
        lines[chain].points.push_back({view.project(p).pixel, p, 1.0f});
      }
    }
  return lines;
}

}  // namespace

InkFrames::InkFrames(const model::Scene& scene, int width, int height)
    : m_width(width),
      m_height(height),
      m_light(scene.keyLight().value_or(model::KeyLight()).towards) {
  std::vector<model::VisibleStructure> structures = model::visibleStructures(scene);
  std::sort(structures.begin(), structures.end(),
            [](const auto& a, const auto& b) { return a.node->id < b.node->id; });
  for (const model::VisibleStructure& structure : structures) {
    const model::Node& node = *structure.node;
    PreparedSurface& prepared = m_surfaces.emplace_back();
    prepared.take(node.mesh, node.provenance);
    m_bounds.add(node.mesh->bounds());
    m_shown.push_back({node.name,
                       {.id = node.id,
                        .mesh = node.mesh,
                        .style = structure.style,
                        .prepared = &prepared,
                        .sections = {},
                        .cut = nullptr}});
  }
}

LineSet InkFrames::exactLines(const Shown& shown, const PictureView& view) {
  return showsLines(shown.drawn.style) ? styledLines(*shown.drawn.prepared, view, shown.drawn.style)
                                       : LineSet{};
}

InkFrame InkFrames::at(const model::Camera& camera, InkRules rules) {
  InkFrame frame{PictureView(camera, m_bounds, m_width, m_height), {}, {}};
  frame.structures.resize(m_shown.size());
  frame.layers.resize(m_shown.size());
  const LayerInput input{.view = frame.view};
  parallelFor(m_shown.size(), 1, [&](std::size_t i) {
    const DrawnStructure& drawn = m_shown[i].drawn;
    frame.layers[i] = depthLayer(
        drawn, input,
        coveredArea(drawn, frame.view, grown(frame.view.whole(), strokeReach(drawn, frame.view))));
  });
  parallelFor(m_shown.size(), 1, [&](std::size_t i) { addLines(m_shown[i], i, rules, frame); });
  return frame;
}

void InkFrames::addLines(const Shown& shown, std::size_t index, InkRules rules,
                         InkFrame& frame) const {
  StructureInk& ink = frame.structures[index];
  ink.name = shown.name;
  const model::ResolvedStyle& style = shown.drawn.style;
  const model::Surface& surface = shown.drawn.surface();
  StructureLines all;
  all.lines = exactLines(shown, frame.view);
  joinLines(surface, frame.view, style, m_light, all);
  ink.dashes = inkOf(all.dashes, frame.view);
  const float opacity = transitions(style.gamma).lines;
  if (!(opacity > 0.0f))
    return;
  const LayerStack stack(frame.layers, frame.view.size());
  const StrokeScene scene{.stack = stack,
                          .own = frame.layers[index],
                          .ownIndex = index,
                          .projection = frame.view.depthTerms(),
                          .probes = contourProbes(surface, frame.view, style),
                          .ink = opacity};
  const Unprojection world(frame.view);
  for (const LineTechnique& technique : lineTechniques()) {
    StructureLines one;
    one.lines[technique.kind] = std::move(all.lines[technique.kind]);
    std::vector<VisibleStroke> visible;
    for (const InkChain& chain :
         inkChains(strokes(surface, frame.view, style, one, frame.layers[index].area)))
      for (VisibleStroke& stroke : withinPage(visibleStrokes(chain, scene), frame.view.size()))
        visible.push_back(std::move(stroke));
    if (rules == InkRules::vectors)
      visible = withoutCrumbs(std::move(visible), frame.unit(), style.shortestLine);
    for (const VisibleStroke& stroke : visible) {
      ink.lines.push_back(
          inkOf(stroke, world, 2.0f * opacity * stroke.veil.transmittance / frame.unit()));
      ink.lines.back().kind = technique.kind;
    }
  }
}

}  // namespace sline::render
