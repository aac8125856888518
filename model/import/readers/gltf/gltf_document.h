// SPDX-License-Identifier: Apache-2.0
// Reads a glTF 2.0 file (Khronos, "glTF 2.0 Specification") as JSON and bytes, with the typed
// look-ups into it that the parts of the reader share.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/import/readers/gltf/gltf_decoders.h"
#include "model/import/source/source.h"

namespace sline::model {

using Json = nlohmann::json;

struct GltfBuffer {
  std::string owned;             ///< decoded from a data URI or read from a file
  std::string_view bytes;        ///< into `owned` or into the GLB
  std::optional<Error> failure;  ///< reported when an accessor asks for the buffer
};

struct GltfDocument {
  const Source& source;
  Json root;
  std::string_view binary;  ///< the BIN chunk of a GLB
  std::vector<GltfBuffer> buffers;
  /// The memory that may still be made out of this file: instances and accessors that share bytes
  /// multiply a small file, so memory is granted from here.
  std::uint64_t budget = 0;
  GltfDecoders decoders = {};
  std::map<std::uint64_t, std::string> unpacked = {};  ///< buffer views, by index
};

/// Returns the member of an object; null where the value is no object or has none of that name.
const Json* member(const Json& object, const char* key);
/// Returns root[list][index] as an object, or null.
const Json* element(const Json& root, const char* list, std::uint64_t index);
/// Returns a whole number ≥ 0, or nothing where it is absent or something else.
std::optional<std::uint64_t> wholeMember(const Json& object, const char* key);
/// Returns the numbers of an array of exactly `count`; empty where it is absent or something else.
std::vector<double> numbersMember(const Json& object, const char* key, std::size_t count);
/// Returns the text; empty where it is absent or something else.
std::string textMember(const Json& object, const char* key);
/// Returns what an object says under `extensions` for one of them, or null.
const Json* extension(const Json& object, const char* name);
/// Returns "accessors[3]".
std::string placeOf(const char* list, std::uint64_t index);

/// Parses JSON or GLB and checks the version.
Result<GltfDocument> openGltf(const Source& source);
/// Fills `buffers`. Files beside the glTF are read only where a relative path stays in its folder,
/// links followed.
void loadBuffers(GltfDocument& document);

/// Returns the bytes to which an object refers by `buffer`, `byteOffset` and `byteLength`; `place`
/// is given in errors.
Result<std::string_view> bytesIn(const GltfDocument& document, const Json& object,
                                 const std::string& place);
/// Unpacks a primitive's mesh as KHR_draco_mesh_compression describes it in `packed`; no memory is
/// taken from the budget. The decoder must be there.
Result<GltfUnpackedMesh> unpackMesh(GltfDocument& document, const Json& packed,
                                    const std::string& place);

/// Reads a VEC3 accessor as positions.
Result<std::vector<glm::vec3>> readPositions(GltfDocument& document, std::uint64_t accessor);
/// Reads a SCALAR accessor of whole numbers.
Result<std::vector<std::uint32_t>> readIndices(GltfDocument& document, std::uint64_t accessor);

/// Describes a mesh as it stands in the scene.
struct GltfInstance {
  std::uint64_t mesh = 0;
  std::uint64_t node = 0;
  std::string name;                 ///< the node's, else the mesh's
  std::vector<std::string> groups;  ///< names of the nodes above, outermost first
  glm::dmat4 toScene{1.0};
};

/// Walks the scene's nodes, parents first; returns an error at a circle, a node with two parents,
/// or more than 256 levels.
Result<std::vector<GltfInstance>> meshInstances(const GltfDocument& document);

}  // namespace sline::model
