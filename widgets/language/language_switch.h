// SPDX-License-Identifier: Apache-2.0
// Applies the language that the user chose: the texts, Qt's own texts, and how numbers are written.
#pragma once

#include <QObject>
#include <QTranslator>

namespace sline::widgets {

class Preferences;

class LanguageSwitch : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Applies the language from now on; existing widgets are told by QEvent::LanguageChange.
  /// `choice` is a value of the preference "language/interface".
  void use(const QString& choice);
  /// Applies the language whenever the preference changes.
  void follow(Preferences& preferences);

 private:
  QTranslator m_texts;
  QTranslator m_qtTexts;
};

}  // namespace sline::widgets
