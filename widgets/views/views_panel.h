// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/preferences/preferences.h"
#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

class QAction;
class QHBoxLayout;
class QToolButton;

namespace sline::widgets {

class ViewList;
class ViewPictures;
class ViewRow;
class ViewTour;
class ViewWordsEditor;

/// Shows the saved views as a row of cards, with buttons for what can be done with them and, below
/// where that is wanted, what the chosen view says.
class ViewsPanel : public QWidget {
  Q_OBJECT
 public:
  /// Makes the panel; `addButtons` gets the window's actions later.
  ViewsPanel(Session& session, Viewport& viewport, ViewTour& tour, Preferences& preferences);
  /// Gives the window's actions a button each, with the other buttons between them.
  void addButtons(QAction& add, QAction& present);

  ViewRow& row() { return *m_row; }
  const ViewPictures& pictures() const { return *m_pictures; }
  /// Returns the chosen view's index, or −1 where none is chosen.
  int current() const;
  void choose(int index);
  /// Unfolds the fields for what the chosen view says, or folds them away.
  void showWords(bool shown);

 signals:
  void wordsShown(bool shown);

 private:
  QToolButton* button(const QString& text, const char* name, const char* icon, const QString& tip);
  void wantPictures();
  void showState();

  Session& m_session;
  ViewTour& m_tour;
  QHBoxLayout* m_cards;  ///< the cards and the buttons beside them
  ViewList* m_list;
  ViewRow* m_row;
  ViewPictures* m_pictures;
  ViewWordsEditor* m_words;
  QToolButton* m_wordsButton = nullptr;
  QToolButton* m_update = nullptr;
  QToolButton* m_remove = nullptr;
};

}  // namespace sline::widgets
