// SPDX-License-Identifier: Apache-2.0
#include "widgets/text/told.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <vector>

namespace sline::widgets {

namespace {

const QRegularExpression& marker() {
  static const QRegularExpression pattern(QStringLiteral("%([1-9])"));
  return pattern;
}

struct Pattern {
  const char* source;
  QRegularExpression form;
  std::vector<int> numbers;  ///< of the markers, in their order in the message
  qsizetype letters = 0;     ///< beside the markers
  QString words;             ///< the longest part between markers; looked for first
};

Pattern patternOf(const char* source) {
  const QString text = QString::fromUtf8(source);
  Pattern pattern{source, {}, {}, 0, {}};
  for (const QString& part : text.split(marker()))
    if (part.size() > pattern.words.size())
      pattern.words = part;
  QString form;
  qsizetype from = 0;
  for (auto match = marker().globalMatch(text); match.hasNext();) {
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
    for (const auto& rows : {toldPatterns(), doubtPatterns(), systemPatterns()})
      for (const char* row : rows)
        made.push_back(patternOf(row));
    return made;
  }();
  return all;
}

/// Puts the parts in place of the markers; `QString::arg` would look into the parts, too.
QString filled(const QString& text, const QStringList& parts) {
  QString whole;
  qsizetype from = 0;
  for (auto match = marker().globalMatch(text); match.hasNext();) {
    const QRegularExpressionMatch at = match.next();
    whole += text.mid(from, at.capturedStart() - from) + parts.value(at.captured(1).toInt());
    from = at.capturedEnd();
  }
  return whole + text.mid(from);
}

struct Found {
  const Pattern* pattern = nullptr;
  QRegularExpressionMatch match;
  qsizetype letters() const { return pattern ? pattern->letters : 0; }
  /// Tells whether the message begins with words of its own.
  bool begins() const { return pattern && pattern->source[0] != '%'; }
};

/// Returns the pattern that says most of the message by itself.
Found found(const QString& english) {
  Found best;
  for (const Pattern& pattern : patterns()) {
    if (pattern.letters <= best.letters() || !english.contains(pattern.words))
      continue;
    if (const auto match = pattern.form.match(english); match.hasMatch())
      best = {&pattern, match};
  }
  return best;
}

QString toldTo(const QString& english, int depth);

QString toldAs(const Found& found, int depth) {
  QStringList parts(10);
  const std::vector<int>& numbers = found.pattern->numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    parts[numbers[i]] = toldTo(found.match.captured(int(i) + 1), depth + 1);
  return filled(QCoreApplication::translate(toldContext, found.pattern->source), parts);
}

QString toldTo(const QString& english, int depth) {
  constexpr int deepest = 6;
  if (english.isEmpty() || depth > deepest)
    return english;
  const QString colon = QStringLiteral(": ");
  const Found whole = found(english);
  if (whole.begins())
    return toldAs(whole, depth);
  // Of whom something is said stands before it: "liver.stl: line 3: is empty".
  for (qsizetype at = english.indexOf(colon); at >= 0; at = english.indexOf(colon, at + 1))
    if (const Found said = found(english.mid(at + colon.size()));
        said.begins() && said.letters() > whole.letters())
      return toldTo(english.left(at), depth + 1) + colon + toldAs(said, depth);
  if (whole.pattern)
    return toldAs(whole, depth);
  // A whole error is a line of sentences.
  if (english.endsWith(QLatin1Char('.')))
    return toldTo(english.chopped(1), depth + 1) + QLatin1Char('.');
  for (const QString& between : {QStringLiteral(". "), colon})
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
