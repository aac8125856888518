// SPDX-License-Identifier: Apache-2.0
// Which kinds of file hold surfaces, and the one door to their readers.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

struct FileKind {
  std::string_view extension;  ///< lower case, with its dot: ".obj"
  std::string_view name;
  /// Null where it is read in a process of its own (worker/reading_child.h), by `name`.
  Result<RawMeshes> (*read)(const std::filesystem::path&, const ReadOptions&);
  bool volume = false;  ///< holds voxels: those of a folder are read together (readVolumeSet)
  bool packs = false;   ///< may be packed by gzip and be called ".obj.gz"
  /// Where others use the ending too: whether a file that was found, not named, is of this kind.
  bool (*isOne)(const std::filesystem::path&) = nullptr;
};

/// The name of that kind.
inline constexpr std::string_view dicomKind = "DICOM";

/// All kinds, in the order messages and dialogs list them.
std::span<const FileKind> fileKinds();
/// ".obj, .stl, … or .glb, many of them packed (.gz) too"
std::string surfaceExtensions();
/// How files of the kinds may end: ".obj", ".obj.gz", …
std::vector<std::string> surfaceEndings();

/// Whether the name ends with `ending`, case ignored, and has something before it.
bool endsLike(std::string_view name, std::string_view ending);

/// True for a name that ends like one of the kinds (case ignored), and for a file without such an
/// ending whose content says DICOM, as that is how DICOM files are often called.
bool isSurfaceFile(const std::filesystem::path& file);
/// True for those of them that a folder is asked for: where others use the ending too, the content
/// says that it is one.
bool isSurfaceFileInFolder(const std::filesystem::path& file);
/// True for those of them that are DICOM.
bool isDicomFile(const std::filesystem::path& file);
/// True for those of them that are label volumes.
bool isVolumeFile(const std::filesystem::path& file);
/// The file's name without the ending that tells its kind: "liver" of "liver.nii.gz".
std::string stemOf(const std::filesystem::path& file);

/// Picks the reader by the name's ending; an unsupported kind is an error that lists the supported
/// ones. Errors and limits are those of the readers (readers/readers.h).
Result<RawMeshes> readSurfaces(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace sline::model
