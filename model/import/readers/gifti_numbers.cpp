// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/gifti_numbers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/base/letters.h"
#include "model/import/source/base64.h"
#include "model/import/source/packed_bytes.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

std::optional<ScalarType> giftiType(std::string_view name) {
  if (name == "NIFTI_TYPE_FLOAT32")
    return ScalarType::float32;
  if (name == "NIFTI_TYPE_FLOAT64")
    return ScalarType::float64;
  if (name == "NIFTI_TYPE_INT32")
    return ScalarType::int32;
  if (name == "NIFTI_TYPE_UINT32")
    return ScalarType::uint32;
  if (name == "NIFTI_TYPE_UINT8")
    return ScalarType::uint8;
  return std::nullopt;
}

}  // namespace

Status GiftiNumbers::open() {
  TRY(readShape());
  const std::string_view encoding = m_array.tag.attribute("Encoding");
  if (encoding == "ASCII") {
    m_text = true;
    if (rows() > (m_array.data.size() + 1) / 2 / 3)
      return tooFew(m_array.data.size());
    return Unit{};
  }
  if (encoding == "ExternalFileBinary")
    return fault("has its numbers in a file of its own, which is not read",
                 "Convert it to GIFTI with base64, as wb_command -gifti-convert does");
  const bool packed = encoding == "GZipBase64Binary";
  if (!packed && encoding != "Base64Binary")
    return fault("has its numbers in an unknown encoding, " + inQuotes(encoding));
  std::optional<std::string> bytes = decodeBase64(m_array.data);
  if (!bytes)
    return fault("has data that are no base64");
  return packed ? unpack(*bytes) : take(std::move(*bytes));
}

Status GiftiNumbers::readShape() {
  const std::optional<ScalarType> type = giftiType(m_array.tag.attribute("DataType"));
  if (!type)
    return fault("is of type " + inQuotes(m_array.tag.attribute("DataType")) +
                 ", which is none of a surface");
  m_type = *type;
  const auto size = [&](const char* key) {
    std::int64_t value = -1;
    TextCursor(m_array.tag.attribute(key)).integer(value);
    return value;
  };
  const std::int64_t count = size("Dim0");
  if (count < 1 || size("Dim1") != 3)
    return fault("has no three numbers for each of its rows");
  if (std::uint64_t(count) > std::max(m_source.limits().vertices, m_source.limits().triangles))
    return fault("promises " + std::to_string(count) + " rows, more than the limit",
                 "Reduce the mesh");
  m_rows = std::size_t(count);
  m_columnsFirst = m_array.tag.attribute("ArrayIndexingOrder") == "ColumnMajorOrder";
  return Unit{};
}

Status GiftiNumbers::take(std::string bytes) {
  if (bytes.size() / (3 * sizeOf(m_type)) < m_rows)
    return tooFew(bytes.size());
  m_bytes = std::move(bytes);
  return Unit{};
}

Status GiftiNumbers::unpack(const std::string& packed) {
  const std::uint64_t wanted = std::uint64_t(m_rows) * 3 * sizeOf(m_type);
  if (wanted >
      std::min(mostUnpacked(packed.size(), Packing::deflated), mostOfSurface(packed.size())))
    return tooFew(packed.size());
  m_bytes.resize(std::size_t(wanted));
  PackedBytes bytes(packed, Packing::deflated);
  if (bytes.read(m_bytes.data(), m_bytes.size()) != m_bytes.size())
    return fault("has packed data that end early or are damaged", "Copy the file again");
  return Unit{};
}

}  // namespace sline::model
