// SPDX-License-Identifier: Apache-2.0
// Reads STL, text and binary. Corners of bit-equal coordinates become one vertex.
#include "model/base/letters.h"
#include "model/import/readers/readers.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/welder.h"

namespace sline::model {

namespace {
constexpr std::size_t headerBytes = 84;
constexpr std::size_t facetBytes = 50;

void takeFrame(RawMesh& mesh, std::string_view header) {
  mesh.frame = frameInText(header);
  if (mesh.frame)
    mesh.frameReason = "SPACE in the header";
}

Result<RawMeshes> onlySurfaces(const Source& source, RawMeshes result) {
  if (result.meshes.empty())
    return source.whole("holds no triangles");
  return result;
}

Result<RawMeshes> readBinary(const Source& source) {
  if (source.size() < headerBytes)
    return source.atByte(source.end(), "too short for an STL file: not text, and its " +
                                           std::to_string(source.size()) +
                                           " bytes do not hold the header of 84");
  BinaryValues count(source.begin() + 80, source.end(), std::endian::little);
  std::int64_t promised = 0;
  count.integer(ScalarType::uint32, promised);
  const std::size_t held = (source.size() - headerBytes) / facetBytes;
  const std::string_view header = source.text().substr(0, headerBytes);
  const bool looksLikeText = std::all_of(header.begin(), header.end(), [](char c) {
    return TextCursor::isSpace(c) || (c >= ' ' && c <= '~');
  });
  if (std::size_t(promised) > held && looksLikeText)
    return source.atLine(
        source.begin(),
        "the file neither begins with 'solid' nor has the size of a binary STL file",
        "Check that the file is an STL file");
  if (std::size_t(promised) > held)
    return source.atByte(source.end(), "the header promises " + std::to_string(promised) +
                                           " triangles, the file ends after " +
                                           std::to_string(held));
  RawMeshes result;
  RawMesh mesh;
  takeFrame(mesh, source.text().substr(0, 80));
  Welder welder(3 * std::size_t(promised));
  mesh.triangles.reserve(std::size_t(promised));
  const bool swap = std::endian::native != std::endian::little;
  const char* at = source.begin() + headerBytes;
  for (std::int64_t i = 0; i < promised; ++i, at += facetBytes) {
    Triangle triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const char* p = at + 12 + 12 * corner;  // the facet's normal comes first
      triangle[corner] = welder.vertex(
          {loadAs<float>(p, swap), loadAs<float>(p + 4, swap), loadAs<float>(p + 8, swap)});
    }
    mesh.triangles.push_back(triangle);
  }
  mesh.positions = welder.take();
  if (at != source.end())
    result.warnings.push_back(source.warning(std::to_string(source.end() - at) +
                                             " bytes after the last triangle of the " +
                                             std::to_string(promised) + " promised are ignored"));
  TRY(finish(source, std::move(mesh), result));
  return onlySurfaces(source, std::move(result));
}

/// Reads text: solid NAME { facet normal x y z, outer loop, vertex x y z …, endloop, endfacet }
/// endsolid.
class TextParser {
 public:
  explicit TextParser(const Source& source) : m_source(source), m_at(source.text()) {}

  Result<RawMeshes> parse() {
    RawMeshes result;
    for (std::string_view word = next(); !word.empty(); word = next()) {
      if (!equalsIgnoringCase(word, "solid"))
        return wrong(word, "'solid'");
      TRY(readSolid(result));
    }
    return onlySurfaces(m_source, std::move(result));
  }

 private:
  /// Returns the next word beyond comments; empty at the end.
  std::string_view next() {
    m_at.skipSpace();
    while (m_at.peek() == '#') {
      m_at.skipLine();
      m_at.skipSpace();
    }
    m_place = m_at.at();
    return m_at.word();
  }

  Error wrong(std::string_view word, const char* expected) const {
    if (word.empty())
      return m_source.atLine(m_source.end(),
                             std::string("the file ends where ") + expected + " should follow");
    return m_source.atLine(m_place, inQuotes(word) + " stands where " + expected + " should");
  }

  std::string readTitle() {
    std::string_view title = m_at.atLineEnd() ? std::string_view() : m_at.restOfLine();
    title = title.substr(0, title.find('#'));
    while (!title.empty() && TextCursor::isBlank(title.back()))
      title.remove_suffix(1);
    return std::string(title);
  }

  Status readSolid(RawMeshes& result) {
    RawMesh mesh;
    mesh.name = readTitle();
    takeFrame(mesh, mesh.name);
    Welder welder(0);
    while (true) {
      const std::string_view word = next();
      if (equalsIgnoringCase(word, "endsolid"))
        break;
      if (!equalsIgnoringCase(word, "facet"))
        return wrong(word, "'facet' or 'endsolid'");
      TRY(readFacet(welder, mesh.triangles));
    }
    if (!m_at.atLineEnd())
      m_at.skipLine();
    mesh.positions = welder.take();
    return finish(m_source, std::move(mesh), result);
  }

  Status readFacet(Welder& welder, std::vector<Triangle>& triangles) {
    std::string_view word = next();
    glm::vec3 p(0.0f);
    if (equalsIgnoringCase(word, "normal")) {
      TRY(readThree(p));
      word = next();
    }
    if (!equalsIgnoringCase(word, "outer"))
      return wrong(word, "'outer loop'");
    if (word = next(); !equalsIgnoringCase(word, "loop"))
      return wrong(word, "'loop'");
    std::array<std::uint32_t, 3> fan{};
    std::size_t corners = 0;
    for (word = next(); equalsIgnoringCase(word, "vertex"); word = next(), ++corners) {
      TRY(readThree(p));
      const std::uint32_t vertex = welder.vertex(p);
      if (corners > 2)
        fan[1] = fan[2];
      fan[std::min<std::size_t>(corners, 2)] = vertex;
      if (corners >= 2)
        triangles.push_back(fan);
    }
    if (corners < 3 || !equalsIgnoringCase(word, "endloop"))
      return wrong(word, corners < 3 ? "a third 'vertex'" : "'endloop'");
    if (word = next(); !equalsIgnoringCase(word, "endfacet"))
      return wrong(word, "'endfacet'");
    return Unit{};
  }

  Status readThree(glm::vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      m_at.skipSpace();
      m_place = m_at.at();
      if (!m_at.number(p[axis]))
        return wrong(m_at.peekWord(), "a number");
    }
    return Unit{};
  }

  const Source& m_source;
  TextCursor m_at;
  const char* m_place = nullptr;
};

/// Tells whether the file is text. Binary headers may begin with "solid" too, so the size decides
/// first and then the content.
bool isText(const Source& source) {
  if (source.size() >= headerBytes) {
    BinaryValues count(source.begin() + 80, source.end(), std::endian::little);
    std::int64_t promised = 0;
    count.integer(ScalarType::uint32, promised);
    if (source.size() == headerBytes + facetBytes * std::size_t(promised))
      return false;
  }
  TextCursor at(source.text());
  at.skipSpace();
  while (at.peek() == '#') {
    at.skipLine();
    at.skipSpace();
  }
  return equalsIgnoringCase(at.word(), "solid") &&
         source.text().substr(0, 512).find('\0') == std::string_view::npos;
}
}  // namespace

Result<RawMeshes> readStl(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  return isText(source) ? TextParser(source).parse() : readBinary(source);
}

}  // namespace sline::model
