// SPDX-License-Identifier: Apache-2.0
// Lists the languages of the interface, and tells what follows from the choice of one.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

#include "model/anatomy/laterality_words.h"

namespace sline::widgets {

/// A language of the interface; English needs no translation, because the texts are written in it.
struct InterfaceLanguage {
  QString id;    ///< "de": the preference's value and the translation's file
  QString name;  ///< "Deutsch": never translated, so that its speakers find it
};
std::vector<InterfaceLanguage> interfaceLanguages();

/// Returns the locale that decides how numbers are written and which texts are used: the system's
/// locale where it is of the chosen language (Swiss numbers stay Swiss), else the language's own.
/// "system" is the first of the user's preferred languages there that the interface has, else
/// English.
QLocale localeOf(const QString& choice, const QLocale& system);

/// Returns the language that the preference "language/structures" asks for; none for names as in
/// the file. "interface" under an English interface is none, too: most files are in English
/// already, in words that their makers chose.
std::optional<model::NameLanguage> namesLanguage(const QString& choice, const QLocale& locale);

}  // namespace sline::widgets
