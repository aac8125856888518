// SPDX-License-Identifier: Apache-2.0
#include "model/focus/twins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "model/anatomy/name_words.h"
#include "model/base/letters.h"
#include "model/base/natural_order.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

/// Boxes of versions share at least this part of what they cover together.
constexpr double sameBox = 0.6;
/// Boxes of two bodies' organs share at least this.
constexpr double overlapping = 0.1;
/// Surfaces coincide where they are no farther apart than this share of their box's diagonal, on
/// average.
constexpr float sameSurface = 0.03f;
/// Where this share of all structures has a twin that overlaps it, there are two bodies.
constexpr double secondBody = 0.5;
constexpr std::size_t fewestOfABody = 3;  ///< pairs
constexpr std::size_t places = 100;       ///< of a surface that are compared

bool isNumber(const std::string& word) {
  const std::size_t from = word.size() > 1 && word.front() == 'v' ? 1 : 0;
  return std::all_of(word.begin() + std::ptrdiff_t(from), word.end(), isDigit);
}

/// Tells whether a word is what programs call surfaces that nobody has named; "Segment 2" is no
/// version of "Segment 1".
bool saysNothing(const std::string& word) {
  static constexpr std::array<std::string_view, 12> words{
      "surface", "segment", "label", "mesh",   "model", "object",
      "part",    "region",  "roi",   "volume", "shape", "structure"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Returns the name without numbers: "liver", "liver 2" and "liver_v3" have the same. Empty where
/// nothing else says what it is.
std::string withoutNumbers(const std::string& name) {
  std::string rest;
  bool named = false;
  for (const std::string& word : wordsOf(name)) {
    if (isNumber(word) || word == "v")
      continue;
    named = named || !saysNothing(word);
    rest += word + ' ';
  }
  return named ? rest : std::string();
}

double volume(const Box& box) {
  const glm::dvec3 size(glm::max(box.high - box.low, 1e-3f));
  return size.x * size.y * size.z;
}

/// Returns how much of what two boxes cover together is in both.
double shared(const Box& a, const Box& b) {
  const glm::vec3 low = glm::max(a.low, b.low);
  const glm::vec3 high = glm::min(a.high, b.high);
  if (!glm::all(glm::lessThan(low, high)))
    return 0.0;
  const double both = volume({low, high});
  return both / (volume(a) + volume(b) - both);
}

/// Returns how far some of the vertices of `b` are from those of `a`, on average, mm.
float meanDistance(const Mesh& a, const Mesh& b) {
  const std::size_t stride = std::max<std::size_t>(b.positions().size() / places, 1);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < b.positions().size(); i += stride) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const glm::vec3& place : a.positions()) {
      const glm::vec3 way = place - b.positions()[i];
      nearest = std::min(nearest, glm::dot(way, way));
    }
    sum += double(std::sqrt(nearest));
    ++count;
  }
  return count > 0 ? float(sum / double(count)) : std::numeric_limits<float>::infinity();
}

bool coincide(const Mesh& a, const Mesh& b) {
  const Box box = a.bounds();
  const float near = sameSurface * glm::length(box.high - box.low);
  return shared(box, b.bounds()) >= sameBox && meanDistance(a, b) <= near &&
         meanDistance(b, a) <= near;
}

}  // namespace

std::vector<Twins> twinsOf(const Scene& scene) {
  std::map<std::string, std::vector<const Node*>> named;
  std::size_t all = 0;
  for (const VisibleStructure& each : visibleStructures(scene)) {
    if (each.node->provenance.frame == "file" || each.node->mesh->positions().empty())
      continue;
    ++all;
    if (const std::string name = withoutNumbers(each.node->name); !name.empty())
      named[name].push_back(each.node);
  }
  std::vector<Twins> versions;
  std::vector<Twins> bodies;
  for (auto& [name, nodes] : named) {
    std::stable_sort(nodes.begin(), nodes.end(), [](const Node* a, const Node* b) {
      return naturallyBefore(a->name, b->name);
    });
    for (std::size_t k = 1; k < nodes.size(); ++k)
      for (std::size_t i = 0; i < k; ++i)
        if (coincide(*nodes[i]->mesh, *nodes[k]->mesh)) {
          versions.push_back({nodes[i]->id, nodes[k]->id});
          break;
        }
    if (nodes.size() == 2 &&
        shared(nodes[0]->mesh->bounds(), nodes[1]->mesh->bounds()) >= overlapping)
      bodies.push_back({nodes[0]->id, nodes[1]->id});
  }
  const bool twoBodies =
      bodies.size() >= fewestOfABody && double(2 * bodies.size()) >= secondBody * double(all);
  return twoBodies ? bodies : versions;
}

std::string twinsText(const Scene& scene, const std::vector<Twins>& twins) {
  if (twins.empty())
    return {};
  const auto nameOf = [&scene](NodeId id) { return '"' + scene.find(id)->name + '"'; };
  std::string text =
      nameOf(twins.front().second) + " lies where " + nameOf(twins.front().first) + " lies";
  if (const std::size_t more = twins.size() - 1; more > 0)
    text += ", and so do " + std::to_string(more) + (more == 1 ? " other" : " others");
  return text + ": two versions or two bodies; a plate shows the first";
}

}  // namespace sline::model
