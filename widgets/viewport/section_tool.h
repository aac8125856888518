// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "widgets/session/session.h"
#include "widgets/viewport/section_handles.h"
#include "widgets/viewport/tool.h"

namespace sline::widgets {

/// Moves, tilts and flips the active section by its handles; each drag is one undo step.
class SectionTool : public Tool {
 public:
  SectionTool(Session& session, const ViewControl& view) : m_session(session), m_view(view) {}

  /// The active section's handles in a picture of that size; absent where there is none.
  std::optional<SectionHandles> handles(const glm::vec2& size) const {
    return handles(size, m_view.camera());
  }
  /// The same in a picture that another camera took.
  std::optional<SectionHandles> handles(const glm::vec2& size, const model::Camera& camera) const;
  SectionGrip gripAt(const Pointer& pointer) const;
  bool dragging() const { return m_drag.has_value(); }
  SectionGrip grip() const { return m_grip; }
  /// What the drag has come to: "L 12.0 mm", "15°"; empty while there is none.
  const QString& readout() const { return m_readout; }

  bool press(const Pointer& pointer) override;
  void move(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;

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
};

}  // namespace sline::widgets
