// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

class QAction;
class QToolButton;

namespace sline::widgets {

class ViewList;
class ViewPictures;
class ViewRow;
class ViewTour;

/// The saved views as a row of cards, and what can be done with them.
class ViewsPanel : public QWidget {
  Q_OBJECT
 public:
  /// `add` and `present` are the window's actions.
  ViewsPanel(Session& session, Viewport& viewport, ViewTour& tour, QWidget* parent = nullptr);
  /// The window's actions get a button each, the others stand between them.
  void addButtons(QAction& add, QAction& present);

  ViewRow& row() { return *m_row; }
  const ViewPictures& pictures() const { return *m_pictures; }
  /// −1 where none is chosen.
  int current() const;
  void choose(int index);

 private:
  QToolButton* button(const QString& text, const char* name, const char* icon, const QString& tip);
  void wantPictures();
  void showState();

  Session& m_session;
  ViewTour& m_tour;
  ViewList* m_list;
  ViewRow* m_row;
  ViewPictures* m_pictures;
  QToolButton* m_update = nullptr;
  QToolButton* m_remove = nullptr;
};

}  // namespace sline::widgets
