// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/import/readers/gltf/gltf_document.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {
std::optional<ScalarType> componentType(std::uint64_t code) {
  switch (code) {
    case 5120:
      return ScalarType::int8;
    case 5121:
      return ScalarType::uint8;
    case 5122:
      return ScalarType::int16;
    case 5123:
      return ScalarType::uint16;
    case 5125:
      return ScalarType::uint32;
    case 5126:
      return ScalarType::float32;
    default:
      return std::nullopt;
  }
}

/// Describes elements at equal distances in a buffer.
struct Strided {
  const char* first = nullptr;
  std::size_t stride = 0;
};

/// Says where an accessor or one of its sparse parts lies: a buffer view and an offset into it.
struct Placement {
  const Json& owner;
  std::uint64_t count = 0;
  std::size_t elementBytes = 0;
  std::string place;
  bool mayStride = true;
};

/// Holds the bytes of a buffer view and how far apart its elements begin; 0 where it does not say.
struct ViewBytes {
  std::string_view bytes;
  std::uint64_t stride = 0;
};

/// Returns a view under EXT_meshopt_compression, unpacked once.
Result<ViewBytes> unpackedView(GltfDocument& document, std::uint64_t index, const Json& packed) {
  const Source& source = document.source;
  const std::string place = placeOf("bufferViews", index);
  if (!document.decoders.view)
    return source.at(place, "is compressed by EXT_meshopt_compression, which is not supported",
                     "Export the mesh without compression");
  const std::uint64_t stride = wholeMember(packed, "byteStride").value_or(0);
  const std::uint64_t count = wholeMember(packed, "count").value_or(0);
  if (const auto known = document.unpacked.find(index); known != document.unpacked.end())
    return ViewBytes{known->second, stride};
  const std::string_view bytes = TRY(bytesIn(document, packed, place));
  if (stride < 1 || stride > 256 || count > document.budget / stride)
    return source.at(place, "promises " + std::to_string(count) + " elements of " +
                                std::to_string(stride) +
                                " bytes, far more than a file of this size describes");
  document.budget -= count * stride;
  Result<std::string> unpacked =
      document.decoders.view({bytes, std::size_t(count), std::size_t(stride),
                              textMember(packed, "mode"), textMember(packed, "filter")});
  if (!unpacked)
    return source.at(place, unpacked.error().reason);
  return ViewBytes{document.unpacked[index] = std::move(*unpacked), stride};
}

Result<ViewBytes> viewBytes(GltfDocument& document, std::uint64_t index, const Json& view) {
  if (const Json* packed = extension(view, "EXT_meshopt_compression"))
    return unpackedView(document, index, *packed);
  const std::string_view bytes = TRY(bytesIn(document, view, placeOf("bufferViews", index)));
  return ViewBytes{bytes, wholeMember(view, "byteStride").value_or(0)};
}

Result<Strided> locate(GltfDocument& document, const Placement& wanted) {
  const Source& source = document.source;
  const std::uint64_t viewIndex = wholeMember(wanted.owner, "bufferView").value_or(UINT64_MAX);
  const Json* json = element(document.root, "bufferViews", viewIndex);
  if (!json)
    return source.at(wanted.place, "refers to a bufferView that does not exist");
  const ViewBytes view = TRY(viewBytes(document, viewIndex, *json));
  const std::uint64_t stride =
      wanted.mayStride && view.stride > 0 ? view.stride : wanted.elementBytes;
  if (stride < wanted.elementBytes || stride > 256)
    return source.at(placeOf("bufferViews", viewIndex),
                     "its byteStride " + std::to_string(stride) + " does not fit the element");
  const std::uint64_t offset = wholeMember(wanted.owner, "byteOffset").value_or(0);
  const std::uint64_t room = offset > view.bytes.size() ? 0 : view.bytes.size() - offset;
  if (wanted.count > 0 &&
      (room < wanted.elementBytes || wanted.count - 1 > (room - wanted.elementBytes) / stride))
    return source.at(wanted.place, "promises " + std::to_string(wanted.count) +
                                       " elements, more than its bufferView holds");
  return Strided{view.bytes.data() + offset, std::size_t(stride)};
}

/// Holds what an accessor says about itself.
struct Accessor {
  const Json& json;
  std::string place;
  ScalarType type = ScalarType::float32;
  std::size_t components = 1;
  std::uint64_t count = 0;
  bool normalized = false;
  std::size_t elementBytes() const { return components * sizeOf(type); }
};

Result<Accessor> describe(GltfDocument& document, std::uint64_t index, const char* kind,
                          std::size_t components) {
  const Source& source = document.source;
  const std::string place = placeOf("accessors", index);
  const Json* json = element(document.root, "accessors", index);
  if (!json)
    return source.at(place, "does not exist");
  if (textMember(*json, "type") != kind)
    return source.at(place, "is of type " + inQuotes(textMember(*json, "type")) + ", not " + kind);
  const auto type = componentType(wholeMember(*json, "componentType").value_or(0));
  const auto count = wholeMember(*json, "count");
  if (!type || !count)
    return source.at(place, "has no componentType or count that is known");
  const Json* normalized = member(*json, "normalized");
  const std::uint64_t bytes = *count > (std::uint64_t(1) << 40) ? UINT64_MAX : 12 * *count;
  if (bytes > document.budget)
    return source.at(place, "promises " + std::to_string(*count) +
                                " elements, far more than a file of this size describes");
  document.budget -= bytes;
  return Accessor{*json,  place,
                  *type,  components,
                  *count, normalized && normalized->is_boolean() && normalized->get<bool>()};
}

float normalizedValue(ScalarType type, float value) {
  switch (type) {
    case ScalarType::int8:
      return std::max(value / 127.0f, -1.0f);
    case ScalarType::uint8:
      return value / 255.0f;
    case ScalarType::int16:
      return std::max(value / 32767.0f, -1.0f);
    case ScalarType::uint16:
      return value / 65535.0f;
    default:
      return value;
  }
}

constexpr bool swapBytes = std::endian::native != std::endian::little;

glm::vec3 positionAt(const Accessor& accessor, const char* at) {
  glm::vec3 p(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = loadFloat(accessor.type, at + std::size_t(axis) * sizeOf(accessor.type), swapBytes);
    if (accessor.normalized)
      p[axis] = normalizedValue(accessor.type, p[axis]);
  }
  return p;
}

std::uint32_t indexAt(const Accessor& accessor, const char* at) {
  return indexFrom(loadInteger(accessor.type, at, swapBytes));
}

/// Replaces the elements that the sparse part names (§3.6.2.3).
template <class T, class Load>
Status applySparse(GltfDocument& document, const Accessor& accessor, std::vector<T>& values,
                   const Load& load) {
  const Json* sparse = member(accessor.json, "sparse");
  if (!sparse)
    return Unit{};
  const std::string place = accessor.place + ".sparse";
  const Json* indices = member(*sparse, "indices");
  const Json* replacing = member(*sparse, "values");
  const auto count = wholeMember(*sparse, "count");
  const auto type = componentType(indices ? wholeMember(*indices, "componentType").value_or(0) : 0);
  if (!indices || !replacing || !count || !type || *type == ScalarType::float32)
    return document.source.at(place, "lacks indices, values or count");
  const Strided at =
      TRY(locate(document, {*indices, *count, sizeOf(*type), place + ".indices", false}));
  const Strided from = TRY(
      locate(document, {*replacing, *count, accessor.elementBytes(), place + ".values", false}));
  for (std::size_t i = 0; i < *count; ++i) {
    const std::int64_t target = loadInteger(*type, at.first + i * at.stride, swapBytes);
    if (target < 0 || std::uint64_t(target) >= values.size())
      return document.source.at(place, "replaces element " + std::to_string(target) + " of " +
                                           std::to_string(values.size()));
    values[std::size_t(target)] = load(accessor, from.first + i * from.stride);
  }
  return Unit{};
}

template <class T, class Load>
Result<std::vector<T>> readAll(GltfDocument& document, const Accessor& accessor, const Load& load) {
  std::vector<T> values;
  if (member(accessor.json, "bufferView")) {
    const Strided at = TRY(locate(
        document, {accessor.json, accessor.count, accessor.elementBytes(), accessor.place, true}));
    values.reserve(std::size_t(accessor.count));
    for (std::size_t i = 0; i < accessor.count; ++i)
      values.push_back(load(accessor, at.first + i * at.stride));
  } else {
    // Without a view all elements are zero until the sparse part replaces them.
    if (accessor.count > document.source.size())
      return document.source.at(accessor.place, "promises " + std::to_string(accessor.count) +
                                                    " elements and holds no data for them");
    values.resize(std::size_t(accessor.count));
  }
  TRY(applySparse(document, accessor, values, load));
  return values;
}
}  // namespace

Result<GltfUnpackedMesh> unpackMesh(GltfDocument& document, const Json& packed,
                                    const std::string& place) {
  const Source& source = document.source;
  const std::uint64_t index = wholeMember(packed, "bufferView").value_or(UINT64_MAX);
  const Json* view = element(document.root, "bufferViews", index);
  const Json* attributes = member(packed, "attributes");
  const auto positions = attributes ? wholeMember(*attributes, "POSITION") : std::nullopt;
  if (!view || !positions || *positions > UINT32_MAX)
    return source.at(place, "lacks the bufferView or the POSITION of its compressed mesh");
  const ViewBytes bytes = TRY(viewBytes(document, index, *view));
  Result<GltfUnpackedMesh> mesh =
      document.decoders.mesh({bytes.bytes, std::uint32_t(*positions), source.limits()});
  if (!mesh)
    return source.at(place, mesh.error().reason);
  return mesh;
}

Result<std::vector<glm::vec3>> readPositions(GltfDocument& document, std::uint64_t accessor) {
  const Accessor described = TRY(describe(document, accessor, "VEC3", 3));
  return readAll<glm::vec3>(document, described, positionAt);
}

Result<std::vector<std::uint32_t>> readIndices(GltfDocument& document, std::uint64_t accessor) {
  const Accessor described = TRY(describe(document, accessor, "SCALAR", 1));
  if (described.type == ScalarType::float32)
    return document.source.at(described.place, "holds real numbers where indices should stand");
  return readAll<std::uint32_t>(document, described, indexAt);
}

}  // namespace sline::model
