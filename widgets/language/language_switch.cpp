// SPDX-License-Identifier: Apache-2.0
#include "widgets/language/language_switch.h"

#include <QCoreApplication>
#include <QLibraryInfo>

#include "widgets/language/languages.h"
#include "widgets/preferences/preferences.h"

// Resources of a static library register themselves only where they are called by name.
static void initialiseTranslations() {
  Q_INIT_RESOURCE(translations);
}

namespace sline::widgets {

void LanguageSwitch::use(const QString& choice) {
  initialiseTranslations();
  const QLocale locale = localeOf(choice, QLocale::system());
  QLocale::setDefault(locale);
  const QString own = QStringLiteral(":/translations/");
  const QString installed = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
  const bool english = locale.language() == QLocale::English || locale.language() == QLocale::C;
  QCoreApplication::removeTranslator(&m_texts);
  QCoreApplication::removeTranslator(&m_qtTexts);
  // English is loaded too, because "%n structures" needs a singular there.
  if (m_texts.load(english ? QLocale(QLocale::English) : locale, QStringLiteral("sline"),
                   QStringLiteral("_"), own))
    QCoreApplication::installTranslator(&m_texts);
  // Qt has no Norwegian translation; the program brings its own.
  if (!english &&
      (m_qtTexts.load(locale, QStringLiteral("qt"), QStringLiteral("_"), own) ||
       m_qtTexts.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), installed)))
    QCoreApplication::installTranslator(&m_qtTexts);
}

void LanguageSwitch::follow(Preferences& preferences) {
  const QString id = QStringLiteral("language/interface");
  connect(&preferences, &Preferences::changed, this,
          [this, id, &preferences](const QString& changed) {
            if (changed == id)
              use(preferences.choice(id));
          });
}

}  // namespace sline::widgets

#include "moc_language_switch.cpp"
