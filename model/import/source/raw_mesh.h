// SPDX-License-Identifier: Apache-2.0
// Describes the result of a reader: one surface as it stands in its file, before frame, unit,
// repair and smoothing are decided.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/geometry/mesh.h"
#include "model/import/source/backbone.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Says where the x, y and z of a file point to in the patient (LPS: left, posterior, superior;
/// RAS: right, anterior, superior). LAS and RPS are mirror images of these; `file` leaves
/// coordinates alone. laterality.h describes each.
enum class Frame { lps, ras, las, rps, file };

struct GreyVolume;  // volumes/grey_volume.h

/// What RawMesh::unitReason says, or begins with, where the format or the file's own header states
/// the unit: a scanner's file is in the millimetres that it says. Others are by custom.
inline constexpr std::string_view dicomUnit = "DICOM: millimetres";
inline constexpr std::string_view statedUnit = "header: ";
constexpr bool isUnitStated(std::string_view reason) {
  return reason == dicomUnit || reason.starts_with(statedUnit);
}

struct RawMesh {
  std::string name;                  ///< the group's or node's name in the file; may be empty
  std::vector<std::string> groups;   ///< enclosing named groups in the file, outermost first
  std::string origin;                ///< shown in place of the file's name, which may name the
                                     ///< patient
  std::vector<glm::vec3> positions;  ///< in the file's own coordinates and unit
  std::vector<Triangle> triangles;   ///< polygons and strips already cut into triangles
  std::optional<Colour> colour;      ///< where the file gives the surface one colour
  std::optional<Opacity> opacity;
  std::optional<Frame> frame;       ///< set where the file's own header says so
  std::string frameReason;          ///< the part of the header that says so
  float millimetresPerUnit = 1.0f;  ///< glTF: 1000 (its unit is the metre)
  std::string unitReason;           ///< the feature of the file or its format that fixes the unit;
                                    ///< empty: none does, and it may be guessed
  bool yUp = false;  ///< +y up and +z to the front of an object that faces its viewer, not +z up
                     ///< and −y to the front; `frame` is that after a quarter turn about x
                     ///< (uprightToLps)
  bool onlySideOpen = false;    ///< +y anterior and +z superior are known, and the frame says
                                ///< only which way x runs: LPS mirrors it, in place of a turn
  std::string file;             ///< its own file's name where several were read together
  bool smooth = false;          ///< made smooth by its reader: not smoothed or refined again
  std::optional<bool> visible;  ///< set where the reader would rather hide it at first
  std::optional<MoleculeOrigin> molecule;  ///< cut from a molecule: named, grouped and coloured by
                                           ///< its reader, not by anatomy
  float displacement = 0.0f;   ///< the farthest that the reader moved a vertex, in the file's unit
  float sliceDistance = 0.0f;  ///< of the slices that it was cut from, in the file's unit, where
                               ///< their steps may still show; else 0
  std::optional<Threshold> threshold;  ///< made it from a scan; has resolved bounds
  /// Of the labelled voxels that it was made of, in the file's unit; absent: of none.
  std::optional<double> voxelVolume;
};

/// Holds a scan as it stands in its file.
struct RawScan {
  std::string file;  ///< as RawMesh::file
  std::shared_ptr<const GreyVolume> volume;
};

/// Describes something left out or mended on the way in; the rest of the file was read.
struct ImportWarning {
  std::string file;
  std::string reason;
  bool operator==(const ImportWarning&) const = default;
};

struct RawMeshes {
  std::vector<RawMesh> meshes;
  std::vector<ImportWarning> warnings;
  std::vector<std::string> notes = {};  ///< actions that are no loss
  std::vector<RawScan> scans = {};      ///< where they are asked for
  std::uint64_t thereAlready = 0;       ///< structures left out by ReadOptions::isThere
};

}  // namespace sline::model
