// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/vtk/vtp_document.h"

#include <map>

#include "model/import/source/text_cursor.h"
#include "model/import/source/xml_tags.h"

namespace sline::model {

namespace {
constexpr std::size_t deepestNesting = 32;

std::optional<ScalarType> xmlType(std::string_view name) {
  static const std::map<std::string_view, ScalarType> types = {
      {"Int8", ScalarType::int8},       {"UInt8", ScalarType::uint8},
      {"Int16", ScalarType::int16},     {"UInt16", ScalarType::uint16},
      {"Int32", ScalarType::int32},     {"UInt32", ScalarType::uint32},
      {"Int64", ScalarType::int64},     {"UInt64", ScalarType::uint64},
      {"Float32", ScalarType::float32}, {"Float64", ScalarType::float64}};
  const auto it = types.find(name);
  return it == types.end() ? std::nullopt : std::optional(it->second);
}

class VtpScanner {
 public:
  explicit VtpScanner(const Source& source) : m_source(source) {}

  Result<VtpDocument> scan() {
    XmlTags tags(m_source.text());
    while (!m_ended) {
      const std::optional<XmlTag> tag = tags.next();
      if (!tag)
        break;
      if (tag->name == "AppendedData" && !tag->closing) {
        openAppended(*tag);
      } else if (const Status status = tag->closing ? close(*tag) : open(*tag); !status) {
        return status.error();
      }
    }
    if (const std::optional<Error> error = incomplete(tags.failure()))
      return *error;
    TRY(locateAll());
    return std::move(m_document);
  }

 private:
  std::size_t offsetOf(const char* place) const { return std::size_t(place - m_source.begin()); }

  /// Opens the appended data; raw data may hold anything, so no tag is looked for behind this one.
  void openAppended(const XmlTag& tag) {
    m_appendedRaw = tag.attribute("encoding") == "raw";
    const std::size_t mark = m_source.text().find('_', offsetOf(tag.end()));
    if (mark != std::string_view::npos)
      m_appended = m_source.text().substr(mark + 1);
    m_ended = true;
  }

  std::optional<Error> incomplete(const char* failure) const {
    if (failure && m_source.text().substr(offsetOf(failure)).starts_with("<!DOCTYPE"))
      return m_source.atLine(failure, "declares a document type, which a VTP file must not");
    if (failure)
      return m_source.atLine(failure, "a tag is malformed, or the file ends within it");
    if (!m_hasFile)
      return noFile(m_source.begin());
    if (!m_ended)
      return m_source.atLine(m_source.end(), "the file ends before </VTKFile>");
    if (m_document.pieces.empty())
      return m_source.whole("has no Piece of PolyData");
    return std::nullopt;
  }

  Error noFile(const char* place) const {
    return m_source.atLine(place, "has no element VTKFile", "Check that the file is a VTP file");
  }

  Status open(const XmlTag& tag) {
    const std::string_view parent = m_path.empty() ? std::string_view() : m_path.back();
    Status status = Unit{};
    if (tag.name == "VTKFile" && m_path.empty())
      status = openFile(tag);
    else if (!m_hasFile)
      return noFile(tag.begin());
    else if (tag.name == "Piece" && parent == "PolyData")
      status = openPiece(tag);
    else if (tag.name == "DataArray" && isInPiece())
      status = addArray(tag, parent);
    else if (parent == "FieldData" && tag.attribute("Name") == "SPACE")
      m_space = tag;
    if (!status)
      return status;
    if (!tag.empty)
      m_path.push_back(tag.name);
    if (m_path.size() > deepestNesting)
      return m_source.atLine(tag.begin(), "elements are nested too deeply");
    return status;
  }

  /// Tells whether VTKFile, PolyData, Piece and one of its sections are open.
  bool isInPiece() const {
    return m_path.size() == 4 && m_path[1] == "PolyData" && m_path[2] == "Piece";
  }

  Status close(const XmlTag& tag) {
    if (m_path.empty() || m_path.back() != tag.name)
      return m_source.atLine(tag.begin(), "is not well-formed XML: </" + std::string(tag.name) +
                                              "> closes nothing that is open");
    m_path.pop_back();
    m_ended = m_path.empty();
    return Unit{};
  }

  Status openFile(const XmlTag& tag) {
    const std::string_view type = tag.attribute("type");
    if (type != "PolyData")
      return m_source.atLine(tag.begin(),
                             "holds a dataset of type " + inQuotes(type) + ", not PolyData",
                             "Extract its surface and save that as PolyData");
    m_hasFile = true;
    m_document.encoding.order =
        tag.attribute("byte_order") == "BigEndian" ? std::endian::big : std::endian::little;
    const std::string_view header = tag.attribute("header_type");
    if (!header.empty() && header != "UInt32" && header != "UInt64")
      return m_source.atLine(tag.begin(), inQuotes(header) + " is not a type of block header");
    m_document.encoding.word = header == "UInt64" ? ScalarType::uint64 : ScalarType::uint32;
    m_document.encoding.compressor = tag.attribute("compressor");
    if (!m_document.encoding.compressor.empty() &&
        !isKnownCompressor(m_document.encoding.compressor))
      return m_source.atLine(tag.begin(), inQuotes(m_document.encoding.compressor) +
                                              " is not a compressor this reads");
    return Unit{};
  }

  static std::optional<std::uint64_t> number(std::string_view text, std::uint64_t absent) {
    if (text.empty())
      return absent;
    TextCursor at(text);
    std::int64_t value = -1;
    if (!at.integer(value) || !at.atEnd() || value < 0)
      return std::nullopt;
    return std::uint64_t(value);
  }

  Status openPiece(const XmlTag& tag) {
    VtpPiece piece;
    piece.place = tag.begin();
    std::uint64_t others[2] = {};
    struct Row {
      const char* attribute;
      std::uint64_t& count;
    };
    for (const Row& row : {Row{"NumberOfPoints", piece.points}, Row{"NumberOfPolys", piece.polys},
                           Row{"NumberOfStrips", piece.strips}, Row{"NumberOfVerts", others[0]},
                           Row{"NumberOfLines", others[1]}}) {
      const std::optional<std::uint64_t> count = number(tag.attribute(row.attribute), 0);
      // The limits are far below; this keeps products of counts from wrapping.
      if (!count || *count > (std::uint64_t(1) << 48))
        return m_source.atLine(tag.begin(), std::string(row.attribute) + " is " +
                                                inQuotes(tag.attribute(row.attribute)) +
                                                ", which is not a count");
      row.count = *count;
    }
    piece.hasLines = others[0] + others[1] > 0;
    m_document.pieces.push_back(std::move(piece));
    return Unit{};
  }

  Status addArray(const XmlTag& tag, std::string_view section) {
    const bool points = section == "Points";
    if (!points && section != "Polys" && section != "Strips")
      return Unit{};
    const std::optional<std::uint64_t> components = number(tag.attribute("NumberOfComponents"), 1);
    if (components != (points ? 3 : 1))
      return m_source.atLine(tag.begin(), std::string(section) + " have " +
                                              inQuotes(tag.attribute("NumberOfComponents")) +
                                              " components");
    const std::optional<ScalarType> type = xmlType(tag.attribute("type"));
    if (!type || (!points && (*type == ScalarType::float32 || *type == ScalarType::float64)))
      return m_source.atLine(tag.begin(), inQuotes(tag.attribute("type")) + " is not a type for " +
                                              std::string(section));
    m_document.pieces.back().arrays.push_back(
        {std::string(section), std::string(tag.attribute("Name")), tag.begin(), {}});
    m_tags.push_back(tag);
    return Unit{};
  }

  /// Locates all arrays; only now is it known where appended data begin.
  Status locateAll() {
    std::size_t next = 0;
    for (VtpPiece& piece : m_document.pieces)
      for (VtpArray& array : piece.arrays) {
        array.content = TRY(contentOf(m_tags[next++]));
      }
    if (m_space) {
      const Result<VtpContent> content = contentOf(*m_space);
      if (content)
        m_document.space = *content;
    }
    return Unit{};
  }

  /// Returns where an array's values are stored.
  Result<VtpContent> contentOf(const XmlTag& tag) const {
    VtpContent content;
    content.type = xmlType(tag.attribute("type")).value_or(ScalarType::int8);
    const std::string_view format = tag.attribute("format");
    content.ascii = format == "ascii";
    if (format == "appended") {
      const std::optional<std::uint64_t> offset = number(tag.attribute("offset"), 0);
      if (!offset || *offset >= m_appended.size())
        return m_source.atLine(tag.begin(), "the appended data end before the array's offset " +
                                                inQuotes(tag.attribute("offset")));
      content.text = m_appended.substr(std::size_t(*offset));
      content.base64 = !m_appendedRaw;
      return content;
    }
    if (!content.ascii && format != "binary")
      return m_source.atLine(tag.begin(), inQuotes(format) + " is not a format of data");
    const std::string_view rest = m_source.text().substr(offsetOf(tag.end()));
    content.text = tag.empty ? std::string_view() : rest.substr(0, rest.find('<'));
    while (!content.text.empty() && TextCursor::isSpace(content.text.front()))
      content.text.remove_prefix(1);
    content.base64 = !content.ascii;
    return content;
  }

  const Source& m_source;
  VtpDocument m_document;
  std::vector<std::string_view> m_path;
  std::vector<XmlTag> m_tags;  ///< tags of the arrays of all pieces, in order
  std::optional<XmlTag> m_space;
  std::string_view m_appended;
  bool m_appendedRaw = false;
  bool m_hasFile = false;
  bool m_ended = false;
};
}  // namespace

Result<VtpDocument> scanVtp(const Source& source) {
  return VtpScanner(source).scan();
}

}  // namespace sline::model
