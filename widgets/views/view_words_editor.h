// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointer>
#include <QWidget>

#include "model/scene/scene.h"
#include "widgets/preferences/preferences.h"
#include "widgets/session/session.h"
#include "widgets/viewport/viewport.h"

class QDoubleSpinBox;
class QGridLayout;
class QLineEdit;

namespace sline::widgets {

class LabelField;
class ViewCaption;

/// Edits what the chosen view says: its title, a text marked up as callouts are, notes for who
/// presents it and what it shows for who does not see it, in the language in which labels are
/// typed, and how long it is shown. While it is open the picture has title and text as pictures and
/// films will have them.
class ViewWordsEditor : public QWidget {
  Q_OBJECT
 public:
  ViewWordsEditor(Session& session, Viewport& viewport, Preferences& preferences);
  ~ViewWordsEditor() override;
  /// Sets the view that is edited; −1 for none.
  void setView(int index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void makeTitle(QGridLayout& grid);
  LabelField* makeField(const char* name, const QString& says);
  const model::View* view() const;
  /// Says it of the view, in one undo step for what is typed in one go into one field.
  void write(const char* field, const model::ViewWords& words);
  void writeWording(const char* field, model::Wording model::ViewWords::*wording,
                    const QString& text);
  void showWords();
  void preview();

  Session& m_session;
  Viewport& m_viewport;
  Preferences& m_preferences;
  QPointer<ViewCaption> m_caption;  ///< belongs to the viewport
  QLineEdit* m_title = nullptr;
  QDoubleSpinBox* m_seconds = nullptr;
  LabelField* m_text = nullptr;
  LabelField* m_notes = nullptr;
  LabelField* m_description = nullptr;
  int m_index = -1;
  std::string m_language;    ///< in which words are typed; empty for the scene's own
  bool m_following = false;  ///< the session changes the controls, not the user
};

}  // namespace sline::widgets
