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

struct FrontAndBack {
  std::vector<float> front;  ///< y of the places
  std::vector<float> back;
};

/// Returns −1 for a word that says front, 1 for back, else 0.
int frontOrBack(const std::string& word) {
  if (word == "anterior" || word == "ventral")
    return -1;
  return word == "posterior" || word == "dorsal" ? 1 : 0;
}

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

FrontVote voteOnFront(std::span<const NamedPosition> places) {
  std::map<std::string, FrontAndBack> pairs;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const NamedPosition& place : places) {
    low = std::min(low, place.y);
    high = std::max(high, place.y);
    std::string rest;
    int side = 0;
    for (const std::string& word : nameWords(place.name)) {
      const int told = frontOrBack(word);
      side = side == 0 ? told : side;
      rest += told != 0 ? std::string() : word + ' ';
    }
    if (side != 0)
      (side > 0 ? pairs[rest].back : pairs[rest].front).push_back(place.y);
  }
  FrontVote vote;
  for (const auto& [rest, pair] : pairs) {
    if (pair.front.empty() || pair.back.empty())
      continue;
    const float backward = median(pair.back) - median(pair.front);
    if (std::abs(backward) > 0.01f * (high - low))
      ++(backward > 0.0f ? vote.posterior : vote.anterior);
  }
  return vote;
}

std::optional<bool> FrontVote::toTheBack() const {
  if (posterior == anterior)
    return std::nullopt;
  return posterior > anterior;
}

const FrameAxes& axesOf(Frame frame) {
  return frames[std::size_t(frame)];
}

const FrameAxes& axesOf(std::string_view name) {
  const auto found = std::find_if(frames.begin(), frames.end(),
                                  [&](const FrameAxes& axes) { return axes.name == name; });
  return found == frames.end() ? frames.front() : *found;
}

FrameAxes axesIn(Frame frame, bool onlySideOpen) {
  FrameAxes axes = axesOf(frame);
  axes.posterior = axes.posterior && !onlySideOpen;
  return axes;
}

Frame frameWith(bool left, bool posterior) {
  if (left)
    return posterior ? Frame::lps : Frame::las;
  return posterior ? Frame::rps : Frame::ras;
}

std::string frameName(Frame frame) {
  return std::string(axesOf(frame).name);
}

}  // namespace sline::model
