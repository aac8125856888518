// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/new_section.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

QString kindName(SectionKind kind) {
  switch (kind) {
    case SectionKind::sagittal:
      return tr("Sagittal section");
    case SectionKind::coronal:
      return tr("Coronal section");
    case SectionKind::axial:
      return tr("Axial section");
    case SectionKind::facing:
      break;
  }
  return tr("Oblique section");
}

// lupdate does not know where tr() belongs in functions that return a qualified type.
QString numbered(const QString& name, int number) {
  return tr("%1 %2").arg(name).arg(number);
}

/// Returns the first free name of "Sagittal section", "Sagittal section 2", …
std::string freshName(const model::Scene& scene, SectionKind kind) {
  const QString name = kindName(kind);
  const auto taken = [&scene](const QString& text) {
    const auto& sections = scene.sections();
    return std::any_of(sections.begin(), sections.end(), [&](const model::Section& section) {
      return section.name == text.toStdString();
    });
  };
  QString fresh = name;
  for (int i = 2; taken(fresh); ++i)
    fresh = numbered(name, i);
  return fresh.toStdString();
}

/// Returns the side of the body to keep so that its cut face looks at the camera.
model::AnatomicalView farSide(const model::Camera& camera, int axis) {
  using View = model::AnatomicalView;
  // LPS: left, back and head lie towards the larger coordinate.
  static constexpr std::array<View, 3> larger{View::left, View::posterior, View::superior};
  static constexpr std::array<View, 3> smaller{View::right, View::anterior, View::inferior};
  constexpr float edgeOn = 1e-3f;
  const bool eyeAtLarger = model::cameraFrame(camera).back[axis] > edgeOn;
  return (eyeAtLarger ? smaller : larger)[std::size_t(axis)];
}

}  // namespace

model::Section newSection(const model::Scene& scene, const model::Camera& camera,
                          const SectionWish& wish) {
  model::Section section;
  if (wish.kind == SectionKind::facing) {
    const model::Box bounds = scene.visibleBounds(wish.scope);
    const glm::vec3 middle = bounds.empty() ? camera.target : bounds.centre();
    const glm::vec3 normal = model::cameraFrame(camera).back;
    section.plane = {.normal = normal, .offset = glm::dot(normal, wish.through.value_or(middle))};
    section.scope = wish.scope;
  } else {
    const int axis = int(wish.kind);
    const std::optional<float> mm =
        wish.through ? std::optional((*wish.through)[axis]) : std::nullopt;
    section = model::anatomicalSection(scene, wish.scope, farSide(camera, axis), mm);
  }
  section.name = freshName(scene, wish.kind);
  return section;
}

model::NodeId commonNode(const model::Scene& scene, const NodeIds& ids) {
  if (ids.empty())
    return model::rootId;
  const auto holdsAll = [&](model::NodeId id) {
    return std::all_of(ids.begin(), ids.end(),
                       [&](model::NodeId one) { return scene.isBelow(one, id); });
  };
  const model::Node* node = scene.find(ids.front());
  while (node && !holdsAll(node->id))
    node = scene.find(node->parent);
  return node ? node->id : model::rootId;
}

QString scopeText(Session& session, model::NodeId scope) {
  const model::Node* node = session.scene().find(scope);
  return node ? session.names().shown(node->name) : tr("Whole scene");
}

}  // namespace sline::widgets
