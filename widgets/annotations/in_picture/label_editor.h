// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/annotations/label_field.h"

namespace sline::widgets {

/// Holds a small field over the picture in which a label's words are typed. Return, or moving to
/// another control, accepts them; Esc discards them.
class LabelEditor : public LabelField {
  Q_OBJECT
 public:
  explicit LabelEditor(QWidget* picture);

  struct Words {
    QString text;        ///< offered, and selected
    bool lines = false;  ///< for a callout: marked up, and Shift+Return begins a new line
    float points = 10.0f;
    QString language;  ///< in which they are typed, by its name
  };
  /// Opens beside the place, shifted so that all of it lies in the picture.
  void open(const QPoint& place, const Words& words);
  bool isOpen() const { return isVisible(); }
  /// Accepts the words as if Return had been pressed.
  void finish();
  void cancel();

 signals:
  void accepted(const QString& text);
  void cancelled();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void fit();

  QPoint m_place;
  bool m_lines = false;
};

}  // namespace sline::widgets
