// SPDX-License-Identifier: Apache-2.0
#include "widgets/help/help_pages.h"

#include <QFile>
#include <QVariant>
#include <QWidget>
#include <algorithm>

// Resources of a static library register themselves only where they are called by name.
static void initialiseHelp() {
  Q_INIT_RESOURCE(help);
}

namespace sline::widgets {

namespace {

/// Maps an objectName to its page.
struct WidgetPage {
  const char* widget;
  const char* page;
};
constexpr WidgetPage places[] = {
    {"structuresPanel", "tree"},       {"propertiesDialog", "tree"},     {"gammaPanel", "gamma"},
    {"savePresetDialog", "gamma"},     {"managePresetsDialog", "gamma"}, {"focusPanel", "focus"},
    {"sectionsPanel", "sections"},     {"viewport", "picture"},          {"startPage", "start"},
    {"historyPanel", "start"},         {"recoveryDialog", "files"},      {"saveDialog", "files"},
    {"importDialog", "import"},        {"controlsDialog", "keys"},       {"viewsPanel", "views"},
    {"annotationsPanel", "labels"},    {"pocketsPanel", "molecules"},    {"labelText", "labels"},
    {"exportDialog", "export_dialog"}, {"figureDialog", "figures"},
};

QString read(const QString& path) {
  initialiseHelp();
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

std::vector<QString> helpPageIds() {
  std::vector<QString> ids;
  for (const char* id :
       {"start",      "tree",       "gamma",         "focus",    "sections",      "picture",
        "labels",     "views",      "export_dialog", "export",   "sheets",        "figures",
        "films",      "files",      "import",        "keys",     "label_volumes", "scans",
        "dicom",      "slicer",     "molecules",     "annotate", "command_line",  "vectors",
        "scene_file", "performance"})
    ids.push_back(QLatin1String(id));
  return ids;
}

QString helpText(const QString& id, const QLocale& locale) {
  const std::vector<QString> ids = helpPageIds();
  if (std::find(ids.begin(), ids.end(), id) == ids.end())
    return {};
  const QString language = QLocale(locale.language()).name().section(QLatin1Char('_'), 0, 0);
  const QString own = read(QStringLiteral(":/help/%1.%2.md").arg(id, language));
  return own.isEmpty() ? read(QStringLiteral(":/help/%1.md").arg(id)) : own;
}

QString helpTitle(const QString& id, const QLocale& locale) {
  const QString text = helpText(id, locale);
  return text.section(QLatin1Char('\n'), 0, 0)
      .remove(QStringLiteral("# "))
      .remove(QLatin1Char('`'))
      .trimmed();
}

std::vector<QString> helpPagesWith(const QString& words, const QLocale& locale) {
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  std::vector<QString> found;
  for (const QString& id : helpPageIds()) {
    const QString text = helpText(id, locale);
    if (std::all_of(wanted.begin(), wanted.end(), [&text](const QString& word) {
          return text.contains(word, Qt::CaseInsensitive);
        }))
      found.push_back(id);
  }
  return found;
}

QString helpPageOf(const QWidget* widget) {
  for (; widget; widget = widget->parentWidget()) {
    const QString said = widget->property(helpPageProperty).toString();
    if (!said.isEmpty())
      return said;
    for (const WidgetPage& place : places)
      if (widget->objectName() == QLatin1String(place.widget))
        return QLatin1String(place.page);
  }
  return helpPageIds().front();
}

}  // namespace sline::widgets
