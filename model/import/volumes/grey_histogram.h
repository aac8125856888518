// SPDX-License-Identifier: Apache-2.0
// Counts how often each intensity occurs in a scan, and derives thresholds from it.
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
  /// Returns the lowest intensity that occurs; `greatest` returns the highest.
  double least() const { return m_least; }
  double greatest() const { return m_greatest; }
  /// Returns how many voxels have an intensity in each of `bins` equal parts of [low, high].
  std::vector<std::uint64_t> binned(double low, double high, std::size_t bins) const;
  /// Returns the intensity below which the given share lies of all voxels that are at least `from`.
  double quantile(double share, double from) const;
  /// Returns the intensity that parts dark from bright best, by the greatest variance between both
  /// (N. Otsu, IEEE Trans. SMC 9(1), 1979). The brightest hundredth counts as its darkest, because
  /// few voxels say little.
  double otsu() const;

 private:
  double intensity(std::size_t code) const { return m_slope * (double(code) - 32768.0) + m_zero; }

  std::vector<std::uint64_t> m_counts;  ///< by intensity, ascending
  double m_slope = 1.0;                 ///< positive: reversed where the scan's is not
  double m_zero = 0.0;
  double m_least = 0.0;
  double m_greatest = 0.0;
};

}  // namespace sline::model
