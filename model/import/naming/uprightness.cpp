// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/uprightness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/name_words.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

/// Names what lies above what in every body that stands.
struct UpRow {
  std::vector<std::string_view> above;
  std::vector<std::string_view> below;
  bool refutes = false;  ///< they lie so far apart that two of each can contradict a file
};

const std::vector<UpRow>& upRows() {
  static const std::vector<UpRow> rows{
      {{"liver", "stomach", "spleen", "heart", "pancreas", "gallbladder", "kidney", "lung",
        "vertebra"},
       {"bladder", "prostate", "uterus", "vagina", "urethra", "femur", "ischium", "pubis",
        "coccyx"},
       true},
      {{"femur", "patella"}, {"tibia", "fibula", "talus", "calcaneus", "foot"}, true},
      {{"tibia", "fibula"}, {"talus", "calcaneus", "foot", "metatarsal"}},
      {{"brain", "cerebrum", "skull", "cranium", "eye", "eyeball", "mandible", "maxilla", "tongue"},
       {"heart", "lung", "liver", "kidney", "trachea", "thyroid", "clavicle", "sternum"}},
      {{"heart", "lung", "clavicle", "scapula", "thyroid", "trachea"},
       {"kidney", "pancreas", "duodenum", "bladder", "sacrum", "ilium"}},
      {{"cerebrum"}, {"cerebellum", "brainstem"}},
      {{"sacrum", "ilium", "hip bone"}, {"coccyx", "femur", "prostate", "urethra"}}};
  return rows;
}

using Points = std::array<std::vector<float>, 3>;  // by axis

void add(Points& points, const NamedPosition& place) {
  points[0].push_back(place.x);
  points[1].push_back(place.y);
  points[2].push_back(place.z);
}

float middleOf(std::vector<float> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

enum class Order { silent, upright, otherwise, refuting };

/// Tells whether the words have those of the name, which may be two, one after the other.
bool hasName(const std::vector<std::string>& words, std::string_view name) {
  const std::size_t blank = name.find(' ');
  const auto first = std::find(words.begin(), words.end(), name.substr(0, blank));
  if (first == words.end() || blank == std::string_view::npos)
    return first != words.end();
  return std::next(first) != words.end() && *std::next(first) == name.substr(blank + 1);
}

/// Returns what the row says of the places: what lies above what along z, and farther than along
/// another axis.
Order orderOf(const UpRow& row, std::span<const NamedPosition> places) {
  constexpr std::size_t refuting = 2;
  Points above;
  Points below;
  for (const NamedPosition& place : places) {
    std::vector<std::string> words = affirmedWords(place.name);
    if (hasName(words, "gall bladder"))
      words = {"gallbladder"};
    const auto among = [&words](const std::vector<std::string_view>& names) {
      return std::any_of(names.begin(), names.end(),
                         [&words](std::string_view name) { return hasName(words, name); });
    };
    if (among(row.above))
      add(above, place);
    else if (among(row.below))
      add(below, place);
  }
  if (above[0].empty() || below[0].empty())
    return Order::silent;
  std::array<float, 3> way{};
  for (std::size_t axis = 0; axis < way.size(); ++axis)
    way[axis] = middleOf(above[axis]) - middleOf(below[axis]);
  if (way[2] > 0.0f && std::max(std::abs(way[0]), std::abs(way[1])) <= way[2])
    return Order::upright;
  const bool many = above[0].size() >= refuting && below[0].size() >= refuting;
  return many && row.refutes ? Order::refuting : Order::otherwise;
}

/// What of one name lies higher and what lower: "superior" and "inferior".
struct HighAndLow {
  std::vector<float> high;
  std::vector<float> low;
};

/// Counts how many names that are alike but for "superior" and "inferior" lie so along z and how
/// many do not.
void countPairs(std::span<const NamedPosition> places, int& upright, int& otherwise) {
  std::map<std::string, HighAndLow> pairs;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const NamedPosition& place : places) {
    low = std::min(low, place.z);
    high = std::max(high, place.z);
    std::string rest;
    int side = 0;
    for (const std::string& word : nameWords(place.name)) {
      const int told = word == "superior" || word == "upper"   ? 1
                       : word == "inferior" || word == "lower" ? -1
                                                               : 0;
      side = side == 0 ? told : side;
      rest += told != 0 ? std::string() : word + ' ';
    }
    if (side != 0)
      (side > 0 ? pairs[rest].high : pairs[rest].low).push_back(place.z);
  }
  for (const auto& [rest, pair] : pairs) {
    if (pair.high.empty() || pair.low.empty())
      continue;
    const float up = middleOf(pair.high) - middleOf(pair.low);
    if (std::abs(up) > 0.01f * (high - low))
      ++(up > 0.0f ? upright : otherwise);
  }
}

}  // namespace

Evidence uprightEvidence(std::span<const NamedPosition> places) {
  int upright = 0;
  int otherwise = 0;
  for (const UpRow& row : upRows())
    switch (orderOf(row, places)) {
      case Order::refuting:
        return Evidence::conflict;
      case Order::upright:
        ++upright;
        break;
      case Order::otherwise:
        ++otherwise;
        break;
      case Order::silent:
        break;
    }
  countPairs(places, upright, otherwise);
  return upright > 0 && isClearVote(otherwise, upright + otherwise) ? Evidence::voted
                                                                    : Evidence::assumed;
}

}  // namespace sline::model
