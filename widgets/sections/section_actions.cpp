// SPDX-License-Identifier: Apache-2.0
#include "widgets/sections/section_actions.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>
#include <array>
#include <cmath>

#include "widgets/sections/section_position.h"

namespace sline::widgets {

namespace {

using SectionIds = std::vector<model::SectionId>;

/// Returns the sections of the whole scene along that axis of LPS.
SectionIds sectionsAlong(const model::Scene& scene, int axis) {
  constexpr float parallel = 0.9999f;
  SectionIds ids;
  for (const model::Section& section : scene.sections())
    if (section.scope == model::rootId && std::abs(section.plane.normal[axis]) > parallel)
      ids.push_back(section.id);
  return ids;
}

QString kindText(SectionKind kind) {
  switch (kind) {
    case SectionKind::sagittal:
      return SectionActions::tr("&Sagittal");
    case SectionKind::coronal:
      return SectionActions::tr("&Coronal");
    case SectionKind::axial:
      return SectionActions::tr("&Axial");
    default:
      return SectionActions::tr("Facing the &View");
  }
}

}  // namespace

SectionActions::SectionActions(Session& session, const ViewControl& view,
                               const WindowActions& actions, QObject* parent)
    : QObject(parent), m_session(session), m_view(view), m_actions(actions) {
  for (int axis = 0; axis < 3; ++axis) {
    actionOf(axis).setCheckable(true);
    connect(&actionOf(axis), &QAction::triggered, this, [this, axis] { toggle(axis); });
  }
  connect(&m_actions[QStringLiteral("sectionFacing")], &QAction::triggered, this,
          [this] { add({.kind = SectionKind::facing}); });
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
    add({.kind = SectionKind(axis)});
  } else {
    m_session.apply(tr("Without %1 Section").arg(name), model::withoutSections(scene, there));
  }
  showState();  // the action has checked itself, whatever the result
}

void SectionActions::add(const SectionWish& wish) {
  const model::Scene& scene = m_session.scene();
  const model::Section section = newSection(scene, m_view.camera(), wish);
  const QString name = QString::fromStdString(section.name);
  if (!m_session.apply(name, model::withSection(scene, section)))
    emit refused({.reason = tr("%1 cannot be added: a structure can have %2 sections at most")
                                .arg(name)
                                .arg(model::maximumSections)
                                .toStdString(),
                  .remedy = tr("Take another section away first").toStdString()});
  else
    m_session.activateSection(m_session.scene().sections().back().id);
}

void SectionActions::fill(QMenu& menu, const SectionWish& wish) {
  for (const SectionKind kind :
       {SectionKind::sagittal, SectionKind::coronal, SectionKind::axial, SectionKind::facing})
    menu.addAction(kindText(kind), this, [this, kind, wish] {
      add({.kind = kind, .scope = wish.scope, .through = wish.through});
    });
}

void SectionActions::fillAddMenu(QToolButton& button) {
  auto* menu = new QMenu(&button);
  menu->setObjectName(QStringLiteral("sectionAddMenu"));
  button.setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    fill(*menu, {});
    const model::NodeId scope = commonNode(m_session.scene(), m_session.selection());
    if (scope == model::rootId)
      return;
    menu->addSection(tr("Of %1 alone").arg(scopeText(m_session, scope)));
    fill(*menu, {.scope = scope});
  });
}

void SectionActions::flip() {
  const model::Scene& scene = m_session.scene();
  model::Edited turned{scene, false};
  for (model::Section section : scene.sections()) {
    section.plane = flipped(section.plane);
    model::Edited next = model::withSectionChanged(turned.scene, section.id, section);
    turned = {std::move(next.scene), turned.changed || next.changed};
  }
  m_session.apply(tr("Flip Sections"), std::move(turned));
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
  m_actions[QStringLiteral("sectionFacing")].setEnabled(!scene.nodes().empty());
  for (const char* id : {"sectionFlip", "sectionOff"})
    m_actions[QLatin1String(id)].setEnabled(!scene.sections().empty());
}

}  // namespace sline::widgets

#include "moc_section_actions.cpp"
