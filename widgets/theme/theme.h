// SPDX-License-Identifier: Apache-2.0
// How the controls look: light or dark, the same on every system.
#pragma once

#include <QPalette>

class QApplication;

namespace sline::widgets {

class Preferences;

enum class Theme { light, dark };

QPalette paletteOf(Theme theme);

/// Dresses the application as the preference "appearance/theme" says, now and whenever it changes;
/// "as the system" is what the application's palette was before.
class ThemeFollower {
 public:
  ThemeFollower(QApplication& application, Preferences& preferences);
  static Theme systemTheme(const QPalette& palette);
};

}  // namespace sline::widgets
