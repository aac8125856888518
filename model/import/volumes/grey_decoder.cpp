// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/grey_decoder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <type_traits>

namespace sline::model {

namespace {

constexpr double leastCode = std::numeric_limits<std::int16_t>::min();
constexpr double mostCode = std::numeric_limits<std::int16_t>::max();

/// Holds the span of the numbers, to put them into 16 bits.
struct Span {
  double least = std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::lowest();
  bool whole = true;

  bool empty() const { return least > greatest; }
  bool fits() const { return whole && greatest - least <= mostCode - leastCode; }
};

template <class T>
void widen(Span& span, const VoxelRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const auto value = double(loadAs<T>(run.at + i * sizeof(T), run.swap));
    if (!std::isfinite(value))
      continue;
    span.least = std::min(span.least, value);
    span.greatest = std::max(span.greatest, value);
    if constexpr (std::is_floating_point_v<T>)
      span.whole = span.whole && value == std::floor(value);
  }
}

/// Converts by number = step × code + zero.
struct Coding {
  double step = 1.0;
  double zero = 0.0;
};

Coding codingOf(const Span& span) {
  if (span.empty())
    return {};
  if (span.fits()) {
    const bool asTheyAre = span.least >= leastCode && span.greatest <= mostCode;
    return {1.0, asTheyAre ? 0.0 : span.least - leastCode};
  }
  const double step = span.greatest / (mostCode - leastCode) - span.least / (mostCode - leastCode);
  return {step, span.least - leastCode * step};
}

template <class T>
void encode(std::vector<std::int16_t>& to, const VoxelRun& run, const Coding& coding,
            double least) {
  for (std::size_t i = 0; i < run.count; ++i) {
    auto value = double(loadAs<T>(run.at + i * sizeof(T), run.swap));
    if (!std::isfinite(value))
      value = least;
    const double code = std::round((value - coding.zero) / coding.step);
    to[run.first + i] = std::int16_t(std::clamp(code, leastCode, mostCode));
  }
}

Error greyFault(std::string reason, std::string remedy) {
  return Error{{}, {}, std::move(reason), std::move(remedy)};
}

/// Visits the runs of the first layer, each with its numbers' type as visit<T>(run).
template <class Visit>
Status forEachOfFirst(const VoxelLayout& layout, const VoxelBytes& stored, std::uint64_t all,
                      const std::function<bool()>& goesOn, const Visit& visit) {
  const std::uint64_t wanted = all / std::uint64_t(layout.layers);
  return forEachRun(layout, stored, all, goesOn, [&](VoxelRun run) {
    run.count = std::min<std::size_t>(run.count, wanted - run.first);
    withNumberType(run.type, [&]<class T>(T) { visit.template operator()<T>(run); });
    return run.first + run.count < wanted;
  });
}

Result<DecodedGrey> decodedGrey(const VoxelLayout& layout, const VoxelBytes& stored,
                                const std::function<bool()>& goesOn) {
  if (layout.layers > 1 && layout.interleaved)
    return greyFault("holds " + std::to_string(layout.layers) + " values in each voxel",
                     "Export a volume with one intensity per voxel");
  const std::uint64_t all = TRY(voxelCount(layout, stored));
  Span span{leastCode, mostCode};
  const bool fits = layout.type == ScalarType::int8 || layout.type == ScalarType::uint8 ||
                    layout.type == ScalarType::int16;
  if (stored.text || !fits) {
    span = {};
    const auto look = [&]<class T>(const VoxelRun& run) { widen<T>(span, run); };
    TRY(forEachOfFirst(layout, stored, all, goesOn, look));
  }
  if (span.empty())
    return greyFault("none of its voxels has a value that is a number", "Export the volume again");
  const Coding coding = codingOf(span);
  DecodedGrey grey;
  grey.volume.slope = layout.slope * coding.step;
  grey.volume.intercept = layout.slope * coding.zero + layout.intercept;
  grey.roundedBy = span.fits() ? 0.0 : 0.5 * std::abs(grey.volume.slope);
  if (!std::isnormal(coding.step) || !std::isnormal(grey.volume.slope) ||
      !std::isfinite(grey.volume.intercept) || !std::isfinite(32768.0 * grey.volume.slope))
    return greyFault("its intensities span more than can be computed with",
                     "Export the volume again, without values that only mark what is missing");
  grey.volume.size = glm::ivec3(layout.size);
  grey.volume.voxels.resize(all / std::uint64_t(layout.layers));
  const auto take = [&]<class T>(const VoxelRun& run) {
    encode<T>(grey.volume.voxels, run, coding, span.least);
  };
  TRY(forEachOfFirst(layout, stored, all, goesOn, take));
  return grey;
}

}  // namespace

Result<DecodedGrey> decodeGrey(const VoxelLayout& layout, const VoxelBytes& stored,
                               const std::function<bool()>& goesOn) {
  Result<DecodedGrey> grey = [&]() -> Result<DecodedGrey> {
    try {
      return decodedGrey(layout, stored, goesOn);
    } catch (const std::bad_alloc&) {
      return greyFault("needs more memory than there is", "Close other programs");
    }
  }();
  if (grey)
    return grey;
  Error error = grey.error();
  error.file = stored.file;
  return error;
}

}  // namespace sline::model
