// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointer>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/brush/brush_mark.h"
#include "widgets/brush/brush_stroke.h"
#include "widgets/session/session.h"
#include "widgets/viewport/tools/tool.h"

namespace sline::widgets {

/// Paints on the selected structures while it is active: the left button paints, with Ctrl it
/// erases; each stroke is one undo step, which Escape takes back. A drag that begins beside them
/// turns nothing: it paints once it comes to one of them. A click there selects another structure.
class BrushTool : public QObject, public Tool {
  Q_OBJECT
 public:
  BrushTool(Session& session, const ViewControl& view);
  /// Shows the brush over the picture, above what lies there so far.
  void showOver(QWidget& picture);
  const BrushMark* mark() const { return m_mark; }

  bool active() const { return m_active; }
  void setActive(bool active);
  const Brush& brush() const { return m_brush; }
  void setBrush(const Brush& brush);
  /// Returns the structures that can be painted on: those selected that are shown and not locked,
  /// or the scene's only one.
  NodeIds targets() const;
  /// Returns how many millimetres one pixel shows where the brush is; 0 beside the targets.
  float millimetresPerPixel() const { return m_millimetres; }
  bool painting() const { return m_stroke.has_value() || m_awaited.has_value(); }
  /// Tells whether a stroke that begins where the brush has come to hover has nothing left to
  /// prepare.
  bool lookedAhead() const { return m_sights.arrived(); }

  bool press(const Pointer& pointer) override;
  void move(const Pointer& pointer) override;
  void passes(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void cancel() override;
  bool grips(const Pointer& pointer) const override;
  std::optional<Qt::CursorShape> cursor(const Pointer& pointer) const override;
  bool movesAtOnce() const override { return true; }
  bool keepsClicks() const override { return painting(); }
  void show(const ShownPicture& picture) override;
  void setDark(bool dark) override;

 signals:
  void activeChanged(bool active);
  void brushChanged();

 private:
  using Grounds = std::map<model::MeshPtr, BrushGroundPtr>;
  struct Place {
    model::NodeId id;
    float distance = 0.0f;
  };
  /// A press that is to paint.
  struct Press {
    glm::vec2 pixel{0.0f};
    glm::vec2 size{1.0f};
    bool erases = false;
  };
  /// Makes the targets' surfaces ready, in the background.
  void prepare();
  /// Tells whether they are; `wait`: waits until they are.
  bool ready(bool wait) const;
  /// Returns the target under the pixel; where the surfaces are not ready, any in whose box it is.
  std::optional<Place> targetAt(const glm::vec2& pixel, const glm::vec2& size) const;
  /// Returns from where one looks at a target whose surface is ready.
  BrushSight::From sightOf(model::NodeId id, const glm::vec2& size) const;
  /// Begins the stroke where the press met a target, or waits until that is known.
  bool start(const Press& press);
  bool begin(const Press& press);
  /// Paints as far as the mouse has come.
  void follow();
  void finish();
  QString stepName() const;

  Session& m_session;
  const ViewControl& m_view;
  Brush m_brush;
  bool m_active = false;
  std::shared_future<Grounds> m_grounds;
  std::set<model::MeshPtr> m_prepared;  ///< the meshes of the grounds
  SightAhead m_sights;
  model::Camera m_shownFrom;  ///< the picture under the mouse

  std::optional<Press> m_beside;   ///< met no target so far
  std::optional<Press> m_awaited;  ///< of which the surfaces are not ready yet
  std::optional<BrushStroke> m_stroke;
  model::NodeId m_target;
  bool m_erases = false;
  std::vector<glm::vec2> m_path;  ///< where the mouse has passed and not painted yet
  glm::vec2 m_last{0.0f};         ///< to where it has painted
  float m_millimetres = 0.0f;
  QPointer<BrushMark> m_mark;
  ShownPicture m_picture;
};

}  // namespace sline::widgets
