// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

namespace sline::widgets {

/// Gives the names under which structures are shown and found. Either function may be empty: then a
/// name is shown as the scene has it, and found under it alone.
struct StructureNames {
  /// Returns the name that the user reads in place of the scene's name.
  std::function<QString(const QString& name)> shown;
  /// Returns further names by which it is found: names in other languages, synonyms.
  std::function<QStringList(const QString& name)> alsoCalled;
};

}  // namespace sline::widgets
