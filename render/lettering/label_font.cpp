// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/label_font.h"

#include <QFontDatabase>
#include <QStringList>

// Resources of a static library must be requested, outside any namespace.
static void useLabelFont() {
  Q_INIT_RESOURCE(label_font);
}

namespace sline::render {

namespace {

/// Returns the family of all four fonts.
QString labelFamily() {
  useLabelFont();
  QString family;
  for (const char* file : {"labels", "labels-bold", "labels-oblique", "labels-bold-oblique"}) {
    const int id = QFontDatabase::addApplicationFont(
        QStringLiteral(":/fonts/%1.ttf").arg(QLatin1String(file)));
    const QStringList families = QFontDatabase::applicationFontFamilies(id);
    if (family.isEmpty() && !families.isEmpty())
      family = families.front();
  }
  return family;
}

}  // namespace

QFont labelFont(const model::LetterStyle& style) {
  static const QString family = labelFamily();
  QFont font(family);
  font.setBold(style.bold);
  font.setItalic(style.italic);
  font.setPixelSize(labelFontPixels);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setKerning(true);
  // Spaced letters, however little, are never joined: in text that is copied from a page "fi" must
  // not be one letter.
  font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
  return font;
}

}  // namespace sline::render
