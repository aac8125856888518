// SPDX-License-Identifier: Apache-2.0
// Reads FBX, COLLADA and Blender's files through assimp 5.2 (github.com/assimp/assimp,
// BSD-3-Clause).
#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/ProgressHandler.hpp>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <set>

#include "model/import/foreign/assimp_convention.h"
#include "model/import/foreign/assimp_files.h"
#include "model/import/foreign/assimp_scene.h"
#include "model/import/foreign/foreign.h"

namespace sline::model {

namespace {

struct AssimpKind {
  const char* name;
  const char* extension;
  AssimpConvention (*convention)(const aiScene&);
  const char* remedy;  ///< for files that cannot be read
};

constexpr AssimpKind fbxKind{"FBX", ".fbx", fbxConvention,
                             "Export it again as FBX 7.4 (2014) or as glTF"};
constexpr AssimpKind colladaKind{"COLLADA", ".dae", colladaConvention,
                                 "Export it again, or as glTF"};
constexpr AssimpKind blendKind{"a scene of Blender", ".blend", blendConvention,
                               "Open it in Blender and export it as glTF"};

/// Lets assimp go on for as long as the reader may.
class GoesOn : public Assimp::ProgressHandler {
 public:
  explicit GoesOn(const std::function<bool()>& goesOn) : m_goesOn(goesOn) {}
  bool Update(float) override { return m_goesOn(); }

 private:
  const std::function<bool()>& m_goesOn;
};

/// Keeps only the importer of the extension: assimp asks all its importers whether they know a
/// file.
void keepOnly(const char* extension, Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i > 0; --i) {
    Assimp::BaseImporter* each = importer.GetImporter(i - 1);
    std::set<std::string> endings;
    each->GetExtensionList(endings);
    if (endings.contains(extension + 1))
      continue;
    importer.UnregisterLoader(each);
    const std::unique_ptr<Assimp::BaseImporter> taken(each);
  }
}

/// Returns a library's message in one line that is not too long.
std::string oneLine(const char* text) {
  std::string line(text);
  line.resize(std::min({line.size(), line.find('\n'), std::size_t(200)}));
  for (char& c : line)
    c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return line;
}

Result<RawMeshes> readWith(const AssimpKind& kind, const Source& source,
                           const ReadOptions& options) {
  if (source.text().starts_with("\x28\xb5\x2f\xfd"))
    return source.whole("is packed by zstd", kind.remedy);
  Assimp::Importer importer;
  keepOnly(kind.extension, importer);
  importer.SetIOHandler(std::make_unique<AssimpFiles>(source).release());
  importer.SetProgressHandler(std::make_unique<GoesOn>(options.goesOn).release());
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_CAMERAS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_LIGHTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(source.file(), 0);
  if (!scene || !scene->mRootNode)
    return source.whole(
        std::string("cannot be read as ") + kind.name + ": " + oneLine(importer.GetErrorString()),
        kind.remedy);
  return meshesOf(*scene, kind.convention(*scene), source);
}

Result<RawMeshes> readThroughAssimp(const AssimpKind& kind, const std::filesystem::path& file,
                                    const ReadOptions& options) {
  const Source source = TRY(Source::read(file, options.limits));
  try {
    return readWith(kind, source, options);
  } catch (const std::bad_alloc&) {
    return source.whole("there is not enough memory for it", "Reduce it or close other programs");
  } catch (const std::exception& e) {
    return source.whole(std::string("cannot be read as ") + kind.name + ": " + oneLine(e.what()),
                        kind.remedy);
  }
}

}  // namespace

Result<RawMeshes> readFbx(const std::filesystem::path& file, const ReadOptions& options) {
  return readThroughAssimp(fbxKind, file, options);
}

Result<RawMeshes> readCollada(const std::filesystem::path& file, const ReadOptions& options) {
  return readThroughAssimp(colladaKind, file, options);
}

Result<RawMeshes> readBlend(const std::filesystem::path& file, const ReadOptions& options) {
  return readThroughAssimp(blendKind, file, options);
}

}  // namespace sline::model
