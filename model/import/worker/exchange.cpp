// SPDX-License-Identifier: Apache-2.0
#include "model/import/worker/exchange.h"

#include <cassert>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "model/import/volumes/grey_volume.h"
#include "model/import/worker/byte_archive.h"

namespace sline::model {

/// Points, triangles and colours are numbers without gaps between them.
template <>
inline constexpr bool copiesAsBytes<glm::vec3> = true;
template <>
inline constexpr bool copiesAsBytes<glm::ivec3> = true;
template <>
inline constexpr bool copiesAsBytes<glm::dmat4> = true;
template <>
inline constexpr bool copiesAsBytes<Triangle> = true;
template <>
inline constexpr bool copiesAsBytes<Colour> = true;

// The functions name all fields of a type: the compiler refuses the list when a field is added.

template <class Archive>
void visitFields(Archive& archive, ReadLimits& limits) {
  auto& [fileBytes, vertices, triangles, childBytes, childSeconds] = limits;
  archive(fileBytes, vertices, triangles, childBytes, childSeconds);
}

template <class Archive>
void visitFields(Archive& archive, Smoothing& smoothing) {
  auto& [mode, steps] = smoothing;
  archive(mode, steps);
}

template <class Archive>
void visitFields(Archive& archive, Threshold& threshold) {
  auto& [name, low, high, scan] = threshold;
  archive(name, low, high, scan);
}

template <class Archive>
void visitFields(Archive& archive, ReadRequest& request) {
  auto& [kind, files, limits, smoothing, thresholds, keepScans] = request;
  archive(kind, files, limits, smoothing, thresholds, keepScans);
}

template <class Archive>
void visitFields(Archive& archive, Error& error) {
  auto& [file, where, reason, remedy] = error;
  archive(file, where, reason, remedy);
}

template <class Archive>
void visitFields(Archive& archive, ImportWarning& warning) {
  auto& [file, reason] = warning;
  archive(file, reason);
}

void visitFields(ByteWriter& archive, Opacity& opacity) {
  archive(opacity.value());
}

void visitFields(ByteReader& archive, Opacity& opacity) {
  float value = 0.0f;
  archive(value);
  opacity = Opacity::clamped(value);
}

template <class Archive>
void visitFields(Archive& archive, RawMesh& mesh) {
  auto& [name, groups, origin, positions, triangles, colour, opacity, frame, frameReason,
         millimetresPerUnit, unitReason, yUp, onlySideOpen, file, smooth, visible, molecule,
         displacement, sliceDistance, threshold, voxelVolume] = mesh;
  assert(!molecule);
  archive(name, groups, origin, positions, triangles, colour, opacity, frame, frameReason,
          millimetresPerUnit, unitReason, yUp, onlySideOpen, file, smooth, visible, displacement,
          sliceDistance, threshold, voxelVolume);
}

template <class Archive>
void visitFields(Archive& archive, GreyVolume& volume) {
  auto& [size, voxels, slope, intercept, hounsfield, name, toLps, frame, frameReason, onlySideOpen,
         unitReason] = volume;
  archive(size, voxels, slope, intercept, hounsfield, name, toLps, frame, frameReason, onlySideOpen,
          unitReason);
}

void visitFields(ByteWriter& archive, RawScan& scan) {
  archive(scan.file, *scan.volume);
}

void visitFields(ByteReader& archive, RawScan& scan) {
  GreyVolume volume;
  archive(scan.file, volume);
  scan.volume = std::make_shared<const GreyVolume>(std::move(volume));
}

template <class Archive>
void visitFields(Archive& archive, RawMeshes& all) {
  auto& [meshes, warnings, notes, scans, thereAlready] = all;
  archive(meshes, warnings, notes, scans, thereAlready);
}

namespace {

bool knowsFrame(const std::optional<Frame>& frame) {
  return !frame || (*frame >= Frame::lps && *frame <= Frame::file);
}

bool isSound(const RawMesh& mesh) {
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t index : triangle)
      if (index >= mesh.positions.size())
        return false;
  for (const glm::vec3& p : mesh.positions)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return false;
  return knowsFrame(mesh.frame) && std::isfinite(mesh.displacement) &&
         std::isfinite(mesh.sliceDistance) && std::isfinite(mesh.millimetresPerUnit) &&
         std::isfinite(mesh.voxelVolume.value_or(0.0));
}

bool isSound(const GreyVolume& volume) {
  std::uint64_t count = 1;
  for (int i = 0; i < 3; ++i) {
    const int side = volume.size[i];
    if (side < 1 || std::uint64_t(side) > volume.voxels.size() / count)
      return false;
    count *= std::uint64_t(side);
  }
  const double determinant = glm::determinant(volume.toLps);
  return count == volume.voxels.size() && std::isfinite(volume.slope) &&
         std::isfinite(volume.intercept) && std::isfinite(determinant) && determinant != 0.0 &&
         knowsFrame(volume.frame);
}

Error notUnderstood() {
  return {{}, {}, "the answer of the program that reads it makes no sense", "Install Sline again"};
}
}  // namespace

std::string encodedRequest(const ReadRequest& request) {
  ByteWriter writer;
  writer(request);
  return writer.take();
}

Result<ReadRequest> decodedRequest(std::string_view bytes) {
  ReadRequest request;
  ByteReader reader(bytes);
  reader(request);
  if (!reader.complete())
    return Error{{}, {}, "is no request", {}};
  return request;
}

std::string encodedAnswer(const Result<RawMeshes>& answer) {
  ByteWriter writer;
  writer(answer.ok());
  if (answer)
    writer(*answer);
  else
    writer(answer.error());
  return writer.take();
}

Result<RawMeshes> decodedAnswer(std::string_view bytes) {
  ByteReader reader(bytes);
  bool ok = false;
  reader(ok);
  if (!ok) {
    Error error;
    reader(error);
    return reader.complete() && !error.reason.empty() ? error : notUnderstood();
  }
  RawMeshes meshes;
  reader(meshes);
  if (!reader.complete())
    return notUnderstood();
  for (const RawMesh& mesh : meshes.meshes)
    if (!isSound(mesh))
      return notUnderstood();
  for (const RawScan& scan : meshes.scans)
    if (!isSound(*scan.volume))
      return notUnderstood();
  return meshes;
}

}  // namespace sline::model
