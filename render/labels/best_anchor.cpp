// SPDX-License-Identifier: Apache-2.0
#include "render/labels/best_anchor.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace sline::render {

namespace {

constexpr int cells = 64;  // along each side of the structure's box on the screen

struct Sample {
  model::Hit hit;
  bool seen = false;
  bool clear = false;  ///< seen, without anything drawn over it
  bool firm = false;   ///< also seen from a little aside: it faces the eye, and no fold is near
};
using Samples = std::vector<std::optional<Sample>>;  ///< cells × cells; none: not on the structure

std::size_t cellAt(int x, int y) {
  return std::size_t(y) * std::size_t(cells) + std::size_t(x);
}

/// Returns the structure's box in the picture.
std::optional<LabelBox> extentOf(const model::Mesh& mesh, const Screen& screen) {
  std::optional<LabelBox> box;
  for (const glm::vec3& p : mesh.positions())
    if (const std::optional<glm::vec2> place = screen.place(p)) {
      if (!box)
        box = LabelBox{*place, *place};
      box->low = glm::min(box->low, *place);
      box->high = glm::max(box->high, *place);
    }
  if (!box)
    return std::nullopt;
  box->low = glm::clamp(box->low, glm::vec2(0.0f), screen.size());
  box->high = glm::clamp(box->high, glm::vec2(0.0f), screen.size());
  return box->size().x > 0.0f && box->size().y > 0.0f ? box : std::nullopt;
}

bool faces(const model::Mesh& mesh, const model::Hit& hit, const model::Ray& ray) {
  constexpr float oblique = 0.3f;  // cosine
  const auto& [a, b, c] = mesh.triangles()[hit.triangle];
  const glm::vec3 normal = glm::cross(mesh.positions()[b] - mesh.positions()[a],
                                      mesh.positions()[c] - mesh.positions()[a]);
  return std::abs(glm::dot(normal, ray.direction)) >= oblique * glm::length(normal);
}

/// Marks samples as not firm where neighbours lie so much farther or nearer that one part of the
/// structure ends in front of another.
void loosenFolds(Samples& samples, float step) {
  const auto far = [&](std::size_t i, std::size_t k) {
    return samples[i] && samples[k] && std::abs(samples[i]->hit.t - samples[k]->hit.t) > step;
  };
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x)
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
        if (x + dx >= cells || y + dy >= cells || !far(cellAt(x, y), cellAt(x + dx, y + dy)))
          continue;
        samples[cellAt(x, y)]->firm = false;
        samples[cellAt(x + dx, y + dy)]->firm = false;
      }
}

Samples samplesOf(const Sights& sights, model::NodeId structure, const model::Mesh& mesh,
                  const Screen& screen, const LabelBox& box) {
  Samples samples(std::size_t(cells * cells));
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const glm::vec2 share = (glm::vec2(x, y) + 0.5f) / float(cells);
      const model::Ray ray = screen.sight(box.low + share * box.size());
      const auto own = sights.nearestOf(structure, ray);
      // A cut face has no triangle to point at.
      if (!own || own->cutFace)
        continue;
      model::Ray before = ray;
      before.farthest = own->hit.t;
      const auto first = sights.nearest(before);
      const bool seen = !first || first->structure == structure;
      samples[cellAt(x, y)] = Sample{own->hit, seen, seen && !sights.drawnOver(structure, before),
                                     faces(mesh, own->hit, ray)};
    }
  loosenFolds(samples, 0.04f * glm::length(mesh.bounds().size()));
  return samples;
}

/// Returns how far each cell is from one that does not count, in the box's own proportions, with
/// two sweeps (Borgefors: Distance transformations in digital images, 1986) and chamfer weights of
/// the cells' sides.
std::vector<float> depths(const std::vector<bool>& counts, const glm::vec2& cell) {
  std::vector<float> depth(counts.size(), 0.0f);
  const float diagonal = glm::length(cell);
  const auto relax = [&](int x, int y, int way) {
    const auto from = [&](int dx, int dy, float cost) {
      const int nx = x + dx;
      const int ny = y + dy;
      const bool inside = nx >= 0 && ny >= 0 && nx < cells && ny < cells;
      return (inside ? depth[cellAt(nx, ny)] : 0.0f) + cost;
    };
    depth[cellAt(x, y)] =
        std::min({depth[cellAt(x, y)], from(-way, 0, cell.x), from(0, -way, cell.y),
                  from(-way, -way, diagonal), from(way, -way, diagonal)});
  };
  for (std::size_t i = 0; i < counts.size(); ++i)
    depth[i] = counts[i] ? std::numeric_limits<float>::infinity() : 0.0f;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x)
      relax(x, y, 1);
  for (int y = cells; y-- > 0;)
    for (int x = cells; x-- > 0;)
      relax(x, y, -1);
  return depth;
}

struct Spot {
  std::size_t cell = 0;
  float depth = 0.0f;  ///< millimetres from where cells do not count
};

/// Returns the deepest cell that counts; of equally deep ones the nearest to the middle of all.
std::optional<Spot> deepest(const std::vector<bool>& counts, const glm::vec2& cell) {
  const std::vector<float> depth = depths(counts, cell);
  glm::vec2 middle(0.0f);
  float number = 0.0f;
  const auto place = [&](std::size_t i) {
    const std::size_t row = i / cells;
    return cell * glm::vec2(float(i % cells), float(row));
  };
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i]) {
      middle += place(i);
      number += 1.0f;
    }
  std::optional<Spot> best;
  float bestWorth = 0.0f;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!counts[i])
      continue;
    const float worth = depth[i] - 0.02f * glm::length(place(i) - middle / number);
    if (!best || worth > bestWorth) {
      best = Spot{i, depth[i]};
      bestWorth = worth;
    }
  }
  return best;
}

/// Returns the deepest of the samples for which `is` is true.
template <typename Counts>
std::optional<Spot> deepest(const Samples& samples, const glm::vec2& cell, Counts&& is) {
  std::vector<bool> counts(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    counts[i] = samples[i] && is(*samples[i]);
  return deepest(counts, cell);
}

/// Returns a place where nothing is drawn over the structure, if a dot has room there; otherwise
/// one where the structure is seen. It is not at a fold if there is room elsewhere. If nothing is
/// seen, it is anywhere on the structure.
std::optional<Spot> bestSpot(const Samples& samples, const glm::vec2& cell) {
  constexpr float roomForDot = 1.2f;  // millimetres
  constexpr float mostLost = 0.6f;    // share of the depth where it is seen
  const auto seen = deepest(samples, cell, [](const Sample& one) { return one.seen; });
  if (!seen)
    return deepest(samples, cell, [](const Sample&) { return true; });
  const float least = std::min(roomForDot, mostLost * seen->depth);
  const auto deepEnough = [least](const std::optional<Spot>& spot) {
    return spot && spot->depth >= least;
  };
  const auto clear = deepest(samples, cell, [](const Sample& one) { return one.clear; });
  const Spot found = deepEnough(clear) ? *clear : *seen;
  if (samples[found.cell]->firm)
    return found;
  for (const bool alsoClear : {true, false}) {
    const auto firm = deepest(samples, cell, [alsoClear](const Sample& one) {
      return one.firm && (alsoClear ? one.clear : one.seen);
    });
    if (deepEnough(firm))
      return firm;
  }
  return found;
}

}  // namespace

std::optional<BestAnchor> bestAnchorOn(const model::Scene& scene, model::NodeId structure,
                                       const Screen& screen, model::MeshTrees& trees) {
  const model::Node* node = scene.find(structure);
  if (!node || node->isGroup())
    return std::nullopt;
  const std::optional<LabelBox> box = extentOf(*node->mesh, screen);
  if (!box)
    return std::nullopt;
  const Sights sights(scene, trees);
  const Samples samples = samplesOf(sights, structure, *node->mesh, screen, *box);
  const std::optional<Spot> best = bestSpot(samples, box->size() / float(cells));
  if (!best)
    return std::nullopt;
  const Sample& sample = *samples[best->cell];
  const float most = std::max(sample.hit.u + sample.hit.v, 1.0f);
  return BestAnchor{{structure, sample.hit.triangle, {sample.hit.u / most, sample.hit.v / most}},
                    !sample.seen};
}

}  // namespace sline::render
