// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/picture_menu.h"

#include <QAction>
#include <QMenu>
#include <algorithm>
#include <optional>

#include "widgets/sections/section_actions.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

/// Escapes a name for a menu's entry, in which an ampersand must not mark a key.
QString plain(QString name) {
  return name.replace(QLatin1Char('&'), QLatin1String("&&"));
}

QIcon swatch(const Colour& colour) {
  constexpr int side = 32;  // pixels, enough for screens of twice the usual resolution
  QPixmap pixels(side, side);
  pixels.fill(QColor(colour.red, colour.green, colour.blue));
  return QIcon(pixels);
}

}  // namespace

PictureMenu::PictureMenu(Session& session, Viewport& viewport, SectionActions& sections,
                         const WindowMenus& menus, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_viewport(viewport),
      m_sections(sections),
      m_menus(menus) {
  connect(&viewport, &Viewport::menuWanted, this, &PictureMenu::popUp);
}

void PictureMenu::addHeading(QMenu& menu) {
  const model::Node* first = m_session.scene().find(m_session.selection().front());
  const int others = int(m_session.selection().size()) - 1;
  const QString name = plain(m_session.names().shown(first->name));
  QAction* heading =
      menu.addAction(others > 0 ? tr("%1 and %n more", nullptr, others).arg(name) : name);
  heading->setEnabled(false);
  menu.addSeparator();
}

void PictureMenu::addStructure(QMenu& menu, const render::Pick& pick) {
  menu.addActions(m_menus[QStringLiteral("structureMenu")].actions());
  menu.addSeparator();
  for (QAction* action : m_menus[QStringLiteral("labelMenu")].actions())
    if (action->objectName() == QLatin1String("labelSelected"))
      menu.addAction(action);
  QMenu* cut = menu.addMenu(tr("Section &Here"));
  cut->setObjectName(QStringLiteral("sectionHere"));
  m_sections.fill(*cut, {.scope = model::rootId, .through = pick.position});
  QMenu* cutThis = menu.addMenu(tr("Section Here, of &This Alone"));
  cutThis->setObjectName(QStringLiteral("sectionHereAlone"));
  m_sections.fill(*cutThis, {.scope = pick.id, .through = pick.position});
  menu.addAction(tr("Turn &Around This Place"), this,
                 [this, place = pick.position] { m_viewport.setPivot(place); });
}

void PictureMenu::addDepths(QMenu& menu, const std::vector<render::Pick>& all) {
  QMenu* here = menu.addMenu(tr("Select Here"));
  here->setObjectName(QStringLiteral("selectHere"));
  for (const render::Pick& pick : all) {
    const model::Node* node = m_session.scene().find(pick.id);
    if (!node)
      continue;
    QAction* entry = here->addAction(swatch(m_session.scene().resolve(pick.id).colour),
                                     plain(m_session.names().shown(node->name)), this,
                                     [this, id = pick.id] { m_session.select({id}); });
    connect(entry, &QAction::hovered, this, [this, id = pick.id] { m_viewport.light(id); });
  }
  connect(here, &QMenu::aboutToHide, this, [this] { m_viewport.light(std::nullopt); });
}

void PictureMenu::popUp(const QPoint& onScreen, const render::Picks& picks) {
  const std::optional<render::Pick> pick =
      picks.seen && m_session.scene().find(picks.seen->id) ? picks.seen : std::nullopt;
  const NodeIds& selected = m_session.selection();
  if (pick && std::find(selected.begin(), selected.end(), pick->id) == selected.end())
    m_session.select({pick->id});
  auto* menu = new QMenu(&m_viewport);
  menu->setObjectName(QStringLiteral("pictureMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (pick)
    addHeading(*menu);
  if (!picks.all.empty()) {
    addDepths(*menu, picks.all);
    menu->addSeparator();
  }
  if (pick)
    addStructure(*menu, *pick);
  else
    menu->addActions(m_menus[QStringLiteral("viewMenu")].actions());
  menu->popup(onScreen);
}

}  // namespace sline::widgets

#include "moc_picture_menu.cpp"
