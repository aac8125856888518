// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/voxel_decoder.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "model/import/volumes/label_codes.h"

namespace sline::model {

namespace {

Error labelFault(std::string reason, std::string remedy) {
  return Error{{}, {}, std::move(reason), std::move(remedy)};
}

class Decoder {
 public:
  Decoder(const VoxelLayout& layout, std::uint64_t count)
      : m_layout(layout),
        m_layers(std::size_t(layout.layers)),
        m_perLayer(std::size_t(count) / m_layers),
        m_codes(m_layers),
        m_volumes(m_layers) {
    for (LabelVolume& volume : m_volumes) {
      volume.size = glm::ivec3(m_layout.size);
      volume.voxels.resize(m_perLayer);
    }
  }

  /// Takes the run; returns false as soon as the values are certain to be no labels.
  bool take(const VoxelRun& run) {
    withNumberType(run.type, [&]<class T>(T) { takeAs<T>(run); });
    return std::none_of(m_codes.begin(), m_codes.end(),
                        [](const LabelCodes& codes) { return codes.refused(); });
  }

  DecodedLabels finish() && {
    for (std::size_t i = 0; i < m_layers; ++i) {
      std::vector<std::uint16_t>& voxels = m_volumes[i].voxels;
      const auto empty = std::size_t(std::count(voxels.begin(), voxels.end(), 0));
      if (std::string reason = m_codes[i].refusal(voxels.size() - empty); !reason.empty())
        return {{}, std::move(reason)};
      m_volumes[i].labels = m_codes[i].sorted(voxels);
    }
    return {std::move(m_volumes), {}};
  }

 private:
  /// Returns the label; one that is off a whole number by the rounding of its scale is that number.
  double scaledLabel(double stored) const {
    const double value = m_layout.slope * stored + m_layout.intercept;
    const double whole = std::round(value);
    return std::abs(value - whole) <= 1e-6 * std::max(1.0, std::abs(whole)) ? whole : value;
  }

  template <class T>
  void takeAs(const VoxelRun& run) {
    if (m_layers == 1 && !m_layout.scaled()) {
      takeOfOneLayer<T>(run);
      return;
    }
    for (std::size_t i = 0; i < run.count; ++i) {
      const T value = loadAs<T>(run.at + i * sizeof(T), run.swap);
      if (m_layout.scaled())
        put(run.first + i, scaledLabel(double(value)));
      else
        put(run.first + i, value);
    }
  }

  /// Most voxels have the value of the one before.
  template <class T>
  void takeOfOneLayer(const VoxelRun& run) {
    std::uint16_t* to = m_volumes[0].voxels.data() + run.first;
    T last = loadAs<T>(run.at, run.swap);
    std::uint16_t code = m_codes[0](last);
    for (std::size_t i = 0; i < run.count; ++i) {
      const T value = loadAs<T>(run.at + i * sizeof(T), run.swap);
      if (value != last) {
        code = m_codes[0](value);
        last = value;
      }
      to[i] = code;
    }
  }

  template <class T>
  void put(std::size_t index, T value) {
    const std::size_t layer = m_layout.interleaved ? index % m_layers : index / m_perLayer;
    const std::size_t voxel = m_layout.interleaved ? index / m_layers : index % m_perLayer;
    m_volumes[layer].voxels[voxel] = m_codes[layer](value);
  }

  const VoxelLayout& m_layout;
  std::size_t m_layers;
  std::size_t m_perLayer;
  std::vector<LabelCodes> m_codes;
  std::vector<LabelVolume> m_volumes;
};

Result<DecodedLabels> decoded(const VoxelLayout& layout, const VoxelBytes& stored,
                              const std::function<bool()>& goesOn) {
  constexpr std::int64_t mostLayers = 512;
  if (layout.layers > mostLayers)
    return labelFault("holds " + std::to_string(layout.layers) + " volumes in one, at most " +
                          std::to_string(mostLayers) + " are read",
                      "Export one label volume");
  const std::uint64_t count = TRY(voxelCount(layout, stored));
  try {
    Decoder decoder(layout, count);
    TRY(forEachRun(layout, stored, count, goesOn,
                   [&](const VoxelRun& run) { return decoder.take(run); }));
    return std::move(decoder).finish();
  } catch (const std::bad_alloc&) {
    return labelFault("needs more memory than there is", "Close other programs");
  }
}

}  // namespace

Result<DecodedLabels> decodeLabels(const VoxelLayout& layout, const VoxelBytes& stored,
                                   const std::function<bool()>& goesOn) {
  Result<DecodedLabels> labels = decoded(layout, stored, goesOn);
  if (labels)
    return labels;
  Error error = labels.error();
  error.file = stored.file;
  return error;
}

}  // namespace sline::model
