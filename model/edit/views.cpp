// SPDX-License-Identifier: Apache-2.0
#include "model/edit/views.h"

#include <algorithm>
#include <map>
#include <set>

#include "model/edit/annotations.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {
void showAnnotations(Scene& scene, const std::vector<AnnotationId>& shown) {
  std::vector<Annotation> annotations = scene.annotations();
  for (Annotation& annotation : annotations)
    annotation.visible = std::find(shown.begin(), shown.end(), annotation.id) != shown.end();
  scene.setAnnotations(std::move(annotations));
}

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}
}  // namespace

Edited withViews(const Scene& scene, std::vector<View> views) {
  if (views == scene.views())
    return {scene, false};
  Edited edited{scene, true};
  edited.scene.setViews(std::move(views));
  return edited;
}

AppliedView withViewApplied(const Scene& scene, const View& view) {
  AppliedView result{scene, {}};
  if (view.sections)
    result.scene.setSections(*view.sections);
  if (view.annotations)
    showAnnotations(result.scene, *view.annotations);
  if (view.focus)
    result.scene.setFocus(*view.focus);
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
  const std::vector<ResolvedStyle> resolved = resolveAll(scene);
  std::vector<Look> looks;
  for (std::size_t i = 0; i < resolved.size(); ++i) {
    const Node& node = scene.nodes()[i];
    Look look{.node = node.id};
    if (!node.isGroup())
      look.style = answersOf(resolved[i]);
    look.style.visible = node.style.visible.value_or(true);
    looks.push_back(std::move(look));
  }
  return looks;
}

std::size_t absentFrom(const Scene& scene, const View& view) {
  std::size_t absent = 0;
  if (view.looks) {
    std::set<NodeId> nodes;
    for (const Node& node : scene.nodes())
      nodes.insert(node.id);
    for (const Look& look : *view.looks)
      absent += nodes.contains(look.node) ? 0 : 1;
  }
  if (view.annotations) {
    std::set<AnnotationId> annotations;
    for (const Annotation& annotation : scene.annotations())
      annotations.insert(annotation.id);
    for (const AnnotationId id : *view.annotations)
      absent += annotations.contains(id) ? 0 : 1;
  }
  return absent;
}

View viewOf(const Scene& scene, const Camera& camera, std::string name) {
  View view{.name = std::move(name), .camera = camera};
  view.sections = scene.sections();
  view.looks = looksOf(scene);
  view.annotations.emplace();
  for (const Annotation& annotation : scene.annotations())
    if (annotation.visible)
      view.annotations->push_back(annotation.id);
  view.focus = scene.focus();
  return view;
}

std::string freeViewName(const Scene& scene, const std::string& wanted,
                         std::optional<std::size_t> but) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < scene.views().size(); ++i)
    if (i != but)
      taken.insert(normalisedName(scene.views()[i].name));
  const std::string name = trimmed(wanted);
  std::string free = name;
  for (int number = 2; taken.contains(normalisedName(free)); ++number)
    free = name + ' ' + std::to_string(number);
  return free;
}

Edited withView(const Scene& scene, View view) {
  view.name = freeViewName(scene, view.name);
  if (trimmed(view.name).empty() || cameraFault(view.camera))
    return {scene, false};
  std::vector<View> views = scene.views();
  views.push_back(std::move(view));
  return withViews(scene, std::move(views));
}

Edited withNewView(const Scene& scene, const Camera& camera, std::string name) {
  View view = viewOf(scene, camera, std::move(name));
  view.annotations = unclaimedAnnotations(scene);
  Edited added = withView(scene, view);
  if (!added.changed)
    return added;
  // Views without a list show what is visible: they keep what they show now.
  std::vector<AnnotationId> seen;
  for (const Annotation& annotation : scene.annotations())
    if (annotation.visible)
      seen.push_back(annotation.id);
  std::vector<View> views = added.scene.views();
  for (View& each : views)
    if (!each.annotations)
      each.annotations = seen;
  added.scene.setViews(std::move(views));
  showAnnotations(added.scene, *view.annotations);
  return added;
}

Edited withViewUpdated(const Scene& scene, std::size_t index, const View& seen) {
  if (index >= scene.views().size() || cameraFault(seen.camera))
    return {scene, false};
  std::vector<View> views = scene.views();
  View updated = seen;
  updated.name = std::move(views[index].name);
  updated.words = std::move(views[index].words);
  updated.unread = std::move(views[index].unread);
  views[index] = std::move(updated);
  return withViews(scene, std::move(views));
}

Edited withViewRenamed(const Scene& scene, std::size_t index, const std::string& name) {
  if (index >= scene.views().size() || trimmed(name).empty())
    return {scene, false};
  std::vector<View> views = scene.views();
  views[index].name = freeViewName(scene, name, index);
  return withViews(scene, std::move(views));
}

Edited withViewWords(const Scene& scene, std::size_t index, const ViewWords& words) {
  if (index >= scene.views().size() ||
      (words.seconds && !viewSecondsLimits.contain(*words.seconds)))
    return {scene, false};
  std::vector<View> views = scene.views();
  views[index].words = words;
  return withViews(scene, std::move(views));
}

Edited withViewMoved(const Scene& scene, std::size_t index, std::size_t to) {
  if (index >= scene.views().size())
    return {scene, false};
  std::vector<View> views = scene.views();
  View moving = std::move(views[index]);
  views.erase(views.begin() + std::ptrdiff_t(index));
  views.insert(views.begin() + std::ptrdiff_t(std::min(to, views.size())), std::move(moving));
  return withViews(scene, std::move(views));
}

Edited withoutView(const Scene& scene, std::size_t index) {
  if (index >= scene.views().size())
    return {scene, false};
  std::vector<View> views = scene.views();
  views.erase(views.begin() + std::ptrdiff_t(index));
  return withViews(scene, std::move(views));
}

Edited withKeyLight(const Scene& scene, const std::optional<KeyLight>& light) {
  if (light == scene.keyLight() || (light && lightFault(*light)))
    return {scene, false};
  Scene after = scene;
  after.setKeyLight(light);
  return {std::move(after), true};
}

}  // namespace sline::model
