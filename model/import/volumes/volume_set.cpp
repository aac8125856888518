// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/volume_set.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>

#include "model/base/parallel.h"
#include "model/import/volumes/volume_readers.h"
#include "model/import/volumes/volume_surfaces.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Volumes of one grid that are kept in memory to be filled up.
constexpr std::size_t mostOpen = 6;
constexpr std::size_t mostLabels = 65'000;
constexpr std::size_t atATime = 3;

bool sameGrid(const LabelVolume& a, const LabelVolume& b) {
  if (a.size != b.size || a.frame != b.frame)
    return false;
  // Two programs may round the same place differently: a hundredth of a voxel is no difference.
  const double voxel = glm::length(glm::dvec3(a.toLps[0]));
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) {
      const double tolerance = column == 3 ? 1e-2 * voxel : 1e-2 * voxel / double(a.size[column]);
      if (!(std::abs(a.toLps[column][row] - b.toLps[column][row]) <= tolerance))
        return false;
    }
  return true;
}

bool overlap(const LabelVolume& a, const LabelVolume& b) {
  for (std::size_t i = 0; i < a.voxels.size(); ++i)
    if (a.voxels[i] != 0 && b.voxels[i] != 0)
      return true;
  return false;
}

/// Returns "liver" for "liver.nii.gz" and for "liver.seg.nrrd".
std::string nameOf(const fs::path& file) {
  fs::path name = file.filename();
  for (const char* ending : {".gz", ".nii", ".hdr", ".img", ".mgz", ".mgh", ".nrrd", ".nhdr",
                             ".mha", ".mhd", ".mnc", ".seg"})
    if (name.extension() == ending)
      name.replace_extension();
  return name.string();
}

/// Holds a volume under way and the file behind each of its labels.
struct Open {
  LabelVolume volume;
  std::vector<std::string> files;
};

class Set {
 public:
  Set(std::span<const fs::path> files, const ReadOptions& options)
      : m_files(files), m_options(options) {}

  Result<RawMeshes> read() {
    for (std::size_t first = 0; first < m_files.size(); first += atATime) {
      const std::size_t count = std::min(atATime, m_files.size() - first);
      std::vector<std::optional<Result<VolumeRead>>> found(count);
      parallelFor(count, 1,
                  [&](std::size_t i) { found[i] = readVolume(m_files[first + i], m_options); });
      for (std::size_t i = 0; i < count; ++i)
        take(m_files[first + i], std::move(*found[i]));
      if (!m_options.goesOn())
        return Error{m_files[first].string(), {}, "the import was cancelled", {}};
    }
    for (Open& open : m_open)
      TRY(close(open));
    if (!m_empty.empty())
      m_all.warnings.push_back(
          {m_files.front().parent_path().filename().string(),
           std::to_string(m_empty.size()) + " masks hold nothing and were left out: " + listed()});
    if (!m_all.meshes.empty() || !m_all.scans.empty())
      return std::move(m_all);
    if (m_firstError)
      return *m_firstError;
    return Error{m_files.front().string(),
                 {},
                 "the volume holds nothing but background",
                 "Choose a volume with structures"};
  }

 private:
  void take(const fs::path& file, Result<VolumeRead>&& found) {
    const std::string shown = file.filename().string();
    if (!found) {
      Error error = found.error();
      if (!m_firstError)
        m_firstError = error;
      error.file.clear();
      m_all.warnings.push_back({shown, "left out: " + error.text()});
      return;
    }
    std::error_code code;
    const std::uintmax_t bytes = fs::file_size(file, code);
    m_bytes += code ? 0 : bytes;
    if (found->scan.volume) {
      takeScan(shown, std::move(found->scan));
      return;
    }
    add(m_all.warnings, found->labels.warnings);
    for (LabelVolume& volume : found->labels.volumes) {
      if (volume.labels.empty())
        m_empty.push_back(nameOf(file));
      for (Label& label : volume.labels)
        if (label.name.empty())
          label.name = nameOf(file);
      if (!volume.labels.empty())
        place(std::move(volume), shown);
    }
  }

  template <class T>
  static void add(std::vector<T>& all, std::vector<T>& more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }

  void takeScan(const std::string& shown, GreyVolumeRead&& scan) {
    add(m_all.warnings, scan.warnings);
    add(m_all.notes, scan.notes);
    Result<RawMeshes> made = scanSurfaces({shown, std::move(scan.volume)}, m_options);
    if (!made) {
      m_firstError = m_firstError.value_or(made.error());
      m_all.warnings.push_back({shown, "left out: " + made.error().text()});
      return;
    }
    add(m_all.meshes, made->meshes);
    add(m_all.warnings, made->warnings);
    add(m_all.notes, made->notes);
    add(m_all.scans, made->scans);
  }

  void place(LabelVolume&& volume, const std::string& file) {
    for (Open& open : m_open) {
      if (!sameGrid(open.volume, volume) || overlap(open.volume, volume) ||
          open.volume.labels.size() + volume.labels.size() > mostLabels)
        continue;
      const auto before = std::uint16_t(open.volume.labels.size());
      for (std::size_t i = 0; i < volume.voxels.size(); ++i)
        if (volume.voxels[i] != 0)
          open.volume.voxels[i] = std::uint16_t(volume.voxels[i] + before);
      open.files.insert(open.files.end(), volume.labels.size(), file);
      std::move(volume.labels.begin(), volume.labels.end(), std::back_inserter(open.volume.labels));
      return;
    }
    std::vector<std::string> files(volume.labels.size(), file);
    m_open.push_back({std::move(volume), std::move(files)});
    if (m_open.size() <= mostOpen)
      return;
    if (const Status closed = close(m_open.front()); !closed)
      m_all.warnings.push_back({file, closed.error().text()});
    m_open.erase(m_open.begin());
  }

  /// Makes the surfaces.
  Status close(Open& open) {
    std::vector<std::string> names;
    for (const Label& label : open.volume.labels)
      names.push_back(label.name);
    // Surfaces come in the labels' order, without those that have no voxel; each carries its place
    // in the list as its name.
    for (std::size_t i = 0; i < names.size(); ++i)
      open.volume.labels[i].name = std::to_string(i);
    LabelVolumes volumes;
    volumes.volumes.push_back(std::move(open.volume));
    RawMeshes made = TRY(volumeSurfaces(volumes, m_bytes, m_options));
    for (RawMesh& mesh : made.meshes) {
      const std::size_t label = std::stoul(mesh.name);
      mesh.name = names[label];
      mesh.file = open.files[label];
      m_all.meshes.push_back(std::move(mesh));
    }
    return Unit{};
  }

  std::string listed() const {
    std::string list;
    for (std::size_t i = 0; i < m_empty.size() && i < 5; ++i)
      list += (i == 0 ? "" : ", ") + m_empty[i];
    return m_empty.size() > 5 ? list + ", …" : list;
  }

  std::span<const fs::path> m_files;
  const ReadOptions& m_options;
  std::vector<Open> m_open;
  std::vector<std::string> m_empty;
  std::optional<Error> m_firstError;
  std::uint64_t m_bytes = 0;
  RawMeshes m_all;
};

}  // namespace

Result<RawMeshes> readVolumeSet(std::span<const fs::path> files, const ReadOptions& options) {
  try {
    return Set(files, options).read();
  } catch (const std::bad_alloc&) {
    return Error{
        files.front().string(), {}, "needs more memory than there is", "Close other programs"};
  }
}

}  // namespace sline::model
