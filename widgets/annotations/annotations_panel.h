// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/annotations/label_sights.h"
#include "widgets/preferences/preferences.h"
#include "widgets/session/session.h"

class QAction;
class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;
class QTreeView;

namespace sline::widgets {

class AnnotationList;
class LabelField;
class LabelViews;

/// Lists all annotations, with the details of the active one below and, above, how labels are shown
/// in the window, which is a preference.
class AnnotationsPanel : public QWidget {
  Q_OBJECT
 public:
  AnnotationsPanel(Session& session, Preferences& preferences, QWidget* parent = nullptr);
  /// Adds buttons for the actions that make labels, before the button that deletes them.
  void addButtons(const std::vector<QAction*>& actions);
  /// Says which labels the picture lacks, and why: in the list and of the active one below it.
  void setSights(LabelSightsById sights);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeButtons();
  QWidget* makePreferencesRow();
  void makeList();
  void makeSight();
  QWidget* makeDetails();
  void makeText();
  void makeChoices();
  int heightOf(int lines) const;  ///< of the field for words
  const model::Annotation* active() const;
  /// Returns the selected annotations, or the active one where no row is selected.
  std::vector<model::AnnotationId> chosen() const;
  void change(const QString& step, const model::Annotation& annotation, const QString& series = {});
  void remove();
  void write();
  void kindChosen(int row);
  void chooseColour();
  void setColour(const QString& step, std::optional<Colour> colour);
  void followPreferences();
  void showActive();
  void showChoices(const model::Annotation& annotation);
  void showSight();

  Session& m_session;
  Preferences& m_preferences;
  AnnotationList* m_annotations;
  QHBoxLayout* m_buttons = nullptr;
  QToolButton* m_remove = nullptr;
  QTreeView* m_list = nullptr;
  QLabel* m_sight = nullptr;  ///< what the picture says about the active label
  QWidget* m_details = nullptr;
  LabelField* m_text = nullptr;
  QComboBox* m_kind = nullptr;
  QToolButton* m_colour = nullptr;
  LabelViews* m_views = nullptr;
  QCheckBox* m_locked = nullptr;
  QToolButton* m_release = nullptr;
  bool m_following = false;  ///< the session changes the controls, not the user
};

}  // namespace sline::widgets
