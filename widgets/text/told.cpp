// SPDX-License-Identifier: Apache-2.0
#include "widgets/text/told.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <vector>

namespace sline::widgets {

namespace {

const QRegularExpression& placeholder() {
  static const QRegularExpression pattern(QStringLiteral("%([1-9])"));
  return pattern;
}

struct Pattern {
  const char* source;
  QRegularExpression form;
  std::vector<int> numbers;  ///< of the placeholders, in their order in the message
  qsizetype letters = 0;     ///< beside the placeholders
};

Pattern patternOf(const char* source) {
  const QString text = QString::fromUtf8(source);
  Pattern pattern{source, {}, {}, 0};
  QString form;
  qsizetype from = 0;
  for (auto match = placeholder().globalMatch(text); match.hasNext();) {
    const QRegularExpressionMatch at = match.next();
    form += QRegularExpression::escape(text.mid(from, at.capturedStart() - from));
    form += QStringLiteral("(.+?)");
    pattern.numbers.push_back(at.captured(1).toInt());
    from = at.capturedEnd();
  }
  form += QRegularExpression::escape(text.mid(from));
  pattern.form.setPattern(QRegularExpression::anchoredPattern(form));
  pattern.form.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
  pattern.letters = text.size() - 2 * qsizetype(pattern.numbers.size());
  return pattern;
}

const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all = [] {
    std::vector<Pattern> made;
    for (const auto& rows : {toldPatterns(), systemPatterns()})
      for (const char* row : rows)
        made.push_back(patternOf(row));
    return made;
  }();
  return all;
}

/// Puts the parts in place of the placeholders; `QString::arg` would look into the parts, too.
QString filled(const QString& text, const QStringList& parts) {
  QString whole;
  qsizetype from = 0;
  for (auto match = placeholder().globalMatch(text); match.hasNext();) {
    const QRegularExpressionMatch at = match.next();
    whole += text.mid(from, at.capturedStart() - from) + parts.value(at.captured(1).toInt());
    from = at.capturedEnd();
  }
  return whole + text.mid(from);
}

QString toldTo(const QString& english, int depth) {
  constexpr int deepest = 6;
  if (english.isEmpty() || depth > deepest)
    return english;
  const Pattern* best = nullptr;
  QRegularExpressionMatch match;
  for (const Pattern& pattern : patterns()) {
    if (best && pattern.letters <= best->letters)
      continue;
    if (const auto found = pattern.form.match(english); found.hasMatch()) {
      best = &pattern;
      match = found;
    }
  }
  if (best) {
    QStringList parts(10);
    for (std::size_t i = 0; i < best->numbers.size(); ++i)
      parts[best->numbers[i]] = toldTo(match.captured(int(i) + 1), depth + 1);
    return filled(QCoreApplication::translate(toldContext, best->source), parts);
  }
  // A whole error is a line of sentences: "liver.stl: line 3: is empty. Check the name."
  if (english.endsWith(QLatin1Char('.')))
    return toldTo(english.chopped(1), depth + 1) + QLatin1Char('.');
  for (const QString& between : {QStringLiteral(". "), QStringLiteral(": ")})
    if (const qsizetype at = english.indexOf(between); at >= 0)
      return toldTo(english.left(at), depth + 1) + between +
             toldTo(english.mid(at + between.size()), depth + 1);
  return english;
}

}  // namespace

QString told(const QString& english) {
  return toldTo(english, 0);
}

}  // namespace sline::widgets
