// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/autosave.h"

#include <algorithm>

#include "model/disk/cache_folder.h"
#include "model/disk/process.h"
#include "model/disk/whole_file.h"
#include "model/scene_file/json_value.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view sourceMember = "recovery.json";
constexpr std::size_t largestCopy = std::size_t(4) << 30;

ZipMember memberFor(const AutosaveSource& source) {
  const Json json = {{"title", source.title}, {"file", source.file.string()}};
  return {std::string(sourceMember), json.dump(1, ' ', false, Json::error_handler_t::replace)};
}

/// Returns the source, empty where the copy does not name it.
AutosaveSource sourceFrom(const fs::path& copy) {
  AutosaveSource source;
  const Result<std::string> bytes = readText(copy, largestCopy);
  if (!bytes.ok())
    return source;
  const Result<ZipReader> zip = ZipReader::open(*bytes);
  const ZipReader::Entry* entry = zip.ok() ? zip->find(sourceMember) : nullptr;
  if (!entry)
    return source;
  const Result<std::string> text = zip->read(*entry);
  const Result<Json> json = text.ok() ? parseJson(*text) : Result<Json>(text.error());
  if (!json.ok())
    return source;
  JsonFault fault;
  const JsonValue value(*json, fault);
  JsonObject object(value);
  source.title = object.need("title").text();
  source.file = object.need("file").text();
  return fault.any() ? AutosaveSource() : source;
}
}  // namespace

fs::path userAutosaveFolder() {
  const fs::path state = userStateFolder();
  return state.empty() ? state : state / "autosave";
}

Result<Autosave> Autosave::begin(const fs::path& folder) {
  std::error_code ignored;  // if the folder is still missing, the lock reports the error
  fs::create_directories(folder, ignored);
  for (int number = 1;; ++number) {
    const fs::path file = folder / (std::to_string(processNumber()) + "-" + std::to_string(number) +
                                    std::string(sceneExtension));
    // A copy under this name was left by an earlier process of the same number.
    if (fs::exists(file, ignored) || FileLock::held(file))
      continue;
    Result<FileLock> lock = FileLock::acquire(file);
    if (!lock.ok())
      return lock.error();
    return Autosave(std::move(*lock));
  }
}

Status Autosave::keep(const SceneDocument& document, const AutosaveSource& source) const {
  SceneDocument copy = document;
  copy.others.push_back(memberFor(source));
  return writeSceneFile(m_lock, copy);
}

void Autosave::discard() const {
  std::error_code ignored;
  fs::remove(file(), ignored);
}

std::vector<Recoverable> recoverableIn(const fs::path& folder) {
  std::vector<Recoverable> all;
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    const fs::path copy = entry->path();
    std::error_code gone;
    const fs::file_time_type when = fs::last_write_time(copy, gone);
    if (!gone && isSceneFile(copy) && !FileLock::held(copy))
      all.push_back({copy, sourceFrom(copy), when});
  }
  std::sort(all.begin(), all.end(), [](const Recoverable& a, const Recoverable& b) {
    return a.when != b.when ? a.when > b.when : a.copy < b.copy;
  });
  return all;
}

Result<SceneDocument> recovered(const Recoverable& found) {
  Result<SceneDocument> document = readSceneFile(found.copy);
  if (document.ok())
    std::erase_if(document->others,
                  [](const ZipMember& member) { return member.name == sourceMember; });
  return document;
}

void forget(const Recoverable& found) {
  const Result<FileLock> lock = FileLock::acquire(found.copy);
  if (!lock.ok())
    return;
  std::error_code ignored;
  fs::remove(found.copy, ignored);
}

}  // namespace sline::model
