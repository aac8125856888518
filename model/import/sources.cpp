// SPDX-License-Identifier: Apache-2.0
#include "model/import/sources.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "model/import/file_kinds.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

std::string supportedKinds() {
  return "Give a file of surfaces (" + surfaceExtensions() +
         "), a folder of them, a 3D Slicer scene (.mrml) or a scene file (.sline)";
}

std::string lowerExtension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

class Collector {
 public:
  explicit Collector(const ReadLimits& limits) : m_limits(limits) {}

  void add(const fs::path& input) {
    std::error_code fault;
    const fs::file_status status = fs::status(input, fault);
    if (!fs::exists(status))
      refuse({.file = input.string(),
              .reason = "there is no such file or folder",
              .remedy = "Check the path"});
    else if (fs::is_directory(status))
      addFolder(input);
    else if (lowerExtension(input) == ".mrml")
      addScene(input);
    else if (isSurfaceFile(input))
      addFile(input, looseFiles(), {});
    else
      refuse({.file = input.string(),
              .reason = "this kind of file is not supported",
              .remedy = supportedKinds()});
  }

  Sources take() && {
    joinVolumes();
    return std::move(m_result);
  }

 private:
  void refuse(Error error) {
    Error told = error;
    told.file.clear();
    m_result.warnings.push_back({error.file, told.text()});
    if (!m_result.firstError)
      m_result.firstError = std::move(error);
  }

  std::size_t looseFiles() {
    auto& sources = m_result.sources;
    const auto found = std::find_if(sources.begin(), sources.end(), [](const ImportSource& s) {
      return s.kind == ImportSource::Kind::files;
    });
    if (found != sources.end())
      return std::size_t(found - sources.begin());
    sources.push_back({});
    return sources.size() - 1;
  }

  /// Label volumes that came together from one folder are read together: programs that give each
  /// structure a file of its own write them so, and structures that touch shall share their faces.
  void joinVolumes() {
    std::vector<SourceFile> files;
    std::map<std::pair<std::size_t, fs::path>, std::size_t> first;
    for (SourceFile& file : m_result.files) {
      if (!file.model && isVolumeFile(file.file)) {
        const auto [found, fresh] =
            first.try_emplace({file.source, file.file.parent_path()}, files.size());
        if (!fresh) {
          files[found->second].together.push_back(file.file);
          files[found->second].bytes += file.bytes;
          continue;
        }
      }
      files.push_back(std::move(file));
    }
    m_result.files = std::move(files);
  }

  void addFile(const fs::path& file, std::size_t source, std::vector<std::string> folders) {
    std::error_code fault;
    const std::uintmax_t bytes = fs::file_size(file, fault);
    m_result.files.push_back(
        {file, source, std::move(folders), std::nullopt, fault ? 0 : bytes, {}});
  }

  void addFolder(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code fault;
    // Links to folders are not followed, so that no circle of links is.
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           fault);
    for (const fs::recursive_directory_iterator end; !fault && entry != end;
         entry.increment(fault)) {
      std::error_code ignored;
      if (entry->is_regular_file(ignored) && isSurfaceFile(entry->path()))
        files.push_back(entry->path());
    }
    if (fault)
      m_result.warnings.push_back(
          {folder.string(), "the folder could not be read to its end: " + fault.message()});
    if (files.empty()) {
      refuse({.file = folder.string(),
              .reason = "the folder holds no mesh",
              .remedy = supportedKinds()});
      return;
    }
    std::sort(files.begin(), files.end());
    m_result.sources.push_back({ImportSource::Kind::folder, folder, std::nullopt});
    for (const fs::path& file : files) {
      std::vector<std::string> folders;
      for (const fs::path& step : file.lexically_relative(folder).parent_path())
        folders.push_back(step.string());
      addFile(file, m_result.sources.size() - 1, std::move(folders));
    }
  }

  void addScene(const fs::path& input) {
    Result<SlicerScene> scene = readSlicerScene(input, m_limits);
    if (!scene) {
      refuse(scene.error());
      return;
    }
    auto& warnings = m_result.warnings;
    warnings.insert(warnings.end(), scene->warnings.begin(), scene->warnings.end());
    if (scene->models.empty()) {
      refuse({.file = input.string(),
              .reason = scene->named == 0 ? "the scene holds no model"
                                          : "none of the scene's " + std::to_string(scene->named) +
                                                " model files can be found",
              .remedy = "Keep the scene beside its model files, or save it again with its models"});
      return;
    }
    const std::size_t source = m_result.sources.size();
    for (std::size_t i = 0; i < scene->models.size(); ++i) {
      addFile(scene->models[i].file, source, {});
      m_result.files.back().model = i;
    }
    m_result.sources.push_back({ImportSource::Kind::slicer, input, std::move(*scene)});
  }

  ReadLimits m_limits;
  Sources m_result;
};

}  // namespace

Sources collectSources(std::span<const fs::path> inputs, const ReadLimits& limits) {
  Collector collector(limits);
  for (const fs::path& input : inputs)
    collector.add(input);
  return std::move(collector).take();
}

}  // namespace sline::model
