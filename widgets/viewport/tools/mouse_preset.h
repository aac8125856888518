// SPDX-License-Identifier: Apache-2.0
// Lists how the mouse moves the camera, as tables: one for each program from which users come to
// this one.
#pragma once

#include <QString>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/camera/camera_moves.h"

namespace sline::widgets {

enum class MousePreset { sline, slicer, blender };

/// Maps a button and keys to the way in which dragging with them moves the camera.
struct MouseRow {
  Qt::MouseButton button = Qt::LeftButton;
  Qt::KeyboardModifiers keys;
  model::CameraDrag::Kind kind = model::CameraDrag::Kind::orbit;
};
std::span<const MouseRow> presetRows(MousePreset preset);
/// Returns the kind of drag; absent where such a drag does nothing.
std::optional<model::CameraDrag::Kind> dragOf(MousePreset preset, Qt::MouseButton button,
                                              Qt::KeyboardModifiers keys);

struct MousePresetName {
  MousePreset preset = MousePreset::sline;
  const char* id = "";  ///< in settings
  QString title;
};
/// Returns the presets in the order of the enumeration.
std::vector<MousePresetName> mousePresetNames();
/// Returns the preset of that id; the first one for an unknown id.
MousePreset mousePresetNamed(const QString& id);

/// A row of help: what the user does with mouse or keys, and its effect.
struct ControlRow {
  QString control;
  QString meaning;
};
/// Returns all that mouse, touchpad and the viewport's own keys do.
std::vector<ControlRow> controlRows(MousePreset preset);

}  // namespace sline::widgets
