// SPDX-License-Identifier: Apache-2.0
// Reads legacy VTK, POLYDATA of versions 1 to 5.1, text and binary: POINTS, POLYGONS and
// TRIANGLE_STRIPS. vtkPolyDataReader is not used, because it trusts counts and cell lengths (it
// allocates and reads by them before anything can check them) and takes seconds for a large text
// file.
#include "model/import/readers/vtk/legacy_vtk.h"

#include "model/base/letters.h"
#include "model/import/readers/vtk/vtk_readers.h"
#include "model/import/source/surface_assembly.h"

namespace sline::model {

namespace {
class LegacyParser {
 public:
  explicit LegacyParser(const Source& source)
      : m_file{source, TextCursor(source.text()), false, 0, {}, {}} {}

  Result<RawMeshes> parse() {
    TRY(readHeader());
    while (!m_done) {
      const std::string_view keyword = m_file.next();
      if (keyword.empty())
        break;
      TRY(readSection(keyword));
    }
    if (!m_hasPoints)
      return m_file.source.whole("has no POINTS");
    m_mesh.frame = m_file.frame;
    m_mesh.frameReason = m_file.frameReason;
    if (m_faces.size() == 0 && m_mesh.positions.empty())
      return m_file.source.whole("is empty: it holds no points");
    if (m_faces.size() == 0)
      return m_file.source.whole(
          m_skippedCells ? "holds points or lines but no POLYGONS" : "holds points but no POLYGONS",
          "Export the mesh as a surface of triangles");
    std::vector<ImportWarning> warnings;
    if (m_skippedCells)
      warnings.push_back(
          m_file.source.warning("VERTICES and LINES are left out; only polygons are read"));
    return assemble(m_file.source, std::move(m_mesh), m_faces, BadFaces::areErrors,
                    std::move(warnings));
  }

 private:
  static bool isEncoding(std::string_view line) {
    return equalsIgnoringCase(line, "binary") || equalsIgnoringCase(line, "ascii");
  }

  Status readHeader() {
    const char* place = m_file.at.at();
    std::string_view line = m_file.at.restOfLine();
    if (!line.starts_with("# vtk DataFile Version"))
      return m_file.source.atLine(place, "the file does not begin with '# vtk DataFile Version'",
                                  "Check that the file is a legacy VTK file");
    TextCursor version(line.substr(22));
    version.skipBlanks();
    double number = 0.0;
    if (!version.number(number) || !(number >= 1.0 && number < 6.0))
      return m_file.source.atLine(place, inQuotes(line.substr(22)) + " is not a version this reads",
                                  "Save the file in version 4.2 or 5.1");
    m_file.majorVersion = int(number);
    const std::string_view title = m_file.at.restOfLine();
    m_file.frame = frameInText(title);
    if (m_file.frame)
      m_file.frameReason = "SPACE in the title";
    place = m_file.at.at();
    line = m_file.at.restOfLine();
    // Some writers leave the title's line out.
    if (isEncoding(title) && line.size() >= 7 && equalsIgnoringCase(line.substr(0, 7), "dataset")) {
      m_file.at.moveTo(place);
      line = title;
    }
    m_file.binary = equalsIgnoringCase(line, "binary");
    if (!isEncoding(line))
      return m_file.wrong(place, inQuotes(line) + " stands where ASCII or BINARY should");
    return Unit{};
  }

  Status readSection(std::string_view keyword) {
    const char* place = keyword.data();
    if (equalsIgnoringCase(keyword, "dataset"))
      return checkDataset(place);
    if (equalsIgnoringCase(keyword, "field"))
      return readField(m_file);
    if (equalsIgnoringCase(keyword, "metadata")) {
      skipMetadata(m_file);
      return Unit{};
    }
    if (!m_isPolyData)
      return m_file.wrong(place, inQuotes(keyword) + " stands where DATASET should");
    if (equalsIgnoringCase(keyword, "points"))
      return readPoints(place);
    if (equalsIgnoringCase(keyword, "polygons"))
      return readCells(place, Cells::polygons);
    if (equalsIgnoringCase(keyword, "triangle_strips"))
      return readCells(place, Cells::strips);
    if (equalsIgnoringCase(keyword, "vertices") || equalsIgnoringCase(keyword, "lines"))
      return readCells(place, Cells::skipped);
    if (equalsIgnoringCase(keyword, "point_data") || equalsIgnoringCase(keyword, "cell_data")) {
      m_done = true;
      return skipAttributes(m_file);
    }
    return m_file.wrong(place, inQuotes(keyword) + " is not a section of POLYDATA");
  }

  Status checkDataset(const char* place) {
    const std::string_view type = m_file.next();
    m_isPolyData = equalsIgnoringCase(type, "polydata");
    if (!m_isPolyData)
      return m_file.wrong(place, "holds a dataset of type " + inQuotes(type) + ", not POLYDATA",
                          "Extract its surface and save that as POLYDATA");
    return Unit{};
  }

  Status readPoints(const char* place) {
    const std::optional<std::uint64_t> count = m_file.nextCount();
    const std::string_view typeName = m_file.next();
    const std::optional<ScalarType> type = legacyType(typeName);
    if (!count || !type)
      return m_file.wrong(place, "POINTS needs a count and a type of number");
    if (m_hasPoints)
      return m_file.wrong(place, "there are two sections POINTS");
    m_hasPoints = true;
    m_file.toValues();
    return withValues([&](auto& values) -> Status {
      const std::uint64_t atMost = values.atMost(*type) / 3;
      if (*count > atMost)
        return tooMany(place, "POINTS", *count, atMost);
      m_mesh.positions.resize(std::size_t(*count));
      for (glm::vec3& p : m_mesh.positions)
        if (!values.number(*type, p.x) || !values.number(*type, p.y) || !values.number(*type, p.z))
          return notANumber(values.at(), "POINTS");
      return Unit{};
    });
  }

  enum class Cells { polygons, strips, skipped };

  Status readCells(const char* place, Cells kind) {
    const std::optional<std::uint64_t> first = m_file.nextCount();
    const std::optional<std::uint64_t> second = m_file.nextCount();
    if (!first || !second)
      return m_file.wrong(place, "a section of cells needs two counts");
    m_skippedCells = m_skippedCells || (kind == Cells::skipped && *first > 0);
    if (m_file.majorVersion >= 5)
      return readOffsetCells(place, kind, *first, *second);
    m_file.toValues();
    return withValues(
        [&](auto& values) { return readCountedCells(values, place, kind, *first, *second); });
  }

  /// Reads cells of versions below 5: each cell is its number of points and the points; `numbers`
  /// counts both.
  template <class Values>
  Status readCountedCells(Values& values, const char* place, Cells kind, std::uint64_t cells,
                          std::uint64_t numbers) {
    constexpr ScalarType type = ScalarType::int32;
    if (numbers > values.atMost(type))
      return tooMany(place, "numbers of cells", numbers, values.atMost(type));
    if (cells > numbers)
      return m_file.wrong(place, "promises " + std::to_string(cells) + " cells of " +
                                     std::to_string(numbers) + " numbers altogether");
    if (kind == Cells::polygons)
      m_faces.reserve(std::size_t(cells), std::size_t(numbers - cells));
    std::uint64_t left = numbers;
    for (std::uint64_t i = 0; i < cells; ++i) {
      const char* at = values.at();
      std::int64_t length = 0;
      if (left == 0 || !values.integer(type, length) || length < 0 ||
          std::uint64_t(length) > left - 1)
        return m_file.wrong(at, "cell " + std::to_string(i) + " of " + std::to_string(cells) +
                                    " is longer than the section, or the file ends");
      left -= 1 + std::uint64_t(length);
      m_cell.clear();
      for (; length > 0; --length) {
        std::int64_t index = 0;
        if (!values.integer(type, index))
          return notANumber(values.at(), "cell " + std::to_string(i));
        m_cell.push_back(indexFrom(index));
      }
      addCell(kind, at);
    }
    if (left != 0)
      return m_file.wrong(place, "promises " + std::to_string(numbers) + " numbers, its " +
                                     std::to_string(cells) + " cells take " +
                                     std::to_string(numbers - left));
    return Unit{};
  }

  /// Reads cells of version 5: OFFSETS where each cell begins, one more than cells, and
  /// CONNECTIVITY.
  Status readOffsetCells(const char* place, Cells kind, std::uint64_t offsetCount,
                         std::uint64_t cornerCount) {
    if (offsetCount == 0)
      return Unit{};
    std::vector<std::int64_t> offsets;
    std::vector<std::int64_t> corners;
    TRY(readIntegers("OFFSETS", offsetCount, offsets));
    const char* at = m_file.at.at();
    TRY(readIntegers("CONNECTIVITY", cornerCount, corners));
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
      if (offsets[i] < 0 || offsets[i + 1] < offsets[i] ||
          std::uint64_t(offsets[i + 1]) > cornerCount)
        return m_file.wrong(
            place, "OFFSETS of cell " + std::to_string(i) + " do not fit its CONNECTIVITY");
      m_cell.clear();
      for (auto k = std::size_t(offsets[i]); k < std::size_t(offsets[i + 1]); ++k)
        m_cell.push_back(indexFrom(corners[k]));
      addCell(kind, at);
    }
    return Unit{};
  }

  Status readIntegers(const char* keyword, std::uint64_t count, std::vector<std::int64_t>& into) {
    const std::string_view word = m_file.next();
    const char* place = m_file.at.at() - word.size();
    if (word != keyword)
      return m_file.wrong(place, inQuotes(word) + " stands where " + keyword + " should");
    const std::string_view typeName = m_file.next();
    const std::optional<ScalarType> type = legacyType(typeName);
    if (!type)
      return m_file.wrong(place, inQuotes(typeName) + " is not a type of legacy VTK");
    m_file.toValues();
    return withValues([&](auto& values) -> Status {
      if (count > values.atMost(*type))
        return tooMany(place, keyword, count, values.atMost(*type));
      into.resize(std::size_t(count));
      for (std::int64_t& value : into)
        if (!values.integer(*type, value))
          return notANumber(values.at(), keyword);
      return Unit{};
    });
  }

  void addCell(Cells kind, const char* place) {
    if (kind == Cells::strips) {
      addStrip(m_cell, m_faces, place);
    } else if (kind == Cells::polygons) {
      for (const std::uint32_t v : m_cell)
        m_faces.add(v, place);
      m_faces.close();
    }
  }

  /// Reads values from the position on, in the file's encoding, and moves behind them.
  template <class Read>
  Status withValues(const Read& read) {
    const auto run = [&](auto values) {
      Status status = read(values);
      m_file.at.moveTo(values.at());
      return status;
    };
    if (m_file.binary)
      return run(BinaryValues(m_file.at.at(), m_file.at.end(), std::endian::big));
    return run(TextValues(m_file.at.at(), m_file.at.end()));
  }

  Error tooMany(const char* place, const char* what, std::uint64_t count,
                std::uint64_t atMost) const {
    return m_file.wrong(place, "promises " + std::to_string(count) + " " + what +
                                   ", the rest of the file holds at most " +
                                   std::to_string(atMost));
  }

  Error notANumber(const char* place, const std::string& within) const {
    TextCursor at(place, m_file.at.end());
    at.skipSpace();
    if (m_file.binary || at.atEnd())
      return m_file.wrong(m_file.at.end(), "the file ends within " + within);
    return m_file.wrong(at.at(), inQuotes(at.peekWord()) + " in " + within + " is not a number");
  }

  LegacyVtk m_file;
  RawMesh m_mesh;
  FaceList m_faces;
  std::vector<std::uint32_t> m_cell;
  bool m_isPolyData = false;
  bool m_hasPoints = false;
  bool m_skippedCells = false;
  bool m_done = false;
};
}  // namespace

Result<RawMeshes> readLegacyVtk(const std::filesystem::path& file, const ReadLimits& limits) {
  const Source source = TRY(Source::read(file, limits));
  return LegacyParser(source).parse();
}

}  // namespace sline::model
