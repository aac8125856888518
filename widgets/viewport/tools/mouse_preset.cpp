// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/tools/mouse_preset.h"

#include <QKeySequence>
#include <QLocale>
#include <algorithm>
#include <array>

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

using Kind = model::CameraDrag::Kind;

constexpr std::array slineRows{
    MouseRow{Qt::LeftButton, Qt::NoModifier, Kind::orbit},
    MouseRow{Qt::MiddleButton, Qt::NoModifier, Kind::pan},
    MouseRow{Qt::LeftButton, Qt::ShiftModifier, Kind::pan},
    MouseRow{Qt::RightButton, Qt::NoModifier, Kind::zoom},
    MouseRow{Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier, Kind::roll}};

constexpr std::array slicerRows{
    MouseRow{Qt::LeftButton, Qt::NoModifier, Kind::orbit},
    MouseRow{Qt::MiddleButton, Qt::NoModifier, Kind::pan},
    MouseRow{Qt::LeftButton, Qt::ShiftModifier, Kind::pan},
    MouseRow{Qt::RightButton, Qt::NoModifier, Kind::zoom},
    MouseRow{Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier, Kind::zoom},
    MouseRow{Qt::LeftButton, Qt::ControlModifier, Kind::roll}};

/// Leaves the left button to selecting; with Alt it replaces a missing middle button.
constexpr std::array blenderRows{
    MouseRow{Qt::MiddleButton, Qt::NoModifier, Kind::orbit},
    MouseRow{Qt::LeftButton, Qt::AltModifier, Kind::orbit},
    MouseRow{Qt::MiddleButton, Qt::ShiftModifier, Kind::pan},
    MouseRow{Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, Kind::pan},
    MouseRow{Qt::MiddleButton, Qt::ControlModifier, Kind::zoom},
    MouseRow{Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier, Kind::zoom},
    MouseRow{Qt::MiddleButton, Qt::ControlModifier | Qt::ShiftModifier, Kind::roll}};

QString buttonText(Qt::MouseButton button) {
  switch (button) {
    case Qt::MiddleButton:
      return tr("Middle drag");
    case Qt::RightButton:
      return tr("Right drag");
    default:
      return tr("Left drag");
  }
}

/// Returns "Ctrl+Shift+Left drag", with the keys as this system writes them.
QString handText(const MouseRow& row) {
  QString keys = QKeySequence(int(row.keys)).toString(QKeySequence::NativeText);
  while (keys.endsWith(QLatin1Char('+')))
    keys.chop(1);
  return keys.isEmpty() ? buttonText(row.button) : keys + QLatin1Char('+') + buttonText(row.button);
}

QString meaningOf(Kind kind) {
  switch (kind) {
    case Kind::pan:
      return tr("Move the picture");
    case Kind::zoom:
      return tr("Zoom: upwards is nearer");
    case Kind::roll:
      return tr("Roll the picture around its middle");
    default:
      return tr("Turn around the pivot");
  }
}

/// Returns the drags that the camera leaves to the selection by a box.
QString boxText(MousePreset preset) {
  QStringList hands;
  for (const Qt::KeyboardModifiers keys :
       {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::CTRL)})
    if (!dragOf(preset, Qt::LeftButton, keys))
      hands << handText({Qt::LeftButton, keys, Kind::orbit});
  const QString first = QKeySequence(Qt::Key_B).toString(QKeySequence::NativeText) +
                        QStringLiteral(", ") + buttonText(Qt::LeftButton);
  return (hands << first).join(QStringLiteral("; "));
}

/// Returns one row for all drags that do the same.
ControlRow dragRow(MousePreset preset, Kind kind) {
  QStringList hands;
  for (const MouseRow& row : presetRows(preset))
    if (row.kind == kind)
      hands << handText(row);
  return {hands.join(QStringLiteral(", ")), meaningOf(kind)};
}

}  // namespace

std::span<const MouseRow> presetRows(MousePreset preset) {
  switch (preset) {
    case MousePreset::slicer:
      return slicerRows;
    case MousePreset::blender:
      return blenderRows;
    default:
      return slineRows;
  }
}

std::optional<model::CameraDrag::Kind> dragOf(MousePreset preset, Qt::MouseButton button,
                                              Qt::KeyboardModifiers keys) {
  // Modifiers for the number pad or a group switch are ignored here.
  const Qt::KeyboardModifiers counted =
      keys & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  for (const MouseRow& row : presetRows(preset))
    if (row.button == button && row.keys == counted)
      return row.kind;
  return std::nullopt;
}

std::vector<MousePresetName> mousePresetNames() {
  return {{MousePreset::sline, "sline", tr("Sline")},
          {MousePreset::slicer, "slicer", tr("3D Slicer")},
          {MousePreset::blender, "blender", tr("Blender")}};
}

MousePreset mousePresetNamed(const QString& id) {
  for (const MousePresetName& name : mousePresetNames())
    if (id == QLatin1String(name.id))
      return name.preset;
  return MousePreset::sline;
}

std::vector<ControlRow> controlRows(MousePreset preset) {
  std::vector<ControlRow> rows;
  for (const Kind kind : {Kind::orbit, Kind::pan, Kind::zoom, Kind::roll})
    rows.push_back(dragRow(preset, kind));
  const QString alt = QKeySequence(Qt::ALT).toString(QKeySequence::NativeText);
  const QString control = QKeySequence(Qt::CTRL).toString(QKeySequence::NativeText);
  const std::vector<ControlRow> others{
      {tr("Wheel"), tr("Zoom to the mouse")},
      {tr("Two fingers on a touchpad"), tr("Move the picture; pinch to zoom")},
      {tr("Click"), tr("Select what is seen there")},
      {control + tr("Click"), tr("Add to the selection, or take away from it")},
      {tr("Middle click, Page Down, %1").arg(alt + tr("Click")),
       tr("Select the next structure behind; after the last the first")},
      {tr("Page Up"), tr("Select the next structure before it")},
      {boxText(preset), tr("Select by a box: to the right what lies within, to the left what it "
                           "touches; with Ctrl in addition")},
      {tr("Double click"), tr("Turn around this place from now on")},
      {tr("Right click"), tr("What can be done with the structure there, and all that lies there "
                             "from front to back")},
      {tr("Drag the arrow of a section"), tr("Move the plane; with Ctrl in whole steps")},
      {tr("Click on the arrow's head"), tr("Keep the other side of the section")},
      {tr("Drag a ring of a section"), tr("Tilt the plane; with Ctrl in steps of 15°")},
      {tr("Arrow keys"), tr("Turn by %1°").arg(QLocale().toString(5))},
      {control + tr("Arrow keys"), tr("Move the picture")},
      {tr("Plus, minus"), tr("Zoom")},
      {tr("Escape during a drag"), tr("As it was before")}};
  rows.insert(rows.end(), others.begin(), others.end());
  std::erase_if(rows, [](const ControlRow& row) { return row.control.isEmpty(); });
  return rows;
}

}  // namespace sline::widgets
