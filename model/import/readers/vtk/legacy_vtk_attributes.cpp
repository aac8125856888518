// SPDX-License-Identifier: Apache-2.0
// Reads the data that a legacy VTK file holds beside its surface. Only a frame in field data is of
// use here; the rest is walked to its end, because a file that ends early was not written
// completely.
#include "model/base/letters.h"
#include "model/import/readers/vtk/legacy_vtk.h"

namespace sline::model {

std::optional<std::uint64_t> LegacyVtk::nextCount() {
  at.skipSpace();
  std::int64_t value = -1;
  if (!at.integer(value) || value < 0)
    return std::nullopt;
  return std::uint64_t(value);
}

void LegacyVtk::toValues() {
  if (binary)
    at.skipLine();
}

std::optional<ScalarType> legacyType(std::string_view name) {
  struct Row {
    std::string_view name;
    ScalarType type;
  };
  // vtkIdType is written as int: see vtkDataReader.
  static constexpr Row rows[] = {{"float", ScalarType::float32},
                                 {"double", ScalarType::float64},
                                 {"int", ScalarType::int32},
                                 {"unsigned_int", ScalarType::uint32},
                                 {"vtkidtype", ScalarType::int32},
                                 {"vtktypeint64", ScalarType::int64},
                                 {"vtktypeuint64", ScalarType::uint64},
                                 {"vtktypeint32", ScalarType::int32},
                                 {"vtktypeuint32", ScalarType::uint32},
                                 {"long", ScalarType::int64},
                                 {"unsigned_long", ScalarType::uint64},
                                 {"char", ScalarType::int8},
                                 {"signed_char", ScalarType::int8},
                                 {"unsigned_char", ScalarType::uint8},
                                 {"short", ScalarType::int16},
                                 {"unsigned_short", ScalarType::uint16}};
  for (const Row& row : rows)
    if (equalsIgnoringCase(name, row.name))
      return row.type;
  return std::nullopt;
}

void skipMetadata(LegacyVtk& file) {
  file.at.skipLine();
  while (!file.at.atEnd() && !file.at.restOfLine().empty()) {
  }
}

namespace {
/// Steps over `count` values; returns false where the file ends first.
bool skipValues(LegacyVtk& file, ScalarType type, std::uint64_t count) {
  if (file.binary) {
    BinaryValues values(file.at.at(), file.at.end(), std::endian::big);
    const bool good = values.skip(type, count);
    file.at.moveTo(values.at());
    return good;
  }
  TextValues values(file.at.at(), file.at.end());
  const bool good = count <= values.atMost(type) && values.skip(type, count);
  file.at.moveTo(values.at());
  return good;
}

/// Reads a string in a binary file: its length stands before it, in 1, 2, 4 or 8 bytes as the first
/// two bits tell (vtkDataWriter, "encoded string").
bool nextBinaryString(LegacyVtk& file, std::string_view& text) {
  const char* at = file.at.at();
  const auto left = std::uint64_t(file.at.end() - at);
  if (left == 0)
    return false;
  const unsigned kind = static_cast<unsigned char>(*at) >> 6;
  const std::uint64_t width = kind == 3 ? 1 : (kind == 2 ? 2 : (kind == 1 ? 4 : 8));
  if (left < width)
    return false;
  std::uint64_t length = static_cast<unsigned char>(*at) & 0x3fu;
  for (std::uint64_t i = 1; i < width; ++i)
    length = length << 8 | static_cast<unsigned char>(at[i]);
  if (length > left - width)
    return false;
  text = {at + width, std::size_t(length)};
  file.at.moveTo(at + width + length);
  return true;
}

bool readStrings(LegacyVtk& file, std::string_view array, std::uint64_t count) {
  if (!file.binary)
    file.at.skipLine();
  for (; count > 0; --count) {
    std::string_view text;
    if (file.binary ? !nextBinaryString(file, text) : file.at.atEnd())
      return false;
    if (!file.binary)
      text = file.at.restOfLine();
    if (array == "SPACE" && !file.frame && (text == "LPS" || text == "RAS")) {
      file.frame = text == "LPS" ? Frame::lps : Frame::ras;
      file.frameReason = "SPACE in the field data";
    }
  }
  return true;
}

/// Reads NAME COMPONENTS TUPLES TYPE and the values.
Status readFieldArray(LegacyVtk& file) {
  std::string_view name = file.next();
  if (name == "METADATA") {
    skipMetadata(file);
    name = file.next();
  }
  const char* place = name.data();
  const std::optional<std::uint64_t> components = file.nextCount();
  const std::optional<std::uint64_t> tuples = file.nextCount();
  const std::string_view typeName = file.next();
  if (!components || !tuples || typeName.empty())
    return file.wrong(place, "an array of FIELD needs a name, two counts and a type");
  if (*components > file.source.size() || *tuples > file.source.size())
    return file.wrong(place,
                      "the array " + inQuotes(name) + " promises more values than the file holds");
  std::uint64_t count = *components * *tuples;
  file.toValues();
  bool good = true;
  if (equalsIgnoringCase(typeName, "string")) {
    good = readStrings(file, name, count);
  } else if (equalsIgnoringCase(typeName, "bit")) {
    good = skipValues(file, ScalarType::uint8, file.binary ? (count + 7) / 8 : count);
  } else {
    const std::optional<ScalarType> type = legacyType(typeName);
    if (!type)
      return file.wrong(typeName.data(), inQuotes(typeName) + " is not a type of legacy VTK");
    good = skipValues(file, *type, count);
  }
  if (!good)
    return file.wrong(file.at.end(), "the file ends within the array " + inQuotes(name));
  return Unit{};
}

/// Describes the values of one attribute, as read from the text after its keyword; absent where the
/// attribute is unknown.
struct AttributeBlock {
  ScalarType type = ScalarType::float32;
  std::uint64_t perTuple = 0;
};

std::optional<AttributeBlock> attributeBlock(LegacyVtk& file, std::string_view keyword) {
  file.next();  // its name
  AttributeBlock block;
  if (equalsIgnoringCase(keyword, "color_scalars")) {
    block.perTuple = file.nextCount().value_or(UINT64_MAX);
    block.type = ScalarType::uint8;
  } else {
    const bool hasDimension = equalsIgnoringCase(keyword, "texture_coordinates");
    if (hasDimension)
      block.perTuple = file.nextCount().value_or(UINT64_MAX);
    const std::optional<ScalarType> type = legacyType(file.next());
    if (!type)
      return std::nullopt;
    block.type = *type;
    if (equalsIgnoringCase(keyword, "normals") || equalsIgnoringCase(keyword, "vectors"))
      block.perTuple = 3;
    else if (equalsIgnoringCase(keyword, "tensors"))
      block.perTuple = 9;
    else if (!hasDimension)
      return std::nullopt;
  }
  return block.perTuple < 100 ? std::optional(block) : std::nullopt;
}

std::optional<AttributeBlock> scalarsBlock(LegacyVtk& file) {
  file.next();
  const std::optional<ScalarType> type = legacyType(file.next());
  file.at.skipBlanks();
  const std::uint64_t components = file.at.atLineEnd() ? 1 : file.nextCount().value_or(100);
  if (!type || components >= 100)
    return std::nullopt;
  const TextCursor before = file.at;
  if (equalsIgnoringCase(file.next(), "lookup_table"))
    file.next();
  else
    file.at = before;
  return AttributeBlock{*type, components};
}
}  // namespace

Status readField(LegacyVtk& file) {
  const char* place = file.next().data();
  const std::optional<std::uint64_t> arrays = file.nextCount();
  if (!arrays)
    return file.wrong(place, "FIELD needs a name and the number of its arrays");
  for (std::uint64_t i = 0; i < *arrays; ++i) {
    file.at.skipSpace();
    if (file.at.atEnd())
      return file.wrong(file.at.end(), "FIELD promises " + std::to_string(*arrays) +
                                           " arrays, the file ends after " + std::to_string(i));
    TRY(readFieldArray(file));
  }
  return Unit{};
}

Status skipAttributes(LegacyVtk& file) {
  std::uint64_t tuples = file.nextCount().value_or(0);
  while (true) {
    const std::string_view keyword = file.next();
    if (keyword.empty())
      return Unit{};
    std::optional<AttributeBlock> block;
    if (equalsIgnoringCase(keyword, "point_data") || equalsIgnoringCase(keyword, "cell_data")) {
      tuples = file.nextCount().value_or(0);
      continue;
    }
    if (equalsIgnoringCase(keyword, "metadata")) {
      skipMetadata(file);
      continue;
    }
    if (equalsIgnoringCase(keyword, "field")) {
      TRY(readField(file));
      continue;
    }
    if (equalsIgnoringCase(keyword, "lookup_table")) {
      file.next();
      const std::uint64_t rows = file.nextCount().value_or(0);
      file.toValues();
      if (rows > file.source.size() || !skipValues(file, ScalarType::uint8, 4 * rows))
        return file.wrong(file.at.end(), "the file ends within LOOKUP_TABLE");
      continue;
    }
    block =
        equalsIgnoringCase(keyword, "scalars") ? scalarsBlock(file) : attributeBlock(file, keyword);
    // This reader does not know the attribute: the surface is complete, the rest does not matter.
    if (!block)
      return Unit{};
    file.toValues();
    if (tuples > file.source.size() || !skipValues(file, block->type, tuples * block->perTuple))
      return file.wrong(file.at.end(), "the file ends within " + std::string(keyword));
  }
}

}  // namespace sline::model
