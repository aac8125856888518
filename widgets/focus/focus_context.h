// SPDX-License-Identifier: Apache-2.0
// Keeps what is in focus and how much is drawn around it; outlives the panel that shows it.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "model/focus/context.h"
#include "model/look/drawing_styles.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Holds the scene's focus (model::Scene::focus) and the analysis that belongs to it.
struct FocusState {
  /// Null where nothing is in focus, and until the analysis of a focus that came with the scene is
  /// there.
  std::shared_ptr<const model::FocusAnalysis> analysis;
  NodeIds targets;  ///< as they were selected
  model::ContextAmount amount = model::ContextAmount::clamped(0.5f);
  model::ContextWishes wishes;
};

/// Changes the focus of the scene and its context, as one step of the session's history each. The
/// focus is part of the scene: undo, a saved view or a scene file bring back what was in focus.
class FocusContext : public QObject {
  Q_OBJECT
 public:
  using CameraOf = std::function<model::Camera()>;
  FocusContext(Session& session, CameraOf camera, QObject* parent = nullptr);
  /// Waits until a running analysis has stopped.
  ~FocusContext() override;

  const FocusState& state() const { return m_state; }
  /// Tells whether an analysis is running.
  bool busy() const { return m_awaited != 0; }

  /// Analyses the surroundings of the structures in the background, then draws the structures in
  /// detail and everything else by its relation to them, as one step.
  void focusOn(NodeIds targets);
  /// Analyses the current focus again: what hides it from where the camera is now, or from all
  /// round.
  void setFromCamera(bool camera);
  void setRoles(const NodeIds& structures, model::ContextRole role);
  void setHiddenToo(bool too);
  /// Gives structures that were set by hand back to the focus: they look as it drew them.
  void giveBack(const NodeIds& structures);

  /// Chooses a look for the whole scene in the background: the subject of that index among
  /// `model::subjectsOf` in focus, seen from where it shows best (METHOD §12). `aspect` is the
  /// picture's width / height.
  void chooseLook(float aspect, std::size_t subject);
  /// Does so for a scene that was just opened, in that drawing style: the step is part of the
  /// opening.
  void openWith(const model::DrawingStyle& style, float aspect);
  /// Returns the index of the subject that was chosen last.
  std::size_t subject() const { return m_subject; }
  /// Works out in the background what plates of the next subjects would look like, for pictures of
  /// that width / height; `subjectOffered` tells each. A later offer or choice replaces it.
  void offerSubjects(float aspect, std::size_t count);

  /// Returns why the structure is drawn as it is, or nothing where the focus has no part in that.
  QString explanation(model::NodeId structure) const;

  void dragTo(model::ContextAmount amount);
  void finishDrag();
  void cancelDrag();
  /// Sets the amount without a drag; steps that follow each other closely are one.
  void stepTo(model::ContextAmount amount);

 signals:
  /// Tells that the focus, its surroundings or the amount has changed.
  void changed();
  void busyChanged(bool busy);
  /// Tells the look that was chosen, which is to be framed.
  void lookChosen(const sline::model::OpeningLook& look);
  /// Tells the look of a plate of the subject with that index.
  void subjectOffered(std::size_t subject,
                      const std::shared_ptr<const sline::model::OpeningLook>& look);
  void failed(const sline::Error& error);

 private:
  using Answer = std::shared_ptr<const model::FocusAnalysis>;
  struct Record {
    int opening = 0;  ///< of the document
    Answer analysis;
  };
  using Look = std::shared_ptr<const model::OpeningLook>;
  struct LookQuestion {
    float aspect = 1.0f;
    std::size_t subject = 0;
    const model::DrawingStyle* opening = nullptr;  ///< null where nothing was just opened
  };
  void askForLook(const LookQuestion& asked);
  /// Returns the document's scene with its structures' own colours.
  model::Scene undrawn() const;
  void takeLook(std::uint64_t question, const Look& look, const model::Scene& asked, bool opening);
  /// Stops what was asked before.
  std::stop_token freshQuestion();
  /// Runs work on a thread that stands back behind the window's.
  void inBackground(std::function<void()> work);
  void analyse(const NodeIds& targets, bool fromCamera, const QString& step);
  void take(std::uint64_t question, const Answer& answer, const NodeIds& targets,
            const QString& step);
  model::Edited edited(const model::Scene& scene) const;
  /// `freed` are structures that no longer stay as they were set by hand.
  void apply(const QString& step, FocusState state, const QString& series = {},
             const NodeIds& freed = {});
  void remember(const Answer& analysis);
  /// Takes the focus from the document; asks for its analysis where none is remembered.
  void follow(const Document& now);
  void analyseAgain();
  void documentChange(const Document& before, const Document& now);
  void await(std::uint64_t question);

  Session& m_session;
  CameraOf m_camera;
  FocusState m_state;
  std::vector<Record> m_records;  ///< for undo, redo and views
  model::ContextAmount m_beforeDrag;
  std::size_t m_subject = 0;
  bool m_dragging = false;
  bool m_applying = false;
  std::shared_ptr<model::FormIndex> m_forms = std::make_shared<model::FormIndex>();
  std::uint64_t m_asked = 0;
  std::uint64_t m_awaited = 0;  ///< 0 for none
  std::stop_source m_stop;
  std::stop_source m_offerStop;
  QThreadPool m_pool;
};

}  // namespace sline::widgets
