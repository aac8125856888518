// SPDX-License-Identifier: Apache-2.0
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>
#include <array>

#include "widgets/preferences/preferences.h"

namespace sline::widgets {

namespace {

struct ColourRow {
  QPalette::ColorRole role;
  QRgb light;
  QRgb dark;
};

// The greys have no tint, so that anatomy's colours look unchanged beside them; one blue marks what
// is selected.
constexpr std::array colourRows{
    ColourRow{QPalette::Window, 0xfff3f3f2, 0xff2b2b2c},
    ColourRow{QPalette::WindowText, 0xff1f1f1f, 0xffe4e4e4},
    ColourRow{QPalette::Base, 0xffffffff, 0xff1f1f20},
    ColourRow{QPalette::AlternateBase, 0xfff7f7f6, 0xff262627},
    ColourRow{QPalette::Text, 0xff1f1f1f, 0xffe4e4e4},
    ColourRow{QPalette::PlaceholderText, 0xff767676, 0xff9a9a9a},
    ColourRow{QPalette::Button, 0xfff3f3f2, 0xff363637},
    ColourRow{QPalette::ButtonText, 0xff1f1f1f, 0xffe4e4e4},
    ColourRow{QPalette::BrightText, 0xffffffff, 0xffffffff},
    ColourRow{QPalette::ToolTipBase, 0xfffffff4, 0xff3c3c3e},
    ColourRow{QPalette::ToolTipText, 0xff1f1f1f, 0xffe4e4e4},
    ColourRow{QPalette::Highlight, 0xff2f6fb3, 0xff3d7cc0},
    ColourRow{QPalette::HighlightedText, 0xffffffff, 0xffffffff},
    ColourRow{QPalette::Link, 0xff1f5fa8, 0xff7db4ec},
    ColourRow{QPalette::LinkVisited, 0xff6a4a9c, 0xffb59be0},
    ColourRow{QPalette::Light, 0xffffffff, 0xff4a4a4b},
    ColourRow{QPalette::Midlight, 0xffeaeae9, 0xff3f3f40},
    ColourRow{QPalette::Mid, 0xffbdbdbb, 0xff232324},
    ColourRow{QPalette::Dark, 0xffa2a2a0, 0xff19191a},
    ColourRow{QPalette::Shadow, 0xff6e6e6c, 0xff0c0c0c},
};

constexpr std::array greyWhenDisabled{QPalette::WindowText, QPalette::Text, QPalette::ButtonText};

/// Outlines what can be ticked once more on a dark background, where Fusion's own outline is darker
/// than the background and cannot be seen.
class VisibleBoxes : public QProxyStyle {
 public:
  VisibleBoxes() : QProxyStyle(QStringLiteral("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool box = element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
    if ((!box && element != PE_IndicatorRadioButton) ||
        ThemeFollower::systemTheme(option->palette) != Theme::dark)
      return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(option->palette.color(QPalette::Disabled, QPalette::WindowText));
    const QRectF outline = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    if (box)
      painter->drawRect(outline);
    else
      painter->drawEllipse(outline);
    painter->restore();
  }
};

void applyTheme(QApplication& application, Theme theme) {
  QApplication::setPalette(paletteOf(theme));
  // Tool tips take their palette from the style, so they need a style sheet.
  application.setStyleSheet(
      QStringLiteral("QToolTip { color: palette(tool-tip-text); background: palette(tool-tip-base);"
                     " border: 1px solid palette(mid); padding: 3px; }"));
}

}  // namespace

QPalette paletteOf(Theme theme) {
  const bool dark = theme == Theme::dark;
  QPalette palette;
  for (const ColourRow& row : colourRows)
    palette.setColor(row.role, QColor(dark ? row.dark : row.light));
  for (const QPalette::ColorRole role : greyWhenDisabled)
    palette.setColor(QPalette::Disabled, role, QColor(dark ? 0xff808080 : 0xff9a9a9a));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(dark ? 0xff4a4a4b : 0xffc8c8c6));
  return palette;
}

Theme ThemeFollower::systemTheme(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() <
                 palette.color(QPalette::WindowText).lightness()
             ? Theme::dark
             : Theme::light;
}

ThemeFollower::ThemeFollower(QApplication& application, Preferences& preferences) {
  const Theme system = systemTheme(QApplication::palette());
  QApplication::setStyle(new VisibleBoxes);
  const auto follow = [&application, &preferences, system] {
    const QString theme = preferences.choice(QStringLiteral("appearance/theme"));
    applyTheme(application, theme == QLatin1String("dark")    ? Theme::dark
                            : theme == QLatin1String("light") ? Theme::light
                                                              : system);
  };
  follow();
  QObject::connect(&preferences, &Preferences::changed, &preferences, [follow](const QString& id) {
    if (id == QLatin1String("appearance/theme"))
      follow();
  });
}

}  // namespace sline::widgets
