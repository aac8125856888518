// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/annotations/label_field.h"

namespace sline::widgets {

/// A small field over the picture in which a label's words are typed. Return takes them over, as
/// does whoever goes elsewhere; Esc forgets them.
class LabelEditor : public LabelField {
  Q_OBJECT
 public:
  explicit LabelEditor(QWidget* picture);

  struct Words {
    QString text;        ///< offered, and selected
    bool lines = false;  ///< a callout's: marked up, and Shift+Return begins another one
    float points = 10.0f;
  };
  /// Beside the place, where all of it is in the picture.
  void open(const QPoint& place, const Words& words);
  bool isOpen() const { return isVisible(); }
  /// As if somebody had pressed Return.
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
