// SPDX-License-Identifier: Apache-2.0
// The languages of the interface, and what follows from the choice of one.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

#include "model/anatomy/laterality_words.h"

namespace sline::widgets {

/// English needs no translation: it is what the texts are written in.
struct InterfaceLanguage {
  QString id;    ///< "de": the preference's value and the translation's file
  QString name;  ///< "Deutsch": never translated, so that its speakers find it
};
std::vector<InterfaceLanguage> interfaceLanguages();

/// How numbers are written and which texts are taken: the system's locale where it is of the chosen
/// language (Swiss numbers stay Swiss), else the language's own. "system" is the first of the
/// languages a person prefers there that the interface has, else English.
QLocale localeOf(const QString& choice, const QLocale& system);

/// What the preference "language/structures" asks for; nothing: names as in the file. "interface"
/// under an English interface is nothing, too: most files are in English already, in words that
/// their makers chose.
std::optional<model::NameLanguage> namesLanguage(const QString& choice, const QLocale& locale);

}  // namespace sline::widgets
