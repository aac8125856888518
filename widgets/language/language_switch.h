// SPDX-License-Identifier: Apache-2.0
// Speaks the language that a person chose: texts, Qt's own texts, and how numbers are written.
#pragma once

#include <QObject>
#include <QTranslator>

namespace sline::widgets {

class Preferences;

class LanguageSwitch : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// From now on; widgets that are there hear of it by QEvent::LanguageChange. `choice` is a value
  /// of the preference "language/interface".
  void use(const QString& choice);
  /// Whenever the preference changes.
  void follow(Preferences& preferences);

 private:
  QTranslator m_texts;
  QTranslator m_qtTexts;
};

}  // namespace sline::widgets
