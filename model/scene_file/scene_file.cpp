// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/scene_file.h"

#include <algorithm>
#include <set>

#include "model/base/letters.h"
#include "model/disk/memory_budget.h"
#include "model/disk/whole_file.h"
#include "model/scene/scene_limits.h"
#include "model/scene_file/fingerprint.h"
#include "model/scene_file/mesh_codec.h"
#include "model/scene_file/paint_codec.h"
#include "model/scene_file/scan_codec.h"
#include "model/scene_json/scene_json.h"
#include "model/scene_json/scene_migration.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view sceneMember = "scene.json";
constexpr std::string_view thumbnailMember = "thumbnail.png";
constexpr std::size_t largestFile = std::size_t(4) << 30;
/// So many of the things that were left out are told by name.
constexpr std::size_t mostNamed = 3;
constexpr const char* unreadable = "Open an older copy of it, or import the meshes again";

Error placed(Error error, std::string_view member) {
  error.where = std::string(member) + (error.where.empty() ? "" : ": " + error.where);
  return error;
}

Result<Json> sceneJsonOf(const ZipReader& zip) {
  const ZipReader::Entry* entry = zip.find(sceneMember);
  if (!entry)
    return Error{.reason = "it holds no scene.json: it is a ZIP file, but no scene"};
  if (entry->size > sceneJsonLimits.bytes)
    return Error{.where = std::string(sceneMember), .reason = "it is too large"};
  const std::string text = TRY(zip.read(*entry));
  Result<Json> root = parseJson(text, sceneJsonLimits);
  return root.ok() ? std::move(root) : placed(root.error(), sceneMember);
}

/// Reads the members to which scene.json refers. Of those that are damaged it keeps why.
class PartsReader {
 public:
  explicit PartsReader(const ZipReader& zip) : m_zip(zip) {}

  /// An error only where the meshes would fill the memory.
  Status take(const Json& root) {
    for (const std::string& name : meshesCalledFor(root))
      if (take(name, m_parts.meshes, decodedMesh))
        if (const Status room = m_memory.claim(m_parts.meshes[name]->triangleCount()); !room.ok())
          return placed(room.error(), name);
    for (const std::string& name : paintsCalledFor(root))
      take(name, m_parts.paints, decodedPaint);
    for (const std::string& name : voxelsCalledFor(root))
      take(name, m_parts.voxels, decodedVoxels);
    return Unit{};
  }
  SceneParts parts() && { return std::move(m_parts); }

 private:
  /// Tells whether the part is there now and was not before. Where there is no such member the
  /// reader of scene.json reports where it was referred to.
  template <class Parts, class Decode>
  bool take(const std::string& name, Parts& parts, const Decode& decode) {
    const ZipReader::Entry* entry = m_zip.find(name);
    if (!entry || parts.contains(name))
      return false;
    const Result<std::string> bytes = m_zip.read(*entry);
    if (!bytes.ok()) {
      m_parts.damaged[name] = bytes.error().reason;
      return false;
    }
    auto decoded = decode(*bytes);
    if (!decoded.ok()) {
      m_parts.damaged[name] = decoded.error().reason;
      return false;
    }
    using Part = typename Parts::mapped_type::element_type;
    parts[name] = std::make_shared<Part>(std::move(*decoded));
    return true;
  }

  const ZipReader& m_zip;
  MemoryBudget m_memory;
  SceneParts m_parts;
};

/// Takes the thumbnail and all members to which the scene does not refer.
void takeRest(const ZipReader& zip, const std::set<std::string, std::less<>>& known,
              SceneDocument& document) {
  for (const ZipReader::Entry& entry : zip.entries()) {
    if (entry.name == sceneMember || known.contains(entry.name))
      continue;
    Result<std::string> bytes = zip.read(entry);
    if (!bytes.ok() && document.leftOut.size() < mostToldFaults)
      document.leftOut.push_back(entry.name + ": " + bytes.error().reason);
    else if (bytes.ok() && entry.name == thumbnailMember)
      document.thumbnail = std::move(*bytes);
    else if (bytes.ok())
      document.others.push_back({entry.name, std::move(*bytes)});
  }
}

Result<SceneDocument> documentFrom(const ZipReader& zip) {
  Json root = TRY(sceneJsonOf(zip));
  const Result<int> schema = schemaOf(root);
  if (!schema.ok())
    return placed(schema.error(), sceneMember);
  if (const Status migrated = migrate(root); !migrated.ok())
    return placed(migrated.error(), sceneMember);
  PartsReader reader(zip);
  TRY(reader.take(root));
  const SceneParts parts = std::move(reader).parts();
  std::vector<JsonRefusal> leftOut;
  Result<Scene> scene = sceneFromJson(root, parts, leftOut);
  if (!scene.ok())
    return placed(scene.error(), sceneMember);
  SceneDocument document{.scene = std::move(*scene), .schema = *schema};
  for (const JsonRefusal& each : leftOut)
    document.leftOut.push_back(each.text());
  std::set<std::string, std::less<>> known;
  const auto know = [&known](const auto& named) {
    for (const auto& each : named)
      known.insert(each.first);
  };
  know(parts.meshes);
  know(parts.paints);
  know(parts.voxels);
  know(parts.damaged);
  takeRest(zip, known, document);
  return document;
}

/// Tells whether the file holds just these bytes.
bool isThere(const fs::path& file, const std::optional<Fingerprint>& bytes) {
  std::error_code unknown;
  if (!bytes || fs::file_size(file, unknown) != bytes->bytes)
    return false;
  const Result<Fingerprint> now = fingerprintOfFile(file);
  return now.ok() && *now == *bytes;
}

/// Refuses to overwrite a file of which this program reads a part alone; one that cannot be read at
/// all does not count as such. One that is known to be whole is not unpacked.
Status mayReplace(const fs::path& file, const std::optional<Fingerprint>& whole) {
  std::error_code unknown;
  if (!fs::is_regular_file(file, unknown) || isThere(file, whole))
    return Unit{};
  const Result<std::string> bytes = readText(file, largestFile);
  if (!bytes.ok())
    return Unit{};
  const auto refused = [&](const char* reason) {
    return Error{.file = file.string(), .reason = reason, .remedy = "Save under another name"};
  };
  // Asked first: what else is in a newer file may be nothing that this program can read.
  const Result<ZipReader> zip = ZipReader::open(*bytes);
  if (zip.ok())
    if (const Result<Json> root = sceneJsonOf(*zip); root.ok())
      if (const Result<int> schema = schemaOf(*root); schema.ok() && *schema > sceneSchema)
        return refused(
            "a newer version of the program has written it, with more than this one would write");
  const Result<SceneDocument> there = documentFromBytes(*bytes);
  if (!there.ok() || there->leftOut.empty())
    return Unit{};
  return refused("something in it is at fault and not in the scene; it would be lost");
}

/// Returns what the scene's text refers to.
SceneParts partsByName(const Scene& scene) {
  SceneParts parts;
  for (const auto& [mesh, name] : meshNames(scene))
    parts.meshes[name] = mesh;
  for (const Node& node : scene.nodes())
    if (node.paint)
      parts.paints[paintName(node.id)] = node.paint;
  for (std::size_t n = 0; n < scene.scans().size(); ++n)
    parts.voxels[voxelsName(n)] = scene.scans()[n].voxels;
  return parts;
}

/// Reads what is about to be written, so that nothing is that could not be read again.
Status checkReadable(const std::string& text, const Scene& scene) {
  constexpr const char* remedy = "Undo what brought it into the scene, and save again";
  Result<Json> root = parseJson(text, sceneJsonLimits);
  if (!root.ok())
    return Error{.where = std::string(sceneMember),
                 .reason = "the scene is too large for a scene file: " + root.error().reason,
                 .remedy = "Save fewer views, or fewer structures in one scene"};
  std::vector<JsonRefusal> leftOut;
  const Result<Scene> again = sceneFromJson(*root, partsByName(scene), leftOut);
  if (!again.ok())
    return Error{.where = again.error().where, .reason = again.error().reason, .remedy = remedy};
  if (!leftOut.empty())
    return Error{.where = leftOut[0].where, .reason = leftOut[0].reason, .remedy = remedy};
  return Unit{};
}
}  // namespace

bool isSceneFile(const fs::path& file) {
  return lowerExtension(file) == sceneExtension;
}

bool SceneDocument::isNewer() const {
  return schema > sceneSchema;
}

std::string SceneDocument::warning() const {
  if (isNewer())
    return "a newer version of the program has written it (schema " + std::to_string(schema) +
           ", known here: " + std::to_string(sceneSchema) +
           "); what is unknown is not shown, and it can only be saved under another name, as "
           "schema " +
           std::to_string(sceneSchema);
  if (leftOut.empty())
    return "";
  std::string named;
  for (std::size_t i = 0; i < std::min(leftOut.size(), mostNamed); ++i)
    named += (i == 0 ? "" : "; ") + leftOut[i];
  if (leftOut.size() > mostNamed)
    named += "; and " + std::to_string(leftOut.size() - mostNamed) + " more";
  return "something in it is at fault and was left out (" + named +
         "); the file stays as it is, and the scene can only be saved under another name";
}

Result<std::string> sceneFileBytes(const SceneDocument& document) {
  if (const std::optional<Error> fault = limitFault(document.scene))
    return *fault;
  std::vector<ZipMember> members{{std::string(sceneMember), sceneJson(document.scene)}};
  TRY(checkReadable(members[0].bytes, document.scene));
  if (!document.thumbnail.empty())
    members.push_back({std::string(thumbnailMember), document.thumbnail});
  std::map<MeshPtr, std::string> names = meshNames(document.scene);
  for (const Node& node : document.scene.nodes()) {
    const auto name = names.find(node.mesh);
    if (name == names.end())
      continue;
    members.push_back({name->second, encodedMesh(*node.mesh)});
    names.erase(name);  // written once, however many structures share it
  }
  for (const Node& node : document.scene.nodes())
    if (node.paint)
      members.push_back({paintName(node.id), encodedPaint(*node.paint)});
  for (std::size_t n = 0; n < document.scene.scans().size(); ++n)
    members.push_back({voxelsName(n), encodedVoxels(*document.scene.scans()[n].voxels)});
  std::vector<const ZipMember*> all;
  std::set<std::string_view> taken;
  const auto add = [&](const ZipMember& member) {
    if (taken.insert(member.name).second)
      all.push_back(&member);
  };
  std::for_each(members.begin(), members.end(), add);
  std::for_each(document.others.begin(), document.others.end(), add);
  std::string bytes = TRY(zipped(all));
  const Result<ZipReader> again = ZipReader::open(bytes);
  if (again.ok() && bytes.size() <= largestFile)
    return bytes;
  return Error{.reason = "the scene is too large for a scene file" +
                         (again.ok() ? std::string() : ": " + again.error().reason),
               .remedy = "Put fewer structures or scans into one scene"};
}

Result<SceneDocument> documentFromBytes(std::string_view bytes) {
  const Result<ZipReader> zip = ZipReader::open(bytes);
  Result<SceneDocument> document =
      zip.ok() ? documentFrom(*zip) : Result<SceneDocument>(zip.error());
  if (document.ok())
    return document;
  Error error = document.error();
  error.remedy = unreadable;
  return error;
}

Result<SceneDocument> readSceneFile(const fs::path& file) {
  const std::string bytes = TRY(readText(file, largestFile));
  Result<SceneDocument> document = documentFromBytes(bytes);
  std::error_code unknown;
  if (document.ok() && !document->isForReading() && fs::is_regular_file(file, unknown))
    document->whole = fingerprintOf(bytes);
  if (document.ok())
    return document;
  Error error = document.error();
  error.file = file.string();
  return error;
}

Status writeSceneFile(const FileLock& lock, const SceneDocument& document) {
  TRY(mayReplace(lock.file(), document.whole));
  Result<std::string> bytes = sceneFileBytes(document);
  if (!bytes.ok()) {
    Error error = bytes.error();
    error.file = lock.file().string();
    return error;
  }
  return writeText(lock.file(), *bytes);
}

Status writeSceneFile(const fs::path& file, const SceneDocument& document) {
  const Result<FileLock> lock = FileLock::acquire(file);
  return lock.ok() ? writeSceneFile(*lock, document) : Status(lock.error());
}

}  // namespace sline::model
