// SPDX-License-Identifier: Apache-2.0
// What is in focus and how much is drawn around it. It outlives the panel that shows it.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "model/focus/context.h"
#include "widgets/session/session.h"

namespace sline::widgets {

struct FocusState {
  std::shared_ptr<const model::FocusAnalysis> analysis;  ///< null: nothing is in focus
  NodeIds targets;                                       ///< as they were selected
  model::ContextAmount amount = model::ContextAmount::clamped(0.5f);
  model::ContextWishes wishes;
};

/// Each change is one step of the session's history; going back there brings back what was in focus
/// here.
class FocusContext : public QObject {
  Q_OBJECT
 public:
  using CameraOf = std::function<model::Camera()>;
  FocusContext(Session& session, CameraOf camera, QObject* parent = nullptr);
  /// Waits until an analysis under way has noticed.
  ~FocusContext() override;

  const FocusState& state() const { return m_state; }
  /// An analysis is under way.
  bool busy() const { return m_awaited != 0; }

  /// Looks at what surrounds the structures, in the background, and then draws them in detail and
  /// everything else by what it is to them: one step.
  void focusOn(NodeIds targets);
  /// The same for what is in focus: what hides it from where the camera is now, or from all round.
  void lookFrom(bool camera);
  void setRoles(const NodeIds& structures, model::ContextRole role);
  void setHiddenToo(bool too);

  void dragTo(model::ContextAmount amount);
  void finishDrag();
  void cancelDrag();
  /// Without a drag; steps that follow each other closely are one.
  void stepTo(model::ContextAmount amount);

 signals:
  /// What is in focus, its surroundings or the amount.
  void changed();
  void busyChanged(bool busy);
  void failed(const sline::Error& error);

 private:
  struct Record {
    model::Scene scene;
    FocusState state;
  };
  using Answer = std::shared_ptr<const model::FocusAnalysis>;
  void analyse(const NodeIds& targets, bool fromCamera, const QString& step);
  void take(std::uint64_t question, const Answer& answer, const NodeIds& targets,
            const QString& step);
  model::Edited edited(const model::Scene& scene) const;
  void apply(const QString& step, FocusState state, const QString& series = {});
  void remember();
  void documentChange(const Document& before, const Document& now);
  void await(std::uint64_t question);

  Session& m_session;
  CameraOf m_camera;
  FocusState m_state;
  std::vector<Record> m_records;  ///< the scenes that came of it, for undo and redo
  model::ContextAmount m_beforeDrag;
  bool m_dragging = false;
  bool m_applying = false;
  std::shared_ptr<model::FormIndex> m_forms = std::make_shared<model::FormIndex>();
  std::uint64_t m_asked = 0;
  std::uint64_t m_awaited = 0;  ///< 0: none
  std::stop_source m_stop;
  QThreadPool m_pool;
};

}  // namespace sline::widgets
