// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// Goes to saved views, and makes them from what is seen; each change of the scene is one undo
/// step.
///
/// Going to a view makes the scene look as the view says: tree and sliders always tell the truth
/// about the picture, and a user who goes on from there edits what is seen, as after "restore scene
/// view" in 3D Slicer. It is an undo step, because the looks that the scene had are the user's work
/// and might be saved in no view. The camera moves along but is no part of the step: turning the
/// scene is no edit anywhere in the program. Where a view changes no looks there is no step. A
/// presentation is for looking at alone, as that of slides is: it leaves the scene as it is
/// (`Presentation`).
class ViewTour : public QObject {
  Q_OBJECT
 public:
  ViewTour(Session& session, Viewport& viewport, QObject* parent = nullptr);

  int count() const { return int(m_session.scene().views().size()); }
  /// Goes to the view, with a transition if flights are wanted.
  void goTo(int index);
  /// Saves what is seen as the last view, by a name of its own ("View 3").
  void add();
  /// Replaces what the view shows by what is seen now.
  void update(int index);
  void remove(int index);
  void rename(int index, const QString& name);
  /// Moves the view so that it stands at `to` afterwards.
  void move(int index, int to);

 signals:
  /// Tells that the view was gone to, or made.
  void arrived(int index);

 private:
  const model::View* at(int index) const;

  Session& m_session;
  Viewport& m_viewport;
};

}  // namespace sline::widgets
