// SPDX-License-Identifier: Apache-2.0
// Does what all readers do once a file's vertices and faces are known: cuts faces into triangles,
// judges faces that point nowhere, leaves out vertices that are no numbers, keeps the limits.
#pragma once

#include <algorithm>
#include <span>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/source.h"
#include "model/import/source/values.h"

namespace sline::model {

/// Holds faces as a file lists them. `place` in the file is kept for the highest index only: it is
/// where an index beyond the vertices is reported.
class FaceList {
 public:
  void reserve(std::size_t faces, std::size_t corners) {
    m_ends.reserve(faces);
    m_corners.reserve(corners);
  }
  void add(std::uint32_t vertex, const char* place) {
    if (vertex > m_highest || !m_highestPlace) {
      m_highest = vertex;
      m_highestPlace = place;
    }
    m_corners.push_back(vertex);
  }
  void close() { m_ends.push_back(std::uint32_t(m_corners.size())); }

  std::size_t size() const { return m_ends.size(); }
  std::size_t corners() const { return m_corners.size(); }
  std::span<const std::uint32_t> face(std::size_t i) const {
    const std::uint32_t first = i == 0 ? 0 : m_ends[i - 1];
    return std::span(m_corners).subspan(first, m_ends[i] - first);
  }
  std::uint32_t highest() const { return m_highest; }
  const char* highestPlace() const { return m_highestPlace; }

 private:
  std::vector<std::uint32_t> m_corners;
  std::vector<std::uint32_t> m_ends;
  std::uint32_t m_highest = 0;
  const char* m_highestPlace = nullptr;
};

/// Cuts a triangle strip: every other triangle is turned so that all face the same way. Triangles
/// with a repeated corner only steer the strip and are left out. `place` is as in FaceList::add.
void addStrip(std::span<const std::uint32_t> strip, FaceList& faces, const char* place);

/// Counts how the faces of a file fared.
struct CutTally {
  std::size_t faces = 0;
  std::size_t outOfRange = 0;
  std::size_t tooShort = 0;  ///< fewer than three corners
  std::size_t vertices = 0;  ///< number of vertices in the file
};

/// Denotes faces [first, last) of a list.
struct FaceRange {
  const FaceList& faces;
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Appends the triangles of the faces; faulty ones are counted and left out.
void cutFaces(const FaceRange& range, std::span<const glm::vec3> positions,
              std::vector<Triangle>& triangles, CutTally& tally);

enum class BadFaces { areErrors, fewAreDropped };

/// Judges a tally: `fewAreDropped` lets less than one face in a hundred go with a warning.
Status judge(const Source& source, const FaceList& faces, const CutTally& tally, BadFaces policy,
             std::vector<ImportWarning>& warnings);

/// Keeps a copy of the vertices that triangles use, in the file's order, and renumbers the
/// triangles. `scratch` is as long as `positions` or empty and is kept between calls.
void keepUsed(std::span<const glm::vec3> positions, std::vector<std::uint32_t>& scratch,
              RawMesh& mesh);

/// Adds a finished surface. Triangles at vertices that are no finite numbers are left out with a
/// warning while such vertices are at most a tenth (else it is an error); a surface without
/// triangles is left out with a warning.
Status finish(const Source& source, RawMesh mesh, RawMeshes& into);

/// Cuts, judges and finishes the one surface of a file; returns an error where no triangle is left.
Result<RawMeshes> assemble(const Source& source, RawMesh mesh, const FaceList& faces,
                           BadFaces policy, std::vector<ImportWarning> warnings = {});

}  // namespace sline::model
