// SPDX-License-Identifier: Apache-2.0
// Edits one number or colour of the selection in each row of the panel, with a button that returns
// to what the group above says.
#pragma once

#include <QWidget>

#include "widgets/gamma/look_drag.h"
#include "widgets/gamma/style_rows.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace sline::widgets {

class RangeBox;
class StyleSlider;

/// A row with a label and a button that resets its value, enabled where any item has a value of its
/// own.
class StyleEditor : public QWidget {
  Q_OBJECT
 public:
  StyleEditor(Session& session, const QString& id, const QString& text, QWidget* parent);
  virtual void showSelection() = 0;

 protected:
  Session& session() const { return m_session; }
  const QString& text() const { return m_text; }
  QLabel& label() const { return *m_label; }
  QToolButton& resetButton() const { return *m_reset; }
  /// Applies the look in one undo step, merged with the one before if that is of the same kind.
  void apply(const model::Style& look);
  /// Applies what was made of the scene by the same rule.
  void apply(model::Edited edited);
  /// Makes the fields that `which` sets inherit from above again.
  void inherit(const model::Style& which);

 private:
  Session& m_session;
  QString m_id;
  QString m_text;
  QLabel* m_label;
  QToolButton* m_reset;
};

class StyleNumberEditor : public StyleEditor {
  Q_OBJECT
 public:
  StyleNumberEditor(Session& session, StyleNumber row, QWidget* parent = nullptr);
  void showSelection() override;

 private:
  void connectValues();
  float styled(double shown) const { return float(shown / m_row.shown); }

  StyleNumber m_row;
  LookDrag m_drag;
  StyleSlider* m_slider;
  RangeBox* m_number;
};

class StyleChoiceEditor : public StyleEditor {
  Q_OBJECT
 public:
  StyleChoiceEditor(Session& session, StyleChoice row, QWidget* parent = nullptr);
  void showSelection() override;

 private:
  StyleChoice m_row;
  QComboBox* m_values;
};

class StyleColourEditor : public StyleEditor {
  Q_OBJECT
 public:
  StyleColourEditor(Session& session, StyleColour row, QWidget* parent = nullptr);
  void showSelection() override;

 private:
  void choose();

  StyleColour m_row;
  QToolButton* m_swatch;
};

}  // namespace sline::widgets
