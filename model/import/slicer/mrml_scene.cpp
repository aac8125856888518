// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/mrml_scene.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/names.h"
#include "model/import/slicer/annotations.h"
#include "model/import/slicer/files_and_transforms.h"
#include "model/import/slicer/hierarchy.h"
#include "model/import/slicer/nodes.h"
#include "model/import/slicer/views.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Scenes of whole bodies have some thousands of nodes.
constexpr std::ptrdiff_t mostNodes = 100'000;

/// Returns where a byte of the file lies, for people.
std::string lineOf(std::string_view text, std::ptrdiff_t offset) {
  const std::string_view before = text.substr(0, std::size_t(std::max<std::ptrdiff_t>(0, offset)));
  return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
}

Result<std::string> wholeFile(const fs::path& file, const ReadLimits& limits) {
  std::error_code fault;
  const std::uintmax_t size = fs::file_size(file, fault);
  if (fault)
    return Error{.file = file.string(),
                 .reason = "it cannot be read: " + fault.message(),
                 .remedy = "Check the path and its permissions"};
  if (size > limits.fileBytes)
    return Error{.file = file.string(), .reason = "it is larger than the limit for one file"};
  std::string text(std::size_t(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), std::streamsize(size)))
    return Error{.file = file.string(),
                 .reason = "it cannot be read to its end",
                 .remedy = "Check the disk and its permissions"};
  return text;
}

/// Reads "Slicer4.4.0" → 404; "Slicer4" → 400; nothing where no version is given. Scenes from 4.11
/// on wrote LPS, those before RAS.
std::optional<int> slicerVersion(const XmlNode& scene) {
  std::string_view text = scene.attribute("version").value();
  if (text.starts_with("Slicer"))
    text.remove_prefix(6);
  int major = 0;
  const auto first = std::from_chars(text.data(), text.data() + text.size(), major);
  if (first.ec != std::errc() || major < 0 || major > 1000)
    return std::nullopt;
  int minor = 0;
  if (first.ptr != text.data() + text.size() && *first.ptr == '.')
    std::from_chars(first.ptr + 1, text.data() + text.size(), minor);
  return major * 100 + std::clamp(minor, 0, 99);
}

class SceneReader {
 public:
  SceneReader(const fs::path& file, const XmlNode& scene)
      : m_file(file), m_folder(file.parent_path()), m_scene(scene), m_nodes(scene) {}

  Result<SlicerScene> read() {
    SlicerScene result;
    m_transforms.emplace(m_nodes, m_file.filename().string(), result.warnings);
    const std::unordered_map<std::string, std::size_t> groupOfModel =
        readSlicerHierarchy({m_scene, m_nodes, m_file}, result);
    for (const XmlNode& node : m_scene.children("Model"))
      readModel(node, groupOfModel, result);
    const bool bare = result.models.empty();
    for (const XmlNode& node : m_scene.children("Segmentation"))
      readSegments(node, result);
    // Scenes keep the label map from which their models were made; then it is not drawn again.
    if (bare && result.models.empty())
      for (const XmlNode& node : m_scene.children("LabelMapVolume"))
        readSegments(node, result);
    readSlicerFiducials({m_scene, m_nodes, m_file}, result);
    readSlicerViews({m_scene, m_nodes, m_file}, result);
    warnOfVolumes(result);
    const auto fibres = m_scene.children("FiberBundle");
    if (const auto bundles = std::distance(fibres.begin(), fibres.end()); bundles > 0) {
      const bool alone = result.named == 0 && result.fiducials.empty();
      if (alone)
        return Error{.file = m_file.string(),
                     .reason = "the scene holds no model but " + std::to_string(bundles) +
                               " bundles of fibres, which are not read",
                     .remedy = "Save them in Slicer as models: surfaces of tubes"};
      warn(result, m_file.filename().string(),
           std::to_string(bundles) + " bundles of fibres are left out, as they are not read");
    }
    return result;
  }

  std::vector<SlicerFileFrame> readFileFrames() {
    std::vector<ImportWarning> notTold;
    SlicerTransforms transforms(m_nodes, m_file.filename().string(), notTold);
    std::vector<SlicerFileFrame> frames;
    for (const XmlNode& node : m_scene.children("Model")) {
      const XmlNode storage = m_nodes.referred(node, "storage");
      std::string written = storage.attribute("fileName").value();
      if (written.empty())
        continue;
      std::replace(written.begin(), written.end(), '\\', '/');
      SlicerModel model;
      decideFrame(storage, model);
      frames.push_back({m_folder / percentDecoded(written), model.frame,
                        std::move(model.frameReason),
                        transforms.above(node, node.attribute("name").value())});
    }
    return frames;
  }

 private:
  void warn(SlicerScene& result, const std::string& file, std::string reason) const {
    result.warnings.push_back({file, std::move(reason)});
  }
  void readModel(const XmlNode& node, const std::unordered_map<std::string, std::size_t>& groups,
                 SlicerScene& result);
  void readSegments(const XmlNode& node, SlicerScene& result);
  void decideFrame(const XmlNode& storage, SlicerModel& model) const;
  void warnOfVolumes(SlicerScene& result) const;

  fs::path m_file;
  fs::path m_folder;
  XmlNode m_scene;
  SlicerNodes m_nodes;
  std::optional<SlicerTransforms> m_transforms;
};

void SceneReader::readModel(const XmlNode& node,
                            const std::unordered_map<std::string, std::size_t>& groups,
                            SlicerScene& result) {
  const XmlNode storage = m_nodes.referred(node, "storage");
  std::string written = storage.attribute("fileName").value();
  std::string name = node.attribute("name").value();
  if (written.empty()) {
    // Slicer's own planes for its slice views are models without a file.
    if (!flag(node, "hideFromEditors", false))
      warn(result, m_file.filename().string(),
           "model \"" + name + "\" refers to no file; it was left out");
    return;
  }
  ++result.named;
  const std::optional<fs::path> file = fileOfSlicer(m_file, written, result.warnings);
  if (!file)
    return;
  SlicerModel model;
  model.id = node.attribute("id").value();
  if (isSurfaceFile(name))
    name = stemOf(name);
  model.name = readableName(name.empty() ? stemOf(*file) : name);
  model.file = *file;
  if (const auto group = groups.find(node.attribute("id").value()); group != groups.end())
    model.group = group->second;
  // A collapsed hierarchy node draws all its models in its own style.
  const bool inherits = model.group && result.groups[*model.group].style.visible.has_value();
  if (!inherits)
    model.style = slicerStyle(m_nodes.referred(node, "display"));
  decideFrame(storage, model);
  model.toWorld = m_transforms->above(node, model.name);
  result.models.push_back(std::move(model));
}

/// Reads a segmentation or a label map: a group with a structure for each of its labels.
void SceneReader::readSegments(const XmlNode& node, SlicerScene& result) {
  const std::string written = m_nodes.referred(node, "storage").attribute("fileName").value();
  const std::string name = node.attribute("name").value();
  if (written.empty()) {
    warn(result, m_file.filename().string(),
         "segmentation \"" + name + "\" refers to no file; it was left out");
    return;
  }
  ++result.named;
  const std::optional<fs::path> file = fileOfSlicer(m_file, written, result.warnings);
  if (!file)
    return;
  if (!isSurfaceFile(*file)) {
    warn(result, written, "segmentations in files of this kind are not supported; it was left out");
    return;
  }
  SlicerModel model;
  model.id = node.attribute("id").value();
  model.name = readableName(name.empty() ? stemOf(*file) : name);
  model.file = *file;
  model.group = result.groups.size();
  model.segments = true;
  model.style = slicerSegmentsStyle(m_nodes.referred(node, "display"));
  decideFrame(XmlNode(), model);
  model.toWorld = SlicerTransforms(m_nodes, m_file.filename().string(), result.warnings)
                      .above(node, model.name);
  result.groups.push_back({model.id, model.name, std::nullopt, {}});
  result.models.push_back(std::move(model));
}

void SceneReader::decideFrame(const XmlNode& storage, SlicerModel& model) const {
  const std::string_view written = storage.attribute("coordinateSystem").value();
  if (written == "RAS" || written == "0" || written == "LPS" || written == "1") {
    model.frame = written == "RAS" || written == "0" ? Frame::ras : Frame::lps;
    model.frameReason = "header: coordinateSystem of the scene's storage node";
    return;
  }
  const std::optional<int> version = slicerVersion(m_scene);
  const bool before = !version || *version < 411;
  model.frame = before ? Frame::ras : Frame::lps;
  model.frameReason = before ? "scene of Slicer before 4.11" : "scene of Slicer 4.11 or later";
}

void SceneReader::warnOfVolumes(SlicerScene& result) const {
  std::string absent;
  std::size_t count = 0;
  std::error_code fault;
  for (const XmlNode& node : m_scene.children("VolumeArchetypeStorage")) {
    const std::string name = percentDecoded(node.attribute("fileName").value());
    if (name.empty() || (staysInside(name) && fs::exists(m_folder / name, fault)))
      continue;
    absent += (count == 0 ? "" : ", ") + name;
    ++count;
  }
  if (count != 0)
    warn(result, m_file.filename().string(),
         "absent volumes (they are not drawn anyway): " + absent);
}

}  // namespace

namespace {
/// Parses the file; the scene's node stays valid as long as the document.
Result<XmlNode> sceneNode(const fs::path& file, const ReadLimits& limits,
                          pugi::xml_document& document) {
  std::string text = TRY(wholeFile(file, limits));
  // The DOCTYPE is skipped and no entity but XML's own five is known, so no file can blow up.
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  if (!parsed)
    return Error{.file = file.string(),
                 .where = lineOf(text, parsed.offset),
                 .reason = std::string("the XML is broken: ") + parsed.description(),
                 .remedy = "Save the scene again in 3D Slicer"};
  const XmlNode scene = document.child("MRML");
  if (!scene)
    return Error{.file = file.string(),
                 .reason = "it is XML, but no 3D Slicer scene: there is no <MRML>",
                 .remedy = "Choose the .mrml file that 3D Slicer saved"};
  if (std::distance(scene.begin(), scene.end()) > mostNodes)
    return Error{.file = file.string(),
                 .reason = "the scene has more than " + std::to_string(mostNodes) + " nodes",
                 .remedy = "Save the scene in parts in 3D Slicer"};
  return scene;
}
}  // namespace

Result<SlicerScene> readSlicerScene(const fs::path& file, const ReadLimits& limits) {
  pugi::xml_document document;
  const XmlNode scene = TRY(sceneNode(file, limits, document));
  return SceneReader(file, scene).read();
}

Result<std::vector<SlicerFileFrame>> fileFramesOfSlicer(const fs::path& file,
                                                        const ReadLimits& limits) {
  pugi::xml_document document;
  const XmlNode scene = TRY(sceneNode(file, limits, document));
  return SceneReader(file, scene).readFileFrames();
}

}  // namespace sline::model
