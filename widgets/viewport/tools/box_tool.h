// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QRect>
#include <QRubberBand>
#include <functional>
#include <memory>

#include "widgets/viewport/tools/camera_tool.h"

namespace sline::widgets {

/// Drags a box over the picture. It takes the mouse where the camera's preset leaves a drag of the
/// left button free, alone or with Ctrl, and for one drag of any kind after `arm`.
class BoxTool : public Tool {
 public:
  struct Box {
    QRect area;             ///< pixels
    bool touching = false;  ///< drawn towards the left: what it touches counts, not what it holds
    bool adding = false;    ///< Ctrl or Shift was down
  };
  using Drawn = std::function<void(const Box&)>;
  BoxTool(QWidget& picture, const CameraTool& camera, Drawn drawn);

  /// Makes the next press of the left button begin a box, or no longer.
  void arm(bool armed) { m_armed = armed; }
  bool armed() const { return m_armed; }

  bool press(const Pointer& pointer) override;
  void move(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  std::optional<Qt::CursorShape> cursor(const Pointer& pointer) const override;

 private:
  QRect area(const Pointer& pointer) const;

  QWidget& m_picture;
  const CameraTool& m_camera;
  Drawn m_drawn;
  std::unique_ptr<QRubberBand> m_band;
  bool m_armed = false;
  glm::vec2 m_from{0.0f};
};

}  // namespace sline::widgets
