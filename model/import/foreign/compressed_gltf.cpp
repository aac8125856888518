// SPDX-License-Identifier: Apache-2.0
// Unpacks the compressed parts of glTF: meshes by Draco 1.5 (github.com/google/draco, Apache-2.0),
// buffer views by meshoptimizer 0.18 (github.com/zeux/meshoptimizer, MIT).
#include <draco/compression/decode.h>
#include <meshoptimizer.h>

#include <exception>
#include <memory>
#include <new>

#include "model/import/foreign/foreign.h"
#include "model/import/readers/gltf/gltf_decoders.h"

namespace sline::model {

namespace {

Error because(std::string reason) {
  return Error{{}, {}, std::move(reason), {}};
}

Result<std::vector<glm::vec3>> positionsOf(const draco::Mesh& mesh, std::uint32_t id) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
  if (!attribute || attribute->num_components() != 3)
    return because("its Draco mesh has no positions under the number that glTF gives them");
  std::vector<glm::vec3> positions(mesh.num_points());
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex at = attribute->mapped_index(draco::PointIndex(i));
    if (at.value() >= attribute->size() || !attribute->ConvertValue<float>(at, 3, &positions[i].x))
      return because("positions of its Draco mesh are missing");
  }
  return positions;
}

Result<GltfUnpackedMesh> unpackDraco(const GltfPackedMesh& packed) {
  draco::DecoderBuffer buffer;
  buffer.Init(packed.bytes.data(), packed.bytes.size());
  draco::Decoder decoder;
  draco::StatusOr<std::unique_ptr<draco::Mesh>> decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
    return because("its Draco data cannot be unpacked: " + decoded.status().error_msg_string());
  const draco::Mesh& mesh = *decoded.value();
  if (mesh.num_points() > packed.limits.vertices || mesh.num_faces() > packed.limits.triangles)
    return because("its Draco mesh is larger than the limit");
  std::vector<glm::vec3> positions = TRY(positionsOf(mesh, packed.positions));
  GltfUnpackedMesh unpacked{std::move(positions), {}};
  unpacked.corners.reserve(3 * std::size_t(mesh.num_faces()));
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i)
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) {
      if (corner.value() >= mesh.num_points())
        return because("faces of its Draco mesh refer to points that do not exist");
      unpacked.corners.push_back(corner.value());
    }
  return unpacked;
}

/// Tells whether meshoptimizer takes elements of that size; it asserts what the extension demands.
bool fits(const GltfPackedView& view) {
  if (view.mode == "ATTRIBUTES")
    return view.stride % 4 == 0;
  return (view.mode == "INDICES" || (view.mode == "TRIANGLES" && view.count % 3 == 0)) &&
         (view.stride == 2 || view.stride == 4) && view.filter.empty();
}

bool filterFits(const GltfPackedView& view) {
  return view.filter.empty() || view.filter == "EXPONENTIAL" ||
         (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) ||
         (view.filter == "QUATERNION" && view.stride == 8);
}

Result<std::string> unpackMeshopt(const GltfPackedView& packed) {
  GltfPackedView view = packed;
  if (view.filter == "NONE")
    view.filter.clear();
  if (!fits(view) || !filterFits(view))
    return because("mode, filter and byteStride of its compression do not fit each other");
  std::string bytes(view.count * view.stride, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(view.bytes.data());
  const std::size_t size = view.bytes.size();
  int failed = -1;
  if (view.mode == "ATTRIBUTES")
    failed = meshopt_decodeVertexBuffer(bytes.data(), view.count, view.stride, from, size);
  else if (view.mode == "TRIANGLES")
    failed = meshopt_decodeIndexBuffer(bytes.data(), view.count, view.stride, from, size);
  else
    failed = meshopt_decodeIndexSequence(bytes.data(), view.count, view.stride, from, size);
  if (failed != 0)
    return because("its compressed data are broken");
  if (view.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(bytes.data(), view.count, view.stride);
  else if (view.filter == "QUATERNION")
    meshopt_decodeFilterQuat(bytes.data(), view.count, view.stride);
  else if (view.filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(bytes.data(), view.count, view.stride);
  return bytes;
}

constexpr GltfDecoders decoders{.view = unpackMeshopt, .mesh = unpackDraco};

}  // namespace

Result<RawMeshes> readCompressedGltf(const std::filesystem::path& file,
                                     const ReadOptions& options) {
  const auto refused = [&](const std::string& reason) {
    return Error{file.string(), {}, reason, "Export the mesh without compression"};
  };
  try {
    return readGltfWith(decoders, file, options.limits);
  } catch (const std::bad_alloc&) {
    return refused("there is not enough memory for it");
  } catch (const std::exception& e) {
    return refused(std::string("cannot be unpacked: ") + e.what());
  }
}

}  // namespace sline::model
