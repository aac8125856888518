// SPDX-License-Identifier: Apache-2.0
#include "widgets/language/languages.h"

#include <algorithm>

namespace sline::widgets {

std::vector<InterfaceLanguage> interfaceLanguages() {
  return {{QStringLiteral("en"), QStringLiteral("English")},
          {QStringLiteral("de"), QStringLiteral("Deutsch")},
          {QStringLiteral("nl"), QStringLiteral("Nederlands")},
          {QStringLiteral("nb"), QStringLiteral("Norsk bokmål")}};
}

QLocale localeOf(const QString& choice, const QLocale& system) {
  const auto ofLanguage = [&system](const QString& id) {
    const QLocale own(id);
    return own.language() == system.language() ? system : own;
  };
  if (choice != QLatin1String("system"))
    return ofLanguage(choice);
  const std::vector<InterfaceLanguage> languages = interfaceLanguages();
  for (const QString& wished : system.uiLanguages())
    for (const InterfaceLanguage& language : languages)
      if (QLocale(wished).language() == QLocale(language.id).language())
        return ofLanguage(language.id);
  return system.language() == QLocale::C ? system : QLocale(QLocale::English);
}

std::optional<model::NameLanguage> namesLanguage(const QString& choice, const QLocale& locale) {
  using model::NameLanguage;
  if (choice == QLatin1String("latin"))
    return NameLanguage::latin;
  if (choice == QLatin1String("en"))
    return NameLanguage::english;
  const bool interface = choice == QLatin1String("interface");
  switch (interface ? locale.language() : QLocale(choice).language()) {
    case QLocale::German:
      return NameLanguage::german;
    case QLocale::Dutch:
      return NameLanguage::dutch;
    case QLocale::NorwegianBokmal:
      return NameLanguage::norwegian;
    default:
      return std::nullopt;
  }
}

}  // namespace sline::widgets
