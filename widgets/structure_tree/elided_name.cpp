// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/elided_name.h"

#include <algorithm>
#include <set>

namespace sline::widgets {

namespace {

constexpr QChar leftOut = u'…';

/// Returns where the word begins in which the names differ first; 0 where that is the first one.
qsizetype differingWord(const QString& a, const QString& b) {
  qsizetype at = 0;
  while (at < std::min(a.size(), b.size()) && a[at] == b[at])
    ++at;
  at = std::min(at, a.size() - 1);
  while (at > 0 && a[at - 1].isLetterOrNumber())
    --at;
  return at;
}

}  // namespace

bool mayStandFor(const QString& shortened, const QString& name) {
  const QStringList parts = shortened.split(leftOut);
  if (parts.size() == 1)
    return shortened == name;
  if (!name.startsWith(parts.front()))
    return false;
  qsizetype at = parts.front().size();
  for (qsizetype i = 1; i + 1 < parts.size(); ++i) {
    const qsizetype found = name.indexOf(parts[i], at);
    if (found < 0)
      return false;
    at = found + parts[i].size();
  }
  return name.size() - at >= parts.back().size() && name.endsWith(parts.back());
}

QString elidedName(const QString& name, const QStringList& others, const QFontMetrics& metrics,
                   int width) {
  if (metrics.horizontalAdvance(name) <= width)
    return name;
  const auto tells = [&](const QString& shortened) {
    return std::none_of(others.begin(), others.end(), [&](const QString& other) {
      return other != name && mayStandFor(shortened, other);
    });
  };
  const QString usual = metrics.elidedText(name, Qt::ElideMiddle, width);
  if (tells(usual))
    return usual;
  std::set<qsizetype> starts{0};
  for (const QString& other : others)
    if (other != name && mayStandFor(usual, other))
      starts.insert(differingWord(name, other));
  for (const qsizetype start : starts) {
    const QString before = start > 0 ? QString(leftOut) : QString();
    const int room = width - metrics.horizontalAdvance(before);
    for (const Qt::TextElideMode mode : {Qt::ElideRight, Qt::ElideMiddle})
      if (const QString text = before + metrics.elidedText(name.mid(start), mode, room);
          tells(text))
        return text;
  }
  return usual;
}

}  // namespace sline::widgets
