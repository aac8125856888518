// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPoint>

#include "render/picking/pick_index.h"
#include "widgets/session/session.h"
#include "widgets/shell/menu_table.h"

class QMenu;

namespace sline::widgets {

class SectionActions;
class Viewport;

/// Opens the menu of a right click in the picture: the tree's menu for the structure there, and
/// sections through the place, and what lies behind; where there is no structure, what can be done
/// with the picture.
class PictureMenu : public QObject {
  Q_OBJECT
 public:
  PictureMenu(Session& session, Viewport& viewport, SectionActions& sections,
              const WindowMenus& menus, QObject* parent);

 private:
  void popUp(const QPoint& onScreen, const render::Picks& picks);
  /// Adds all that is there from front to back, to choose from; each shows in the picture while the
  /// mouse is on its entry.
  void addDepths(QMenu& menu, const std::vector<render::Pick>& all);
  /// Adds the name of what is selected.
  void addHeading(QMenu& menu);
  void addStructure(QMenu& menu, const render::Pick& pick);

  Session& m_session;
  Viewport& m_viewport;
  SectionActions& m_sections;
  const WindowMenus& m_menus;
};

}  // namespace sline::widgets
