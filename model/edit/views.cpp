// SPDX-License-Identifier: Apache-2.0
#include "model/edit/views.h"

#include <algorithm>
#include <map>

namespace sline::model {

namespace {
void showAnnotations(Scene& scene, const std::vector<AnnotationId>& shown) {
  std::vector<Annotation> annotations = scene.annotations();
  for (Annotation& annotation : annotations)
    annotation.visible = std::find(shown.begin(), shown.end(), annotation.id) != shown.end();
  scene.setAnnotations(std::move(annotations));
}
}  // namespace

ShownScene shown(const Scene& scene, const View& view) {
  ShownScene result{scene, {}};
  if (view.sections)
    result.scene.setSections(*view.sections);
  if (view.annotations)
    showAnnotations(result.scene, *view.annotations);
  if (!view.looks)
    return result;
  std::map<NodeId, const Style*> styles;
  for (const Look& look : *view.looks)
    styles[look.node] = &look.style;
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    const auto found = styles.find(node.id);
    if (found == styles.end())
      continue;
    patch(node.style, *found->second);
    styles.erase(found);
  }
  result.scene.setNodes(std::move(nodes));
  for (const auto& [id, style] : styles)
    result.absent.push_back(id);
  return result;
}

std::vector<Look> looksOf(const Scene& scene) {
  std::vector<Look> looks;
  for (const Node& node : scene.nodes()) {
    Look look{.node = node.id};
    look.style.visible = node.style.visible.value_or(true);
    if (!node.isGroup()) {
      const ResolvedStyle seen = scene.resolve(node.id);
      look.style.colour = seen.colour;
      look.style.inkColour = seen.inkColour;
      look.style.gamma = seen.gamma;
      look.style.opacity = seen.opacity;
      look.style.fill = seen.fill;
      look.style.penWeight = seen.penWeight;
      look.style.hatchDensity = seen.hatchDensity;
      look.style.hatchTone = seen.hatchTone;
    }
    looks.push_back(std::move(look));
  }
  return looks;
}

Edited withKeyLight(const Scene& scene, const std::optional<KeyLight>& light) {
  if (light == scene.keyLight() || (light && lightFault(*light)))
    return {scene, false};
  Scene after = scene;
  after.setKeyLight(light);
  return {std::move(after), true};
}

}  // namespace sline::model
