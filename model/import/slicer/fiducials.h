// SPDX-License-Identifier: Apache-2.0
// Reads 3D Slicer's files of points and lines: .fcsv (Slicer 3 and 4) and .mrk.json (Slicer 4.11
// and later).
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "model/import/source/raw_mesh.h"
#include "model/scene/annotation.h"

namespace sline::model {

/// Describes a point (kind pin) or a line (kind distance).
struct Fiducial {
  AnnotationKind kind = AnnotationKind::pin;
  std::vector<glm::dvec3> places;  ///< in the file's coordinates, millimetres
  std::string text;
  std::optional<Colour> colour;
  bool selected = true;  ///< Slicer draws these in its second colour
  bool visible = true;
  bool locked = false;
  Frame frame = Frame::ras;
};

struct Fiducials {
  std::vector<Fiducial> items;
  std::vector<ImportWarning> warnings;
};

/// Tells whether the file is one of fiducials by the name's ending; case is ignored.
bool isFiducialFile(const std::filesystem::path& file);
/// Returns ".fcsv or .mrk.json".
std::string fiducialExtensions();

/// Reads the file; the error says which line or member is wrong. Curves, angles, planes and regions
/// are left out with a warning. Where the file names no coordinate system, .fcsv is RAS and
/// .mrk.json LPS.
Result<Fiducials> readFiducials(const std::filesystem::path& file, const ReadLimits& limits);

/// Returns an annotation with its places in LPS, in no scene yet.
Annotation annotationOf(const Fiducial& fiducial);

}  // namespace sline::model
