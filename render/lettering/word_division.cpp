// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/word_division.h"

#include <QHash>
#include <QTextBoundaryFinder>
#include <algorithm>
#include <numeric>
#include <utility>

#include "render/lettering/label_font.h"

namespace sline::render {

namespace {

bool parts(QChar c) {
  constexpr QChar unbroken(0x00a0);
  constexpr QChar narrowUnbroken(0x202f);
  return c.isSpace() && c != unbroken && c != narrowUnbroken;
}

/// Returns the text from one place to another, each letter in its style.
TextLine piece(const TextLine& text, qsizetype from, qsizetype to) {
  TextLine line;
  qsizetype at = 0;
  for (const TextRun& run : text.runs) {
    const qsizetype begin = std::max(from - at, qsizetype(0));
    const qsizetype end = std::min(to - at, run.text.size());
    if (begin < end)
      append(line, QStringView(run.text).mid(begin, end - begin), run.style);
    at += run.text.size();
  }
  return line;
}

std::vector<qsizetype> boundaries(QTextBoundaryFinder::BoundaryType type, const QString& text) {
  std::vector<qsizetype> places;
  QTextBoundaryFinder finder(type, text);
  for (qsizetype at = finder.toNextBoundary(); at > 0; at = finder.toNextBoundary())
    places.push_back(at);
  return places;
}

/// Returns where a line may end within the text, and the text's end.
std::vector<qsizetype> lineEnds(const QString& text) {
  std::vector<qsizetype> ends = boundaries(QTextBoundaryFinder::Line, text);
  for (qsizetype i = 1; i < text.size(); ++i)
    if (QStringLiteral("-_/").contains(text[i - 1]) || (text[i].isUpper() && text[i - 1].isLower()))
      ends.push_back(i);
  ends.push_back(text.size());
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

/// Returns where a line may end within the text, and whether a hyphen shows it because a syllable
/// ends there: syllables count only within pieces wider than `most`.
std::vector<std::pair<qsizetype, bool>> pieceEnds(const TextLine& line, const Ruler& ruler,
                                                  qreal most) {
  const QString text = plainText(line);
  const std::vector<qsizetype> syllables = ruler.hyphenation().syllableEnds(text);
  std::vector<std::pair<qsizetype, bool>> ends;
  qsizetype from = 0;
  for (const qsizetype end : lineEnds(text)) {
    if (!syllables.empty() && ruler.width(piece(line, from, end)) > most)
      for (const qsizetype syllable : syllables)
        if (syllable > from && syllable < end)
          ends.emplace_back(syllable, true);
    ends.emplace_back(end, false);
    from = end;
  }
  return ends;
}

/// Tells whether words of the letter's alphabet are divided with hyphens.
bool hyphenates(QChar c) {
  const QChar::Script script = c.script();
  return c.isLetter() && (script == QChar::Script_Latin || script == QChar::Script_Greek ||
                          script == QChar::Script_Cyrillic || script == QChar::Script_Armenian);
}

/// Divides words that have no place for it.
class Cutter {
 public:
  Cutter(const TextLine& text, const Ruler& ruler)
      : m_text(plainText(text)),
        m_hyphen(ruler.hyphen()),
        m_ends(boundaries(QTextBoundaryFinder::Grapheme, m_text)) {
    QHash<QString, qreal> known;
    qsizetype from = 0;
    for (const qsizetype end : m_ends) {
      // Kerning, and letters that take another form beside others, make little difference.
      const TextLine sign = piece(text, from, end);
      const model::LetterStyle style = sign.runs.front().style;
      const QString key = plainText(sign) + QLatin1Char(style.bold ? 'b' : ' ') +
                          QLatin1Char(style.italic ? 'i' : ' ');
      const auto found = known.constFind(key);
      m_widths.push_back(found != known.constEnd() ? *found
                                                   : *known.insert(key, ruler.width(sign)));
      from = end;
    }
  }

  /// Returns where parts of about the same width end, as few as possible.
  std::vector<qsizetype> ends(qreal most) const {
    const std::size_t number = cut(most).size();
    qreal low = 0.0;
    qreal high = most;
    for (int i = 0; i < 12; ++i) {
      const qreal middle = 0.5 * (low + high);
      (cut(middle).size() > number ? low : high) = middle;
    }
    return cut(high);
  }

  bool hyphenAt(qsizetype end) const {
    return end < m_text.size() && hyphenates(m_text[end - 1]) && hyphenates(m_text[end]);
  }

 private:
  std::vector<qsizetype> cut(qreal most) const {
    std::vector<qsizetype> ends;
    qreal used = 0.0;
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
      const qreal hyphen = hyphenAt(m_ends[i]) ? m_hyphen : 0.0;
      if (i > 0 && used > 0.0 && used + m_widths[i] + hyphen > most) {
        ends.push_back(m_ends[i - 1]);
        used = 0.0;
      }
      used += m_widths[i];
    }
    ends.push_back(m_text.size());
    return ends;
  }

  QString m_text;
  qreal m_hyphen;
  std::vector<qsizetype> m_ends;  ///< of its signs
  std::vector<qreal> m_widths;
};

}  // namespace

Ruler::Ruler(const std::string& language)
    : m_metrics{QFontMetricsF(labelFont()), QFontMetricsF(labelFont({.bold = true})),
                QFontMetricsF(labelFont({.italic = true})),
                QFontMetricsF(labelFont({.bold = true, .italic = true}))},
      m_hyphen(m_metrics[0].horizontalAdvance(QLatin1Char('-'))),
      m_hyphenation(language) {}

qreal Ruler::width(const TextRun& run) const {
  return m_metrics[std::size_t(run.style.bold) + 2 * std::size_t(run.style.italic)]
      .horizontalAdvance(run.text);
}

qreal Ruler::width(const TextLine& line) const {
  return std::accumulate(line.runs.begin(), line.runs.end(), 0.0,
                         [this](qreal sum, const TextRun& run) { return sum + width(run); });
}

std::vector<Word> divided(const Word& word, const Ruler& ruler, const WordLimits& limits) {
  std::vector<Word> pieces;
  const auto add = [&](TextLine text, bool hyphen) {
    const qreal width = ruler.width(text);
    pieces.push_back({.text = std::move(text),
                      .joined = word.joined || !pieces.empty(),
                      .hyphen = hyphen,
                      .width = width});
  };
  const QString text = plainText(word.text);
  qsizetype from = 0;
  for (const auto& [end, syllable] : pieceEnds(word.text, ruler, limits.part)) {
    const TextLine part = piece(word.text, from, end);
    const bool soft = syllable || (end < text.size() && text[end - 1] == QChar::SoftHyphen);
    if (ruler.width(part) + (soft ? ruler.hyphen() : 0.0) <= limits.whole) {
      add(part, soft);
    } else {
      const Cutter cutter(part, ruler);
      qsizetype begin = 0;
      for (const qsizetype stop : cutter.ends(limits.part)) {
        add(piece(part, begin, stop), cutter.hyphenAt(stop));
        begin = stop;
      }
    }
    from = end;
  }
  return pieces;
}

std::vector<Word> wordsOf(const TextLine& line, const Ruler& ruler, const WordLimits& limits) {
  std::vector<Word> whole;
  bool within = false;
  for (const TextRun& run : line.runs)
    for (const QChar c : run.text) {
      if (!parts(c) && !std::exchange(within, true))
        whole.emplace_back();
      within = !parts(c);
      if (within)
        append(whole.back().text, QStringView(&c, 1), run.style);
    }
  std::vector<Word> words;
  for (Word& word : whole) {
    word.width = ruler.width(word.text);
    if (word.width <= limits.line)
      words.push_back(std::move(word));
    else
      for (Word& part : divided(word, ruler, limits))
        words.push_back(std::move(part));
  }
  return words;
}

}  // namespace sline::render
