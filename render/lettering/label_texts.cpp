// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/label_texts.h"

#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "model/lengths/told_length.h"
#include "model/scene/label_words.h"
#include "render/lettering/mark_words.h"
#include "render/lettering/word_division.h"

namespace sline::render {

namespace {

float pixelsToMm(const LabelStyle& style) {
  return style.points * millimetresPerPoint / float(labelFontPixels);
}

/// Some 800 lines: more than fit on any page.
constexpr std::size_t mostBytes = 20'000;

std::string bounded(const std::string& text) {
  if (text.size() <= mostBytes)
    return text;
  std::size_t end = mostBytes;
  while ((text[end] & '\xc0') == '\x80')  // inside a character of UTF-8
    --end;
  return text.substr(0, end) + "\u2026";
}

/// Returns "88 mm", "≈ 3.8 µm", "< 2 mm" or that two structures touch.
QString distanceText(const ShownLabel& label, const std::string& language) {
  if (label.length->mm <= 0.0f && label.length->offMm <= 0.0f)
    return MarkWords(language, {}).touching();
  const model::ToldDistance told = model::toldDistance(*label.length, label.unit);
  const QLocale locale(
      QString::fromStdString(language.empty() ? "en" : model::firstLanguage(language)));
  QString text = QString::fromUtf8(told.sign.data(), qsizetype(told.sign.size()));
  if (!text.isEmpty())
    text += QChar(QChar::Nbsp);
  return text + locale.toString(told.value, 'f', told.decimals) + QChar(QChar::Nbsp) +
         QString::fromStdString(told.unit);
}

QString fullText(const ShownLabel& label, const LabelStyle& style) {
  QString text = QString::fromStdString(bounded(label.text)).simplified();
  // A slash between two names ends a line, it begins none.
  text.replace(QStringLiteral(" / "), QStringLiteral("\u00a0/ "));
  if (!label.length)
    return text;
  const QString length = distanceText(label, style.language);
  return text.isEmpty() ? length : text + QLatin1Char(' ') + length;
}

/// Returns the width of two digits, as all badges have the same width.
float badgeMm(const Ruler& ruler, const LabelStyle& style) {
  return float(ruler.width(TextLine(QStringLiteral("00")))) * pixelsToMm(style);
}

WordLimits limitsOf(float widestMm, const WordRoom& words, float scale) {
  return {.line = qreal(widestMm / scale),
          .whole = qreal(std::max(widestMm, words.whole) / scale),
          .part = qreal(std::max(widestMm, words.part) / scale)};
}

/// Holds what the author began on a line of its own.
struct Paragraph {
  std::vector<Word> words;
  bool bullet = false;
};

/// Breaks the paragraphs of one text into lines.
class LineBreaker {
 public:
  LineBreaker(std::vector<Paragraph> paragraphs, const Ruler& ruler)
      : m_paragraphs(std::move(paragraphs)), m_ruler(ruler) {}

  static TextLine bullet() {
    return {QString::fromUtf8(model::bulletSign.data(), qsizetype(model::bulletSign.size()))};
  }

  /// Returns as few lines as possible, the longest as short as possible.
  std::vector<TextLine> lines(qreal widest) const {
    const std::vector<TextLine> lines = filled(widest);
    qreal low = 0.0;
    qreal high = widest;
    for (int i = 0; i < 12; ++i) {
      const qreal middle = 0.5 * (low + high);
      (filled(middle).size() > lines.size() ? low : high) = middle;
    }
    return filled(high);
  }

 private:
  std::vector<TextLine> filled(qreal width) const {
    std::vector<TextLine> lines;
    for (const Paragraph& paragraph : m_paragraphs)
      add(paragraph, width, lines);
    return lines;
  }

  /// Adds the lines of a paragraph; those of an item are indented by as much as its bullet needs.
  void add(const Paragraph& paragraph, qreal width, std::vector<TextLine>& lines) const {
    const qreal indent = paragraph.bullet ? m_ruler.width(bullet()) : 0.0;
    lines.push_back(paragraph.bullet ? bullet() : TextLine());
    qreal used = 0.0;
    bool first = true;
    const Word* before = nullptr;
    for (const Word& word : paragraph.words) {
      const model::LetterStyle style =
          first ? model::LetterStyle() : spaceStyle(lines.back(), word);
      const TextRun space{.text = QStringLiteral(" "), .style = style};
      const qreal gap = first || word.joined ? 0.0 : m_ruler.width(space);
      const qreal hyphen = word.hyphen ? m_ruler.hyphen() : 0.0;
      if (!first && indent + used + gap + word.width + hyphen > width) {
        if (before && before->hyphen)
          hyphenate(lines.back());
        lines.emplace_back().indent = float(indent / labelFontPixels);
        lines.back().joined = word.joined;
        used = 0.0;
      } else if (!first) {
        used += gap;
        if (!word.joined)
          append(lines.back(), space.text, space.style);
      }
      for (const TextRun& run : word.text.runs)
        append(lines.back(), run.text, run.style);
      used += word.width;
      first = false;
      before = &word;
    }
  }

  static void hyphenate(TextLine& line) {
    append(line, QStringLiteral("-"), {});
    line.hyphenated = true;
  }

  static model::LetterStyle spaceStyle(const TextLine& before, const Word& word) {
    const model::LetterStyle style = word.text.runs.front().style;
    return before.runs.back().style == style ? style : model::LetterStyle();
  }

  std::vector<Paragraph> m_paragraphs;
  const Ruler& m_ruler;
};

std::vector<TextLine> broken(const QString& text, const Ruler& ruler, const WordLimits& limits) {
  std::vector<Word> words = wordsOf(TextLine(text), ruler, limits);
  if (words.empty())
    return {};
  return LineBreaker({{.words = std::move(words)}}, ruler).lines(limits.line);
}

std::vector<Paragraph> paragraphsOf(const std::string& text, const Ruler& ruler,
                                    const WordLimits& limits) {
  const qreal indent = ruler.width(LineBreaker::bullet());
  std::vector<Paragraph> paragraphs;
  for (const model::MarkedLine& line : model::markedLines(bounded(text))) {
    TextLine marked;
    for (const model::MarkedRun& run : line.runs)
      append(marked, QString::fromStdString(run.text), run.style);
    const qreal less = line.bullet ? indent : 0.0;
    paragraphs.push_back(
        {.words = wordsOf(marked, ruler, limits.less(less)), .bullet = line.bullet});
  }
  return paragraphs;
}

void setCallout(LabelText& text, const std::string& words, const Ruler& ruler,
                const WordLimits& limits) {
  std::vector<Paragraph> paragraphs = paragraphsOf(words, ruler, limits);
  text.list = std::any_of(paragraphs.begin(), paragraphs.end(),
                          [](const Paragraph& paragraph) { return paragraph.bullet; });
  text.lines = LineBreaker(std::move(paragraphs), ruler).lines(limits.line);
}

}  // namespace

qreal advanceOf(const TextLine& line) {
  qreal width = 0.0;
  for (const TextRun& run : line.runs)
    width += QFontMetricsF(labelFont(run.style)).horizontalAdvance(run.text);
  return width;
}

float textWidthMm(const TextLine& line, float points) {
  return (float(advanceOf(line)) / float(labelFontPixels) + line.indent) * points *
         millimetresPerPoint;
}

float capHeightMm(float points) {
  return float(QFontMetricsF(labelFont()).capHeight()) * points * millimetresPerPoint /
         float(labelFontPixels);
}

float lineHeightMm(const LabelStyle& style) {
  return 1.18f * style.points * millimetresPerPoint;
}

float blankWidthMm(const LabelStyle& style) {
  return 8.0f * style.points * millimetresPerPoint;
}

glm::vec2 paddingOf(model::AnnotationKind kind, const LabelStyle& style) {
  const float em = style.points * millimetresPerPoint;
  if (style.mode == LabelMode::numbers)
    return {0.25f * em, 0.12f * em};
  return kind == model::AnnotationKind::callout ? glm::vec2(0.45f, 0.3f) * em
                                                : glm::vec2(0.25f, 0.04f) * em;
}

float widestTextMm(float pictureWidthMm, const LabelStyle& style) {
  const float em = style.points * millimetresPerPoint;
  return std::max(6.0f * em, std::min(14.0f * em, 0.22f * pictureWidthMm));
}

WordRoom wordRoom(float pictureWidthMm, const LabelStyle& style) {
  const float part = widestTextMm(pictureWidthMm, style);
  return {.whole = std::max(part, 0.35f * pictureWidthMm), .part = part};
}

MeasuredText::MeasuredText(const ShownLabel& label, const LabelStyle& style, const WordRoom& words)
    : m_padding(paddingOf(label.item.kind, style)),
      m_scale(pixelsToMm(style)),
      m_lineHeight(lineHeightMm(style)) {
  if (style.mode != LabelMode::on) {
    m_fixed = textOf(label, style, 0.0f).box;
    return;
  }
  const Ruler ruler(model::firstLanguage(style.language));
  m_space = float(ruler.width(TextLine(QStringLiteral(" "))));
  const WordLimits limits = limitsOf(0.0f, words, m_scale);
  const auto measured = [&ruler, &limits](const Word& word, qreal indent) {
    WordWidths widths{.whole = float(word.width), .parts = {}};
    for (const Word& part : divided(word, ruler, limits.less(indent)))
      widths.parts.push_back({float(part.width), part.hyphen ? float(ruler.hyphen()) : 0.0f});
    return widths;
  };
  constexpr qreal infinity = std::numeric_limits<qreal>::infinity();
  constexpr WordLimits undivided{infinity, infinity, infinity};
  std::vector<Paragraph> paragraphs;
  if (label.item.kind == model::AnnotationKind::callout)
    paragraphs = paragraphsOf(label.text, ruler, undivided);
  else
    paragraphs.push_back({.words = wordsOf(TextLine(fullText(label, style)), ruler, undivided)});
  for (const Paragraph& paragraph : paragraphs) {
    ParagraphWidths& own = m_paragraphs.emplace_back();
    own.indent = paragraph.bullet ? float(ruler.width(LineBreaker::bullet())) : 0.0f;
    for (const Word& word : paragraph.words)
      own.words.push_back(measured(word, qreal(own.indent)));
  }
}

MeasuredText::Filled MeasuredText::fill(float widest, float most) const {
  Filled filled;
  for (const ParagraphWidths& paragraph : m_paragraphs) {
    ++filled.lines;
    float line = paragraph.indent;
    bool begun = false;
    float hyphenBefore = 0.0f;
    const auto add = [&](float before, float width, float hyphen) {
      if (begun && line + before + width + hyphen > most) {
        filled.width = std::max(filled.width, line + hyphenBefore);
        ++filled.lines;
        line = paragraph.indent + width;
      } else {
        line += (begun ? before : 0.0f) + width;
      }
      filled.width = std::max(filled.width, line);
      begun = true;
      hyphenBefore = hyphen;
    };
    for (const WordWidths& word : paragraph.words)
      if (word.whole <= widest - paragraph.indent)
        add(m_space, word.whole, 0.0f);
      else
        for (std::size_t i = 0; i < word.parts.size(); ++i)
          add(i == 0 ? m_space : 0.0f, word.parts[i].width, word.parts[i].hyphen);
    filled.width = std::max(filled.width, line);
  }
  return filled;
}

glm::vec2 MeasuredText::boxAt(float widestMm) const {
  if (m_fixed)
    return *m_fixed;
  const float widest = widestMm / m_scale;
  const std::size_t least = fill(widest, widest).lines;
  float low = 0.0f;
  float high = widest;
  for (int i = 0; i < 12; ++i) {
    const float middle = 0.5f * (low + high);
    (fill(widest, middle).lines > least ? low : high) = middle;
  }
  const float height = float(std::max<std::size_t>(least, 1)) * m_lineHeight;
  return glm::vec2(fill(widest, high).width * m_scale, height) + 2.0f * m_padding;
}

LabelText textOf(const ShownLabel& label, const LabelStyle& style, float widestMm,
                 const WordRoom& words) {
  const Ruler ruler(model::firstLanguage(style.language));
  const float scale = pixelsToMm(style);
  const glm::vec2 padding = paddingOf(label.item.kind, style);
  const WordLimits limits = limitsOf(widestMm, words, scale);
  LabelText text;
  if (style.mode == LabelMode::blank) {
    text.lines = {QString()};
    text.box = glm::vec2(blankWidthMm(style), 2.0f * lineHeightMm(style)) + 2.0f * padding;
    return text;
  }
  if (style.mode == LabelMode::numbers)
    text.lines = {QString::number(label.number)};
  else if (label.item.kind == model::AnnotationKind::callout)
    setCallout(text, label.text, ruler, limits);
  else
    text.lines = broken(fullText(label, style), ruler, limits);
  float width = 0.0f;
  for (const TextLine& line : text.lines)
    width = std::max(width, textWidthMm(line, style.points));
  const float height = float(std::max<std::size_t>(text.lines.size(), 1)) * lineHeightMm(style);
  text.box = glm::vec2(width, height) + 2.0f * padding;
  if (style.mode == LabelMode::numbers)
    text.box.x = std::max({text.box.x, text.box.y, badgeMm(ruler, style) + 2.0f * padding.x});
  return text;
}

std::string keyText(const ShownLabel& label, const LabelStyle& style) {
  return label.length ? fullText(label, style).toStdString() : plainText(label);
}

}  // namespace sline::render
