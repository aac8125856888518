// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "widgets/session/session.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QToolButton;
class QTreeView;

namespace sline::widgets {

class SectionList;

/// Lists all sections, with the details of the active one below.
class SectionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SectionsPanel(Session& session, QWidget* parent = nullptr);
  /// Returns the button that adds sections; the caller, which knows the camera, gives it a menu.
  QToolButton& addButton() { return *m_add; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeList();
  QWidget* makeButtons();
  QWidget* makeDetails();
  const model::Section* active() const;
  void change(const QString& step, const model::Section& section, const QString& series = {});
  void remove();
  void showActive();
  void listScopes(const model::Section& section);
  void scopeChosen(int row);
  void facesChosen(int row);

  Session& m_session;
  SectionList* m_sections;
  QTreeView* m_list = nullptr;
  QToolButton* m_add = nullptr;
  QToolButton* m_flip = nullptr;
  QToolButton* m_remove = nullptr;
  QWidget* m_details = nullptr;
  QDoubleSpinBox* m_position = nullptr;
  QComboBox* m_scope = nullptr;
  QComboBox* m_faces = nullptr;  ///< rows in the order of model::CutFaces
  QCheckBox* m_hatched = nullptr;
  bool m_following = false;  ///< the session changes the controls, not the user
};

}  // namespace sline::widgets
