// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/coinciding.h"

#include <algorithm>
#include <cmath>

#include "render/drawn/gamma_offsets.h"
#include "render/drawn/surface_fill.h"

namespace sline::render {

namespace {

/// The share of light from behind that still counts, half a step of eight bits.
constexpr double leastLight = 0.5 / 255.0;
constexpr int mostInOnePlace = 64;

bool alikeButForColours(const model::ResolvedStyle& a, model::ResolvedStyle b) {
  b.colour = a.colour;
  b.inkColour = a.inkColour;
  return a == b;
}

bool coincide(const DrawnStructure& a, const DrawnStructure& b) {
  return a.prepared == b.prepared && a.gammaOffsets == b.gammaOffsets && a.pattern == b.pattern &&
         alike(a.sections, b.sections) && alikeButForColours(a.style, b.style);
}

}  // namespace

int showingInOnePlace(const model::ResolvedStyle& style) {
  if (!hasFill(style))
    return 1;
  const double cover = gammaVaries(style) ? 0.0 : double(fillCover(style));
  if (cover >= 1.0)
    return 1;
  const double needed = std::ceil(std::log(leastLight) / std::log1p(-cover));
  return needed < double(mostInOnePlace) ? std::max(1, int(needed)) : mostInOnePlace;
}

bool Coinciding::isBuried(const DrawnStructure& shown) {
  std::vector<Alike>& others = m_seen[shown.mesh.get()];
  const auto found = std::find_if(others.begin(), others.end(), [&shown](const Alike& one) {
    return coincide(*one.first, shown);
  });
  if (found == others.end()) {
    others.push_back({&shown, 1});
    return false;
  }
  return ++found->count > showingInOnePlace(shown.style);
}

}  // namespace sline::render
