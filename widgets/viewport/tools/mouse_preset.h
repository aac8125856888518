// SPDX-License-Identifier: Apache-2.0
// What the mouse does to the camera, as tables: one for each program whose users come to this one.
#pragma once

#include <QString>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "widgets/viewport/tools/navigation.h"

namespace sline::widgets {

enum class MousePreset { sline, slicer, blender };

/// Dragging with that button and those keys moves the camera so.
struct MouseRow {
  Qt::MouseButton button = Qt::LeftButton;
  Qt::KeyboardModifiers keys;
  CameraDrag::Kind kind = CameraDrag::Kind::orbit;
};
std::span<const MouseRow> presetRows(MousePreset preset);
/// Absent where such a drag does nothing.
std::optional<CameraDrag::Kind> dragOf(MousePreset preset, Qt::MouseButton button,
                                       Qt::KeyboardModifiers keys);

struct MousePresetName {
  MousePreset preset = MousePreset::sline;
  const char* id = "";  ///< in settings
  QString title;
};
/// In the order of the enumeration.
std::vector<MousePresetName> mousePresetNames();
/// The first one for an unknown id.
MousePreset mousePresetNamed(const QString& id);

/// A row of help: what is done with mouse or keys, and what comes of it.
struct ControlRow {
  QString control;
  QString meaning;
};
/// All that mouse, touchpad and the viewport's own keys do.
std::vector<ControlRow> controlRows(MousePreset preset);

}  // namespace sline::widgets
