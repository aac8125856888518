// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/surface_assembly.h"

#include <cmath>

#include "model/import/source/polygon.h"

namespace sline::model {

namespace {
std::string countOf(std::size_t some, std::size_t all, const char* what) {
  return std::to_string(some) + " of " + std::to_string(all) + " " + what;
}

/// Removes vertices that are no numbers and the triangles that use them.
std::size_t dropNonFinite(RawMesh& mesh) {
  std::vector<std::uint32_t> renumbered(mesh.positions.size(), noVertex);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (isFinite(mesh.positions[i])) {
      mesh.positions[kept] = mesh.positions[i];
      renumbered[i] = kept++;
    }
  mesh.positions.resize(kept);
  const std::size_t before = mesh.triangles.size();
  std::erase_if(mesh.triangles, [&](Triangle& t) {
    for (std::uint32_t& corner : t) {
      corner = renumbered[corner];
      if (corner == noVertex)
        return true;
    }
    return false;
  });
  return before - mesh.triangles.size();
}
}  // namespace

void addStrip(std::span<const std::uint32_t> strip, FaceList& faces, const char* place) {
  for (std::size_t i = 2; i < strip.size(); ++i) {
    const std::uint32_t a = strip[i - 2];
    const std::uint32_t b = strip[i - 1];
    const std::uint32_t c = strip[i];
    if (a == b || b == c || a == c)
      continue;
    const bool odd = i % 2 == 1;
    faces.add(odd ? b : a, place);
    faces.add(odd ? a : b, place);
    faces.add(c, place);
    faces.close();
  }
}

void cutFaces(const FaceRange& range, std::span<const glm::vec3> positions,
              std::vector<Triangle>& triangles, CutTally& tally) {
  const auto& [faces, first, last] = range;
  tally.vertices = positions.size();
  triangles.reserve(triangles.size() + (last - first));
  const bool allInRange = faces.highest() < positions.size();
  tally.faces += last - first;
  for (std::size_t i = first; i < last; ++i) {
    const std::span<const std::uint32_t> face = faces.face(i);
    const auto isBeyond = [&](std::uint32_t v) { return v >= positions.size(); };
    if (!allInRange && std::any_of(face.begin(), face.end(), isBeyond))
      ++tally.outOfRange;
    else if (face.size() < 3)
      ++tally.tooShort;
    else
      cutPolygon(face, positions, triangles);
  }
}

Status judge(const Source& source, const FaceList& faces, const CutTally& tally, BadFaces policy,
             std::vector<ImportWarning>& warnings) {
  const std::size_t bad = tally.outOfRange;
  if (bad > 0) {
    const std::string reason =
        countOf(bad, tally.faces, "faces refer to vertices that do not exist") + " (there are " +
        std::to_string(tally.vertices) + " vertices)";
    if (policy == BadFaces::areErrors || bad * 100 >= tally.faces)
      return source.text().find('\0') == std::string_view::npos
                 ? source.atLine(faces.highestPlace(), reason)
                 : source.atByte(faces.highestPlace(), reason);
    warnings.push_back(source.warning(reason + "; they are left out"));
  }
  if (tally.tooShort > 0)
    warnings.push_back(source.warning(countOf(
        tally.tooShort, tally.faces, "faces have fewer than three corners and are left out")));
  return Unit{};
}

void keepUsed(std::span<const glm::vec3> positions, std::vector<std::uint32_t>& scratch,
              RawMesh& mesh) {
  scratch.resize(positions.size(), noVertex);
  std::vector<std::uint32_t> used;
  used.reserve(std::min(positions.size(), 3 * mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (scratch[v] == noVertex) {
        scratch[v] = 0;
        used.push_back(v);
      }
  std::sort(used.begin(), used.end());
  mesh.positions.resize(used.size());
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    scratch[used[i]] = i;
    mesh.positions[i] = positions[used[i]];
  }
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      v = scratch[v];
  for (const std::uint32_t v : used)
    scratch[v] = noVertex;
}

Status finish(const Source& source, RawMesh mesh, RawMeshes& into) {
  const std::string name = mesh.name.empty() ? std::string() : " in " + inQuotes(mesh.name);
  if (mesh.positions.size() > source.limits().vertices ||
      mesh.triangles.size() > source.limits().triangles)
    return source.whole(std::to_string(mesh.positions.size()) + " vertices and " +
                            std::to_string(mesh.triangles.size()) +
                            " triangles are more than the limit" + name,
                        "Reduce the mesh");
  const auto isBad = [](const glm::vec3& p) { return !isFinite(p); };
  const auto first = std::find_if(mesh.positions.begin(), mesh.positions.end(), isBad);
  if (first != mesh.positions.end()) {
    const auto bad = std::size_t(std::count_if(first, mesh.positions.end(), isBad));
    const std::string where = "vertex " + std::to_string(first - mesh.positions.begin()) + name;
    const std::string reason =
        countOf(bad, mesh.positions.size(), "vertices are not finite numbers");
    if (bad * 10 > mesh.positions.size())
      return source.at(where, reason);
    const std::size_t dropped = dropNonFinite(mesh);
    into.warnings.push_back(source.warning(reason + " (the first: " + where + "); they and the " +
                                           std::to_string(dropped) +
                                           " triangles that use them are left out"));
  }
  if (mesh.triangles.empty())
    into.warnings.push_back(source.warning("no triangles" + name + "; left out"));
  else
    into.meshes.push_back(std::move(mesh));
  return Unit{};
}

Result<RawMeshes> assemble(const Source& source, RawMesh mesh, const FaceList& faces,
                           BadFaces policy, std::vector<ImportWarning> warnings) {
  RawMeshes result;
  result.warnings = std::move(warnings);
  CutTally tally;
  cutFaces({faces, 0, faces.size()}, mesh.positions, mesh.triangles, tally);
  TRY(judge(source, faces, tally, policy, result.warnings));
  TRY(finish(source, std::move(mesh), result));
  if (result.meshes.empty())
    return source.whole("holds no triangles", "Export the mesh as a surface of triangles");
  return result;
}

}  // namespace sline::model
