// SPDX-License-Identifier: Apache-2.0
// Lists the files to read, from what the user named.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/import/plan/import.h"
#include "model/import/slicer/bundle.h"
#include "model/import/slicer/fiducials.h"
#include "model/import/slicer/mrml_scene.h"

namespace sline::model {

struct ImportSource {
  enum class Kind { files, folder, slicer } kind = Kind::files;
  std::filesystem::path path;                            ///< path of the folder or scene
  std::optional<SlicerScene> scene;                      ///< kind slicer
  std::shared_ptr<const SlicerBundle> bundle = nullptr;  ///< holds the scene's files, if unpacked
};

struct SourceFile {
  std::filesystem::path file;
  std::size_t source = 0;            ///< in Sources::sources
  std::vector<std::string> folders;  ///< folders below the named one, by their names
  std::optional<std::size_t> model;  ///< index among the scene's models
  std::uintmax_t bytes = 0;
  /// Lists further label volumes of the same folder, which are read with this one.
  std::vector<std::filesystem::path> together;
  /// Is true for a DICOM image of CT, MR or PET; those of its folder are `together`.
  bool slice = false;
  /// What a scene of 3D Slicer in the same folder says of the file's coordinates.
  std::optional<SlicerFileFrame> told = {};
};

struct Sources {
  std::vector<ImportSource> sources;  ///< all mesh files named one by one are one source
  std::vector<SourceFile> files;
  std::vector<Fiducial> fiducials;  ///< from files named one by one
  std::vector<ImportWarning> warnings;
  std::optional<Error> firstError;  ///< about an input that gave nothing
};

/// Tells whether there is a point or a line among the sources, in a scene or beside it.
bool haveFiducials(const Sources& sources);

/// Says what happens to the slices that scanners write as DICOM: they are left out with a note that
/// they hold no segmentation, or read.
enum class ScannerSlices { leftOut, read };

/// Collects the sources. Inputs that cannot be used become warnings; `firstError` describes the
/// first of them.
Sources collectSources(std::span<const std::filesystem::path> inputs, const ReadLimits& limits,
                       ScannerSlices slices);

/// Returns a measure of how much there is to read; never 0.
double bytesOf(const Sources& sources);

/// Returns the error to give where the sources yielded no surface.
Error nothingRead(const Sources& sources, const std::vector<ImportWarning>& warnings);

}  // namespace sline::model
