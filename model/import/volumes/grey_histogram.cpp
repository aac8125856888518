// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/grey_histogram.h"

#include <algorithm>
#include <cmath>

namespace sline::model {

GreyHistogram::GreyHistogram(const GreyVolume& volume)
    : m_slope(std::abs(volume.slope)), m_zero(volume.intercept) {
  if (volume.voxels.empty())
    return;
  m_counts.assign(65536, 0);
  for (const std::int16_t code : volume.voxels)
    ++m_counts[std::size_t(std::ptrdiff_t(code) + 32768)];
  if (volume.slope < 0.0) {
    // slope × c + zero = −slope × (−1 − c) + zero + slope: the codes run backwards.
    std::reverse(m_counts.begin(), m_counts.end());
    m_zero += volume.slope;
  }
  std::size_t first = 0;
  std::size_t last = m_counts.size() - 1;
  while (m_counts[first] == 0)
    ++first;
  while (m_counts[last] == 0)
    --last;
  m_least = intensity(first);
  m_greatest = intensity(last);
}

std::vector<std::uint64_t> GreyHistogram::binned(double low, double high, std::size_t bins) const {
  std::vector<std::uint64_t> result(bins, 0);
  if (!(high > low) || bins == 0)
    return result;
  for (std::size_t code = 0; code < m_counts.size(); ++code) {
    const double at = (intensity(code) - low) / (high - low);
    if (m_counts[code] > 0 && at >= 0.0 && at <= 1.0)
      result[std::min(bins - 1, std::size_t(at * double(bins)))] += m_counts[code];
  }
  return result;
}

double GreyHistogram::quantile(double share, double from) const {
  std::uint64_t all = 0;
  for (std::size_t code = 0; code < m_counts.size(); ++code)
    all += intensity(code) >= from ? m_counts[code] : 0;
  std::uint64_t below = 0;
  for (std::size_t code = 0; code < m_counts.size(); ++code) {
    below += intensity(code) >= from ? m_counts[code] : 0;
    if (below > 0 && double(below) >= share * double(all))
      return intensity(code);
  }
  return m_greatest;
}

double GreyHistogram::otsu() const {
  const double brightest = quantile(0.99, m_least);
  double all = 0.0;
  double sum = 0.0;
  for (std::size_t code = 0; code < m_counts.size(); ++code) {
    all += double(m_counts[code]);
    sum += double(m_counts[code]) * std::min(intensity(code), brightest);
  }
  double dark = 0.0;
  double darkSum = 0.0;
  double best = -1.0;
  double first = m_least;  // where the variance is the same between several intensities, the
                           // middle of them is taken
  double last = m_least;
  for (std::size_t code = 0; code < m_counts.size() && intensity(code) < brightest; ++code) {
    dark += double(m_counts[code]);
    darkSum += double(m_counts[code]) * intensity(code);
    if (dark == 0.0 || dark == all)
      continue;
    const double apart = darkSum / dark - (sum - darkSum) / (all - dark);
    const double variance = dark * (all - dark) * apart * apart;
    if (variance > best) {
      best = variance;
      first = intensity(code);
    }
    if (variance >= best)
      last = intensity(code);
  }
  return 0.5 * (first + last) + 0.5 * m_slope;
}

}  // namespace sline::model
