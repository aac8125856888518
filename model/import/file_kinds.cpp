// SPDX-License-Identifier: Apache-2.0
#include "model/import/file_kinds.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "model/import/dicom/dicom_file.h"
#include "model/import/molecules/molecules.h"
#include "model/import/readers/gltf_decoders.h"
#include "model/import/readers/readers.h"
#include "model/import/readers/source.h"
#include "model/import/readers/text_cursor.h"
#include "model/import/volumes/volume_surfaces.h"
#include "model/import/worker/reading_child.h"

namespace sline::model {

namespace {

/// A reader that needs only the limits.
template <auto reader>
Result<RawMeshes> within(const std::filesystem::path& file, const ReadOptions& options) {
  return reader(file, options.limits);
}

/// Compressed ones are read by those who have the libraries.
Result<RawMeshes> readAnyGltf(const std::filesystem::path& file, const ReadOptions& options) {
  return isCompressedGltf(file) ? readInChild("compressed glTF", {&file, 1}, options)
                                : readGltf(file, options.limits);
}

constexpr std::array kinds = {FileKind{".obj", "OBJ", within<readObj>},
                              FileKind{".stl", "STL", within<readStl>},
                              FileKind{".ply", "PLY", within<readPly>},
                              FileKind{".off", "OFF", within<readOff>},
                              FileKind{".vtk", "legacy VTK", within<readLegacyVtk>},
                              FileKind{".vtp", "VTP", within<readVtp>},
                              FileKind{".gltf", "glTF", readAnyGltf},
                              FileKind{".glb", "GLB", readAnyGltf},
                              FileKind{".vtu", "VTU", nullptr},
                              FileKind{".3mf", "3MF", within<readThreeMf>},
                              FileKind{".wrl", "VRML", within<readX3d>},
                              FileKind{".x3d", "X3D", within<readX3d>},
                              FileKind{".x3dv", "X3D", within<readX3d>},
                              FileKind{".3ds", "3DS", within<readThreeDs>},
                              FileKind{".fbx", "FBX", nullptr},
                              FileKind{".dae", "COLLADA", nullptr},
                              FileKind{".blend", "Blender", nullptr},
                              FileKind{".nii", "NIfTI", readNiftiSurfaces, true},
                              FileKind{".nii.gz", "packed NIfTI", readNiftiSurfaces, true},
                              FileKind{".nrrd", "NRRD", readNrrdSurfaces, true},
                              FileKind{".nhdr", "NRRD", readNrrdSurfaces, true},
                              FileKind{".mha", "MetaImage", readMetaImageSurfaces, true},
                              FileKind{".mhd", "MetaImage", readMetaImageSurfaces, true},
                              FileKind{".mnc", "MINC", readMincSurfaces, true},
                              FileKind{".dcm", "DICOM", nullptr},
                              FileKind{".pdb", "PDB", readPdb},
                              FileKind{".ent", "PDB", readPdb},
                              FileKind{".cif", "mmCIF", readMmcif},
                              FileKind{".mmcif", "mmCIF", readMmcif}};

/// The kind with the longest ending that fits.
const FileKind* kindOf(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const FileKind* found = nullptr;
  for (const FileKind& kind : kinds)
    if (endsLike(name, kind.extension) &&
        (!found || kind.extension.size() > found->extension.size()))
      found = &kind;
  if (!found && mayBeDicom(file))
    found = &*std::find_if(kinds.begin(), kinds.end(),
                           [](const FileKind& kind) { return kind.name == "DICOM"; });
  return found;
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
                                 {"Kaydara FBX Binary", "FBX"},
                                 {"BLENDER", "Blender"},
                                 {"CDF\x01", "MINC"},
                                 {"CDF\x02", "MINC"},
                                 {"#VRML", "VRML"},
                                 {"#X3D", "X3D"},
                                 {"\x89PNG", "PNG"},
                                 {"%PDF", "PDF"}};
  for (const Row& row : rows)
    if (text.starts_with(row.beginning))
      return row.name;
  if (text.size() > 132 && text.substr(128, 4) == "DICM")
    return "DICOM";
  if (text.find("<VTKFile") != std::string_view::npos)
    return text.find("PolyData") != std::string_view::npos           ? "VTP"
           : text.find("UnstructuredGrid") != std::string_view::npos ? "VTU"
                                                                     : "VTK XML";
  if (text.find("<X3D") != std::string_view::npos)
    return "X3D";
  if (text.find("<COLLADA") != std::string_view::npos)
    return "COLLADA";
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

bool endsLike(std::string_view name, std::string_view ending) {
  return name.size() > ending.size() &&
         equalsIgnoringCase(name.substr(name.size() - ending.size()), ending);
}

std::span<const FileKind> fileKinds() {
  return kinds;
}

std::string surfaceExtensions() {
  std::string list;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    list += (i == 0 ? "" : i + 1 < kinds.size() ? ", " : " or ") + std::string(kinds[i].extension);
  return list;
}

bool isSurfaceFile(const std::filesystem::path& file) {
  return kindOf(file) != nullptr;
}

bool isDicomFile(const std::filesystem::path& file) {
  const FileKind* kind = kindOf(file);
  return kind && kind->name == "DICOM";
}

bool isVolumeFile(const std::filesystem::path& file) {
  const FileKind* kind = kindOf(file);
  return kind && kind->volume;
}

std::string stemOf(const std::filesystem::path& file) {
  const FileKind* kind = kindOf(file);
  std::string name = file.filename().string();
  return kind && endsLike(name, kind->extension)
             ? name.substr(0, name.size() - kind->extension.size())
             : file.stem().string();
}

Result<RawMeshes> readSurfaces(const std::filesystem::path& file, const ReadOptions& options) {
  const FileKind* kind = kindOf(file);
  std::error_code code;
  const std::string_view content =
      std::filesystem::is_regular_file(file, code) ? kindInContent(file) : std::string_view();
  if (!kind) {
    if (!std::filesystem::is_regular_file(file, code))
      if (const Result<Source> source = Source::read(file, options.limits); !source)
        return source.error();
    std::string reason = file.extension().empty() ? "has no extension that tells its kind"
                                                  : "files of kind '" + file.extension().string() +
                                                        "' are not supported";
    if (!content.empty())
      reason += "; its content looks like " + std::string(content);
    return Error{file.string(), {}, reason, "Use " + surfaceExtensions()};
  }
  Result<RawMeshes> result =
      kind->read ? kind->read(file, options) : readInChild(kind->name, {&file, 1}, options);
  // "glTF" and "GLB" are read by the same reader under either extension.
  const bool gltf = kind->name == "glTF" || kind->name == "GLB";
  const bool packed = (kind->name == "3MF" && content == "a ZIP archive") ||
                      (kind->extension.ends_with(".gz") && content == "a gzip archive");
  const bool same =
      packed || content == kind->name || (gltf && (content == "glTF" || content == "GLB"));
  if (!result && !content.empty() && !same) {
    Error error = result.error();
    error.reason += "; its content looks like " + std::string(content);
    error.remedy = "Give the file the extension of its kind or export the mesh again";
    return error;
  }
  return result;
}

}  // namespace sline::model
