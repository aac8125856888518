// SPDX-License-Identifier: Apache-2.0
#include "render/export/comparison/comparison_sheet.h"

#include <QStringList>
#include <algorithm>

#include "model/scene/visible_structures.h"
#include "render/export/comparison/sheet_numbers.h"
#include "render/lettering/label_texts.h"
#include "render/lines/techniques/technique_list.h"

namespace sline::render {

namespace {

// Millimetres.
constexpr float margin = 12.0f;
constexpr float headWidth = 27.0f;  ///< of rows
constexpr float gap = 4.0f;
constexpr float columnHead = 9.0f;
constexpr float captionHeight = 9.5f;
constexpr float rowSpace = 4.0f;
constexpr float leadingShare = 1.3f;
// Points.
constexpr float namePoints = 8.0f;
constexpr float smallPoints = 6.5f;
constexpr float leastPoints = 4.0f;

constexpr Colour black{0, 0, 0};
constexpr Colour grey{90, 90, 90};
constexpr Colour rule{170, 170, 170};

float leadingOf(float points) {
  return leadingShare * points * millimetresPerPoint;
}

TextLine plain(const QString& text, bool bold = false) {
  TextLine line(text);
  line.runs.front().style.bold = bold;
  return line;
}

/// Splits off what of a word fits in the width: at least a letter.
QString firstPart(const QString& word, float points, float widthMm, bool bold) {
  qsizetype count = 1;
  while (count < word.size() && textWidthMm(plain(word.left(count + 1), bold), points) <= widthMm)
    ++count;
  return word.left(count);
}

/// Breaks the text so that no line is wider: between words, and within those that are wider.
std::vector<TextLine> broken(const QString& text, float points, float widthMm, bool bold) {
  std::vector<TextLine> lines;
  QString line;
  for (QString word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
    if (textWidthMm(plain(longer, bold), points) <= widthMm) {
      line = longer;
      continue;
    }
    if (!line.isEmpty())
      lines.push_back(plain(line, bold));
    for (QString part = firstPart(word, points, widthMm, bold); part != word;
         part = firstPart(word, points, widthMm, bold)) {
      lines.push_back(plain(part, bold));
      word.remove(0, part.size());
    }
    line = word;
  }
  lines.push_back(plain(line, bold));
  return lines;
}

/// Returns the size at which none of the lines is wider.
float fittedPoints(const std::vector<TextLine>& lines, float points, float widthMm) {
  float widest = 0.0f;
  for (const TextLine& line : lines)
    widest = std::max(widest, textWidthMm(line, points));
  return widest > widthMm ? std::max(leastPoints, points * widthMm / widest) : points;
}

class Layout {
 public:
  Layout(const Comparison& comparison, const ComparisonWords& words)
      : m_comparison(comparison), m_words(words), m_cell(comparison.order.cellMm) {}

  ComparisonSheet make() {
    const std::size_t columns = m_comparison.order.techniques.size();
    m_sheet.sizeMm.x = margin + headWidth + float(columns) * (m_cell + gap) + margin - gap;
    for (std::size_t column = 0; column < columns; ++column)
      addColumnHead(column);
    addRule(margin + columnHead);
    float y = margin + columnHead + gap;
    for (std::size_t row = 0; row < m_comparison.rows.size(); ++row) {
      addRowHead(row, y);
      for (std::size_t column = 0; column < columns; ++column)
        addCell(row, column, y);
      y += m_cell + captionHeight + rowSpace;
    }
    addRule(y);
    addNotes(y + gap);
    return std::move(m_sheet);
  }

 private:
  float left(std::size_t column) const {
    return margin + headWidth + float(column) * (m_cell + gap);
  }

  QString techniqueName(model::Technique technique) const {
    const std::size_t place = std::size_t(technique);
    return QString::fromStdString(place < m_words.techniques.size()
                                      ? m_words.techniques[place]
                                      : std::string(factsOf(technique).name));
  }

  QString meaningOf(const TechniqueThreshold& threshold) const {
    return m_words.meaning ? QString::fromStdString(m_words.meaning(threshold.meaning))
                           : QString::fromUtf8(threshold.meaning);
  }

  /// Adds lines from that baseline and returns the next one.
  float addText(const QString& name, std::vector<TextLine> lines, const glm::vec2& at, float points,
                const Colour& ink) {
    const float leading = leadingOf(points);
    const float below = at.y + float(lines.size()) * leading;
    m_sheet.lettering.items.push_back({.name = name.toStdString(),
                                       .shapes = {},
                                       .text = LetteringText{.lines = std::move(lines),
                                                             .at = at,
                                                             .leading = leading,
                                                             .points = points,
                                                             .anchor = TextAnchor::start,
                                                             .ink = ink}});
    return below;
  }

  void addRule(float y) {
    m_sheet.lettering.items.push_back(
        {.name = "rule",
         .shapes = {{.path = polyline({{margin, y}, {m_sheet.sizeMm.x - margin, y}}),
                     .pen = 0.15f,
                     .ink = rule,
                     .fill = {}}},
         .text = {}});
  }

  void addColumnHead(std::size_t column) {
    const model::Technique technique = m_comparison.order.techniques[column];
    const std::vector<TextLine> name{plain(techniqueName(technique), true)};
    const float points = fittedPoints(name, namePoints, m_cell);
    const QString head = techniqueName(technique);
    const float next = addText(head, name, {left(column), margin + 2.5f}, points, black);
    const std::vector<TextLine> citation{
        plain(QString::fromStdString(factsOf(technique).citation()))};
    addText(head + QStringLiteral(", source"), citation, {left(column), next},
            fittedPoints(citation, smallPoints, m_cell), grey);
  }

  void addRowHead(std::size_t row, float y) {
    const ComparedModel& model = m_comparison.order.models[row];
    constexpr float width = headWidth - gap;
    const QString name = QString::fromStdString(model.name);
    float next = addText(name, broken(name, namePoints, width, true), {margin, y + 0.5f * m_cell},
                         namePoints, black);
    std::size_t triangles = 0;
    for (const model::VisibleStructure& structure : model::visibleStructures(model.scene))
      triangles += structure.node->mesh->triangleCount();
    QString count = QString::fromStdString(m_words.triangles);
    count.replace(QStringLiteral("%1"), QString::fromStdString(grouped(triangles)));
    next = addText(name + QStringLiteral(", size"), broken(count, smallPoints, width, false),
                   {margin, next}, smallPoints, grey);
    if (!model.note.empty())
      addText(name + QStringLiteral(", note"),
              broken(QString::fromStdString(model.note), smallPoints, width, false), {margin, next},
              smallPoints, grey);
  }

  void addCell(std::size_t row, std::size_t column, float y) {
    const ComparedCell& cell = m_comparison.rows[row][column];
    const model::Technique technique = m_comparison.order.techniques[column];
    const QString name = QString::fromStdString(m_comparison.order.models[row].name) +
                         QStringLiteral(", ") + techniqueName(technique);
    m_sheet.cells.push_back(
        {.id = "cell-" + std::to_string(row + 1) + "-" + std::to_string(column + 1),
         .name = name.toStdString(),
         .drawing = &cell.drawing,
         .at = {left(column), y}});
    QStringList thresholds;
    for (const TechniqueThreshold& threshold : factsOf(technique).thresholds)
      thresholds.append(
          QString::fromUtf8(threshold.id) + QLatin1Char(' ') +
          QString::fromStdString(shortNumber(valueOf(threshold, m_comparison.order.thresholds))));
    std::vector<TextLine> lines{plain(thresholds.join(QStringLiteral(", ")))};
    lines.push_back(
        plain(QString::fromStdString(threeDigits(cell.frameMs)) + QStringLiteral(" ms · ") +
              QString::fromStdString(threeDigits(cell.linesPerMm)) + QStringLiteral(" mm⁻¹")));
    addText(name + QStringLiteral(", figures"), lines, {left(column), y + m_cell + 3.5f},
            fittedPoints(lines, smallPoints, m_cell), black);
  }

  /// Says what the figures mean and ends the page below.
  void addNotes(float y) {
    QStringList notes{QString::fromStdString(m_words.time), QString::fromStdString(m_words.length),
                      QString::fromStdString(m_words.sizes)};
    for (const model::Technique technique : m_comparison.order.techniques)
      for (const TechniqueThreshold& threshold : factsOf(technique).thresholds)
        notes.append(techniqueName(technique) + QStringLiteral(", ") +
                     QString::fromUtf8(threshold.id) + QStringLiteral(": ") + meaningOf(threshold) +
                     QLatin1Char('.'));
    const float width = m_sheet.sizeMm.x - 2.0f * margin;
    const float next = addText(QStringLiteral("notes"),
                               broken(notes.join(QLatin1Char(' ')), smallPoints, width, false),
                               {margin, y}, smallPoints, grey);
    m_sheet.sizeMm.y = next - leadingOf(smallPoints) + margin;
  }

  const Comparison& m_comparison;
  const ComparisonWords& m_words;
  float m_cell;
  ComparisonSheet m_sheet;
};

}  // namespace

ComparisonSheet comparisonSheet(const Comparison& comparison, const ComparisonWords& words) {
  return Layout(comparison, words).make();
}

}  // namespace sline::render
