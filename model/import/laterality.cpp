// SPDX-License-Identifier: Apache-2.0
#include "model/import/laterality.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/import/names.h"

namespace sline::model {

namespace {

struct Pair {
  std::vector<float> left;
  std::vector<float> right;
};

/// Bones and canals that lie in the middle of every body: where no pair tells the midline, they do.
bool liesInTheMiddle(const std::string& name) {
  for (const std::string& word : nameWords(name))
    for (const char* middle :
         {"sacrum", "coccyx", "vertebra", "lumbar", "spine", "spinal", "sternum"})
      if (word == middle)
        return true;
  return false;
}

float mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values)
    sum += value;
  return float(sum / double(std::max<std::size_t>(1, values.size())));
}

float median(std::vector<float> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<Frame> FrameVote::winner() const {
  if (lps == ras)
    return std::nullopt;
  return lps > ras ? Frame::lps : Frame::ras;
}

std::string FrameVote::text() const {
  return "vote: " + std::to_string(std::max(lps, ras)) + " of " + std::to_string(lps + ras) +
         " left/right names";
}

FrameVote voteOnFrame(std::span<const NamedPlace> places) {
  std::map<std::string, Pair> pairs;
  std::vector<float> middles;
  std::vector<float> spine;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const NamedPlace& place : places) {
    low = std::min(low, place.x);
    high = std::max(high, place.x);
    const SidedName name = sidedName(place.name);
    if (name.side == Side::left)
      pairs[name.rest].left.push_back(place.x);
    else if (name.side == Side::right)
      pairs[name.rest].right.push_back(place.x);
    else if (liesInTheMiddle(place.name))
      spine.push_back(place.x);
  }
  FrameVote vote;
  const float least = 0.01f * (high - low);
  const auto count = [&](float leftMinusRight) {
    if (leftMinusRight > least)
      ++vote.lps;
    else if (leftMinusRight < -least)
      ++vote.ras;
  };
  for (const auto& [name, pair] : pairs) {
    if (pair.left.empty() || pair.right.empty())
      continue;
    const float left = mean(pair.left);
    const float right = mean(pair.right);
    count(left - right);
    middles.push_back(0.5f * (left + right));
  }
  if (middles.empty())
    middles = spine;
  if (middles.empty())
    return vote;
  const float midline = median(middles);
  for (const auto& [name, pair] : pairs) {
    if (pair.right.empty())
      count(mean(pair.left) - midline);
    else if (pair.left.empty())
      count(midline - mean(pair.right));
  }
  return vote;
}

std::string frameName(Frame frame) {
  switch (frame) {
    case Frame::lps:
      return "LPS";
    case Frame::ras:
      return "RAS";
    case Frame::file:
      break;
  }
  return "file";
}

}  // namespace sline::model
