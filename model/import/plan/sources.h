// SPDX-License-Identifier: Apache-2.0
// What the user named, as the list of files to read.
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
  std::filesystem::path path;                            ///< of the folder or scene
  std::optional<SlicerScene> scene;                      ///< kind slicer
  std::shared_ptr<const SlicerBundle> bundle = nullptr;  ///< where the scene's files are, if there
};

struct SourceFile {
  std::filesystem::path file;
  std::size_t source = 0;            ///< in Sources::sources
  std::vector<std::string> folders;  ///< below the folder named, as they are called
  std::optional<std::size_t> model;  ///< in the scene's models
  std::uintmax_t bytes = 0;
  /// Further label volumes of the same folder, which are read with this one.
  std::vector<std::filesystem::path> together;
  /// A DICOM image of CT, MR or PET; those of its folder are `together`.
  bool slice = false;
};

struct Sources {
  std::vector<ImportSource> sources;  ///< all mesh files named one by one are one source
  std::vector<SourceFile> files;
  std::vector<Fiducial> fiducials;  ///< of files named one by one
  std::vector<ImportWarning> warnings;
  std::optional<Error> firstError;  ///< of an input that gave nothing
};

/// Whether there is a point or a line among them, in a scene or beside it.
bool haveFiducials(const Sources& sources);

/// What becomes of the slices that scanners write as DICOM: nothing but a word that they hold no
/// segmentation, or files to read.
enum class ScannerSlices { leftOut, read };

/// Inputs that cannot be used become warnings; `firstError` tells about the first of them.
Sources collectSources(std::span<const std::filesystem::path> inputs, const ReadLimits& limits,
                       ScannerSlices slices);

/// A measure of how much there is to read; never 0.
double bytesOf(const Sources& sources);

/// The error to give where no surface came of them.
Error nothingRead(const Sources& sources, const std::vector<ImportWarning>& warnings);

}  // namespace sline::model
