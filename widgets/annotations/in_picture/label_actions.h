// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "widgets/preferences/preferences.h"
#include "widgets/session/background_queue.h"
#include "widgets/session/session.h"
#include "widgets/shell/window_actions.h"

class QMainWindow;
class QMenu;

namespace sline::widgets {

class PictureLabels;
class ViewControl;

/// Returns the actions that make labels, one for each kind, and the one that labels the selection.
std::vector<QAction*> labelMakers(const WindowActions& actions);

/// Runs the actions that concern labels in the window and has the picture show labels as the
/// preferences say.
class LabelActions : public QObject {
  Q_OBJECT
 public:
  struct Context {
    QMainWindow& window;
    Session& session;
    QWidget& picture;
    const ViewControl& view;
    PictureLabels& labels;
    Preferences& preferences;
    const WindowActions& actions;
    QMenu& shown;  ///< takes one entry for each way to show labels
  };
  LabelActions(const Context& context, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeTools();
  void follow();
  void showMaking();
  void showState();
  /// Adds the shortest distance where two structures are selected; else returns false.
  bool measureSelected();
  /// Labels each selected structure that has no label, at the point where it is best seen.
  void labelSelected();
  /// Returns what to say when saved views leave out the label that was made last; empty if none
  /// does.
  QString notInAllViews() const;
  /// Says so where the label made last is not in the picture, or points at what is hidden.
  void tellOfMade();
  /// Says how many of the labels that were added together found no room.
  void tellOfAdded();
  void take(const std::vector<model::Annotation>& found, int opening);

  QMainWindow& m_window;
  Session& m_session;
  QWidget& m_picture;
  const ViewControl& m_view;
  PictureLabels& m_labels;
  Preferences& m_preferences;
  const WindowActions& m_actions;
  QString m_hint;                             ///< how to go on with the current tool
  std::optional<model::AnnotationId> m_made;  ///< whose picture is still to come
  /// Labels added together whose picture is still to come, and what is said of them already.
  std::vector<model::AnnotationId> m_added;
  QString m_saidOfAdded;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
