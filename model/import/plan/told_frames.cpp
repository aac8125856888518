// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/told_frames.h"

#include <algorithm>
#include <map>
#include <set>

#include "model/base/letters.h"
#include "model/base/natural_order.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// A folder may hold any number of copies of a scene.
constexpr std::size_t mostScenes = 32;
/// And be that of downloads.
constexpr std::size_t mostEntries = 20'000;

fs::path tidyPath(const fs::path& path) {
  std::error_code fault;
  const fs::path whole = fs::absolute(path, fault);
  return (fault ? path : whole).lexically_normal();
}

/// Finds files by what a scene calls them.
class FilesByPath {
 public:
  explicit FilesByPath(std::span<SourceFile> files) {
    for (SourceFile& file : files) {
      m_whole[tidyPath(file.file)] = &file;
      m_names[file.file.filename()].push_back(&file);
    }
  }
  SourceFile* of(const fs::path& path, NamedAs named) const {
    if (const auto whole = m_whole.find(tidyPath(path)); whole != m_whole.end())
      return whole->second;
    if (named == NamedAs::path)
      return nullptr;
    // A file that is where the scene has it, and is not among these, is another one.
    if (std::error_code fault; fs::exists(path, fault))
      return nullptr;
    const auto called = m_names.find(path.filename());
    return called != m_names.end() && called->second.size() == 1 ? called->second.front() : nullptr;
  }

 private:
  std::map<fs::path, SourceFile*> m_whole;
  std::map<fs::path, std::vector<SourceFile*>> m_names;
};

}  // namespace

void tellFrames(std::span<SourceFile> files, ScenesBeside beside, const ReadLimits& limits,
                std::vector<ImportWarning>& warnings) {
  std::vector<fs::path>& scenes = beside.files;
  const FilesByPath byPath(files);
  std::sort(scenes.begin(), scenes.end(), pathNaturallyBefore);
  if (scenes.size() > mostScenes)
    scenes.resize(mostScenes);
  std::set<SourceFile*> disputed;
  for (const fs::path& scene : scenes) {
    const auto frames = fileFramesOfSlicer(scene, limits);
    if (!frames.ok())
      continue;
    for (const SlicerFileFrame& told : *frames)
      if (SourceFile* file = byPath.of(told.file, beside.named)) {
        const bool other =
            file->told && (file->told->frame != told.frame || file->told->toWorld != told.toWorld);
        if (other)
          disputed.insert(file);
        else
          file->told = told;
      }
  }
  for (SourceFile* file : disputed) {
    file->told.reset();
    warnings.push_back({file->file.filename().string(),
                        "scenes of 3D Slicer beside it disagree about its coordinates; none of "
                        "them was followed"});
  }
}

ScenesBeside scenesBeside(const fs::path& folder) {
  ScenesBeside beside{scenesIn(folder), NamedAs::name};
  if (beside.files.empty())
    beside = {scenesIn(folderAbove(folder)), NamedAs::path};
  return beside;
}

std::vector<fs::path> scenesIn(const fs::path& folder) {
  std::vector<fs::path> scenes;
  std::error_code fault;
  std::size_t count = 0;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder,
                               fs::directory_options::skip_permission_denied, fault);
  for (const fs::directory_iterator end; !fault && entry != end && count < mostEntries;
       entry.increment(fault), ++count)
    if (lowerExtension(entry->path()) == ".mrml")
      scenes.push_back(entry->path());
  return scenes;
}

fs::path folderAbove(const fs::path& folder) {
  const fs::path whole = tidyPath(folder);
  return whole.has_filename() ? whole.parent_path() : whole.parent_path().parent_path();
}

}  // namespace sline::model
