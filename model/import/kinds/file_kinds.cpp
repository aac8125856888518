// SPDX-License-Identifier: Apache-2.0
#include "model/import/kinds/file_kinds.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "model/base/letters.h"
#include "model/import/molecules/molecules.h"
#include "model/import/readers/dicom_kind.h"
#include "model/import/readers/gltf/gltf.h"
#include "model/import/readers/gltf/gltf_decoders.h"
#include "model/import/readers/readers.h"
#include "model/import/readers/vtk/vtk_readers.h"
#include "model/import/readers/x3d/x3d.h"
#include "model/import/source/source.h"
#include "model/import/source/text_cursor.h"
#include "model/import/volumes/formats/image_pair.h"
#include "model/import/volumes/volume_surfaces.h"
#include "model/import/worker/reading_child.h"

namespace sline::model {

namespace {

/// Adapts a reader that needs only the limits.
template <auto reader>
Result<RawMeshes> within(const std::filesystem::path& file, const ReadOptions& options) {
  return reader(file, options.limits);
}

/// Reads any glTF; compressed ones are read by the child process, which has the libraries.
Result<RawMeshes> readAnyGltf(const std::filesystem::path& file, const ReadOptions& options) {
  return isCompressedGltf(file) ? readInChild("compressed glTF", {&file, 1}, options)
                                : readGltf(file, options.limits);
}

constexpr std::array kinds = {
    FileKind{".obj", "OBJ", within<readObj>, false, true},
    FileKind{".stl", "STL", within<readStl>, false, true},
    FileKind{".ply", "PLY", within<readPly>, false, true},
    FileKind{".off", "OFF", within<readOff>, false, true},
    FileKind{".vtk", "legacy VTK", within<readLegacyVtk>, false, true},
    FileKind{".vtp", "VTP", within<readVtp>, false, true},
    FileKind{".gltf", "glTF", readAnyGltf, false, true},
    FileKind{".glb", "GLB", readAnyGltf, false, true},
    FileKind{".vtu", "VTU", nullptr},
    FileKind{".3mf", "3MF", within<readThreeMf>},
    FileKind{".wrl", "VRML", within<readX3d>, false, true},
    FileKind{".x3d", "X3D", within<readX3d>},
    FileKind{".x3dv", "X3D", within<readX3d>},
    FileKind{".3ds", "3DS", within<readThreeDs>},
    FileKind{".fbx", "FBX", nullptr},
    FileKind{".dae", "COLLADA", nullptr},
    FileKind{".blend", "Blender", nullptr},
    FileKind{".gii", "GIFTI", within<readGifti>, false, true, isGiftiAnatomy},
    FileKind{".pial", "FreeSurfer", within<readFreeSurferSurface>, false, false,
             isFreeSurferAnatomy},
    FileKind{".white", "FreeSurfer", within<readFreeSurferSurface>, false, false,
             isFreeSurferAnatomy},
    FileKind{".smoothwm", "FreeSurfer", within<readFreeSurferSurface>, false, false,
             isFreeSurferAnatomy},
    FileKind{".orig", "FreeSurfer", within<readFreeSurferSurface>, false, false,
             isFreeSurferAnatomy},
    FileKind{".inflated", "FreeSurfer", within<readFreeSurferSurface>, false, false,
             isFreeSurferAnatomy},
    FileKind{".sphere", "FreeSurfer", within<readFreeSurferSurface>, false, false,
             isFreeSurferAnatomy},
    FileKind{".nii", "NIfTI", readVolumeSurfaces, true, true},
    FileKind{".hdr", "NIfTI or Analyze", readVolumeSurfaces, true, true, isImagePair},
    FileKind{".img", "NIfTI or Analyze", readVolumeSurfaces, true, true, isImagePair},
    FileKind{".mgz", "FreeSurfer volume", readVolumeSurfaces, true},
    FileKind{".mgh", "FreeSurfer volume", readVolumeSurfaces, true, true},
    FileKind{".nrrd", "NRRD", readVolumeSurfaces, true},
    FileKind{".nhdr", "NRRD", readVolumeSurfaces, true},
    FileKind{".mha", "MetaImage", readVolumeSurfaces, true},
    FileKind{".mhd", "MetaImage", readVolumeSurfaces, true},
    FileKind{".mnc", "MINC", readVolumeSurfaces, true},
    FileKind{".dcm", dicomKind, nullptr},
    FileKind{".pdb", "PDB", readPdb, false, true},
    FileKind{".ent", "PDB", readPdb, false, true},
    FileKind{".cif", "mmCIF", readMmcif, false, true},
    FileKind{".mmcif", "mmCIF", readMmcif, false, true},
    FileKind{".json", "mmJSON", readMmjson, false, true, isMmjson}};

constexpr std::string_view packedEnding = ".gz";

/// Returns how many letters at the end of the name tell the kind; 0 where they are others.
std::size_t endingLength(std::string_view name, const FileKind& kind) {
  if (endsLike(name, kind.extension))
    return kind.extension.size();
  if (!kind.packs || !endsLike(name, packedEnding))
    return 0;
  name.remove_suffix(packedEnding.size());
  return endsLike(name, kind.extension) ? kind.extension.size() + packedEnding.size() : 0;
}

const FileKind* kindOf(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (const FileKind& kind : kinds)
    if (endingLength(name, kind) > 0)
      return &kind;
  if (!mayBeDicom(file))
    return nullptr;
  return &*std::find_if(kinds.begin(), kinds.end(),
                        [](const FileKind& kind) { return kind.name == dicomKind; });
}

/// Returns what the first bytes say a file is; nothing where they do not tell.
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
                                 {"ENVI", "a header of ENVI"},
                                 {"#?RADIANCE", "a picture of Radiance"},
                                 {"\xff\xff\xfe", "FreeSurfer"},
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
  return list + ", many of them packed (.gz) too";
}

std::vector<std::string> surfaceEndings() {
  std::vector<std::string> endings;
  for (const FileKind& kind : kinds) {
    endings.emplace_back(kind.extension);
    if (kind.packs)
      endings.push_back(endings.back() + std::string(packedEnding));
  }
  return endings;
}

bool isArchive(const std::filesystem::path& file) {
  static constexpr std::array<std::string_view, 10> endings{
      ".zip", ".mrb", ".7z", ".rar", ".tar", ".tgz", ".tar.gz", ".tar.bz2", ".tar.xz", ".tar.zst"};
  const std::string name = file.filename().string();
  return std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view ending) { return endsLike(name, ending); });
}

bool isSurfaceFile(const std::filesystem::path& file) {
  return kindOf(file) != nullptr;
}

bool isSurfaceFileInFolder(const std::filesystem::path& file) {
  const FileKind* kind = kindOf(file);
  return kind && (!kind->isOne || kind->isOne(file));
}

bool isDicomFile(const std::filesystem::path& file) {
  const FileKind* kind = kindOf(file);
  return kind && kind->name == dicomKind;
}

bool isVolumeFile(const std::filesystem::path& file) {
  const FileKind* kind = kindOf(file);
  return kind && kind->volume;
}

std::string stemOf(const std::filesystem::path& file) {
  const FileKind* kind = kindOf(file);
  const std::string name = file.filename().string();
  const std::size_t ending = kind ? endingLength(name, *kind) : 0;
  return ending > 0 ? name.substr(0, name.size() - ending) : file.stem().string();
}

Result<RawMeshes> readSurfaces(const std::filesystem::path& file, const ReadOptions& options) {
  const FileKind* kind = kindOf(file);
  std::error_code code;
  const std::string_view content =
      std::filesystem::is_regular_file(file, code) ? kindInContent(file) : std::string_view();
  if (!kind) {
    if (!std::filesystem::is_regular_file(file, code))
      TRY(Source::read(file, options.limits));
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
                      (content == "a gzip archive" && (kind->packs || kind->volume));
  // The content of JSON tells only that it is JSON.
  const bool json = kind->name == "mmJSON" && content == "glTF";
  const bool same =
      packed || json || content == kind->name || (gltf && (content == "glTF" || content == "GLB"));
  if (!result && !content.empty() && !same) {
    Error error = result.error();
    error.reason += "; its content looks like " + std::string(content);
    error.remedy = "Give the file the extension of its kind or export the mesh again";
    return error;
  }
  return result;
}

}  // namespace sline::model
