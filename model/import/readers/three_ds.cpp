// SPDX-License-Identifier: Apache-2.0
// Reads 3D Studio's .3ds: chunks in chunks, each of an id, a length and its content. Vertices stand
// in the scene's own coordinates (+z up), wherever a mesh's axes and its animation say it turns
// about, so neither is looked at.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

#include "model/import/readers/readers.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {

enum Chunk3ds : std::uint16_t {
  colourFloat = 0x0010,
  colourBytes = 0x0011,
  colourBytesGamma = 0x0012,
  colourFloatGamma = 0x0013,
  percentWhole = 0x0030,
  percentReal = 0x0031,
  editor = 0x3d3d,
  object = 0x4000,
  triangleMesh = 0x4100,
  vertexList = 0x4110,
  faceList = 0x4120,
  faceMaterial = 0x4130,
  mainFile = 0x4d4d,
  materialName = 0xa000,
  materialDiffuse = 0xa020,
  materialTransparency = 0xa050,
  material = 0xafff
};
constexpr std::size_t chunkHeader = 6;
constexpr bool swap3ds = std::endian::native != std::endian::little;

/// Describes the content of one chunk, behind its header.
struct ChunkSpan {
  std::uint16_t id = 0;
  const char* at = nullptr;
  const char* end = nullptr;
  std::size_t size() const { return std::size_t(end - at); }
};

/// Returns text up to a zero, and moves `chunk` behind it.
std::string_view textIn(ChunkSpan& chunk) {
  const char* zero = std::find(chunk.at, chunk.end, '\0');
  const std::string_view text(chunk.at, std::size_t(zero - chunk.at));
  chunk.at = zero == chunk.end ? zero : zero + 1;
  return text;
}

struct Material3ds {
  std::optional<Colour> colour;
  std::optional<Opacity> opacity;
};

class ThreeDsReader {
 public:
  explicit ThreeDsReader(const Source& source) : m_source(source) {}

  Result<RawMeshes> read() {
    const char* begin = m_source.begin();
    if (m_source.size() < chunkHeader || loadAs<std::uint16_t>(begin, swap3ds) != mainFile)
      return m_source.whole("is no file of 3D Studio: it does not begin with its mark");
    const auto length = loadAs<std::uint32_t>(begin + 2, swap3ds);
    if (length < chunkHeader || length > m_source.size())
      return m_source.atByte(m_source.end(), "its beginning promises " + std::to_string(length) +
                                                 " bytes, it has " +
                                                 std::to_string(m_source.size()));
    TRY(readFile({mainFile, begin + chunkHeader, begin + length}));
    if (m_result.meshes.empty())
      return m_source.whole("holds no meshes", "Export the mesh again, as triangles");
    return std::move(m_result);
  }

 private:
  /// Returns the chunks that stand one after another; one that is longer than the chunk around it
  /// is an error.
  Result<std::vector<ChunkSpan>> chunksIn(const ChunkSpan& in) const {
    std::vector<ChunkSpan> chunks;
    for (const char* at = in.at; in.end - at >= std::ptrdiff_t(chunkHeader);) {
      const auto length = loadAs<std::uint32_t>(at + 2, swap3ds);
      if (length < chunkHeader || length > std::size_t(in.end - at))
        return m_source.atByte(at, "a part promises " + std::to_string(length) +
                                       " bytes, there are " + std::to_string(in.end - at));
      chunks.push_back({loadAs<std::uint16_t>(at, swap3ds), at + chunkHeader, at + length});
      at += length;
    }
    return chunks;
  }

  Status readFile(const ChunkSpan& file) {
    const std::vector<ChunkSpan> parts = TRY(chunksIn(file));
    for (const ChunkSpan& part : parts) {
      if (part.id != editor)
        continue;
      const std::vector<ChunkSpan> entries = TRY(chunksIn(part));
      // Objects refer to materials, which may stand behind the objects.
      for (const ChunkSpan& entry : entries)
        if (entry.id == material)
          TRY(readMaterial(entry));
      for (const ChunkSpan& entry : entries)
        if (entry.id == object)
          TRY(readObject(entry));
    }
    return Unit{};
  }

  Status readMaterial(const ChunkSpan& chunk) {
    const std::vector<ChunkSpan> parts = TRY(chunksIn(chunk));
    std::string name;
    Material3ds read;
    for (ChunkSpan part : parts) {
      if (part.id == materialName)
        name = textIn(part);
      if (part.id != materialDiffuse && part.id != materialTransparency)
        continue;
      const std::vector<ChunkSpan> values = TRY(chunksIn(part));
      for (const ChunkSpan& value : values)
        if (part.id == materialDiffuse)
          takeColour(value, read);
        else
          takeTransparency(value, read);
    }
    m_materials[name] = read;
    return Unit{};
  }

  /// Takes a colour. If there are two kinds of values, the one for screens is written first, and
  /// stays.
  static void takeColour(const ChunkSpan& value, Material3ds& read) {
    const bool bytes = value.id == colourBytes || value.id == colourBytesGamma;
    const bool reals = value.id == colourFloat || value.id == colourFloatGamma;
    if (read.colour || (bytes && value.size() < 3) || (reals && value.size() < 12) ||
        !(bytes || reals))
      return;
    const auto channel = [&](std::size_t i) {
      if (bytes)
        return std::uint8_t(value.at[i]);
      const float real = loadAs<float>(value.at + 4 * i, swap3ds);
      return std::uint8_t(std::lround(255.0f * (real > 0.0f ? std::min(real, 1.0f) : 0.0f)));
    };
    read.colour = Colour{channel(0), channel(1), channel(2)};
  }

  static void takeTransparency(const ChunkSpan& value, Material3ds& read) {
    float share = 0.0f;
    if (value.id == percentWhole && value.size() >= 2)
      share = float(loadAs<std::int16_t>(value.at, swap3ds)) / 100.0f;
    else if (value.id == percentReal && value.size() >= 4)
      share = loadAs<float>(value.at, swap3ds);
    if (share > 0.0f && share < 1.0f)
      read.opacity = Opacity::clamped(1.0f - share);
  }

  Status readObject(ChunkSpan chunk) {
    const std::string_view name = textIn(chunk);
    const std::vector<ChunkSpan> parts = TRY(chunksIn(chunk));
    for (const ChunkSpan& part : parts)
      if (part.id == triangleMesh)
        TRY(readMesh(part, name));
    return Unit{};
  }

  Status readMesh(const ChunkSpan& chunk, std::string_view name) {
    const std::vector<ChunkSpan> parts = TRY(chunksIn(chunk));
    std::vector<glm::vec3> positions;
    const ChunkSpan* faces = nullptr;
    for (const ChunkSpan& part : parts) {
      if (part.id == faceList)
        faces = &part;
      if (part.id != vertexList)
        continue;
      const std::size_t count = countIn(part);
      if (part.size() < 2 + 12 * count)
        return m_source.atByte(
            part.at, "promises " + std::to_string(count) + " vertices, more than there are");
      for (const char* at = part.at + 2; positions.size() < count; at += 12)
        positions.emplace_back(loadAs<float>(at, swap3ds), loadAs<float>(at + 4, swap3ds),
                               loadAs<float>(at + 8, swap3ds));
    }
    if (!faces)
      return Unit{};
    return addFaces(*faces, positions, name);
  }

  static std::size_t countIn(const ChunkSpan& part) {
    return part.size() < 2 ? 0 : loadAs<std::uint16_t>(part.at, swap3ds);
  }

  /// Adds faces: three corners and flags each; behind them, which of them have which material.
  Status addFaces(const ChunkSpan& part, const std::vector<glm::vec3>& positions,
                  std::string_view name) {
    const std::size_t count = countIn(part);
    if (part.size() < 2 + 8 * count)
      return m_source.atByte(part.at,
                             "promises " + std::to_string(count) + " faces, more than there are");
    const char* behind = part.at + std::min(part.size(), 2 + 8 * count);
    const std::vector<ChunkSpan> parts = TRY(chunksIn({faceList, behind, part.end}));
    std::vector<std::size_t> materialOf(count, 0);
    std::vector<const Material3ds*> used{nullptr};
    for (ChunkSpan entry : parts)
      if (entry.id == faceMaterial)
        paint(entry, materialOf, used);
    for (std::size_t i = 0; i < used.size(); ++i)
      TRY(addPainted({part, materialOf, i, used[i]}, positions, name));
    return Unit{};
  }

  void paint(ChunkSpan& entry, std::vector<std::size_t>& materialOf,
             std::vector<const Material3ds*>& used) const {
    const auto found = m_materials.find(textIn(entry));
    if (found == m_materials.end())
      return;
    const std::size_t count =
        std::min(countIn(entry), (entry.size() - std::min<std::size_t>(2, entry.size())) / 2);
    used.push_back(&found->second);
    for (std::size_t i = 0; i < count; ++i)
      if (const auto face = loadAs<std::uint16_t>(entry.at + 2 + 2 * i, swap3ds);
          face < materialOf.size())
        materialOf[face] = used.size() - 1;
  }

  /// Holds the faces of one mesh that have the same material.
  struct PaintedFaces {
    const ChunkSpan& part;
    const std::vector<std::size_t>& materialOf;
    std::size_t which;
    const Material3ds* material;
  };

  Status addPainted(const PaintedFaces& painted, const std::vector<glm::vec3>& positions,
                    std::string_view name) {
    FaceList faces;
    for (std::size_t i = 0; i < painted.materialOf.size(); ++i) {
      if (painted.materialOf[i] != painted.which)
        continue;
      const char* at = painted.part.at + 2 + 8 * i;
      for (std::size_t corner = 0; corner < 3; ++corner)
        faces.add(loadAs<std::uint16_t>(at + 2 * corner, swap3ds), at);
      faces.close();
    }
    if (faces.size() == 0)
      return Unit{};
    RawMesh mesh;
    mesh.name = name;
    if (painted.material) {
      mesh.colour = painted.material->colour;
      mesh.opacity = painted.material->opacity;
    }
    CutTally tally;
    cutFaces({faces, 0, faces.size()}, positions, mesh.triangles, tally);
    TRY(judge(m_source, faces, tally, BadFaces::areErrors, m_result.warnings));
    keepUsed(positions, m_scratch, mesh);
    m_scratch.clear();
    return finish(m_source, std::move(mesh), m_result);
  }

  const Source& m_source;
  std::map<std::string, Material3ds, std::less<>> m_materials;
  std::vector<std::uint32_t> m_scratch;
  RawMeshes m_result;
};

}  // namespace

Result<RawMeshes> readThreeDs(const std::filesystem::path& file, const ReadLimits& limits) {
  const Result<Source> source = Source::read(file, limits);
  return source ? ThreeDsReader(*source).read() : source.error();
}

}  // namespace sline::model
