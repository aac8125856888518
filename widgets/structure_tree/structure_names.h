// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

namespace sline::widgets {

/// How structures are called where people read and look for them. Either may be empty: then a name
/// is shown as the scene has it, and found under it alone.
struct StructureNames {
  /// What a person reads in place of the scene's name.
  std::function<QString(const QString& name)> shown;
  /// Under what else it is looked for: names in other languages, synonyms.
  std::function<QStringList(const QString& name)> alsoCalled;
};

}  // namespace sline::widgets
