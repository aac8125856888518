// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/threshold_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <sstream>

#include "model/base/parallel.h"
#include "model/import/volumes/grey_refinement.h"
#include "model/import/volumes/label_surfaces.h"
#include "model/import/volumes/net_relaxation.h"
#include "model/import/volumes/threshold_presets.h"
#include "model/import/volumes/voxel_pieces.h"

namespace sline::model {

namespace {

constexpr double specksOfUnnamed = 100.0;  // mm³

Error thresholdFault(std::string reason, std::string remedy) {
  return Error{{}, {}, std::move(reason), std::move(remedy)};
}

/// Writes volumes as people do.
std::string volumeText(double cubicMillimetres) {
  const bool large = cubicMillimetres >= 1000.0;
  const double value = large ? cubicMillimetres / 1000.0 : cubicMillimetres;
  std::ostringstream text;
  text << (value >= 10.0 ? std::round(value) : std::round(10.0 * value) / 10.0)
       << (large ? " cm³" : " mm³");
  return text.str();
}

std::string boundsText(const IntensityBounds& bounds) {
  std::ostringstream text;
  if (bounds.low && bounds.high)
    text << *bounds.low << " to " << *bounds.high;
  else if (bounds.low)
    text << *bounds.low << " and more";
  else
    text << *bounds.high << " and less";
  return text.str();
}

class Thresholder {
 public:
  Thresholder(const GreyVolume& volume, Threshold threshold, const ReadOptions& options)
      : m_volume(volume),
        m_threshold(std::move(threshold)),
        m_options(options),
        m_bounds{m_threshold.low, m_threshold.high} {
    if (const ThresholdPreset* preset = presetNamed(m_threshold.name))
      m_preset = *preset;
  }

  Result<ThresholdSurface> run() {
    if (!makeMask())
      return thresholdFault("nothing in it has an intensity of " + boundsText(m_bounds),
                            "Choose other bounds");
    TRY(keepPieces());
    RawMeshes surfaces =
        TRY(placedSurfaces(m_mask, m_options, [this](const LabelNet& net) { return placed(net); }));
    ThresholdSurface result{std::move(surfaces.meshes.front()), std::move(m_notes)};
    result.mesh.displacement = m_displacement;
    result.mesh.sliceDistance = 0.0f;  // intensities tell where it lies between voxels
    result.mesh.threshold = m_threshold;
    result.mesh.voxelVolume.reset();  // it lies between voxels
    return result;
  }

 private:
  double intensity(std::size_t voxel) const {
    return m_volume.slope * double(m_volume.voxels[voxel]) + m_volume.intercept;
  }
  double voxelVolume() const { return std::abs(glm::determinant(glm::dmat3(m_volume.toLps))); }

  /// Makes the mask; returns false where nothing is within the bounds.
  bool makeMask() {
    std::vector<std::uint8_t> within(65536);
    for (std::size_t code = 0; code < within.size(); ++code)
      within[code] =
          m_bounds.contain(m_volume.slope * (double(code) - 32768.0) + m_volume.intercept);
    m_mask.size = m_volume.size;
    m_mask.toLps = m_volume.toLps;
    m_mask.frame = m_volume.frame;
    m_mask.frameReason = m_volume.frameReason;
    m_mask.onlySideOpen = m_volume.onlySideOpen;
    m_mask.unitReason = m_volume.unitReason;
    m_mask.labels = {{1, m_threshold.name, {}, {}}};
    m_mask.voxels.resize(m_volume.voxels.size());
    parallelFor(m_mask.voxels.size(), std::size_t(1) << 16, [&](std::size_t i) {
      m_mask.voxels[i] = within[std::size_t(std::ptrdiff_t(m_volume.voxels[i]) + 32768)];
    });
    return std::any_of(m_mask.voxels.begin(), m_mask.voxels.end(), [](auto v) { return v != 0; });
  }

  Status keepPieces() {
    const std::optional<VoxelPieces> pieces = VoxelPieces::find(m_mask, false, m_options.goesOn);
    if (!pieces)
      return noPieces();
    const std::vector<std::uint64_t>& sizes = pieces->sizes();
    const std::uint64_t largest = *std::max_element(sizes.begin(), sizes.end());
    const double specks = std::min(
        (m_preset ? m_preset->specksMm3 : specksOfUnnamed) / std::max(voxelVolume(), 1e-30),
        1e-3 * double(largest));
    const bool one = m_preset && m_preset->outerSurface;
    std::vector<bool> leftOut(sizes.size());
    std::uint64_t count = 0;
    std::uint64_t voxels = 0;
    bool kept = false;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      leftOut[i] = one ? kept || sizes[i] != largest : double(sizes[i]) < specks;
      kept = kept || !leftOut[i];
      count += leftOut[i];
      voxels += leftOut[i] ? sizes[i] : 0;
    }
    if (count > 0) {
      pieces->invert(m_mask, leftOut);
      m_notes.push_back("\"" + m_threshold.name + "\": " + std::to_string(count) +
                        (count == 1 ? " piece" : " pieces") + " of " +
                        volumeText(double(voxels) * voxelVolume()) + " in all left out" +
                        (one ? ", as only the largest is the body's"
                             : ", each smaller than " + volumeText(specks * voxelVolume())));
    }
    if (one)
      fillSlices(m_mask, longAxis());
    return fillCavities(specks);
  }

  Error noPieces() const {
    return m_options.goesOn() ? thresholdFault("with an intensity of " + boundsText(m_bounds) +
                                                   " it falls into specks of single voxels",
                                               "Choose bounds away from the noise")
                              : thresholdFault("the import was cancelled", "Import it again");
  }

  /// Fills cavities as small as specks, which are noise like them; they cannot be seen.
  Status fillCavities(double specks) {
    const std::optional<VoxelPieces> hollows = VoxelPieces::find(m_mask, true, m_options.goesOn);
    if (!hollows)
      return noPieces();
    std::vector<bool> filled;
    for (const std::uint64_t size : hollows->sizes())
      filled.push_back(double(size) < specks);
    hollows->invert(m_mask, filled);
    return Unit{};
  }

  /// Returns the axis of the grid along the body.
  int longAxis() const {
    int best = 2;
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 along = glm::dvec3(m_volume.toLps[axis]);
      const double share = std::abs(along.z) / std::max(glm::length(along), 1e-30);
      if (share > most) {
        most = share;
        best = axis;
      }
    }
    return best;
  }

  /// Returns how far between two voxels' middles the bounds are crossed, from the one inside; the
  /// middle where their intensities do not tell: voxels that were filled or left out, and the
  /// volume's border.
  double crossing(double inside, std::optional<double> outside) const {
    if (!outside || !m_bounds.contain(inside) || m_bounds.contain(*outside))
      return 0.5;
    const double bound = m_bounds.low && *outside < *m_bounds.low ? *m_bounds.low : *m_bounds.high;
    return std::clamp((bound - inside) / (*outside - inside), 0.02, 0.98);
  }

  std::optional<double> intensityAt(const glm::ivec3& p) const {
    const glm::ivec3& size = m_volume.size;
    if (p.x < 0 || p.y < 0 || p.z < 0 || p.x >= size.x || p.y >= size.y || p.z >= size.z)
      return std::nullopt;
    return intensity(m_mask.at(p.x, p.y, p.z));
  }

  std::vector<glm::vec3> placed(const LabelNet& made) {
    std::vector<glm::vec3> at(made.sheets.cellOf.size(), glm::vec3(0.0f));
    std::vector<float> counts(at.size(), 0.0f);
    for (const LabelSheets::Quad& quad : made.sheets.quadsOf(1)) {
      const SurfaceNet::Cell& far = made.net.cells[quad.face / 8];
      const auto axis = int(quad.face % 8 / 2);
      glm::ivec3 inside(far.x, far.y, far.z);
      glm::ivec3 outside = inside;
      ++(quad.face % 2 != 0 ? inside : outside)[axis];
      const glm::ivec3 corner = made.box.low() - 1;
      const double share =
          crossing(intensityAt(inside + corner).value_or(0.0), intensityAt(outside + corner));
      const glm::vec3 place =
          (glm::vec3(inside) + float(share) * glm::vec3(outside - inside) - 1.0f) * made.spacing;
      for (const std::uint32_t node : quad.nodes) {
        at[made.sheets.pointOf[node]] += place;
        counts[made.sheets.pointOf[node]] += 1.0f;
      }
    }
    for (std::size_t i = 0; i < at.size(); ++i)
      at[i] /= std::max(counts[i], 1.0f);
    constexpr std::size_t pointSteps = 120'000'000;
    Relaxation relaxation = relaxationHere();
    relaxation.steps = std::min(relaxation.steps, 30 + int(pointSteps / (at.size() + 1)));
    relaxation.from = at;
    std::vector<glm::vec3> relaxedAt =
        relaxed(made.net, made.sheets, made.spacing, relaxation, m_options.goesOn);
    for (std::size_t i = 0; i < relaxedAt.size(); ++i)
      m_displacement = std::max(m_displacement, glm::distance(at[i], relaxedAt[i]));
    return relaxedAt;
  }

  /// Returns the relaxation that takes the voxels' steps and noise away; skin is even over a wider
  /// reach.
  Relaxation relaxationHere() const {
    if (m_options.smoothing.mode == Smoothing::Mode::off)
      return {.steps = 0, .looseSteps = 0};
    if (m_options.smoothing.mode == Smoothing::Mode::steps)
      return {.steps = m_options.smoothing.steps, .looseSteps = 0};
    return m_preset && m_preset->outerSurface ? Relaxation()
                                              : Relaxation{.steps = 40, .looseSteps = 20};
  }

  const GreyVolume& m_volume;
  const Threshold m_threshold;
  const ReadOptions& m_options;
  std::optional<ThresholdPreset> m_preset;
  IntensityBounds m_bounds;
  LabelVolume m_mask;  ///< 1 where the structure is
  std::vector<std::string> m_notes;
  float m_displacement = 0.0f;
};

}  // namespace

Result<ThresholdSurface> thresholdSurface(const GreyVolume& volume, const Threshold& threshold,
                                          const ReadOptions& options) {
  // Bounds that depend on the scan's contents are found in the measured data.
  const IntensityBounds bounds = TRY(boundsOf(threshold, volume));
  const ThresholdPreset* preset = presetNamed(threshold.name);
  const bool even = preset && preset->outerSurface;
  const std::optional<GreyVolume> finer = even ? std::nullopt : refinedScan(volume);
  return Thresholder(finer ? *finer : volume, {threshold.name, bounds.low, bounds.high}, options)
      .run();
}

}  // namespace sline::model
