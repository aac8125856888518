// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "widgets/annotations/in_picture/label_layer.h"
#include "widgets/session/session.h"
#include "widgets/viewport/tools/tool.h"

namespace sline::widgets {

/// Moves labels: their texts anywhere, the places that they point at over surfaces; each drag is
/// one undo step. A press on a label makes it the active one; locked labels stay where they are.
class LabelTool : public QObject, public Tool {
  Q_OBJECT
 public:
  using Answer = std::function<void(const std::vector<model::Anchor>&)>;
  /// Looks up the anchors of a label on what is seen at a pixel, of which the last is the place
  /// itself; none where nothing is. The answer comes later.
  using Surface = std::function<void(const glm::vec2& pixel, const Answer& answer)>;
  LabelTool(Session& session, const LabelLayer& layer, Surface surface, QObject* parent);

  bool dragging() const { return m_grip.has_value(); }
  std::optional<LabelGrip> gripAt(const glm::vec2& pixel) const;

  bool press(const Pointer& pointer) override;
  void move(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool keepsClicks() const override { return true; }

 private:
  const model::Annotation* before() const;
  void moveText(const Pointer& pointer);
  void movePlace(const Pointer& pointer);
  void show(const model::Annotation& annotation);
  void commit();

  Session& m_session;
  const LabelLayer& m_layer;
  Surface m_surface;
  std::optional<LabelGrip> m_grip;
  glm::vec2 m_pressed{0.0f};
  glm::vec2 m_offset{0.0f};  ///< of the text when the drag began, in heights of the picture
  int m_asked = 0;
  int m_answered = 0;
  bool m_ending = false;  ///< the drag ends when the pending answer arrives
};

}  // namespace sline::widgets
