// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPlainTextEdit>

#include "model/edit/letter_style.h"

class QLabel;

namespace sline::widgets {

/// Holds a field in which a label's words are typed: always plain text, whatever is pasted. Where
/// the words are marked up, as a callout's are, Ctrl+B and Ctrl+I put markers around the selection
/// or take them away, in one step of the field's undo.
class LabelField : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit LabelField(QWidget* parent = nullptr);

  /// Shows at the right edge which language the words are in; without a name nothing is there.
  void setLanguage(const QString& name);
  /// Returns how many pixels that takes of the width.
  int languageWidth() const;

  /// Sets what is shown where nothing is typed. QPlainTextEdit::setPlaceholderText does not paint
  /// one that replaces another.
  void setHint(const QString& hint);
  void setMarkup(bool on) { m_markup = on; }
  /// Returns one line about the markup that can be typed.
  static QString markupHint();
  /// Says how links are written.
  static QString linkHint();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool canInsertFromMimeData(const QMimeData* source) const override;
  void insertFromMimeData(const QMimeData* source) override;

 private:
  void placeLanguage();
  std::optional<model::LetterMark> markOf(QKeyEvent& key) const;
  void mark(model::LetterMark mark);

  QLabel* m_language;
  bool m_markup = false;
};

}  // namespace sline::widgets
