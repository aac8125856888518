// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/names_by_language.h"

#include <QLocale>
#include <algorithm>
#include <array>

#include "widgets/text/tr.h"

namespace sline::widgets {

std::map<std::string, std::string> namesByLanguage(const DisplayNames& names,
                                                   const std::string& name) {
  std::map<std::string, std::string> all;
  if (names.knows(name))
    for (const QString& tag : knownLanguages())
      all[tag.toStdString()] = names.calledIn(name, tag.toStdString()).toStdString();
  return all;
}

QStringList knownLanguages() {
  return {QStringLiteral("en"), QStringLiteral("la"), QStringLiteral("de"), QStringLiteral("nl"),
          QStringLiteral("nb")};
}

QString languageName(const QString& tag) {
  if (tag.isEmpty())
    return tr("The scene's own");
  QStringList names;
  for (const QString& one : tag.split(QLatin1Char('+'))) {
    const std::array<std::pair<const char*, QString>, 5> known{{{"en", tr("English")},
                                                                {"de", tr("German")},
                                                                {"la", tr("Latin")},
                                                                {"nl", tr("Dutch")},
                                                                {"nb", tr("Norwegian")}}};
    const auto found = std::find_if(known.begin(), known.end(), [&one](const auto& language) {
      return one == QLatin1String(language.first);
    });
    const QString own = QLocale(one).nativeLanguageName();
    names << (found != known.end()                                      ? found->second
              : QLocale(one).language() != QLocale::C && !own.isEmpty() ? own
                                                                        : one);
  }
  return names.join(QStringLiteral(" / "));
}

}  // namespace sline::widgets
