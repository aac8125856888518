// SPDX-License-Identifier: Apache-2.0
#include "render/export/label_texts.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <utility>
#include <vector>

// Resources of a static library must be asked for, outside of any namespace.
static void useLabelFont() {
  Q_INIT_RESOURCE(label_font);
}

namespace sline::render {

namespace {

float pixelsToMm(const LabelStyle& style) {
  return style.points * millimetresPerPoint / float(labelFontPixels);
}

QString fullText(const ShownLabel& label, const LabelStyle& style) {
  QString text = QString::fromStdString(label.text).simplified();
  if (!label.lengthMm)
    return text;
  const QLocale locale(QString::fromStdString(style.language.empty() ? "en" : style.language));
  const int digits = *label.lengthMm < 10.0f ? 1 : 0;
  const QString length =
      locale.toString(double(*label.lengthMm), 'f', digits) + QStringLiteral("\u00a0mm");
  return text.isEmpty() ? length : text + QLatin1Char(' ') + length;
}

/// Two digits: badges are all of one width.
float badgeMm(const QFontMetricsF& metrics, const LabelStyle& style) {
  return float(metrics.horizontalAdvance(QStringLiteral("00"))) * pixelsToMm(style);
}

/// A word, or a part of one: joined to what stands before it.
struct Word {
  QString text;
  bool joined = false;
};

/// Where programs join words: "L4-L3-Disc", "left_kidney", "CystWall".
QStringList partsOf(const QString& word) {
  QStringList parts{word.left(1)};
  for (qsizetype i = 1; i < word.size(); ++i) {
    const bool after = QStringLiteral("-_/").contains(word[i - 1]);
    if (after || (word[i].isUpper() && word[i - 1].isLower()))
      parts << QString();
    parts.back() += word[i];
  }
  return parts;
}

/// Words wider than that are divided.
std::vector<Word> wordsOf(const QString& text, const QFontMetricsF& metrics, qreal widest) {
  std::vector<Word> words;
  for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const bool whole = metrics.horizontalAdvance(word) <= widest;
    const QStringList parts = whole ? QStringList{word} : partsOf(word);
    for (qsizetype i = 0; i < parts.size(); ++i)
      words.push_back({parts[i], i > 0});
  }
  return words;
}

/// As few lines as there must be, each about as long as the others.
QStringList broken(const QString& text, const QFontMetricsF& metrics, qreal widest) {
  const std::vector<Word> words = wordsOf(text, metrics, widest);
  const auto fill = [&](qreal width) {
    QStringList lines;
    for (const Word& word : words) {
      const QString space = word.joined ? QString() : QStringLiteral(" ");
      const QString longer = lines.isEmpty() ? word.text : lines.back() + space + word.text;
      if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= width)
        lines.back() = longer;
      else
        lines.push_back(word.text);
    }
    return lines;
  };
  const QStringList lines = fill(widest);
  // The narrowest width that needs no more lines.
  qreal low = 0.0;
  qreal high = widest;
  for (int i = 0; i < 12; ++i) {
    const qreal middle = 0.5 * (low + high);
    (fill(middle).size() > lines.size() ? low : high) = middle;
  }
  return fill(high);
}

/// A callout's lines begin where its writer began them, too.
QStringList writtenLines(const ShownLabel& label, const QFontMetricsF& metrics, qreal widest) {
  QStringList lines;
  for (const QString& line : QString::fromStdString(label.text).trimmed().split(QLatin1Char('\n')))
    lines << (line.trimmed().isEmpty() ? QStringList{QString()}
                                       : broken(line.simplified(), metrics, widest));
  return lines;
}

}  // namespace

QFont labelFont() {
  static const QString family = [] {
    useLabelFont();
    const int id = QFontDatabase::addApplicationFont(QStringLiteral(":/fonts/labels.ttf"));
    const QStringList families = QFontDatabase::applicationFontFamilies(id);
    return families.isEmpty() ? QString() : families.front();
  }();
  QFont font(family);
  font.setPixelSize(labelFontPixels);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setKerning(true);
  // Spaced letters, however little, are never joined: in text that is copied from a page "fi" must
  // not be one letter.
  font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
  return font;
}

float textWidthMm(const QString& text, float points) {
  return float(QFontMetricsF(labelFont()).horizontalAdvance(text)) * points * millimetresPerPoint /
         float(labelFontPixels);
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

MeasuredText::MeasuredText(const ShownLabel& label, const LabelStyle& style)
    : m_padding(paddingOf(label.item.kind, style)),
      m_scale(pixelsToMm(style)),
      m_lineHeight(lineHeightMm(style)) {
  if (style.mode != LabelMode::on) {
    m_fixed = textOf(label, style, 0.0f).box;
    return;
  }
  const QFontMetricsF metrics(labelFont());
  m_space = float(metrics.horizontalAdvance(QLatin1Char(' ')));
  const QString text = QString::fromStdString(label.text).trimmed();
  const QStringList paragraphs = label.item.kind == model::AnnotationKind::callout
                                     ? text.split(QLatin1Char('\n'))
                                     : QStringList{fullText(label, style)};
  for (const QString& paragraph : paragraphs) {
    Paragraph& words = m_paragraphs.emplace_back();
    for (const QString& word : paragraph.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
      Word& measured = words.emplace_back();
      measured.whole = float(metrics.horizontalAdvance(word));
      for (const QString& part : partsOf(word))
        measured.parts.push_back(float(metrics.horizontalAdvance(part)));
    }
  }
}

glm::vec2 MeasuredText::boxAt(float widestMm) const {
  if (m_fixed)
    return *m_fixed;
  const float widest = widestMm / m_scale;
  std::size_t lines = 0;
  float width = 0.0f;
  for (const Paragraph& paragraph : m_paragraphs) {
    // Words as they are divided at that width, each with what stands before it on its line.
    std::vector<std::pair<float, float>> parts;
    for (const Word& word : paragraph)
      if (word.whole <= widest)
        parts.emplace_back(m_space, word.whole);
      else
        for (std::size_t i = 0; i < word.parts.size(); ++i)
          parts.emplace_back(i == 0 ? m_space : 0.0f, word.parts[i]);
    const auto fill = [&](float most) {
      std::pair<std::size_t, float> filled{1, 0.0f};  // lines, the widest
      float line = 0.0f;
      for (const auto& [before, part] : parts) {
        if (line > 0.0f && line + before + part > most) {
          ++filled.first;
          line = part;
        } else {
          line += (line > 0.0f ? before : 0.0f) + part;
        }
        filled.second = std::max(filled.second, line);
      }
      return filled;
    };
    const std::size_t least = fill(widest).first;
    float low = 0.0f;
    float high = widest;
    for (int i = 0; i < 10; ++i) {
      const float middle = 0.5f * (low + high);
      (fill(middle).first > least ? low : high) = middle;
    }
    lines += least;
    width = std::max(width, fill(high).second);
  }
  return glm::vec2(width * m_scale, float(lines) * m_lineHeight) + 2.0f * m_padding;
}

LabelText textOf(const ShownLabel& label, const LabelStyle& style, float widestMm) {
  const QFontMetricsF metrics(labelFont());
  const float scale = pixelsToMm(style);
  const glm::vec2 padding = paddingOf(label.item.kind, style);
  LabelText text;
  if (style.mode == LabelMode::blank) {
    text.lines = {QString()};
    text.box = glm::vec2(blankWidthMm(style), 2.0f * lineHeightMm(style)) + 2.0f * padding;
    return text;
  }
  if (style.mode == LabelMode::numbers)
    text.lines = {QString::number(label.number)};
  else if (label.item.kind == model::AnnotationKind::callout)
    text.lines = writtenLines(label, metrics, qreal(widestMm / scale));
  else
    text.lines = broken(fullText(label, style), metrics, qreal(widestMm / scale));
  qreal width = 0.0;
  for (const QString& line : text.lines)
    width = std::max(width, metrics.horizontalAdvance(line));
  const float height = float(std::max<qsizetype>(text.lines.size(), 1)) * lineHeightMm(style);
  text.box = glm::vec2(float(width) * scale, height) + 2.0f * padding;
  if (style.mode == LabelMode::numbers)
    text.box.x = std::max({text.box.x, text.box.y, badgeMm(metrics, style) + 2.0f * padding.x});
  return text;
}

}  // namespace sline::render
