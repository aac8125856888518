// SPDX-License-Identifier: Apache-2.0
#include "widgets/shell/menu_table.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <set>

#include "widgets/shell/window_actions.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Splits at blanks; "|" is a separator, which has no id.
std::vector<QString> ids(const char* text) {
  std::vector<QString> ids;
  for (const QString& word : QString::fromLatin1(text).split(QLatin1Char(' ')))
    ids.push_back(word == QLatin1String("|") ? QString() : word);
  return ids;
}

}  // namespace

std::vector<MenuRow> menuRows() {
  const auto row = [](const char* id, const QString& text, std::vector<QString> entries) {
    return MenuRow{QLatin1String(id), text, std::move(entries)};
  };
  return {
      row("fileMenu", tr("&File"),
          ids("new openFiles openFolder >recentMenu >demoMenu | importFiles importFolder "
              "importAgain | save saveAs saveCopy revert | export composeFigure printProof "
              "compareTechniques | reload recover | close quit")),
      row("recentMenu", tr("Open &Recent"), {}),
      row("demoMenu", tr("&Demo"), {}),
      row("editMenu", tr("&Edit"),
          ids("undo redo | >selectMenu find | copyPicture >styleMenu >sidesMenu | preferences")),
      row("sidesMenu", tr("Left and Ri&ght"), ids("sidesRight | sidesMirror sidesTurn")),
      row("selectMenu", tr("S&elect"),
          ids("selectAll selectInverse selectSameKind selectOtherSide selectInFocus | selectBox")),
      row("structureMenu", tr("&Structure"),
          ids("focus focusNear focusPlace context ghost colour >brushMenu >styleMenu "
              ">hiddenLinesMenu >inheritMenu | "
              ">selectMenu "
              "| toggle hide isolate hideOthers showAll zoomTo | rename newGroup group ungroup "
              "lock "
              "properties | remove")),
      row("brushMenu", tr("Paint"), ids("brush | brushSmaller brushLarger | brushErase")),
      row("hiddenLinesMenu", tr("Hi&dden Outlines"),
          ids("hiddenLinesNone hiddenLinesThin hiddenLinesDashed")),
      row("inheritMenu", tr("&Inherit"), ids("inherit inheritColour inheritOpacity | inheritAll")),
      row("styleMenu", tr("St&yle"), ids("copyStyle pasteStyle pasteStyleAlone | makeLike")),
      row("labelMenu", tr("&Labels"),
          ids("annotateLabel annotateCallout annotatePin annotateDistance | labelSelected "
              "| labelEdit labelDelete | >labelModeMenu")),
      row("labelModeMenu", tr("S&how as"), {}),
      row("viewMenu", tr("&View"),
          ids("anterior posterior left right superior inferior fit zoomTo | plate "
              "anotherSubject subjects | >savedViews addView present | >sectionMenu keyLight "
              ">backgroundMenu >marksMenu | >panelMenu")),
      row("savedViews", tr("Saved &Views"), {}),
      row("sectionMenu", tr("S&ection"),
          ids("sectionSagittal sectionCoronal sectionAxial sectionFacing | sectionFlip "
              "sectionOff")),
      row("backgroundMenu", tr("&Background"), {}),
      row("marksMenu", tr("&Over the Picture"),
          ids("showCube showScaleBar showNames showFrameTime")),
      row("panelMenu", tr("Pa&nels"), ids("panels |")),
      row("helpMenu", tr("&Help"), ids("help controls | about")),
  };
}

std::vector<QString> toolRows() {
  return ids(
      "openFiles openFolder save export | undo redo | focus context isolate brush "
      "showAll | anterior posterior left right superior inferior fit | "
      "sectionSagittal sectionCoronal sectionAxial sectionFlip | annotateLabel "
      "annotateDistance | keyLight");
}

WindowMenus::WindowMenus(QMainWindow& window, const WindowActions& actions) {
  const std::vector<MenuRow> rows = menuRows();
  std::set<QString> below;
  for (const MenuRow& row : rows) {
    auto* menu = new QMenu(row.text, &window);
    menu->setObjectName(row.id);
    menu->setToolTipsVisible(true);
    m_menus[row.id] = menu;
  }
  for (const MenuRow& row : rows) {
    QMenu& menu = *m_menus[row.id];
    for (const QString& entry : row.entries) {
      if (entry.isEmpty()) {
        menu.addSeparator();
      } else if (entry.startsWith(QLatin1Char('>'))) {
        below.insert(entry.mid(1));
        menu.addMenu(&(*this)[entry.mid(1)]);
      } else {
        menu.addAction(&actions[entry]);
      }
    }
  }
  for (const MenuRow& row : rows)
    if (!below.contains(row.id))
      window.menuBar()->addMenu(m_menus[row.id]);
}

QMenu& WindowMenus::operator[](const QString& id) const {
  const auto found = m_menus.find(id);
  Q_ASSERT(found != m_menus.end());
  return *found->second;
}

QToolBar* makeToolBar(QMainWindow& window, const WindowActions& actions) {
  QToolBar* tools = window.addToolBar(tr("Toolbar"));
  tools->setObjectName(QStringLiteral("tools"));
  tools->setMovable(false);
  tools->setIconSize({20, 20});
  for (const QString& id : toolRows()) {
    if (id.isEmpty())
      tools->addSeparator();
    else
      tools->addAction(&actions[id]);
  }
  return tools;
}

}  // namespace sline::widgets
