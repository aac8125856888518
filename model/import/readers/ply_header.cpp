// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/ply_header.h"

#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {
constexpr std::size_t mostElements = 1000;

std::optional<ScalarType> scalarNamed(std::string_view name) {
  struct Row {
    std::string_view name;
    std::string_view other;
    ScalarType type;
  };
  static constexpr Row rows[] = {
      {"char", "int8", ScalarType::int8},        {"uchar", "uint8", ScalarType::uint8},
      {"short", "int16", ScalarType::int16},     {"ushort", "uint16", ScalarType::uint16},
      {"int", "int32", ScalarType::int32},       {"uint", "uint32", ScalarType::uint32},
      {"int64", "long", ScalarType::int64},      {"uint64", "ulong", ScalarType::uint64},
      {"float", "float32", ScalarType::float32}, {"double", "float64", ScalarType::float64}};
  for (const Row& row : rows)
    if (name == row.name || name == row.other)
      return row.type;
  return std::nullopt;
}

class HeaderParser {
 public:
  explicit HeaderParser(const Source& source) : m_source(source), m_at(source.text()) {}

  Result<PlyHeader> parse() {
    if (m_at.restOfLine() != "ply")
      return m_source.atLine(m_source.begin(), "the file does not begin with 'ply'",
                             "Check that the file is a PLY file");
    bool hasFormat = false;
    while (!m_at.atEnd()) {
      m_place = m_at.at();
      const std::string_view keyword = nextWord();
      Status status = Unit{};
      if (keyword == "end_header") {
        m_at.skipLine();
        m_header.body = m_at.at();
        if (!hasFormat)
          return m_source.atLine(m_place, "the header has no 'format' line");
        return std::move(m_header);
      }
      if (keyword == "format") {
        hasFormat = true;
        status = readFormat();
      } else if (keyword == "element") {
        status = readElement();
      } else if (keyword == "property") {
        status = readProperty();
      } else if (keyword == "comment" || keyword == "obj_info") {
        const std::optional<Frame> frame = frameInText(m_at.restOfLine());
        m_header.frame = m_header.frame ? m_header.frame : frame;
        continue;
      } else if (!keyword.empty()) {
        return m_source.atLine(m_place, inQuotes(keyword) + " is not a line of a PLY header");
      }
      if (!status)
        return status.error();
      m_at.skipLine();
    }
    return m_source.atLine(m_at.at(), "the header has no 'end_header'");
  }

 private:
  std::string_view nextWord() {
    m_at.skipBlanks();
    return m_at.word();
  }

  Status readFormat() {
    const std::string_view name = nextWord();
    if (name == "binary_little_endian")
      m_header.binary = std::endian::little;
    else if (name == "binary_big_endian")
      m_header.binary = std::endian::big;
    else if (name != "ascii")
      return m_source.atLine(m_place, inQuotes(name) + " is not a format of PLY");
    return Unit{};
  }

  Status readElement() {
    PlyElement element;
    element.name = nextWord();
    element.place = m_place;
    std::int64_t count = -1;
    m_at.skipBlanks();
    if (element.name.empty() || !m_at.integer(count) || count < 0)
      return m_source.atLine(m_place, "an element needs a name and a count");
    if (m_header.elements.size() == mostElements)
      return m_source.atLine(m_place, "the header has more than 1000 elements");
    element.count = std::uint64_t(count);
    m_header.elements.push_back(std::move(element));
    return Unit{};
  }

  Status readProperty() {
    PlyProperty property;
    std::string_view type = nextWord();
    if (type == "list") {
      const std::string_view countType = nextWord();
      property.countType = scalarNamed(countType);
      if (!property.countType)
        return m_source.atLine(m_place, inQuotes(countType) + " is not a type of PLY");
      type = nextWord();
    }
    const std::optional<ScalarType> scalar = scalarNamed(type);
    if (!scalar)
      return m_source.atLine(m_place, inQuotes(type) + " is not a type of PLY");
    property.type = *scalar;
    property.name = nextWord();
    if (m_header.elements.empty() || property.name.empty())
      return m_source.atLine(m_place, "a property needs a name and an element before it");
    if (m_header.elements.back().properties.size() == mostElements)
      return m_source.atLine(m_place, "the element has more than 1000 properties");
    m_header.elements.back().properties.push_back(std::move(property));
    return Unit{};
  }

  const Source& m_source;
  TextCursor m_at;
  const char* m_place = nullptr;
  PlyHeader m_header;
};
}  // namespace

Result<PlyHeader> readPlyHeader(const Source& source) {
  return HeaderParser(source).parse();
}

}  // namespace sline::model
