// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <map>
#include <string>

#include "widgets/session/display_names.h"

namespace sline::widgets {

/// Returns what the structure is called in each language, by BCP 47 tag; empty where the table does
/// not know the name.
std::map<std::string, std::string> namesByLanguage(const DisplayNames& names,
                                                   const std::string& name);

/// Returns the BCP 47 tags of the languages that the table has.
QStringList knownLanguages();
/// Returns what languages of labels, as in "de" or "de+la", are called in the interface's language,
/// others in their own. Without a tag it is the scene's own.
QString languageName(const QString& tag);

}  // namespace sline::widgets
