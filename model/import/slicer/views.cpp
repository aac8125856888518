// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/views.h"

#include <map>
#include <set>

#include "model/import/slicer/annotations.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {

/// Views hold a copy of the scene each: no scene made by a person has more than this.
constexpr std::size_t mostViews = 200;
constexpr const char* ownCamera = "3D Slicer's camera";

std::optional<glm::vec3> pointIn(const XmlNode& node, const char* attribute) {
  const auto ras = numbers(node.attribute(attribute).value(), 3);
  if (!ras)
    return std::nullopt;
  return glm::vec3(narrowed(-(*ras)[0]), narrowed(-(*ras)[1]), narrowed((*ras)[2]));
}

std::optional<float> numberIn(const XmlNode& node, const char* attribute) {
  const auto value = numbers(node.attribute(attribute).value(), 1);
  return value ? std::optional(narrowed(value->front())) : std::nullopt;
}

/// Reads a camera node: RAS, millimetres, the full vertical opening angle (VTK's 30° where it is
/// not said), and half of the height that a parallel view shows.
std::optional<Camera> cameraOf(const XmlNode& node) {
  const auto eye = pointIn(node, "position");
  const auto target = pointIn(node, "focalPoint");
  const auto up = pointIn(node, "viewUp");
  if (!eye || !target || !up)
    return std::nullopt;
  Camera camera{.eye = *eye, .target = *target, .up = *up};
  if (flag(node, "parallelProjection", false))
    camera.projection = Projection::orthographic;
  camera.fovyDegrees = numberIn(node, "viewAngle").value_or(camera.fovyDegrees);
  if (const auto half = numberIn(node, "parallelScale"); half && *half > 0.0f)
    camera.heightMm = 2.0f * *half;
  if (cameraFault(camera))
    return std::nullopt;
  return camera;
}

/// Returns the camera; of several that of a 3D view.
std::optional<Camera> cameraIn(const XmlNode& scene) {
  std::optional<Camera> found;
  for (const XmlNode& node : scene.children("Camera")) {
    const bool ofView = *node.attribute("activetag").value() != '\0';
    if (const auto camera = cameraOf(node); camera && (!found || ofView))
      found = camera;
    if (found && ofView)
      break;
  }
  return found;
}

/// Represents a copy of the scene as it was when the view was saved.
class SavedScene {
 public:
  explicit SavedScene(const XmlNode& scene) : m_nodes(scene) {
    for (const XmlNode& node : scene.children("ModelHierarchy")) {
      std::string model = SlicerNodes::reference(node, "associated");
      if (model.empty())
        model = SlicerNodes::reference(node, "model");
      if (!model.empty())
        m_placeOfModel.emplace(std::move(model), node);
    }
  }

  /// Returns the style of a group. A group that is collapsed draws everything in it in its own
  /// style; one that is not collapsed says nothing.
  Style group(const std::string& id) const {
    const XmlNode node = m_nodes.find(id);
    Style style;
    if (node && !flag(node, "expanded", true))
      style = slicerStyle(m_nodes.referred(node, "display"));
    if (!style.visible)
      style.visible = true;
    return style;
  }

  Style model(const std::string& id) const {
    const XmlNode node = m_nodes.find(id);
    const std::string_view kind = node.name();
    if (kind == "Segmentation" || kind == "LabelMapVolume")
      return slicerSegmentsStyle(m_nodes.referred(node, "display"));
    if (kind != "Model")
      return {.visible = false};
    Style style = slicerStyle(m_nodes.referred(node, "display"));
    if (const XmlNode above = collapsedAbove(id))
      style = slicerStyle(m_nodes.referred(above, "display"));
    if (!style.visible)
      style.visible = true;
    return style;
  }

  bool shows(const std::string& id) const {
    const XmlNode node = m_nodes.find(id);
    return node && slicerShows(m_nodes, node);
  }

 private:
  /// Returns the outermost collapsed group above the model.
  XmlNode collapsedAbove(const std::string& model) const {
    XmlNode outermost;
    std::set<std::string> seen;
    const auto place = m_placeOfModel.find(model);
    XmlNode node = place == m_placeOfModel.end() ? XmlNode() : place->second;
    while (node) {
      const std::string id = SlicerNodes::reference(node, "parent");
      if (id.empty() || !seen.insert(id).second)
        break;
      node = m_nodes.find(id);
      if (node && !flag(node, "expanded", true))
        outermost = node;
    }
    return outermost;
  }

  SlicerNodes m_nodes;
  std::map<std::string, XmlNode> m_placeOfModel;
};

}  // namespace

void readSlicerViews(const SlicerDocument& document, SlicerScene& result) {
  const auto warn = [&](std::string reason) {
    result.warnings.push_back({document.file.filename().string(), std::move(reason)});
  };
  for (const char* tag : {"SceneView", "SceneSnapshot"})
    for (const XmlNode& node : document.scene.children(tag)) {
      SlicerView view{.name = node.attribute("name").value()};
      const std::optional<Camera> camera = cameraIn(node);
      if (!camera || result.views.size() == mostViews) {
        warn("the saved view \"" + view.name + "\" was left out: " +
             (camera ? "there are too many" : "it has no camera that could be used"));
        continue;
      }
      view.camera = *camera;
      const SavedScene saved(node);
      for (const SlicerGroup& group : result.groups)
        view.groups.push_back(saved.group(group.id));
      for (const SlicerModel& model : result.models)
        view.models.push_back(saved.model(model.id));
      for (const std::string& id : result.fiducialIds)
        view.fiducials.push_back(saved.shows(id));
      result.views.push_back(std::move(view));
    }
  if (const std::optional<Camera> camera = cameraIn(document.scene))
    result.views.push_back({.name = ownCamera, .camera = *camera});
}

}  // namespace sline::model
