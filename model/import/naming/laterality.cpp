// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/laterality.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/import/naming/names.h"

namespace sline::model {

namespace {

struct Pair {
  std::vector<std::size_t> left;  ///< indices in the places
  std::vector<std::size_t> right;
};

/// Holds what one pair, or one name without its counterpart, says.
struct Ballot {
  float leftMinusRight = 0.0f;
  std::vector<std::size_t> places;
};

/// Tells whether the name is that of a bone or canal that lies in the middle of every body: where
/// no pair tells the midline, those do.
bool liesInTheMiddle(const std::string& name) {
  for (const std::string& word : nameWords(name))
    for (const char* middle :
         {"sacrum", "coccyx", "vertebra", "lumbar", "spine", "spinal", "sternum"})
      if (word == middle)
        return true;
  return false;
}

float mean(std::span<const NamedPosition> places, const std::vector<std::size_t>& which) {
  double sum = 0.0;
  for (const std::size_t i : which)
    sum += double(places[i].x);
  return float(sum / double(std::max<std::size_t>(1, which.size())));
}

float median(std::vector<float> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the ballots of all names that say something.
std::vector<Ballot> ballots(std::span<const NamedPosition> places) {
  std::map<std::string, Pair> pairs;
  std::vector<float> middles;
  std::vector<float> spine;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const NamedPosition& place = places[i];
    low = std::min(low, place.x);
    high = std::max(high, place.x);
    const SidedName name = sidedName(place.name);
    if (name.side == Side::left)
      pairs[name.rest].left.push_back(i);
    else if (name.side == Side::right)
      pairs[name.rest].right.push_back(i);
    else if (liesInTheMiddle(place.name))
      spine.push_back(place.x);
  }
  const float least = 0.01f * (high - low);
  std::vector<Ballot> cast;
  const auto add = [&](float leftMinusRight, std::vector<std::size_t> of) {
    if (std::abs(leftMinusRight) > least)
      cast.push_back({leftMinusRight, std::move(of)});
  };
  for (const auto& [name, pair] : pairs) {
    if (pair.left.empty() || pair.right.empty())
      continue;
    const float left = mean(places, pair.left);
    const float right = mean(places, pair.right);
    std::vector<std::size_t> both = pair.left;
    both.insert(both.end(), pair.right.begin(), pair.right.end());
    add(left - right, std::move(both));
    middles.push_back(0.5f * (left + right));
  }
  if (middles.empty())
    middles = spine;
  if (middles.empty())
    return cast;
  const float midline = median(middles);
  for (const auto& [name, pair] : pairs) {
    if (pair.right.empty())
      add(mean(places, pair.left) - midline, pair.left);
    else if (pair.left.empty())
      add(midline - mean(places, pair.right), pair.right);
  }
  return cast;
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

FrameVote voteOnFrame(std::span<const NamedPosition> places) {
  FrameVote vote;
  for (const Ballot& ballot : ballots(places))
    ++(ballot.leftMinusRight > 0.0f ? vote.lps : vote.ras);
  return vote;
}

std::vector<std::size_t> namedForOtherSide(std::span<const NamedPosition> places) {
  std::vector<std::size_t> found;
  for (const Ballot& ballot : ballots(places))
    if (ballot.leftMinusRight < 0.0f)
      found.insert(found.end(), ballot.places.begin(), ballot.places.end());
  std::sort(found.begin(), found.end());
  return found;
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
