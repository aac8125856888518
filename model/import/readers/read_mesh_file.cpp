// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdio>

#include "model/import/readers/readers.h"
#include "model/import/readers/source.h"
#include "model/import/readers/text_cursor.h"

namespace sline::model {

namespace {
struct Kind {
  std::string_view extension;
  std::string_view name;
  Result<RawMeshes> (*read)(const std::filesystem::path&, const ReadLimits&);
};

constexpr std::array kinds = {Kind{".obj", "OBJ", readObj},
                              Kind{".stl", "STL", readStl},
                              Kind{".ply", "PLY", readPly},
                              Kind{".off", "OFF", readOff},
                              Kind{".vtk", "legacy VTK", readLegacyVtk},
                              Kind{".vtp", "VTP", readVtp},
                              Kind{".gltf", "glTF", readGltf},
                              Kind{".glb", "GLB", readGltf}};

const Kind* kindOf(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  for (const Kind& kind : kinds)
    if (equalsIgnoringCase(extension, kind.extension))
      return &kind;
  return nullptr;
}

/// What the first bytes say a file is; nothing where they do not tell.
std::string_view kindInContent(const std::filesystem::path& file) {
  std::array<char, 512> bytes{};
  std::FILE* handle = std::fopen(file.string().c_str(), "rb");
  if (!handle)
    return {};
  const std::size_t size = std::fread(bytes.data(), 1, bytes.size(), handle);
  std::fclose(handle);
  const std::string_view text(bytes.data(), size);
  struct Row {
    std::string_view beginning;
    std::string_view name;
  };
  static constexpr Row rows[] = {{"# vtk DataFile", "legacy VTK"},
                                 {"glTF", "GLB"},
                                 {"ply\n", "PLY"},
                                 {"ply\r", "PLY"},
                                 {"OFF", "OFF"},
                                 {"COFF", "OFF"},
                                 {"NOFF", "OFF"},
                                 {"PK\x03\x04", "a ZIP archive"},
                                 {"\x1f\x8b", "a gzip archive"},
                                 {"NRRD", "NRRD"},
                                 {"\x89PNG", "PNG"},
                                 {"%PDF", "PDF"}};
  for (const Row& row : rows)
    if (text.starts_with(row.beginning))
      return row.name;
  if (text.find("<VTKFile") != std::string_view::npos)
    return text.find("PolyData") != std::string_view::npos ? "VTP" : "VTK XML";
  if (text.find("<MRML") != std::string_view::npos)
    return "a 3D Slicer scene";
  if (text.starts_with("solid") && text.find("facet") != std::string_view::npos)
    return "STL";
  TextCursor at(text);
  at.skipSpace();
  if (at.peek() == '{' && text.find('"') != std::string_view::npos)
    return "glTF";
  while (at.peek() == '#') {
    at.skipLine();
    at.skipSpace();
  }
  return at.peekWord() == "v" ? "OBJ" : std::string_view();
}
}  // namespace

bool isMeshFile(const std::filesystem::path& file) {
  return kindOf(file) != nullptr;
}

Result<RawMeshes> readMeshFile(const std::filesystem::path& file, const ReadLimits& limits) {
  const Kind* kind = kindOf(file);
  std::error_code code;
  const std::string_view content =
      std::filesystem::is_regular_file(file, code) ? kindInContent(file) : std::string_view();
  if (!kind) {
    if (!std::filesystem::is_regular_file(file, code))
      if (const Result<Source> source = Source::read(file, limits); !source)
        return source.error();
    std::string reason = file.extension().empty() ? "has no extension that tells its kind"
                                                  : "files of kind '" + file.extension().string() +
                                                        "' are not supported";
    if (!content.empty())
      reason += "; its content looks like " + std::string(content);
    return Error{
        file.string(), {}, reason, "Use .obj, .stl, .ply, .off, .vtk, .vtp, .gltf or .glb"};
  }
  Result<RawMeshes> result = kind->read(file, limits);
  // "glTF" and "GLB" are read by the same reader under either extension.
  const bool other = !content.empty() && content != kind->name &&
                     !(content.starts_with("gl") && kind->read == readGltf) && content != "GLB";
  if (!result && (other || (content == "GLB" && kind->read != readGltf))) {
    Error error = result.error();
    error.reason += "; its content looks like " + std::string(content);
    error.remedy = "Give the file the extension of its kind or export the mesh again";
    return error;
  }
  return result;
}

}  // namespace sline::model
