// SPDX-License-Identifier: Apache-2.0
// Lists the kinds of file that hold surfaces, and is the one door to their readers.
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
  /// Reads the file; null where files of the kind are read in a process of their own
  /// (worker/reading_child.h), by `name`.
  Result<RawMeshes> (*read)(const std::filesystem::path&, const ReadOptions&);
  bool volume = false;  ///< holds voxels: those of a folder are read together (readVolumeSet)
  bool packs = false;   ///< may be packed by gzip and be called ".obj.gz"
  /// Tells, where other programs use the ending too, whether a file that was found, not named, is
  /// of this kind.
  bool (*isOne)(const std::filesystem::path&) = nullptr;
};

/// Names the kind of DICOM files.
inline constexpr std::string_view dicomKind = "DICOM";

/// Returns all kinds, in the order messages and dialogs list them.
std::span<const FileKind> fileKinds();
/// Returns ".obj, .stl, … or .glb, many of them packed (.gz) too".
std::string surfaceExtensions();
/// Returns the endings that files of the kinds may have: ".obj", ".obj.gz", …
std::vector<std::string> surfaceEndings();

/// Tells whether the name ends with `ending`, case ignored, and has something before it.
bool endsLike(std::string_view name, std::string_view ending);

/// Returns true for a name that ends like one of the kinds (case ignored), and for a file without
/// such an ending that has content of DICOM, as that is how DICOM files are often called.
bool isSurfaceFile(const std::filesystem::path& file);
/// Tells whether a surface file is to be read where it lies in a folder: where other programs use
/// the ending too, its content must say that it is one.
bool isSurfaceFileInFolder(const std::filesystem::path& file);
/// Tells whether a surface file is DICOM.
bool isDicomFile(const std::filesystem::path& file);
/// Tells whether a surface file is a label volume.
bool isVolumeFile(const std::filesystem::path& file);
/// Tells whether the name ends like that of an archive, in which there may be any files.
bool isArchive(const std::filesystem::path& file);
/// Returns the file's name without the ending that tells its kind: "liver" of "liver.nii.gz".
std::string stemOf(const std::filesystem::path& file);

/// Reads the file by the reader that its name's ending asks for; an unsupported kind is an error
/// that lists the supported ones. Errors and limits are those of the readers (readers/readers.h).
Result<RawMeshes> readSurfaces(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace sline::model
