// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/structure_lines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/parallel.h"
#include "render/drawn/section_caps.h"
#include "render/lines/ground/chains.h"
#include "render/lines/ground/stage_entry.h"
#include "render/lines/ground/stages.h"
#include "render/lines/ground/view_fields.h"
#include "render/lines/hatching/clipping.h"
#include "render/lines/techniques/line_technique.h"
#include "render/lines/techniques/technique_list.h"
#include "render/strokes/hidden_lines.h"
#include "render/strokes/line_curves.h"
#include "render/strokes/stroke_maker.h"

namespace sline::render {

namespace {

constexpr float standardPen = 2.0f;  // λ, METHOD §4
// The share of a pen's width that contours within their own mask have, where its pressure varies.
constexpr float innerContour = 0.75f;
// How far a pencil wavers to either side, λ.
constexpr float widestWaver = 0.5f;

// The distance in λ within which a contour of a surface seen along its length may find its far
// side.
constexpr float wideStep = 2.5f;

// Where triangles are smaller than pixels, segments are joined: at most this many pixels off what a
// pen draws, to strokes of at most that many.
constexpr float simplification = 0.1f;
constexpr float longestStroke = 16.0f;
// Pieces of curves are shorter: they enter as a whole as Γ grows, and long ones are seen to jump.
constexpr float longestPiece = 5.0f;
// No pen reaches farther into the picture, λ.
constexpr float outsideReach = 100.0f;
// And at most this many off the place where it is looked up whether something hides the line; in
// depth by half of what that forgives (StrokeMaker), in edges of triangles.
constexpr float lookUpError = 0.5f;
constexpr float outlineDepthError = 0.25f;
constexpr float lineDepthError = 0.05f;

float pixelsPerMillimetre(const model::Surface& surface, const PictureView& view) {
  const float mm = view.millimetresPerPixel(surface.boundingSphere.centre);
  return mm > 0.0f ? 1.0f / mm : 0.0f;
}

/// Returns how far the triangles' own outline may lie from the line where nv = 0, in pixels: the
/// sagitta of an edge.
float outlineError(const model::Surface& surface, const PictureView& view) {
  const float sagitta =
      surface.meanEdge * surface.meanEdge / (2.0f * std::max(surface.filigreeSize, 1e-20f));
  return std::min(sagitta * pixelsPerMillimetre(surface, view), 2.0f);
}

}  // namespace

bool showsLines(const model::ResolvedStyle& style) {
  return transitions(gammaSpan(style).least).lines > 0.0f && style.penWeight > 0.0f;
}

bool showsHatching(const model::ResolvedStyle& style) {
  return showsLines(style) && transitions(gammaSpan(style).most).hatching > 0.0f &&
         style.technique == model::Technique::sline && style.hatchDensity.value() > 0.0f &&
         style.hatchTone.value() > 0.0f;
}

bool showsEdges(const model::ResolvedStyle& style) {
  return transitions(gammaSpan(style).most).complete > 0.0f && style.opacity.value() > 0.0f;
}

namespace {

/// Returns how far a fill has tones, 0 … 1: gaps beside them are seen as soon as they enter.
float tonesOf(const model::ResolvedStyle& style) {
  constexpr float soon = 4.0f;
  const bool tinted = style.fill == model::Fill::tint;
  const float shading = transitions(gammaSpan(style).most).shading;
  return std::min(soon * style.opacity.value() * (tinted ? 1.0f : shading), 1.0f);
}

}  // namespace

float evenInk(const model::ResolvedStyle& style) {
  return gammaVaries(style) ? 1.0f : transitions(style.gamma).lines;
}

float penWidth(const model::Surface& surface, const PictureView& view, float penWeight) {
  const float pen = standardPen * penWeight * view.outputUnit();
  const float across = 2.0f * surface.filigreeSize * pixelsPerMillimetre(surface, view);
  return pen * std::clamp(across / std::max(6.0f * pen, 1e-6f), 0.5f, 1.0f);
}

LineKinds shownKinds(const model::ResolvedStyle& style) {
  const Gamma most = gammaSpan(style).most;
  LineKinds kinds{};
  for (const LineTechnique& technique : lineTechniques())
    if (technique.bounds ||
        (showsLines(style) && technique.drawnBy.value_or(style.technique) == style.technique &&
         technique.entered(most) > 0.0f))
      kinds.add(technique.kind);
  return kinds;
}

namespace {

/// Returns a time at which the technique ranks its lines, should any of them enter at some time
/// of their own.
float rankingTime(const LineTechnique& technique, const model::ResolvedStyle& style) {
  const GammaSpan span = gammaSpan(style);
  const float first = technique.entered(span.least);
  return first == technique.entered(span.most) ? first : 0.5f;
}

/// Sets Γ at the segments' ends.
void setGammas(std::vector<Segment>& segments, const model::Mesh& mesh, Gamma own,
               const GammaOffsets* offsets) {
  parallelFor(segments.size(), 2048, [&](std::size_t i) {
    Segment& s = segments[i];
    s.gammaA = offsets ? gammaAt(mesh, *offsets, own, s.triangle, s.a) : own.value();
    s.gammaB = offsets ? gammaAt(mesh, *offsets, own, s.triangle, s.b) : own.value();
  });
}

/// Returns the segments without their Γ.
LineSet linesOf(PreparedSurface& prepared, const PictureView& view,
                const model::ResolvedStyle& style, const glm::vec3& light) {
  const model::Surface& surface = *prepared.surface;
  const bool twoSided = needsTwoSides(surface, view.camera());
  LineRequest request{.kinds = {},
                      .thresholds = lineThresholds(style.lineThresholds),
                      .twoSided = twoSided,
                      .hiddenContours = twoSided,
                      .aspect = view.size().x / view.size().y,
                      .preparations = &prepared.lines,
                      .light = light};
  LineRequest scaled = request;
  const LineKinds shown = shownKinds(style);
  for (const LineTechnique& technique : lineTechniques())
    if (shown.has(technique.kind))
      (technique.atScale ? scaled : request).kinds.add(technique.kind);
  LineSet lines = extractLines(surface, view.camera(), request);
  if (scaled.kinds.empty())
    return lines;
  const float deviation = scaleDeviation(surface, view, style.lineScale, prepared.smoothness);
  for (const ScaledShape& shape : prepared.scales.at(prepared.surface, deviation)) {
    for (const LineTechnique& technique : lineTechniques())
      for (std::size_t i = 0; i < technique.thresholds.size(); ++i)
        if (technique.thresholds[i].grows)
          scaled.thresholds.set(technique.kind, i,
                                shape.threshold * request.thresholds.of(technique.kind, i));
    LineSet found = extractLines(*shape.surface, view.camera(), scaled);
    for (const LineTechnique& technique : lineTechniques()) {
      std::vector<Segment>& here = found[technique.kind];
      for (Segment& s : here) {
        s.opacityA *= shape.share;
        s.opacityB *= shape.share;
      }
      std::vector<Segment>& all = lines[technique.kind];
      if (all.empty())
        all = std::move(here);
      else
        all.insert(all.end(), here.begin(), here.end());
    }
  }
  return lines;
}

}  // namespace

LineSet styledLines(PreparedSurface& prepared, const PictureView& view,
                    const model::ResolvedStyle& style, const GammaOffsets* offsets,
                    const glm::vec3& light) {
  LineSet lines = linesOf(prepared, view, style, light);
  if (gammaVaries(style))
    for (const LineTechnique& technique : lineTechniques())
      setGammas(lines[technique.kind], *prepared.surface->mesh, style.gamma, offsets);
  return lines;
}

Hatching styledHatching(const DrawnStructure& shown, const PictureView& view,
                        const glm::vec3& light) {
  const model::ResolvedStyle& style = shown.style;
  const GammaOffsets* offsets = shown.gammaOffsets.get();
  std::vector<float> gammas(gammaVaries(style) && offsets ? offsets->size() : 0);
  for (std::size_t v = 0; v < gammas.size(); ++v)
    gammas[v] = Gamma::clamped(style.gamma.value() + (*offsets)[v]).value();
  return extractHatching(*shown.prepared->strokes, view.camera(),
                         {.entered = transitions(style.gamma).hatching,
                          .gammas = gammas,
                          .spacing = spacingOf(style.hatchDensity),
                          .tone = style.hatchTone.value(),
                          .light = light,
                          .aspect = view.size().x / view.size().y,
                          .twoSided = needsTwoSides(shown.surface(), view.camera()),
                          .mostCells = shown.hatchCells});
}

std::size_t hatchCellsEach(std::size_t hatched) {
  constexpr std::size_t mostOfPicture = 2'000'000;
  return std::min(mostHatchCells, mostOfPicture / std::bit_ceil(std::max<std::size_t>(hatched, 1)));
}

void cutLines(const SectionedSurface& cut, StructureLines& drawn) {
  for (const LineTechnique& technique : lineTechniques())
    clip(drawn.lines[technique.kind], cut.planes);
  clip(drawn.hatching, cut.planes);
  std::vector<Segment>& outlines = drawn.lines[LineKind::section];
  for (const CutFace& face : cut.faces)
    outlines.insert(outlines.end(), face.outline.begin(), face.outline.end());
}

namespace {

/// Tells whether a line lies so far beyond one side of the picture that nothing of it can be seen.
bool liesOutside(std::span<const ChainPoints::Point> points, const PictureView& view) {
  const float margin = outsideReach * view.outputUnit();
  glm::vec2 low(std::numeric_limits<float>::infinity());
  glm::vec2 high = -low;
  for (const ChainPoints::Point& point : points) {
    if (!(point.w > 0.0f))
      return false;
    low = glm::min(low, point.pixel);
    high = glm::max(high, point.pixel);
  }
  return low.x > view.size().x + margin || low.y > view.size().y + margin || high.x < -margin ||
         high.y < -margin;
}

}  // namespace

void joinLines(const model::Surface& surface, const PictureView& view,
               const model::ResolvedStyle& style, const glm::vec3& light, StructureLines& drawn) {
  const float pixel = view.millimetresPerPixel(surface.boundingSphere.centre);
  const std::span<const LineTechnique> techniques = lineTechniques();
  parallelFor(techniques.size(), 1, [&](std::size_t i) {
    const LineTechnique& technique = techniques[i];
    std::vector<Segment>& segments = drawn.lines[technique.kind];
    if (technique.rank)
      technique.rank(segments, surface, view.camera(), rankingTime(technique, style));
    if (!(pixel > 0.0f))
      return;
    DrawnChains drawnChains;
    if (technique.pen != LinePen::cutEdge && technique.joined) {
      drawnChains = joinedChains(segments, view);
    } else {
      drawnChains.chains = connectedChains(segments);
      drawnChains.points = pointsInPicture(drawnChains.chains, segments, view);
    }
    const Chains& chains = drawnChains.chains;
    const ChainPoints& points = drawnChains.points;
    std::vector<float>& lengths = drawnChains.points.lengths;
    // The longest outline stays, as it may be all there is of a structure.
    if (technique.bounds && !lengths.empty())
      *std::max_element(lengths.begin(), lengths.end()) = std::numeric_limits<float>::max();
    const float shortest = style.shortestLine * view.outputUnit();
    if (shortest > 0.0f)
      fadeShortChains(segments, chains, lengths,
                      {technique.specks.shortest * shortest, technique.specks.whole * shortest});
    // Fills are softened along faded outlines, too.
    const float faded = technique.bounds && showsEdges(style) ? 0.0f : technique.specks.shortest;
    leaveOut(drawnChains, [&](std::size_t chain) {
      return (shortest > 0.0f && lengths[chain] <= faded * shortest) ||
             liesOutside(points.of(chains, chain), view);
    });
    if (technique.pen != LinePen::cutEdge) {
      CurveSettings settings{.smoothing = style.lineSmoothing,
                             .variation = style.lineVariation,
                             .pen = penWidth(surface, view, style.penWeight),
                             .waver = widestWaver * style.grain * view.outputUnit(),
                             .outline = technique.pen == LinePen::outside,
                             .light = light,
                             .pixel = pixel};
      if (technique.bounds && style.hiddenLines == model::HiddenLines::dashed) {
        const std::vector<Segment> dashes =
            dashed(curved(segments, chains, points, view, settings), view);
        drawn.dashes = simplified(dashes, connectedChains(dashes), simplification * pixel,
                                  longestStroke * pixel);
      }
      settings.joints = {
          .drawn = simplification,
          .line = lookUpError,
          .depth = simplification * pixel +
                   (settings.outline ? outlineDepthError : lineDepthError) * surface.meanEdge,
          .longest = longestPiece};
      segments = curved(segments, chains, points, view, settings);
    } else {
      segments = simplified(segments, chains, simplification * pixel, longestStroke * pixel);
    }
  });
}

ContourProbes contourProbes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style) {
  const float error = outlineError(surface, view);
  return {.probe = penWidth(surface, view, style.penWeight) + 1.0f + error,
          .reach = {1.0f + 0.5f * error, 2.0f + wideStep * view.outputUnit()},
          .sheet = 6.0f * surface.meanEdge +
                   wideStep * view.outputUnit() *
                       view.millimetresPerPixel(surface.boundingSphere.centre)};
}

float innerContourShare(const model::ResolvedStyle& style) {
  return glm::mix(1.0f, innerContour, style.lineVariation);
}

Segment leaving(const Segment& segment) {
  const float a = transitions(Gamma::clamped(segment.gammaA)).lines;
  const float b = transitions(Gamma::clamped(segment.gammaB)).lines;
  Segment s = segment;
  s.pressureA *= a;
  s.pressureB *= b;
  s.opacityA *= a;
  s.opacityB *= b;
  return s;
}

std::vector<Stroke> strokes(const model::Surface& surface, const PictureView& view,
                            const model::ResolvedStyle& style, const StructureLines& drawn,
                            const PixelRect& area) {
  StrokeMaker maker(surface, view, area);
  maker.setTones(tonesOf(style));
  const Transitions t = transitions(style.gamma);
  const float pen = penWidth(surface, view, style.penWeight);
  const float innerShare = innerContourShare(style);
  const bool varies = gammaVaries(style);
  const auto set = [&](const LineTechnique& technique) {
    const auto endAt = [&](Gamma gamma) -> StrokeMaker::LineEnd {
      const float lines = transitions(gamma).lines;
      return {{pen * lines, lines}, technique.entered(gamma)};
    };
    const StrokeMaker::LineEnd even = endAt(style.gamma);
    for (const Segment& s : drawn.lines[technique.kind])
      switch (technique.pen) {
        case LinePen::outside: {
          const float entered =
              varies ? technique.entered(Gamma::clamped(0.5f * (s.gammaA + s.gammaB))) : even.t;
          const float inner = innerShare * render::entered(entered, 0.5f * (s.entryA + s.entryB));
          if (varies)
            maker.contour(leaving(s), pen, 1.0f, inner);
          else
            maker.contour(s, pen * t.lines, t.lines, inner);
          break;
        }
        case LinePen::centred:
          if (varies)
            maker.surfaceLine(s, endAt(Gamma::clamped(s.gammaA)), endAt(Gamma::clamped(s.gammaB)));
          else
            maker.surfaceLine(s, even, even);
          break;
        case LinePen::cutEdge:
          // Cut edges stay outlined where other lines leave: half as wide.
          maker.outline(s, pen * (0.5f + 0.5f * t.lines), style.penWeight > 0.0f ? 1.0f : 0.0f);
          break;
      }
  };
  for (const LineTechnique& technique : lineTechniques())
    if (technique.pen != LinePen::cutEdge)
      set(technique);
  for (const HatchStroke& s : drawn.hatching.strokes)
    maker.hatching(std::span(drawn.hatching.points).subspan(s.first, s.count),
                   varies ? 1.0f : t.lines, varies ? 1.0f : t.lines);
  // Like cut edges, patterns stay where other lines leave. Under a fine pen they thin less than its
  // lines, as strokes of less than a pixel would be grey.
  if (style.penWeight > 0.0f)
    for (const FacePattern& face : drawn.patterns)
      maker.pattern(face, std::min(0.5f + 0.5f * style.penWeight, 1.3f) * (0.7f + 0.3f * t.lines));
  for (const LineTechnique& technique : lineTechniques())
    if (technique.pen == LinePen::cutEdge)
      set(technique);
  return maker.take();
}

std::vector<Stroke> edges(const model::Surface& surface, const PictureView& view,
                          const model::ResolvedStyle& style, const LineSet& lines,
                          const PixelRect& area) {
  StrokeMaker maker(surface, view, area);
  const auto complete = [varies = gammaVaries(style)](float gamma) {
    return varies ? transitions(Gamma::clamped(gamma)).complete : 1.0f;
  };
  for (const LineTechnique& technique : lineTechniques())
    if (technique.bounds)
      for (const Segment& s : lines[technique.kind])
        maker.edge(s, complete(s.gammaA), complete(s.gammaB));
  return maker.take();
}

std::size_t firstContour(std::span<const Stroke> strokes) {
  return std::size_t(std::find_if(strokes.begin(), strokes.end(), isContour) - strokes.begin());
}

PixelRect strokeBounds(const Stroke& s) {
  // The stroke's middle lies up to half a width off the line, its edge as much again, and half a
  // pixel of softness is added.
  const float reach = 2.0f * std::max(s.halfWidthA, s.halfWidthB) + 1.5f +
                      std::max(glm::length(s.moveA), glm::length(s.moveB));
  const glm::vec2 limit(1e6f);
  const glm::vec2 low = glm::clamp(glm::floor(glm::min(s.a, s.b) - reach), -limit, limit);
  const glm::vec2 high = glm::clamp(glm::ceil(glm::max(s.a, s.b) + reach), -limit, limit);
  return {int(low.x), int(low.y), int(high.x - low.x), int(high.y - low.y)};
}

}  // namespace sline::render
