// SPDX-License-Identifier: Apache-2.0
// Says at a field why it does not take what was typed there.
#pragma once

#include <QObject>

class QLineEdit;
class QWidget;

namespace sline::widgets {

/// Shows a sentence at the field for some seconds.
void sayAt(QWidget& field, const QString& sentence);

/// Says how long a text can be where a line refuses what is typed, pasted or dropped because it is
/// full: the line itself does so without a word. Holds for all lines that are made after it.
class LongestText : public QObject {
  Q_OBJECT
 public:
  explicit LongestText(QObject* parent);

  /// Says it at a field that holds so many characters.
  static void say(QWidget& field, int longest);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace sline::widgets
