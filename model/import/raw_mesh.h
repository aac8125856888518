// SPDX-License-Identifier: Apache-2.0
// What a reader hands on: one surface as it stands in its file, before frame, unit, repair and
// smoothing are decided.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/geometry/mesh.h"

namespace sline::model {

/// How the x, y, z of a file map to the patient (LPS: left, posterior, superior; RAS: right,
/// anterior, superior); `file` leaves coordinates alone.
enum class Frame { lps, ras, file };

struct RawMesh {
  std::string name;                  ///< the group's or node's name in the file; may be empty
  std::vector<std::string> groups;   ///< enclosing named groups in the file, outermost first
  std::vector<glm::vec3> positions;  ///< in the file's own coordinates and unit
  std::vector<Triangle> triangles;   ///< polygons and strips already cut into triangles
  std::optional<Colour> colour;      ///< where the file gives the surface one colour
  std::optional<Opacity> opacity;
  std::optional<Frame> frame;       ///< where the file's own header says so
  std::string frameReason;          ///< which part of the header
  float millimetresPerUnit = 1.0f;  ///< glTF: 1000 (its unit is the metre)
  bool yUp = false;                 ///< glTF: +y up, +x patient left, +z to the front
};

/// Something left out or mended on the way in; the rest of the file was read.
struct ImportWarning {
  std::string file;
  std::string reason;
  bool operator==(const ImportWarning&) const = default;
};

struct RawMeshes {
  std::vector<RawMesh> meshes;
  std::vector<ImportWarning> warnings;
};

/// Limits every reader keeps, so that a small file cannot ask for a large machine.
struct ReadLimits {
  std::uint64_t fileBytes = std::uint64_t(4) << 30;
  std::uint64_t vertices = 100'000'000;
  std::uint64_t triangles = 200'000'000;
};

}  // namespace sline::model
