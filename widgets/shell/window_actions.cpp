// SPDX-License-Identifier: Apache-2.0
#include "widgets/shell/window_actions.h"

#include <QAction>
#include <QWidget>

#include "widgets/text/tr.h"
#include "widgets/theme/icons.h"

namespace sline::widgets {

namespace {

QList<QKeySequence> key(const QKeySequence& keys) {
  return {keys};
}

std::vector<ActionRow> fileRows() {
  return {{QStringLiteral("new"), tr("&New"), key(QKeySequence::New),
           tr("A scene without anything in it"), "new"},
          {QStringLiteral("openFiles"), tr("&Open Files…"), key(QKeySequence::Open),
           tr("Open scenes, meshes, label volumes and other files"), "open_files"},
          {QStringLiteral("openFolder"), tr("Open &Folder…"), key(tr("Ctrl+Shift+O")),
           tr("Open all meshes in a folder"), "open_folder"},
          {QStringLiteral("importFiles"), tr("&Import…"), key(tr("Ctrl+I")),
           tr("See and change what an import would do, before it is done")},
          {QStringLiteral("importFolder"), tr("I&mport Folder…"), key(tr("Ctrl+Shift+I")),
           tr("The same for all meshes in a folder")},
          {QStringLiteral("importAgain"),
           tr("Import Op&tions…"),
           {},
           tr("Import what is open once more, with other units, smoothing or choice")},
          {QStringLiteral("save"), tr("&Save"), key(QKeySequence::Save), tr("Write the scene file"),
           "save"},
          {QStringLiteral("saveAs"), tr("Save &As…"), key(tr("Ctrl+Shift+S")),
           tr("Write another scene file and go on with that")},
          {QStringLiteral("saveCopy"),
           tr("Save a Cop&y…"),
           {},
           tr("Write another scene file and go on with this one")},
          {QStringLiteral("revert"),
           tr("Re&vert to Saved…"),
           {},
           tr("Read the scene file again; what was changed since is undone")},
          {QStringLiteral("recover"),
           tr("Recover &Unsaved Work…"),
           {},
           tr("What was kept when the program did not end as it should")}};
}

std::vector<ActionRow> exportRows() {
  return {
      {QStringLiteral("export"), tr("&Export…"), key(tr("Ctrl+Shift+E")),
       tr("Write pictures, drawings and other files for print, teaching and other programs"),
       "export"},
      {QStringLiteral("composeFigure"),
       tr("Fi&gure of Several Panels…"),
       {},
       tr("Lay saved views out as panels a, b, c on a page for a journal, with insets, scale bars "
          "and one legend")},
      {QStringLiteral("printProof"),
       tr("&Print Proof…"),
       {},
       tr("Find neighbours that a press without colours or some eyes cannot tell apart, and "
          "what would help")},
      {QStringLiteral("compareTechniques"),
       tr("Compare Tec&hniques…"),
       {},
       tr("See what is selected, or all, drawn by several line techniques side by side, and save "
          "that as a sheet")}};
}

std::vector<ActionRow> closeAndEditRows() {
  return {{QStringLiteral("close"), tr("&Close"), key(QKeySequence::Close),
           tr("Close the scene and go to the start page")},
          {QStringLiteral("reload"), tr("Re&load from Source"), key(QKeySequence::Refresh),
           tr("Read meshes again whose files have changed")},
          {QStringLiteral("quit"), tr("&Quit"), key(QKeySequence::Quit), tr("Close the program")},
          {QStringLiteral("undo"), tr("&Undo"), key(QKeySequence::Undo),
           tr("Take the last step back"), "undo"},
          {QStringLiteral("redo"), tr("&Redo"), key(QKeySequence::Redo), tr("Do it again"), "redo"},
          {QStringLiteral("copyPicture"), tr("&Copy Picture"), key(tr("Ctrl+Shift+C")),
           tr("The picture on the clipboard, with its labels, for other programs")},
          {QStringLiteral("sidesRight"),
           tr("Sides Are &Right"),
           {},
           tr("What was assumed of left and right is so; marks lose their question marks")},
          {QStringLiteral("sidesMirror"),
           tr("&Mirror Left and Right"),
           {},
           tr("Left and right are swapped, front and back are not: the scene becomes its mirror "
              "image")},
          {QStringLiteral("sidesTurn"),
           tr("&Turn About the Body's Axis"),
           {},
           tr("Left and right are swapped, and front and back, too, as where RAS was taken for "
              "LPS: half a turn")},
          {QStringLiteral("preferences"), tr("&Preferences…"), key(QKeySequence::Preferences),
           tr("Theme, background and other habits"), "preferences"},
          {QStringLiteral("find"), tr("&Find Structure"), key(QKeySequence::Find),
           tr("Type a few letters of a name")}};
}

std::vector<ActionRow> lookRows() {
  return {
      {QStringLiteral("focus"),
       tr("&Focus"),
       {QKeySequence(tr("F")), QKeySequence(tr("Ctrl+E"))},
       tr("The selected structures in detail, everything else by what it is to them"),
       "focus"},
      {QStringLiteral("plate"), tr("Dra&w as Plate"), key(tr("Ctrl+Shift+L")),
       tr("What the scene is about in detail, seen from where it shows best, everything else as "
          "context")},
      {QStringLiteral("anotherSubject"),
       tr("Another S&ubject"),
       {},
       tr("A plate of what else the scene may be about; again for the next")},
      {QStringLiteral("subjects"), tr("Other Sub&jects…"), key(tr("Ctrl+Shift+J")),
       tr("Small plates of the next three subjects, to choose from")},
      {QStringLiteral("context"), tr("&Context"), key(tr("Ctrl+D")),
       tr("The selected structures as contours"), "context"},
      {QStringLiteral("ghost"), tr("&Ghost"), key(tr("Ctrl+Shift+D")),
       tr("The selected structures as outlines under a veil"), "ghost"},
      {QStringLiteral("colour"), tr("Co&lour…"), {}, tr("Another colour for the selected")},
      {QStringLiteral("hiddenLinesNone"),
       tr("&Not Drawn"),
       {},
       tr("Outlines of the selected end where other structures hide them")},
      {QStringLiteral("hiddenLinesThin"),
       tr("&Thin"),
       {},
       tr("Outlines of the selected go on thinly where other structures hide them")},
      {QStringLiteral("hiddenLinesDashed"),
       tr("&Dashed"),
       {},
       tr("Outlines of the selected go on dashed where other structures hide them")},
      {QStringLiteral("inherit"), tr("Inherit &Γ"), {}, tr("Take Γ from the group above again")},
      {QStringLiteral("inheritColour"),
       tr("Inherit &Colour"),
       {},
       tr("Take the colour from the group above again")},
      {QStringLiteral("inheritOpacity"),
       tr("Inherit &Opacity"),
       {},
       tr("Take the opacity from the group above again")},
      {QStringLiteral("inheritAll"),
       tr("Inherit &All"),
       {},
       tr("Take the whole look from the group above again")},
      {QStringLiteral("toggle"),
       tr("Show or &Hide"),
       {},
       tr("Hide the selected structures, or show them again (Space in the list)"),
       "toggle"},
      {QStringLiteral("hide"), tr("Hide"), key(tr("H")), tr("Hide the selected structures")},
      {QStringLiteral("isolate"), tr("I&solate"), key(tr("/")),
       tr("Show the selected structures and nothing else; again: everything"), "isolate"},
      {QStringLiteral("hideOthers"), tr("Hide &Others"), key(tr("Shift+H")),
       tr("Hide all but the selected structures")},
      {QStringLiteral("showAll"), tr("Show &All"), key(tr("Ctrl+Shift+H")), tr("Hide nothing"),
       "show_all"}};
}

/// Rows of what is done by hand in the picture: near to what everything is, and what is painted.
std::vector<ActionRow> handRows() {
  return {{QStringLiteral("focusNear"), tr("Focus by Nearness"), key(tr("Shift+F")),
           tr("The selected shaded, everything else the less detailed the farther away it is")},
          {QStringLiteral("focusPlace"), tr("Nearness to a Place"), key(tr("Ctrl+Shift+F")),
           tr("Click in the picture to set the place, and drag it; with Shift in depth")},
          {QStringLiteral("brush"), tr("&Brush"), key(tr("Shift+B")),
           tr("Paint on the selected structures where more is to be told than elsewhere"), "brush"},
          {QStringLiteral("brushSmaller"), tr("S&maller Brush"), key(tr("[")),
           tr("Paint with a smaller brush")},
          {QStringLiteral("brushLarger"), tr("&Larger Brush"), key(tr("]")),
           tr("Paint with a larger brush")},
          {QStringLiteral("brushErase"),
           tr("&Erase with the Brush"),
           {},
           tr("Take away what is painted (Ctrl while you paint)")}};
}

std::vector<ActionRow> selectionRows() {
  return {{QStringLiteral("selectAll"), tr("&All"), key(QKeySequence::SelectAll),
           tr("Select all structures that are shown and not locked")},
          {QStringLiteral("selectInverse"), tr("&Inverse"), key(tr("Ctrl+Shift+A")),
           tr("Select what is shown and not selected, in place of what is")},
          {QStringLiteral("selectSameKind"), tr("Same &Kind"), key(tr("Shift+G")),
           tr("Select what differs from the selected by side or number alone, such as all ribs; "
              "again: all of their system")},
          {QStringLiteral("selectOtherSide"), tr("&Other Side"), key(tr("Shift+M")),
           tr("Select what the selected structures are paired with on the other side of the body")},
          {QStringLiteral("selectInFocus"), tr("In &Focus"), {}, tr("Select what is in focus")},
          {QStringLiteral("selectBox"), tr("By a &Box"), key(tr("B")),
           tr("Drag a box in the picture: to the right what lies within, to the left what it "
              "touches")}};
}

std::vector<ActionRow> styleRows() {
  return {{QStringLiteral("copyStyle"), tr("&Copy Style"), key(tr("Ctrl+Alt+C")),
           tr("The whole look of the selected structure, for others")},
          {QStringLiteral("pasteStyle"), tr("&Paste Style"), key(tr("Ctrl+Alt+V")),
           tr("Give the selected structures the look that was copied")},
          {QStringLiteral("pasteStyleAlone"), tr("Paste Style, &Keep Colour"),
           key(tr("Ctrl+Alt+Shift+V")),
           tr("Give the selected structures the look that was copied, but for colour and ink")},
          {QStringLiteral("makeLike"), tr("&Make Like…"), key(tr("Shift+L")),
           tr("Click on another structure, in the picture or the list: the selected ones are drawn "
              "as it is and keep their colours")}};
}

std::vector<ActionRow> structureRows() {
  return {
      {QStringLiteral("zoomTo"),
       tr("&Zoom To"),
       {QKeySequence(tr("Z")), QKeySequence(tr(".")),
        QKeySequence(int(Qt::KeypadModifier) | Qt::Key_Period),
        QKeySequence(int(Qt::KeypadModifier) | Qt::Key_Comma)},
       tr("Bring the selected structures into the picture, and turn around them"),
       "zoom_to"},
      {QStringLiteral("rename"), tr("Re&name"), key(tr("F2")), tr("Another name")},
      {QStringLiteral("newGroup"), tr("Ne&w Group"), key(tr("Ctrl+Shift+N")), tr("An empty group")},
      {QStringLiteral("group"), tr("Grou&p"), key(tr("Ctrl+G")),
       tr("The selected structures in a group of their own"), "group"},
      {QStringLiteral("ungroup"), tr("&Ungroup"), key(tr("Ctrl+Shift+G")),
       tr("Dissolve the selected groups; what is in them keeps its look")},
      {QStringLiteral("lock"), tr("Loc&k"), key(tr("Ctrl+L")),
       tr("What is locked keeps its look, name and place and cannot be clicked in the picture"),
       "lock"},
      {QStringLiteral("properties"), tr("Proper&ties…"), key(tr("Alt+Return")),
       tr("Where it came from, how large it is, how it is drawn")},
      {QStringLiteral("remove"), tr("&Remove"), key(QKeySequence::Delete),
       tr("Take the selected structures out of the scene"), "remove"}};
}

std::vector<ActionRow> labelRows() {
  return {{QStringLiteral("annotateLabel"), tr("&Label"), key(tr("T")),
           tr("Click on a structure and type what it is called"), "label"},
          {QStringLiteral("annotateCallout"), tr("&Callout"), key(tr("Shift+T")),
           tr("Click on a place and type a few lines, which stand in a frame"), "callout"},
          {QStringLiteral("annotatePin"), tr("&Pin"), key(tr("Shift+P")),
           tr("Click on a place to mark it; its text stands beside it"), "pin"},
          {QStringLiteral("annotateDistance"), tr("&Distance"), key(tr("M")),
           tr("Click on two places to measure between them"), "distance"},
          {QStringLiteral("labelSelected"), tr("Label the &Selected"), key(tr("Ctrl+T")),
           tr("The selected structures get labels with their names, where they are best seen"),
           "label_selected"},
          {QStringLiteral("labelEdit"),
           tr("&Edit Text"),
           {},
           tr("Type what the chosen label says (F2 in the picture)")},
          {QStringLiteral("labelDelete"),
           tr("Dele&te Label"),
           {},
           tr("Take the chosen label away (Del in the picture)")}};
}

std::vector<ActionRow> viewRows() {
  return {
      {QStringLiteral("anterior"), tr("&Anterior"), key(tr("A")), tr("Seen from the front")},
      {QStringLiteral("posterior"), tr("&Posterior"), key(tr("P")), tr("Seen from the back")},
      {QStringLiteral("left"), tr("&Left"), key(tr("L")), tr("Seen from the patient's left")},
      {QStringLiteral("right"), tr("&Right"), key(tr("R")), tr("Seen from the patient's right")},
      {QStringLiteral("superior"), tr("&Superior"), key(tr("S")), tr("Seen from above")},
      {QStringLiteral("inferior"), tr("&Inferior"), key(tr("I")), tr("Seen from below")},
      {QStringLiteral("fit"), tr("&Fit All"), key(tr("Home")),
       tr("Bring all that is shown into the picture"), "fit"},
      {QStringLiteral("addView"), tr("A&dd View"), key(tr("Ctrl+Shift+V")),
       tr("Save what you see as a view: camera, what is shown, Γ, colours and sections"),
       "view_add"},
      {QStringLiteral("panels"), tr("&All Panels"), key(tr("F12")),
       tr("Hide all panels around the picture, or show them again")},
      {QStringLiteral("present"), tr("Presen&t"), key(tr("Shift+F5")),
       tr("The saved views one after the other on the whole screen"), "present"},
      {QStringLiteral("sectionSagittal"), tr("&Sagittal"), key(tr("Ctrl+1")),
       tr("Cut in the plane between left and right; again: whole"), "section_sagittal"},
      {QStringLiteral("sectionCoronal"), tr("&Coronal"), key(tr("Ctrl+2")),
       tr("Cut in the plane between front and back; again: whole"), "section_coronal"},
      {QStringLiteral("sectionAxial"), tr("&Axial"), key(tr("Ctrl+3")),
       tr("Cut in the plane between upper and lower; again: whole"), "section_axial"},
      {QStringLiteral("sectionFacing"), tr("Facing the &View"), key(tr("Ctrl+4")),
       tr("Cut across the line of sight")},
      {QStringLiteral("sectionFlip"), tr("&Flip"), key(tr("X")),
       tr("Keep the other side of each section"), "section_flip"},
      {QStringLiteral("sectionOff"), tr("&Whole Again"), key(tr("Ctrl+0")),
       tr("Take all sections away")},
      {QStringLiteral("keyLight"), tr("&Key Light"), key(tr("K")),
       tr("Light from the upper left on what is shaded"), "key_light"},
      {QStringLiteral("help"), tr("&Help on This"), key(QKeySequence(Qt::Key_F1)),
       tr("The page about the panel that has the keyboard")},
      {QStringLiteral("showCube"),
       tr("&Orientation Cube"),
       {},
       tr("The body's sides in the corner of the picture; a click looks from there")},
      {QStringLiteral("showScaleBar"), tr("Scale &Bar"), {}, tr("How long a centimetre is")},
      {QStringLiteral("showNames"),
       tr("&Names under the Mouse"),
       {},
       tr("What a structure is called where the mouse rests")},
      {QStringLiteral("showFrameTime"),
       tr("Picture &Time"),
       {},
       tr("How long the last picture took to draw")},
      {QStringLiteral("controls"), tr("&Mouse and Keys"), key(tr("?")),
       tr("What the mouse and the keys do")},
      {QStringLiteral("about"), tr("&About Sline"), {}, tr("What this program is")}};
}

}  // namespace

std::vector<ActionRow> actionRows() {
  std::vector<ActionRow> rows = fileRows();
  for (const std::vector<ActionRow>& more :
       {exportRows(), closeAndEditRows(), lookRows(), handRows(), selectionRows(), styleRows(),
        structureRows(), labelRows(), viewRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

WindowActions::WindowActions(QWidget& window) {
  remake(window);
}

void WindowActions::remake(QWidget& window) {
  for (const auto& [id, action] : m_actions)
    delete action;
  m_actions.clear();
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

std::vector<ControlRow> listRows() {
  return {{tr("Space"), tr("Show or hide the selected structures")},
          {tr("Enter"), tr("Bring the selected structures into the picture")},
          {tr("Drag over eyes or locks"), tr("Set them all alike")},
          {tr("Alt + click on an eye"), tr("Show this and nothing else; again: everything")},
          {tr("Middle click on Γ or colour"), tr("Take it from the group above again")},
          {tr("Drag rows"), tr("Put them elsewhere, or into another group")},
          {tr("Double click on a name"), tr("Another name")}};
}

}  // namespace sline::widgets
