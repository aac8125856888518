// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "widgets/preferences/preferences.h"

namespace sline::widgets {

namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Preferences", text);
}

std::vector<PreferenceRow> appearanceRows() {
  const QString page = tr("Appearance");
  return {{QStringLiteral("appearance/theme"), page, tr("Theme"),
           tr("Light or dark controls; the picture has a background of its own"),
           ChoiceOf{{{QStringLiteral("system"), tr("As the system")},
                     {QStringLiteral("light"), tr("Light")},
                     {QStringLiteral("dark"), tr("Dark")}},
                    QStringLiteral("system")}},
          {QStringLiteral("appearance/toolTexts"), page, tr("Text under the toolbar’s icons"),
           tr("What each button does in a word"), Switch{false}}};
}

std::vector<PreferenceRow> pictureRows() {
  const QString page = tr("Picture");
  return {{QStringLiteral("picture/background"), page, tr("Background"),
           tr("What the picture is drawn on; on the dark one ink is light"),
           ChoiceOf{{{QStringLiteral("white"), tr("White")},
                     {QStringLiteral("paper"), tr("Paper")},
                     {QStringLiteral("dark"), tr("Dark")}},
                    QStringLiteral("paper")}}};
}

}  // namespace

std::vector<PreferenceRow> preferenceRows() {
  std::vector<PreferenceRow> rows = appearanceRows();
  for (const std::vector<PreferenceRow>& more : {pictureRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace sline::widgets
