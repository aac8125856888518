// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sline::render {

namespace {

/// Fills gaps evenly; there must be a value.
std::vector<float> filled(const std::vector<std::optional<float>>& places, bool loops) {
  const std::size_t count = places.size();
  std::vector<float> values(count);
  for (std::size_t t = 0; t < count; ++t) {
    std::size_t back = 0;
    while (back < count && (loops || back <= t) && !places[(t + count - back) % count])
      ++back;
    std::size_t on = 0;
    while (on < count && (loops || t + on < count) && !places[(t + on) % count])
      ++on;
    const bool before = back < count && (loops || back <= t);
    const bool after = on < count && (loops || t + on < count);
    const float first = *places[before ? (t + count - back) % count : (t + on) % count];
    const float next = *places[after ? (t + on) % count : (t + count - back) % count];
    const std::size_t gap = back + on;
    const float part = gap > 0 && before && after ? float(back) / float(gap) : 0.0f;
    values[t] = first + part * (next - first);
  }
  return values;
}

float steepest(const std::vector<float>& values, bool loops) {
  float most = 0.0f;
  for (std::size_t t = loops ? 0 : 1; t < values.size(); ++t)
    most = std::max(most, std::abs(values[t] - values[(t + values.size() - 1) % values.size()]));
  return most;
}

}  // namespace

std::vector<float> averaged(const std::vector<float>& values, std::size_t radius, bool loops) {
  const auto count = std::ptrdiff_t(values.size());
  const auto reach = std::min(std::ptrdiff_t(radius), (count - 1) / 2);
  std::vector<float> means(values.size());
  for (std::ptrdiff_t t = 0; t < count; ++t) {
    double sum = 0.0;
    for (std::ptrdiff_t k = t - reach; k <= t + reach; ++k)
      sum += double(values[std::size_t(loops ? (k + count) % count
                                             : std::clamp(k, std::ptrdiff_t(0), count - 1))]);
    means[std::size_t(t)] = float(sum / double(2 * reach + 1));
  }
  return means;
}

std::vector<float> steadyPath(const std::vector<std::optional<float>>& places, float slack,
                              const Film& film) {
  constexpr float fastest = 25.0f;  // millimetres a second
  constexpr double ease = 0.3;      // seconds
  constexpr int most = 12;
  const std::size_t count = places.size();
  std::vector<float> path = filled(places, film.loops());
  const auto [low, high] = std::minmax_element(path.begin(), path.end());
  if (*high - *low <= 2.0f * slack) {
    std::vector<float> sorted = path;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(count / 2), sorted.end());
    return std::vector<float>(count, sorted[count / 2]);
  }
  float at = path.front();
  const std::vector<float> given = path;
  for (std::size_t t = 0; t < (film.loops() ? 2 : 1) * count; ++t) {
    at = std::clamp(at, given[t % count] - slack, given[t % count] + slack);
    path[t % count] = at;
  }
  const auto radius = std::size_t(std::lround(ease * double(film.framesPerSecond())));
  for (int rounds = 0; rounds < most; ++rounds) {
    if (rounds > 1 && steepest(path, film.loops()) <= fastest / float(film.framesPerSecond()))
      break;
    path = averaged(path, std::max<std::size_t>(radius, 1), film.loops());
  }
  return path;
}

std::vector<float> eased(const Presence& there, std::size_t frames, bool loops) {
  const std::size_t count = there.size();
  std::vector<float> shares(count, 0.0f);
  const auto reach = std::ptrdiff_t(frames);
  for (std::size_t t = 0; t < count; ++t)
    for (std::ptrdiff_t k = -reach; k <= reach && there[t]; ++k) {
      const std::ptrdiff_t at = std::ptrdiff_t(t) + k;
      if (!loops && (at < 0 || at >= std::ptrdiff_t(count)))
        continue;
      const auto whole = std::ptrdiff_t(count);
      float& share = shares[std::size_t(((at % whole) + whole) % whole)];
      const float part = 1.0f - float(std::abs(k)) / float(reach + 1);
      share = std::max(share, part * part * (3.0f - 2.0f * part));
    }
  return shares;
}

}  // namespace sline::render
