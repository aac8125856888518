// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <QThreadPool>
#include <functional>
#include <optional>
#include <set>

#include "model/focus/nearness.h"
#include "widgets/focus/near_mark.h"
#include "widgets/session/session.h"
#include "widgets/viewport/tools/tool.h"

namespace sline::widgets {

/// Focuses by nearness: Γ of everything falls off with the distance from the selected structures or
/// from a place. The place is set by a click and dragged over what is seen, with Shift along the
/// line of sight; the picture follows, and each drag is one undo step.
class NearTool : public QObject, public Tool {
  Q_OBJECT
 public:
  NearTool(Session& session, const ViewControl& view);
  ~NearTool() override;
  void showOver(QWidget& picture);
  const NearMark* mark() const { return m_mark; }

  /// Makes everything near to the structures, as one step, once what lies before them is known.
  void focusOn(const NodeIds& targets);
  /// Makes the next press of the left button set the place, or no longer.
  void setPlacing(bool placing);
  bool placing() const { return m_placing; }
  /// Returns from where on there are silhouettes: in the scene, else what was set last.
  float falloffMm() const;
  /// Changes it, during a drag of a slider; `finishFalloff` ends the drag with one step.
  void dragFalloff(float millimetres);
  void finishFalloff();
  bool busy() const { return static_cast<bool>(m_then); }
  bool dragging() const { return m_drag.has_value(); }

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

 signals:
  void placingChanged(bool placing);

 protected:
  /// Escape leaves placing.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Drag {
    glm::vec2 pixel{0.0f};  ///< where the mouse is
    glm::vec2 size{1.0f};
    bool inDepth = false;
    glm::vec2 from{0.0f};   ///< where it was when it began to go in depth
    glm::vec3 base{0.0f};   ///< the place then
    bool released = false;  ///< before the surfaces were ready
  };
  /// Calls `then` when rays against all that is shown are quick; only the last one asked for.
  void whenReady(std::function<void()> then);
  bool near(const glm::vec2& pixel, const glm::vec2& size) const;
  /// Returns the place that one means by pointing there.
  glm::vec3 placeAt(const glm::vec2& pixel, const glm::vec2& size);
  void follow();
  void finish();
  model::Edited edited(const model::Scene& scene, const model::NearFocus& focus);

  Session& m_session;
  const ViewControl& m_view;
  bool m_placing = false;
  std::optional<float> m_falloffMm;  ///< as set last; absent: what suits the scene
  std::optional<Drag> m_drag;
  glm::vec3 m_place{0.0f};  ///< of the drag
  model::MeshTrees m_trees;
  std::set<model::MeshPtr> m_ready;
  std::function<void()> m_then;
  QPointer<NearMark> m_mark;
  ShownPicture m_picture;
  QThreadPool m_pool;
};

}  // namespace sline::widgets
