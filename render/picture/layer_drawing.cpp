// SPDX-License-Identifier: Apache-2.0
// Draws the surfaces, caps and ink of layers into the atlas.
#include <algorithm>

#include "render/drawn/section_caps.h"
#include "render/drawn/surface_fill.h"
#include "render/picture/layer_content.h"
#include "render/picture/layer_ink.h"
#include "render/picture/layer_painter.h"
#include "render/strokes/coverage.h"

namespace sline::render {

namespace {

/// Appends squares of the layer as they lie in the atlas.
void appendSquares(const Layer& layer, const TileMask& squares,
                   std::vector<PixelRect>& rectangles) {
  for (PixelRect rect : squares.rectangles()) {
    rect.x += layer.slot.x - layer.area.x;
    rect.y += layer.slot.y - layer.area.y;
    rectangles.push_back(rect);
  }
}

/// Returns what of a layer's surface must be empty before it is drawn. Enlarging looks at one more
/// pixel around.
std::vector<PixelRect> surfaceSquares(const Layer& layer) {
  std::vector<PixelRect> squares;
  appendSquares(layer, layer.touched, squares);
  if (layer.surfaceStep > 1)
    for (PixelRect& rect : squares)
      rect = grown(coarser(rect, layer.surfaceStep), 1);
  return squares;
}

}  // namespace

void LayerPainter::emptyInk(gpu::Device& device, std::span<const Layer> layers,
                            std::span<const std::size_t> changed) const {
  // Where a layer has a fill, its depth was copied.
  for (const bool colour : {false, true})
    for (const bool depth : {false, true}) {
      std::vector<PixelRect> rectangles;
      for (const std::size_t i : changed)
        if (layers[i].shows() && layers[i].hasInk() == colour && layers[i].filled != depth)
          appendSquares(layers[i], layers[i].mask, rectangles);
      m_wipePass->draw(device, m_atlas.inkTarget(), {rectangles, colour, depth});
    }
}

void LayerPainter::drawMember(gpu::Device& device, const MemberDraw& member,
                              const passes::SurfaceView& view, gpu::DrawQueue& queue) const {
  const PreparedStructure& shown = member.layer.members[member.index];
  if (member.fill.gammaOffsets)
    shown.cached->showGammaOffsets(member.fill.gammaOffsets);
  const std::vector<glm::vec4> sections =
      shown.cut ? sectionVectors(shown.cut->planes) : std::vector<glm::vec4>();
  passes::SurfaceDraw draw{.surface = shown.cached->geometry(member.fill.byForm),
                           .triangles = {},
                           .layer = member.place.pixels,
                           .slot = member.place.slot,
                           .fill = member.fill,
                           .sections = sections};
  if (member.layer.triangles.empty()) {
    if (isCutAway(shown, shown.mesh->bounds()))
      return;
    shown.cached->keepWhole();
    draw.whole = true;
    draw.cullsBack = member.cullsBack;
    m_surfacePass->draw(device, member.target, view, draw);
    return;
  }
  std::span<const std::uint32_t> left = member.layer.triangles[member.index];
  while (!left.empty()) {
    draw.triangles = left.first(std::min(left.size(), gpu::DrawQueue::mostIndices));
    m_surfacePass->draw(device, member.target, view, draw);
    queue.addTriangles(draw.triangles.size());
    left = left.subspan(draw.triangles.size());
  }
}

void LayerPainter::drawSurface(gpu::Device& device, const PictureInput& input, const Layer& layer,
                               gpu::DrawQueue& queue) const {
  const passes::SurfaceView view{.viewProjection = input.view.viewProjection(),
                                 .eye = input.view.eyeVector(),
                                 .pictureSize = input.view.size(),
                                 .key = input.view.toPatient(keyLight(input))};
  const SurfacePlace place = surfacePlace(layer, layer.slot);
  for (std::size_t i = 0; i < layer.members.size(); ++i)
    drawMember(device,
               {m_atlas.surfaceTarget(), layer, i, place, shownFill(input, layer.members[i]),
                cullsBack(layer.members[i], input.view)},
               view, queue);
}

void LayerPainter::drawCaps(gpu::Device& device, const PictureInput& input, const Layer& layer,
                            const gpu::Target& target, const SurfacePlace& place) const {
  for (const PreparedStructure& shown : layer.members) {
    if (!hasCaps(shown))
      continue;
    const CapDraws caps = capDraws(shown, input.view, input.background, place.pixels, place.slot);
    for (const passes::CapDraw& draw : caps.draws)
      m_capPass->draw(device, target, draw);
  }
}

Status LayerPainter::drawSurfaces(gpu::Device& device, const PictureInput& input,
                                  std::span<const Layer> layers,
                                  std::span<const std::size_t> changed) const {
  gpu::DrawQueue queue(device.software());
  const bool enlarged = input.surfaceStep > 1;
  // Found depths come before all that is drawn, for which a driver would have to wait.
  for (const std::size_t i : changed)
    if (layers[i].shows() && !layers[i].pixels.empty())
      TRY(m_atlas.surfaceDepths().upload(std::as_bytes(std::span(layers[i].pixels.surfaceDepths)),
                                         surfacePlace(layers[i], layers[i].slot).slot));
  for (const std::size_t i : changed)
    if (layers[i].shows() && layers[i].pixels.empty()) {
      m_wipePass->draw(device, m_atlas.surfaceTarget(),
                       {surfaceSquares(layers[i]), layers[i].filled, true});
      drawSurface(device, input, layers[i], queue);
      if (!enlarged)
        drawCaps(device, input, layers[i], m_atlas.surfaceTarget(),
                 {layers[i].area, layers[i].slot});
    }
  // Where a layer has a fill, it lies as deep as its surface; elsewhere only its ink counts. All
  // copies come after all surfaces: a software driver starts anew at each change of target.
  if (enlarged)
    enlargeSurfaces(device, input, layers, changed, queue);
  else
    for (const std::size_t i : changed)
      if (layers[i].shows() && layers[i].filled) {
        device.copyDepth(m_atlas.surfaceTarget(), m_atlas.inkTarget(), layers[i].slot);
        queue.addCopies(layers[i].slot);
      }
  emptyInk(device, layers, changed);
  return Unit{};
}

void LayerPainter::enlargeSurfaces(gpu::Device& device, const PictureInput& input,
                                   std::span<const Layer> layers,
                                   std::span<const std::size_t> changed,
                                   gpu::DrawQueue& queue) const {
  for (const std::size_t i : changed)
    if (layers[i].shows() && layers[i].filled) {
      std::vector<PixelRect> squares;
      appendSquares(layers[i], layers[i].mask, squares);
      m_enlargePass->draw(device, m_atlas.edgeTarget(),
                          {.colours = m_atlas.coarseColours(),
                           .depths = m_atlas.surfaceDepths(),
                           .step = input.surfaceStep,
                           .rectangles = squares});
      queue.addCopies(layers[i].slot);
    }
  // Cut faces are few and flat: they are drawn in the picture's own pixels instead, and for the
  // lines that they hide in coarse ones.
  for (const std::size_t i : changed)
    if (layers[i].shows() && layers[i].filled)
      drawCaps(device, input, layers[i], m_atlas.edgeTarget(), {layers[i].area, layers[i].slot});
  for (const std::size_t i : changed)
    if (layers[i].shows())
      drawCaps(device, input, layers[i], m_atlas.surfaceTarget(),
               surfacePlace(layers[i], layers[i].slot));
}

Status LayerPainter::drawInk(gpu::Device& device, const PictureInput& input,
                             std::vector<Layer>& layers, std::span<const std::size_t> changed) {
  // All edges, then all strokes, so that the target changes once.
  std::vector<InkDraw> draws;
  std::vector<InkDraw> strokes;
  const auto append = [](std::vector<InkDraw>& to, const std::vector<InkDraw>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const std::size_t i : changed) {
    append(draws, edgeDraws(input, layers[i]));
    append(strokes, strokeDraws(input, layers[i]));
  }
  draws.insert(draws.end(), strokes.begin(), strokes.end());
  Status drawn = m_inkPass->draw(device, {m_atlas.edgeTarget(), m_atlas.inkTarget()},
                                 {m_atlas.surfaceDepths(), m_atlas.enlargedFills()}, draws);
  for (const std::size_t i : changed)
    forgetStrokes(layers[i]);
  return drawn;
}

}  // namespace sline::render
