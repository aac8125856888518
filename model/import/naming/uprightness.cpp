// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/uprightness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/name_words.h"

namespace sline::model {

namespace {

/// Names what lies above what in every body that stands.
struct UpRow {
  std::array<std::string_view, 9> above;
  std::array<std::string_view, 9> below;
};

constexpr std::array<UpRow, 2> upRows{
    {{{"liver", "stomach", "spleen", "heart", "pancreas", "gallbladder", "kidney", "lung",
       "vertebra"},
      {"bladder", "prostate", "uterus", "vagina", "urethra", "femur", "ischium", "pubis",
       "coccyx"}},
     {{"femur", "patella"}, {"tibia", "fibula", "talus", "calcaneus", "foot"}}}};

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

bool contradicts(const UpRow& row, std::span<const NamedPosition> places) {
  constexpr std::size_t least = 2;
  Points above;
  Points below;
  for (const NamedPosition& place : places) {
    const std::vector<std::string> words = affirmedWords(place.name);
    const auto among = [&words](const std::array<std::string_view, 9>& names) {
      return std::any_of(names.begin(), names.end(), [&words](std::string_view name) {
        return !name.empty() && std::find(words.begin(), words.end(), name) != words.end();
      });
    };
    if (among(row.above))
      add(above, place);
    else if (among(row.below))
      add(below, place);
  }
  if (above[0].size() < least || below[0].size() < least)
    return false;
  std::array<float, 3> way{};
  for (std::size_t axis = 0; axis < way.size(); ++axis)
    way[axis] = middleOf(above[axis]) - middleOf(below[axis]);
  return way[2] <= 0.0f || std::max(std::abs(way[0]), std::abs(way[1])) > way[2];
}

}  // namespace

bool contradictsUpright(std::span<const NamedPosition> places) {
  return std::any_of(upRows.begin(), upRows.end(),
                     [places](const UpRow& row) { return contradicts(row, places); });
}

}  // namespace sline::model
