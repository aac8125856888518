// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/sources.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "model/base/letters.h"
#include "model/base/natural_order.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/plan/dicom_left_out.h"
#include "model/import/plan/told_frames.h"
#include "model/import/readers/dicom_kind.h"
#include "model/import/volumes/formats/image_pair.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

std::string supportedKinds() {
  return "Give a file of surfaces (" + surfaceExtensions() +
         "), a folder of them, a 3D Slicer scene (.mrml, .mrb) or its fiducials (" +
         fiducialExtensions() + "), or a scene file (.sline)";
}

/// What a folder holds that gives no mesh, and what can be done about it.
struct LeftOut {
  std::string text;
  std::string remedy;
};

/// Returns "a.zip, b.mrb are archives and were not looked into".
std::string archivesText(std::vector<fs::path> archives) {
  std::sort(archives.begin(), archives.end(), pathNaturallyBefore);
  constexpr std::size_t mostTold = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(archives.size(), mostTold); ++i)
    list += (i == 0 ? "" : ", ") + archives[i].filename().string();
  if (archives.size() > mostTold)
    list += " …";
  return list + (archives.size() == 1 ? " is an archive and was not looked into"
                                      : " are archives and were not looked into");
}

constexpr const char* archivesRemedy =
    "Open a bundle of 3D Slicer (.mrb) by itself; unpack any other and open what was in it";

/// Limits how often a scene may have all of its files in it: a small one must not fill the memory
/// by naming a large mesh again and again.
constexpr std::uint64_t mostTimes = 4;

class Collector {
 public:
  Collector(const ReadLimits& limits, ScannerSlices slices) : m_limits(limits), m_slices(slices) {}

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
      addScene(input, nullptr);
    else if (lowerExtension(input) == ".mrb")
      addBundle(input);
    else if (isFiducialFile(input))
      addFiducials(input);
    else if (isSlice(input))
      addFile(input, looseFiles(), {});
    else if (m_looseImages.takes(input))
      m_imageFile = input;
    else if (isSurfaceFile(input))
      addOnce(input, looseFiles(), {});
    else if (isArchive(input))
      refuse({.file = input.string(),
              .reason = "is an archive, which is not looked into",
              .remedy = "Unpack it and open what was in it"});
    else
      refuse({.file = input.string(),
              .reason = "this kind of file is not supported",
              .remedy = supportedKinds()});
  }

  Sources take() && {
    tellLooseFiles();
    joinVolumes();
    if (!m_looseImages.empty())
      refuse({.file = m_looseImages.count() == 1 ? m_imageFile.string() : std::string(),
              .reason = m_looseImages.text(),
              .remedy = DicomLeftOut::remedy()});
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

  /// Tells whether the file is to be read as a part of a scan.
  bool isSlice(const fs::path& file) const {
    return m_slices == ScannerSlices::read && isDicomFile(file) &&
           !scannerOf(sopClassOf(file)).empty();
  }

  /// Joins label volumes that came together from one folder, to be read together: programs that
  /// give each structure a file of its own write them so, and structures that touch must share
  /// their faces. The slices of a folder are joined too.
  void joinVolumes() {
    std::vector<SourceFile> files;
    std::map<std::tuple<std::size_t, fs::path, bool>, std::size_t> first;
    for (SourceFile& file : m_result.files) {
      if (file.slice || (!file.model && isVolumeFile(file.file))) {
        const auto [found, fresh] =
            first.try_emplace({file.source, file.file.parent_path(), file.slice}, files.size());
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

  /// Adds a volume once where two files make it: the file is the one with the voxels, which changes
  /// when they do.
  void addOnce(const fs::path& file, std::size_t source, std::vector<std::string> folders) {
    const Result<ImagePair> pair =
        isOfImagePair(file) ? imagePairOf(file) : Result<ImagePair>(ImagePair{file, file});
    const fs::path& voxels = pair ? pair->image : file;
    const bool again =
        pair && pair->header != pair->image &&
        std::any_of(m_result.files.begin(), m_result.files.end(), [&](const SourceFile& each) {
          return each.source == source && each.file == voxels;
        });
    if (!again)
      addFile(voxels, source, std::move(folders));
  }

  void addFile(const fs::path& file, std::size_t source, std::vector<std::string> folders) {
    std::error_code fault;
    const std::uintmax_t bytes = fs::file_size(file, fault);
    m_result.files.push_back(
        {file, source, std::move(folders), std::nullopt, fault ? 0 : bytes, {}, isSlice(file)});
  }

  void addFolder(const fs::path& folder) {
    std::vector<fs::path> files;
    std::vector<fs::path> scenes;
    std::vector<fs::path> archives;
    DicomLeftOut images;
    std::error_code fault;
    // Links to folders are not followed, so that circles of links do no harm.
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           fault);
    for (const fs::recursive_directory_iterator end; !fault && entry != end;
         entry.increment(fault)) {
      std::error_code ignored;
      if (!entry->is_regular_file(ignored))
        continue;
      if (lowerExtension(entry->path()) == ".mrml")
        scenes.push_back(entry->path());
      else if (isArchive(entry->path()))
        archives.push_back(entry->path());
      else if (isSlice(entry->path()) ||
               (!images.takes(entry->path()) && isSurfaceFileInFolder(entry->path())))
        files.push_back(entry->path());
    }
    if (fault)
      m_result.warnings.push_back(
          {folder.string(), "the folder could not be read to its end: " + fault.message()});
    std::vector<LeftOut> leftOut;
    if (!images.empty())
      leftOut.push_back({images.text(), DicomLeftOut::remedy()});
    if (!archives.empty())
      leftOut.push_back({archivesText(std::move(archives)), archivesRemedy});
    if (files.empty()) {
      if (leftOut.empty())
        leftOut.push_back({"the folder holds no mesh", supportedKinds()});
      for (const LeftOut& each : leftOut)
        refuse({.file = folder.string(), .reason = each.text, .remedy = each.remedy});
      return;
    }
    for (const LeftOut& each : leftOut)
      m_result.warnings.push_back({folder.string(), each.text + ". " + each.remedy});
    std::sort(files.begin(), files.end(), pathNaturallyBefore);
    const std::size_t first = m_result.files.size();
    m_result.sources.push_back({ImportSource::Kind::folder, folder, std::nullopt});
    for (const fs::path& file : files) {
      std::vector<std::string> folders;
      // Folders of medical images are called after patients and studies, not after anatomy.
      if (!isDicomFile(file))
        for (const fs::path& step : file.lexically_relative(folder).parent_path())
          folders.push_back(step.string());
      addOnce(file, m_result.sources.size() - 1, std::move(folders));
    }
    ScenesBeside beside{std::move(scenes), NamedAs::name};
    if (beside.files.empty())
      beside = {scenesIn(folderAbove(folder)), NamedAs::path};
    tellFrames(std::span(m_result.files).subspan(first), std::move(beside), m_limits,
               m_result.warnings);
  }

  /// Files that were named one by one may lie beside the scene that they belong to.
  void tellLooseFiles() {
    std::map<fs::path, std::vector<SourceFile*>> folders;
    for (SourceFile& file : m_result.files)
      if (m_result.sources[file.source].kind == ImportSource::Kind::files && !file.slice)
        folders[file.file.parent_path()].push_back(&file);
    for (const auto& [folder, files] : folders) {
      const ScenesBeside beside = scenesBeside(folder);
      // Whether scenes disagree matters to nobody who has not named them or their folder.
      std::vector<ImportWarning> notTold;
      for (SourceFile* file : files)
        tellFrames({file, 1}, beside, m_limits, notTold);
    }
  }

  void addFiducials(const fs::path& input) {
    Result<Fiducials> read = readFiducials(input, m_limits);
    if (!read) {
      refuse(read.error());
      return;
    }
    auto& warnings = m_result.warnings;
    warnings.insert(warnings.end(), read->warnings.begin(), read->warnings.end());
    std::move(read->items.begin(), read->items.end(), std::back_inserter(m_result.fiducials));
  }

  void addBundle(const fs::path& input) {
    Result<SlicerBundle> bundle = unpackBundle(input, m_limits);
    if (!bundle)
      refuse(bundle.error());
    else
      addScene(input, std::make_shared<const SlicerBundle>(std::move(*bundle)));
  }

  void addScene(const fs::path& input, std::shared_ptr<const SlicerBundle> bundle) {
    Result<SlicerScene> scene = readSlicerScene(bundle ? bundle->scene : input, m_limits);
    if (!scene) {
      Error error = scene.error();
      if (bundle)
        error.where = bundle->scene.filename().string() +
                      (error.where.empty() ? std::string() : ", " + error.where);
      error.file = input.string();
      refuse(std::move(error));
      return;
    }
    auto& warnings = m_result.warnings;
    warnings.insert(warnings.end(), scene->warnings.begin(), scene->warnings.end());
    if (scene->models.empty() && scene->fiducials.empty()) {
      refuse({.file = input.string(),
              .reason = scene->named == 0 ? "the scene holds no model"
                                          : "none of the scene's " + std::to_string(scene->named) +
                                                " model files can be found",
              .remedy = "Keep the scene beside its model files, or save it again with its models"});
      return;
    }
    const std::size_t source = m_result.sources.size();
    std::uint64_t allowed = 0;
    std::set<fs::path> files;
    for (const SlicerModel& model : scene->models)
      if (std::error_code fault; files.insert(model.file).second)
        allowed += mostTimes * fs::file_size(model.file, fault);
    for (std::size_t i = 0; i < scene->models.size(); ++i) {
      addFile(scene->models[i].file, source, {});
      SourceFile& added = m_result.files.back();
      added.model = i;
      if (added.bytes <= allowed) {
        allowed -= added.bytes;
        continue;
      }
      warnings.push_back(
          {added.file.filename().string(), "the scene refers to its files too many times; \"" +
                                               scene->models[i].name + "\" was left out"});
      m_result.files.pop_back();
    }
    m_result.sources.push_back(
        {ImportSource::Kind::slicer, input, std::move(*scene), std::move(bundle)});
  }

  ReadLimits m_limits;
  ScannerSlices m_slices;
  Sources m_result;
  DicomLeftOut m_looseImages;
  fs::path m_imageFile;  ///< the last of the loose images
};

}  // namespace

bool haveFiducials(const Sources& sources) {
  return !sources.fiducials.empty() ||
         std::any_of(sources.sources.begin(), sources.sources.end(),
                     [](const ImportSource& s) { return s.scene && !s.scene->fiducials.empty(); });
}

Sources collectSources(std::span<const fs::path> inputs, const ReadLimits& limits,
                       ScannerSlices slices) {
  Collector collector(limits, slices);
  for (const fs::path& input : inputs)
    collector.add(input);
  return std::move(collector).take();
}

double bytesOf(const Sources& sources) {
  double bytes = 1.0;
  for (const SourceFile& file : sources.files)
    bytes += double(file.bytes) + 1.0;
  return bytes;
}

Error nothingRead(const Sources& sources, const std::vector<ImportWarning>& warnings) {
  if (sources.firstError)
    return *sources.firstError;
  if (warnings.empty())
    return {.reason = "there is nothing to read", .remedy = "Name a mesh, a folder or a scene"};
  const ImportWarning& first = warnings.front();
  return {.file = first.file,
          .reason = first.reason,
          .remedy = sources.files.size() > 1 ? "None of the files could be read" : ""};
}

}  // namespace sline::model
