// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/section_actions.h"

#include <QAction>
#include <array>
#include <cmath>

#include "model/edit/sections.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

using SectionIds = std::vector<model::SectionId>;

/// Of the whole scene, along that axis of LPS.
SectionIds sectionsAlong(const model::Scene& scene, int axis) {
  constexpr float parallel = 0.9999f;
  SectionIds ids;
  for (const model::Section& section : scene.sections())
    if (section.scope == model::rootId && std::abs(section.plane.normal[axis]) > parallel)
      ids.push_back(section.id);
  return ids;
}

/// The side of the body to keep so that its cut face looks at the camera.
model::AnatomicalView farSide(const model::Camera& camera, int axis) {
  using View = model::AnatomicalView;
  // LPS: towards the larger coordinate lie the left, the back and the head.
  static constexpr std::array<View, 3> larger{View::left, View::posterior, View::superior};
  static constexpr std::array<View, 3> smaller{View::right, View::anterior, View::inferior};
  constexpr float edgeOn = 1e-3f;
  const bool eyeAtLarger = model::cameraFrame(camera).back[axis] > edgeOn;
  return (eyeAtLarger ? smaller : larger)[std::size_t(axis)];
}

}  // namespace

SectionActions::SectionActions(Session& session, const Viewport& viewport,
                               const WindowActions& actions, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport), m_actions(actions) {
  for (int axis = 0; axis < 3; ++axis) {
    actionOf(axis).setCheckable(true);
    connect(&actionOf(axis), &QAction::triggered, this, [this, axis] { toggle(axis); });
  }
  connect(&m_actions[QStringLiteral("sectionFlip")], &QAction::triggered, this,
          &SectionActions::flip);
  connect(&m_actions[QStringLiteral("sectionOff")], &QAction::triggered, this,
          &SectionActions::remove);
  connect(&session, &Session::documentChanged, this, &SectionActions::showState);
  showState();
}

QAction& SectionActions::actionOf(int axis) const {
  static constexpr std::array<const char*, 3> ids{"sectionSagittal", "sectionCoronal",
                                                  "sectionAxial"};
  return m_actions[QLatin1String(ids[std::size_t(axis)])];
}

void SectionActions::toggle(int axis) {
  const model::Scene& scene = m_session.scene();
  const QString name = QString(actionOf(axis).text()).remove(QLatin1Char('&'));
  const SectionIds there = sectionsAlong(scene, axis);
  if (there.empty()) {
    const model::Section section =
        model::anatomicalSection(scene, model::rootId, farSide(m_viewport.camera(), axis));
    m_session.apply(tr("%1 Section").arg(name), model::withSection(scene, section));
  } else {
    m_session.apply(tr("Without %1 Section").arg(name), model::withoutSections(scene, there));
  }
  showState();  // the action has checked itself, whatever came of it
}

void SectionActions::flip() {
  const model::Scene& scene = m_session.scene();
  model::Edited flipped{scene, false};
  for (model::Section section : scene.sections()) {
    section.plane = {.normal = -section.plane.normal, .offset = -section.plane.offset};
    model::Edited next = model::withSectionChanged(flipped.scene, section.id, section);
    flipped = {std::move(next.scene), flipped.changed || next.changed};
  }
  m_session.apply(tr("Flip Sections"), std::move(flipped));
}

void SectionActions::remove() {
  SectionIds all;
  for (const model::Section& section : m_session.scene().sections())
    all.push_back(section.id);
  m_session.apply(tr("Whole Again"), model::withoutSections(m_session.scene(), all));
}

void SectionActions::showState() {
  const model::Scene& scene = m_session.scene();
  for (int axis = 0; axis < 3; ++axis) {
    actionOf(axis).setEnabled(!scene.nodes().empty());
    actionOf(axis).setChecked(!sectionsAlong(scene, axis).empty());
  }
  for (const char* id : {"sectionFlip", "sectionOff"})
    m_actions[QLatin1String(id)].setEnabled(!scene.sections().empty());
}

}  // namespace sline::widgets
