// SPDX-License-Identifier: Apache-2.0
// How often each intensity stands in a scan, and what follows from it.
#pragma once

#include <cstdint>
#include <vector>

#include "model/import/volumes/grey_volume.h"

namespace sline::model {

class GreyHistogram {
 public:
  GreyHistogram() = default;
  explicit GreyHistogram(const GreyVolume& volume);

  bool empty() const { return m_counts.empty(); }
  /// The extremes that occur.
  double least() const { return m_least; }
  double greatest() const { return m_greatest; }
  /// How many voxels have an intensity in each of `bins` equal parts of [low, high].
  std::vector<std::uint64_t> binned(double low, double high, std::size_t bins) const;
  /// The intensity below which that share of all voxels lies that are at least `from`.
  double quantile(double share, double from) const;
  /// What parts dark from bright best: the greatest variance between both (N. Otsu, IEEE Trans.
  /// SMC 9(1), 1979). The brightest hundredth counts as its darkest: few voxels say little.
  double otsu() const;

 private:
  double intensity(std::size_t code) const { return m_slope * (double(code) - 32768.0) + m_zero; }

  std::vector<std::uint64_t> m_counts;  ///< by intensity, ascending
  double m_slope = 1.0;                 ///< positive: turned round where the scan's is not
  double m_zero = 0.0;
  double m_least = 0.0;
  double m_greatest = 0.0;
};

}  // namespace sline::model
