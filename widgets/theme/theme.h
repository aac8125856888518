// SPDX-License-Identifier: Apache-2.0
// Sets how the controls look: light or dark, the same on every system.
#pragma once

#include <QPalette>

class QApplication;

namespace sline::widgets {

class Preferences;

enum class Theme { light, dark };

QPalette paletteOf(Theme theme);

/// Styles the application as the preference "appearance/theme" says, now and whenever it changes;
/// "as the system" is the application's palette before that.
class ThemeFollower {
 public:
  ThemeFollower(QApplication& application, Preferences& preferences);
  static Theme systemTheme(const QPalette& palette);
};

}  // namespace sline::widgets
