// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/window_actions.h"

#include <QAction>
#include <QCoreApplication>
#include <QWidget>

#include "widgets/theme/icons.h"

namespace sline::widgets {

namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("WindowActions", text);
}

QList<QKeySequence> key(const QKeySequence& keys) {
  return {keys};
}

std::vector<ActionRow> fileRows() {
  return {{QStringLiteral("openFiles"), tr("&Open Files…"), key(QKeySequence::Open),
           tr("Open mesh files or a 3D Slicer scene"), "open_files"},
          {QStringLiteral("openFolder"), tr("Open &Folder…"), key(tr("Ctrl+Shift+O")),
           tr("Open all meshes in a folder"), "open_folder"},
          {QStringLiteral("reload"), tr("&Reload from Source"), key(QKeySequence::Refresh),
           tr("Read meshes again whose files have changed")},
          {QStringLiteral("quit"), tr("&Quit"), key(QKeySequence::Quit), tr("Close the program")},
          {QStringLiteral("undo"), tr("&Undo"), key(QKeySequence::Undo),
           tr("Take the last step back"), "undo"},
          {QStringLiteral("redo"), tr("&Redo"), key(QKeySequence::Redo), tr("Do it again"), "redo"},
          {QStringLiteral("preferences"), tr("&Preferences…"), key(QKeySequence::Preferences),
           tr("Theme, background and other habits"), "preferences"},
          {QStringLiteral("find"), tr("&Find Structure"), key(QKeySequence::Find),
           tr("Type a few letters of a name")}};
}

std::vector<ActionRow> structureRows() {
  return {
      {QStringLiteral("focus"), tr("&Focus"), key(tr("Ctrl+E")),
       tr("The selected structures in detail, everything else as contours"), "focus"},
      {QStringLiteral("context"), tr("&Context"), key(tr("Ctrl+D")),
       tr("The selected structures as contours"), "context"},
      {QStringLiteral("inherit"), tr("&Inherit Γ"), {}, tr("Take Γ from the group above again")},
      {QStringLiteral("toggle"),
       tr("Show or &Hide"),
       {},
       tr("Hide the selected structures, or show them again (Space in the list)"),
       "toggle"},
      {QStringLiteral("isolate"), tr("I&solate"), key(tr("/")), tr("Hide everything else"),
       "isolate"},
      {QStringLiteral("showAll"), tr("Show &All"), key(tr("Ctrl+Shift+H")), tr("Hide nothing"),
       "show_all"},
      {QStringLiteral("remove"), tr("&Remove"), key(QKeySequence::Delete),
       tr("Take the selected structures out of the scene"), "remove"}};
}

std::vector<ActionRow> viewRows() {
  return {
      {QStringLiteral("anterior"), tr("&Anterior"), key(tr("A")), tr("Seen from the front")},
      {QStringLiteral("posterior"), tr("&Posterior"), key(tr("P")), tr("Seen from the back")},
      {QStringLiteral("left"), tr("&Left"), key(tr("L")), tr("Seen from the patient's left")},
      {QStringLiteral("right"), tr("&Right"), key(tr("R")), tr("Seen from the patient's right")},
      {QStringLiteral("superior"), tr("&Superior"), key(tr("S")), tr("Seen from above")},
      {QStringLiteral("inferior"), tr("&Inferior"), key(tr("I")), tr("Seen from below")},
      {QStringLiteral("fit"),
       tr("&Fit All"),
       {QKeySequence(tr("F")), QKeySequence(tr("Home"))},
       tr("Bring all that is shown into the picture"),
       "fit"},
      {QStringLiteral("sectionSagittal"), tr("&Sagittal"), key(tr("Ctrl+1")),
       tr("Cut in the plane between left and right; again: whole"), "section_sagittal"},
      {QStringLiteral("sectionCoronal"), tr("&Coronal"), key(tr("Ctrl+2")),
       tr("Cut in the plane between front and back; again: whole"), "section_coronal"},
      {QStringLiteral("sectionAxial"), tr("&Axial"), key(tr("Ctrl+3")),
       tr("Cut in the plane between upper and lower; again: whole"), "section_axial"},
      {QStringLiteral("sectionFlip"), tr("&Flip"), key(tr("X")),
       tr("Keep the other side of each section"), "section_flip"},
      {QStringLiteral("sectionOff"), tr("&Whole Again"), key(tr("Ctrl+0")),
       tr("Take all sections away")},
      {QStringLiteral("keyLight"), tr("&Key Light"), key(tr("K")),
       tr("Light from the upper left on what is shaded"), "key_light"},
      {QStringLiteral("controls"), tr("&Mouse and Keys"), key(tr("H")),
       tr("What the mouse and the keys do")},
      {QStringLiteral("about"), tr("&About Sline"), {}, tr("What this program is")}};
}

}  // namespace

std::vector<ActionRow> actionRows() {
  std::vector<ActionRow> rows = fileRows();
  for (const std::vector<ActionRow>& more : {structureRows(), viewRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

WindowActions::WindowActions(QWidget& window) {
  for (const ActionRow& row : actionRows()) {
    auto* action = new QAction(row.text, &window);
    action->setObjectName(row.id);
    action->setShortcuts(row.keys);
    action->setToolTip(row.tip);
    action->setStatusTip(row.tip);
    if (row.icon)
      action->setIcon(lineIcon(QLatin1String(row.icon)));
    window.addAction(action);
    m_actions[row.id] = action;
  }
}

QAction& WindowActions::operator[](const QString& id) const {
  const auto found = m_actions.find(id);
  Q_ASSERT(found != m_actions.end());
  return *found->second;
}

std::vector<ControlRow> mouseRows() {
  return {{tr("Left drag"), tr("Turn around the pivot")},
          {tr("Middle drag, Shift + left drag"), tr("Move the picture")},
          {tr("Wheel"), tr("Zoom to the mouse")},
          {tr("Click"), tr("Select what is seen there; Ctrl adds to the selection")},
          {tr("Double click"), tr("Turn around this place from now on")},
          {tr("Space in the list"), tr("Show or hide the selected structures")},
          {tr("Escape during a drag"), tr("As it was before")}};
}

}  // namespace sline::widgets
