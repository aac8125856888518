// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer_scene.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "model/import/file_kinds.h"
#include "model/import/names.h"
#include "model/import/slicer_hierarchy.h"
#include "model/import/slicer_nodes.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Where a byte of the file lies, for people.
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

/// "Slicer4.4.0" → 404; "Slicer4" → 400; nothing where no version is given. Scenes from 4.11 on
/// wrote LPS, those before RAS.
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

bool inside(const fs::path& relative) {
  const fs::path tidy = relative.lexically_normal();
  return !tidy.empty() && !tidy.is_absolute() && *tidy.begin() != "..";
}

class SceneReader {
 public:
  SceneReader(const fs::path& file, const XmlNode& scene)
      : m_file(file), m_folder(file.parent_path()), m_scene(scene), m_nodes(scene) {}

  SlicerScene read() {
    SlicerScene result;
    const std::unordered_map<std::string, std::size_t> groupOfModel =
        readSlicerHierarchy({m_scene, m_nodes, m_file.filename().string()}, result);
    for (const XmlNode& node : m_scene.children("Model"))
      readModel(node, groupOfModel, result);
    warnOfVolumes(result);
    return result;
  }

 private:
  void warn(SlicerScene& result, const std::string& file, std::string reason) const {
    result.warnings.push_back({file, std::move(reason)});
  }
  void readModel(const XmlNode& node, const std::unordered_map<std::string, std::size_t>& groups,
                 SlicerScene& result);
  std::optional<fs::path> locate(const std::string& written, SlicerScene& result) const;
  void decideFrame(const XmlNode& storage, SlicerModel& model) const;
  void applyTransforms(const XmlNode& node, SlicerModel& model, SlicerScene& result) const;
  std::optional<glm::dmat4> ownMatrix(const XmlNode& transform, SlicerScene& result) const;
  void warnOfVolumes(SlicerScene& result) const;

  fs::path m_file;
  fs::path m_folder;
  XmlNode m_scene;
  SlicerNodes m_nodes;
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
  const std::optional<fs::path> file = locate(written, result);
  if (!file)
    return;
  SlicerModel model;
  if (isSurfaceFile(name))
    name = stemOf(name);
  model.name = readableName(name.empty() ? file->stem().string() : name);
  model.file = *file;
  if (const auto group = groups.find(node.attribute("id").value()); group != groups.end())
    model.group = group->second;
  // A collapsed hierarchy node draws all its models in its own style.
  const bool inherits = model.group && result.groups[*model.group].style.visible.has_value();
  if (!inherits)
    model.style = slicerStyle(m_nodes.referred(node, "display"));
  decideFrame(storage, model);
  applyTransforms(node, model, result);
  result.models.push_back(std::move(model));
}

std::optional<fs::path> SceneReader::locate(const std::string& written, SlicerScene& result) const {
  std::string slashes = written;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  const std::string decoded = percentDecoded(slashes);
  std::error_code fault;
  for (const std::string& name : {slashes, decoded})
    if (inside(name) && fs::is_regular_file(m_folder / name, fault))
      return m_folder / fs::path(name).lexically_normal();
  const bool escapes = !inside(decoded) || (decoded.size() > 1 && decoded[1] == ':');
  for (const std::string& name : {slashes, decoded}) {
    const fs::path base = fs::path(name).filename();
    if (!escapes || base.empty() || base == "..")
      continue;
    for (const fs::path& place : {m_folder / base, m_folder / "Data" / base})
      if (fs::is_regular_file(place, fault))
        return place;
  }
  warn(result, written,
       escapes ? "the scene refers to a place outside its folder; it was left out"
               : "the file is absent; it was left out");
  return std::nullopt;
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

std::optional<glm::dmat4> SceneReader::ownMatrix(const XmlNode& transform,
                                                 SlicerScene& result) const {
  const std::string name = transform.attribute("name").value();
  const std::string kind = transform.name();
  const char* const toParent = transform.attribute("matrixTransformToParent").value();
  const char* const fromParent = transform.attribute("matrixTransformFromParent").value();
  const bool inverse = *toParent == '\0' && *fromParent != '\0';
  if (*toParent == '\0' && *fromParent == '\0') {
    warn(result, m_file.filename().string(),
         "transform \"" + name + "\" is not a matrix in the scene (" + kind +
             "); its models stay untransformed");
    return std::nullopt;
  }
  const auto values = numbers(inverse ? fromParent : toParent, 16);
  glm::dmat4 matrix(1.0);
  for (int row = 0; values && row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix[column][row] = (*values)[std::size_t(row) * 4 + std::size_t(column)];
  const double size = glm::determinant(glm::dmat3(matrix));
  const bool affine =
      matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
  if (!values || !affine || !(std::abs(size) > 1e-12)) {
    warn(result, m_file.filename().string(),
         "the matrix of transform \"" + name +
             (values ? "\" is singular or not affine" : "\" is not 16 numbers") +
             "; its models stay untransformed");
    return std::nullopt;
  }
  return inverse ? glm::inverse(matrix) : matrix;
}

void SceneReader::applyTransforms(const XmlNode& node, SlicerModel& model,
                                  SlicerScene& result) const {
  glm::dmat4 total(1.0);
  std::set<std::string> seen;
  std::string id = SlicerNodes::reference(node, "transform");
  if (id.empty())
    return;
  for (; !id.empty(); id = SlicerNodes::reference(m_nodes.find(id), "transform")) {
    const XmlNode transform = m_nodes.find(id);
    if (!transform || !seen.insert(id).second) {
      warn(result, m_file.filename().string(),
           transform ? "transforms refer to each other in a circle (" + id + "); \"" + model.name +
                           "\" stays untransformed"
                     : "transform " + id + " of \"" + model.name +
                           "\" is absent; it stays untransformed");
      return;
    }
    const std::optional<glm::dmat4> matrix = ownMatrix(transform, result);
    if (!matrix)
      return;
    total = *matrix * total;
  }
  model.toWorld = total;
}

void SceneReader::warnOfVolumes(SlicerScene& result) const {
  std::string absent;
  std::size_t count = 0;
  std::error_code fault;
  for (const XmlNode& node : m_scene.children("VolumeArchetypeStorage")) {
    const std::string name = percentDecoded(node.attribute("fileName").value());
    if (name.empty() || (inside(name) && fs::exists(m_folder / name, fault)))
      continue;
    absent += (count == 0 ? "" : ", ") + name;
    ++count;
  }
  if (count != 0)
    warn(result, m_file.filename().string(),
         "absent volumes (they are not drawn anyway): " + absent);
}

}  // namespace

Result<SlicerScene> readSlicerScene(const fs::path& file, const ReadLimits& limits) {
  Result<std::string> text = wholeFile(file, limits);
  if (!text)
    return text.error();
  pugi::xml_document document;
  // The DOCTYPE is skipped and no entity but XML's own five is known, so no file can blow up.
  const pugi::xml_parse_result parsed = document.load_buffer(text->data(), text->size());
  if (!parsed)
    return Error{.file = file.string(),
                 .where = lineOf(*text, parsed.offset),
                 .reason = std::string("the XML is broken: ") + parsed.description(),
                 .remedy = "Save the scene again in 3D Slicer"};
  const XmlNode scene = document.child("MRML");
  if (!scene)
    return Error{.file = file.string(),
                 .reason = "it is XML, but no 3D Slicer scene: there is no <MRML>",
                 .remedy = "Choose the .mrml file that 3D Slicer saved"};
  return SceneReader(file, scene).read();
}

}  // namespace sline::model
