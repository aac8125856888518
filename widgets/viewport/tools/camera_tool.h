// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "widgets/viewport/tools/mouse_preset.h"
#include "widgets/viewport/tools/tool.h"

namespace sline::widgets {

/// Moves the camera as the mouse preset says.
class CameraTool : public Tool {
 public:
  explicit CameraTool(ViewControl& view) : m_view(view) {}
  MousePreset preset() const { return m_preset; }
  void setPreset(MousePreset preset) { m_preset = preset; }

  bool press(const Pointer& pointer) override;
  void move(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;

 private:
  ViewControl& m_view;
  MousePreset m_preset = MousePreset::sline;
  std::optional<model::CameraDrag> m_drag;
  model::Camera m_before;
};

}  // namespace sline::widgets
