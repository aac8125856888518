// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/hatch_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "model/base/wide_loops.h"

namespace sline::render {

namespace {

// Where less than this share of the distance between strokes is seen they come and go as the
// surface turns.
constexpr float deep = 0.25f;
constexpr std::size_t placesAtOnce = 128;

/// Some points in a row with the one before and the one after, or those at the stroke's ends twice.
struct PlaceBlock {
  using Row = std::array<float, placesAtOnce>;
  std::array<std::array<float, placesAtOnce + 2>, 3> position;
  Row facing;
  Row x;
  Row y;
  Row across;
  Row perMm;

  std::size_t take(const LaidTile& tile, const LaidStroke& stroke, std::size_t from) {
    const std::size_t last = stroke.rowLength() - 1;
    const std::size_t count = std::min<std::size_t>(placesAtOnce, stroke.rowLength() - from);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float* row = tile.positionRow(stroke, axis);
      position[axis][0] = row[from > 0 ? from - 1 : 0];
      std::copy_n(row + from, count, position[axis].begin() + 1);
      position[axis][count + 1] = row[std::min(from + count, last)];
    }
    return count;
  }
};

/// Computes a block's points. All is written without branches, so that several are computed at
/// once.
template <bool atInfinity>
[[gnu::always_inline]] inline void findPlaces(PlaceBlock& block, std::size_t count,
                                              const PlacesView& view) {
  const auto& [px, py, pz] = block.position;
  const ViewScale::Frame frame = view.scale.frame();
  const glm::vec3 eye = view.eye.value;
  const glm::vec2 farthest = view.farthest;
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = px[i + 1] - frame.origin.x;
    const float dy = py[i + 1] - frame.origin.y;
    const float dz = pz[i + 1] - frame.origin.z;
    const float distance = -(dx * frame.back.x + dy * frame.back.y + dz * frame.back.z);
    const float mm = atInfinity ? frame.unit : distance * frame.unit;
    const float perMm = mm > 0.0f ? 1.0f / mm : 0.0f;
    const float x = perMm * (dx * frame.right.x + dy * frame.right.y + dz * frame.right.z);
    const float y = perMm * (dx * frame.up.x + dy * frame.up.y + dz * frame.up.z);
    // See seenAcross.
    const float ax = px[i + 2] - px[i], ay = py[i + 2] - py[i], az = pz[i + 2] - pz[i];
    const float ex = atInfinity ? eye.x : eye.x - px[i + 1];
    const float ey = atInfinity ? eye.y : eye.y - py[i + 1];
    const float ez = atInfinity ? eye.z : eye.z - pz[i + 1];
    const float lengths = (ax * ax + ay * ay + az * az) * (ex * ex + ey * ey + ez * ez);
    const float towards = ax * ex + ay * ey + az * ez;
    const float nv = block.facing[i];
    const float sideways = 1.0f - towards * towards / std::max(lengths, 1e-30f);
    const float alongStroke = nv / std::sqrt(std::max(std::max(sideways, nv * nv), 1e-12f));
    const float anyWay = std::sqrt(std::max(nv, 0.0f));
    const float across = lengths > 1e-30f ? alongStroke : anyWay;
    const float wide = std::sqrt(std::max(across, 0.0f));
    const float narrow = across * (1.0f / 0.5f);
    const float beyond = std::max(std::abs(x) - farthest.x, std::abs(y) - farthest.y);
    block.x[i] = x;
    block.y[i] = y;
    block.across[i] = across;
    block.perMm[i] = beyond <= 0.0f ? perMm * (across >= deep ? wide : narrow) : 0.0f;
  }
  static_assert(deep == 0.25f, "its root is 0.5");
}

SLINE_WIDE_LOOPS
void placesFromAfar(PlaceBlock& block, std::size_t count, const PlacesView& view) {
  findPlaces<true>(block, count, view);
}

SLINE_WIDE_LOOPS
void placesFromNear(PlaceBlock& block, std::size_t count, const PlacesView& view) {
  findPlaces<false>(block, count, view);
}

}  // namespace

void HatchPlaces::find(const LaidTile& tile, const LaidStroke& stroke, const PlacesView& view,
                       const std::vector<float>& facing) {
  for (std::vector<float>* row : {&x, &y, &across, &perMm})
    row->resize(stroke.rowLength());
  PlaceBlock block;
  for (std::size_t from = 0; from < x.size(); from += placesAtOnce) {
    const std::size_t count = block.take(tile, stroke, from);
    std::copy_n(facing.begin() + std::ptrdiff_t(from), count, block.facing.begin());
    if (view.eye.atInfinity)
      placesFromAfar(block, count, view);
    else
      placesFromNear(block, count, view);
    const auto keep = [&](const PlaceBlock::Row& row, std::vector<float>& all) {
      std::copy_n(row.begin(), count, all.begin() + std::ptrdiff_t(from));
    };
    keep(block.x, x);
    keep(block.y, y);
    keep(block.across, across);
    keep(block.perMm, perMm);
  }
}

}  // namespace sline::render
