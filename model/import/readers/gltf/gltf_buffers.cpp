// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/gltf/gltf_document.h"
#include "model/import/source/base64.h"
#include "model/import/source/file_in_folder.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/values.h"

namespace sline::model {

const Json* member(const Json& object, const char* key) {
  if (!object.is_object())
    return nullptr;
  const auto it = object.find(key);
  return it == object.end() ? nullptr : &*it;
}

const Json* element(const Json& root, const char* list, std::uint64_t index) {
  const Json* array = member(root, list);
  if (!array || !array->is_array() || index >= array->size())
    return nullptr;
  const Json& found = (*array)[std::size_t(index)];
  return found.is_object() ? &found : nullptr;
}

std::optional<std::uint64_t> wholeMember(const Json& object, const char* key) {
  const Json* value = member(object, key);
  if (!value || !value->is_number_unsigned())
    return std::nullopt;
  return value->get<std::uint64_t>();
}

std::vector<double> numbersMember(const Json& object, const char* key, std::size_t count) {
  const Json* array = member(object, key);
  std::vector<double> numbers;
  if (!array || !array->is_array() || array->size() != count)
    return numbers;
  for (const Json& value : *array) {
    if (!value.is_number())
      return {};
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

std::string textMember(const Json& object, const char* key) {
  const Json* value = member(object, key);
  return value && value->is_string() ? value->get<std::string>() : std::string();
}

const Json* extension(const Json& object, const char* name) {
  const Json* extensions = member(object, "extensions");
  const Json* found = extensions ? member(*extensions, name) : nullptr;
  return found && found->is_object() ? found : nullptr;
}

std::string placeOf(const char* list, std::uint64_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

namespace {
constexpr std::uint32_t jsonChunk = 0x4e4f534a;
constexpr std::uint32_t binaryChunk = 0x004e4942;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  return loadAs<std::uint32_t>(bytes.data() + at, std::endian::native != std::endian::little);
}

/// Splits a GLB: "glTF", version, length, then chunks of length, type and data.
Status splitGlb(const Source& source, std::string_view& json, std::string_view& binary) {
  const std::string_view text = source.text();
  if (text.size() < 20)
    return source.atByte(source.end(), "the file ends within the GLB header");
  if (wordAt(text, 4) != 2)
    return source.atByte(source.begin() + 4, "GLB version " + std::to_string(wordAt(text, 4)) +
                                                 " is not supported, only 2 is");
  if (wordAt(text, 8) > text.size())
    return source.atByte(source.end(), "the header promises " + std::to_string(wordAt(text, 8)) +
                                           " bytes, the file has " + std::to_string(text.size()));
  for (std::size_t at = 12; at + 8 <= text.size();) {
    const std::uint32_t length = wordAt(text, at);
    const std::uint32_t type = wordAt(text, at + 4);
    if (length > text.size() - at - 8)
      return source.atByte(text.data() + at, "a chunk of " + std::to_string(length) +
                                                 " bytes is longer than the rest of the file");
    const std::string_view chunk = text.substr(at + 8, length);
    if (at == 12 && type != jsonChunk)
      return source.atByte(text.data() + at, "the first chunk is not JSON");
    if (type == jsonChunk && json.empty())
      json = chunk;
    else if (type == binaryChunk && binary.empty())
      binary = chunk;
    at += 8 + std::size_t(length);
  }
  return Unit{};
}

/// Resolves %20 and its like; returns nothing where it is malformed.
std::optional<std::string> percentDecoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text += uri[i];
      continue;
    }
    const auto digit = [&](std::size_t at) {
      const char c = at < uri.size() ? uri[at] : '\0';
      if (c >= '0' && c <= '9')
        return c - '0';
      const char lower = char(c | 0x20);
      return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
    };
    const int high = digit(i + 1);
    const int low = digit(i + 2);
    if (high < 0 || low < 0 || high + low == 0)
      return std::nullopt;
    text += char(high * 16 + low);
    i += 2;
  }
  return text;
}

GltfBuffer failed(Error error) {
  return {{}, {}, std::move(error)};
}

GltfBuffer loadUri(const GltfDocument& document, const std::string& uri, const std::string& place) {
  const Source& source = document.source;
  GltfBuffer buffer;
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64"))
      return failed(source.at(place, "its data URI is not base64"));
    std::optional<std::string> bytes = decodeBase64(std::string_view(uri).substr(comma + 1));
    if (!bytes)
      return failed(source.at(place, "its base64 text is broken"));
    buffer.owned = std::move(*bytes);
    return buffer;
  }
  const std::optional<std::string> name = percentDecoded(uri);
  const std::optional<std::filesystem::path> path =
      name ? fileInFolder(source.file(), *name) : std::nullopt;
  if (!path)
    return failed(source.at(place,
                            "refers to " + inQuotes(uri) + ", which is outside the file's folder",
                            "Put the buffer beside the file and refer to it by its name"));
  const Result<Source> file = Source::read(*path, source.limits());
  if (!file)
    return failed(source.at(
        place, "refers to " + inQuotes(uri) + ", which cannot be read: " + file.error().reason,
        "Put the buffer beside the file or export the mesh as .glb"));
  buffer.owned = file->text();
  return buffer;
}
}  // namespace

Result<GltfDocument> openGltf(const Source& source) {
  std::string_view json = source.text();
  GltfDocument document{source, {}, {}, {}, 64 * std::uint64_t(source.size()) + (64u << 20)};
  if (json.starts_with("glTF")) {
    json = {};
    TRY(splitGlb(source, json, document.binary));
  }
  try {
    document.root = Json::parse(json.begin(), json.end());
  } catch (const Json::parse_error& e) {
    return source.atByte(json.data() + std::min(e.byte, json.size()), "is not valid JSON there");
  }
  const Json* asset = member(document.root, "asset");
  const std::string version = asset ? textMember(*asset, "version") : std::string();
  if (version.empty())
    return source.whole("is JSON but not glTF: it has no asset.version",
                        "Check that the file is a glTF file");
  if (!version.starts_with("2."))
    return source.whole("glTF version " + inQuotes(version) + " is not supported, only 2.0 is");
  return document;
}

void loadBuffers(GltfDocument& document) {
  const Json* list = member(document.root, "buffers");
  if (!list || !list->is_array())
    return;
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Json& entry = (*list)[i];
    const std::string place = placeOf("buffers", i);
    const std::optional<std::uint64_t> length = wholeMember(entry, "byteLength");
    const Json* uri = member(entry, "uri");
    GltfBuffer buffer;
    if (!length)
      buffer = failed(document.source.at(place, "has no byteLength"));
    else if (uri && uri->is_string())
      buffer = loadUri(document, uri->get_ref<const std::string&>(), place);
    else if (i == 0 && !document.binary.empty())
      buffer.bytes = document.binary;
    else
      buffer = failed(document.source.at(place, "has no data"));
    if (!buffer.owned.empty())
      buffer.bytes = buffer.owned;
    total += buffer.bytes.size();
    if (!buffer.failure && total > document.source.limits().fileBytes)
      buffer = failed(document.source.at(place, "the buffers are larger than the limit"));
    if (!buffer.failure && *length > buffer.bytes.size())
      buffer = failed(document.source.at(place, "promises " + std::to_string(*length) +
                                                    " bytes, its data have " +
                                                    std::to_string(buffer.bytes.size())));
    document.buffers.push_back(std::move(buffer));
    // A short string lives inside the object that was just moved.
    if (!document.buffers.back().owned.empty())
      document.buffers.back().bytes = document.buffers.back().owned;
  }
  for (GltfBuffer& buffer : document.buffers)
    if (!buffer.owned.empty())
      buffer.bytes = buffer.owned;
}

Result<std::string_view> bytesIn(const GltfDocument& document, const Json& object,
                                 const std::string& place) {
  const Source& source = document.source;
  const std::uint64_t index = wholeMember(object, "buffer").value_or(UINT64_MAX);
  if (index >= document.buffers.size())
    return source.at(place, "refers to a buffer that does not exist");
  const GltfBuffer& buffer = document.buffers[std::size_t(index)];
  if (buffer.failure)
    return *buffer.failure;
  const std::uint64_t offset = wholeMember(object, "byteOffset").value_or(0);
  const std::uint64_t length = wholeMember(object, "byteLength").value_or(0);
  if (offset > buffer.bytes.size() || length > buffer.bytes.size() - offset)
    return source.at(
        place, "reaches beyond its buffer of " + std::to_string(buffer.bytes.size()) + " bytes");
  return buffer.bytes.substr(std::size_t(offset), std::size_t(length));
}

}  // namespace sline::model
