// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointer>
#include <QString>

#include "widgets/sections/section_mark.h"
#include "widgets/session/session.h"
#include "widgets/viewport/tools/tool.h"

namespace sline::widgets {

/// Moves, tilts and flips the active section by its handles; each drag is one undo step.
class SectionTool : public QObject, public Tool {
  Q_OBJECT
 public:
  SectionTool(Session& session, const ViewControl& view);
  /// Shows its handles over the picture, beneath all that lies there so far.
  void showOver(QWidget& picture);
  /// Returns the mark that it shows; null where `showOver` was never called.
  const SectionMark* mark() const { return m_mark; }

  /// Returns the active section's handles in a picture of that size; absent where there is none.
  std::optional<SectionHandles> handles(const glm::vec2& size) const {
    return handles(size, m_view.camera());
  }
  /// Returns the active section's handles in a picture that another camera took.
  std::optional<SectionHandles> handles(const glm::vec2& size, const model::Camera& camera) const;
  SectionGrip gripAt(const Pointer& pointer) const;
  bool dragging() const { return m_drag.has_value(); }
  SectionGrip grip() const { return m_grip; }
  /// Returns the result of the drag so far: "L 12.0 mm", "15°"; empty while there is no drag.
  const QString& readout() const { return m_readout; }

  bool press(const Pointer& pointer) override;
  void move(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool grips(const Pointer& pointer) const override;
  std::optional<Qt::CursorShape> cursor(const Pointer& pointer) const override;
  bool movesAtOnce() const override { return true; }
  bool keepsClicks() const override { return true; }
  void show(const ShownPicture& picture) override;
  void setDark(bool dark) override;

 private:
  const model::Section* active() const;
  void finish();

  Session& m_session;
  const ViewControl& m_view;
  std::optional<SectionDrag> m_drag;
  std::optional<model::Section> m_before;
  SectionGrip m_grip = SectionGrip::none;
  glm::vec2 m_pressed{0.0f};
  QString m_readout;
  QPointer<SectionMark> m_mark;
  ShownPicture m_picture;
};

}  // namespace sline::widgets
