// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/lesson_lists.h"

#include <QCollator>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "render/export/pdf/sheet_lists.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float contentsRow = 8.0f;
constexpr float contentsPoints = 11.0f;
constexpr float indexRow = 5.4f;
constexpr float indexPoints = 9.0f;
constexpr float indexColumn = 84.0f;  ///< about, with the space beside it
constexpr float gap = 3.0f;

/// Gives rows their places in columns, page by page.
class Rows {
 public:
  Rows(const LessonSetting& setting, QString heading, float height, int columns)
      : m_setting(setting), m_heading(std::move(heading)), m_height(height), m_columns(columns) {
    begin();
  }

  /// Returns the place of the next row.
  glm::vec2 next() {
    const LabelBox& content = m_setting.layout.content;
    if (m_y + m_height > content.high.y) {
      m_y = content.low.y;
      if (++m_column == m_columns)
        begin();
    }
    const glm::vec2 at{content.low.x + float(m_column) * (width() + columnSpace), m_y};
    m_y += m_height;
    return at;
  }
  float width() const { return columnWidth(m_setting.layout.content, m_columns); }

 private:
  void begin() {
    const bool untitled = m_setting.title.isEmpty();
    beginSheetPage(m_setting.pages, m_setting.count, m_setting.layout,
                   {untitled ? m_heading : m_setting.title, untitled ? QString() : m_heading});
    m_y = m_setting.layout.content.low.y;
    m_column = 0;
  }

  const LessonSetting& m_setting;
  QString m_heading;
  float m_height;
  int m_columns;
  int m_column = 0;
  float m_y = 0.0f;
};

std::size_t pageNow(const LessonSetting& setting) {
  return std::size_t(setting.count.page) - 1;
}

/// Sets the page's number so that it ends at that place, as a link to it; returns its width.
float setPageNumber(const LessonSetting& setting, std::size_t page, const glm::vec2& end,
                    float points) {
  const QString number = QString::number(page + 1);
  const float width = textWidthMm(number, points);
  setLine(setting.pages.painter(), number, end, points, TextAnchor::end);
  const float height = capHeightMm(points);
  setting.links.push_back(
      {pageNow(setting), {{end.x - width - 0.6f, end.y - height - 1.2f}, end + 0.9f}, page});
  return width;
}

int indexColumns(const SheetLayout& layout) {
  return std::max(1, int(std::lround(layout.content.size().x / indexColumn)));
}

std::size_t pagesFor(const SheetLayout& layout, std::size_t rows, float height, int columns) {
  const auto most = std::size_t(columns) * std::size_t(layout.content.size().y / height);
  return (rows + most - 1) / most;
}

}  // namespace

std::size_t contentsPages(const SheetLayout& layout, std::size_t entries) {
  return pagesFor(layout, entries, contentsRow, 1);
}

std::size_t indexPages(const SheetLayout& layout, std::size_t entries) {
  return pagesFor(layout, entries, indexRow, indexColumns(layout));
}

std::vector<QString> setContents(const LessonSetting& setting, const QString& heading,
                                 const std::vector<ContentsEntry>& entries) {
  std::vector<QString> shortened;
  Rows rows(setting, heading, contentsRow, 1);
  for (const ContentsEntry& entry : entries) {
    const glm::vec2 at = rows.next();
    const float baseline = at.y + 0.5f * (contentsRow + capHeightMm(contentsPoints));
    const float number =
        setPageNumber(setting, entry.page, {at.x + rows.width(), baseline}, contentsPoints);
    const float room = rows.width() - number - gap;
    const QString fitted = elidedText(entry.text, contentsPoints, room);
    if (fitted != entry.text)
      shortened.push_back(entry.text);
    setLine(setting.pages.painter(), fitted, {at.x, baseline}, contentsPoints);
    const float end = textWidthMm(fitted, contentsPoints) + gap;
    if (end < room)
      setRule(setting.pages.painter(), {at.x + end, baseline}, room - end, 0.1f);
    setting.links.push_back(
        {pageNow(setting), {at, at + glm::vec2(room, contentsRow)}, entry.page});
  }
  return shortened;
}

std::vector<IndexEntry> sortedIndex(std::vector<IndexEntry> entries, const std::string& language) {
  QCollator order(language.empty() ? QLocale(QLocale::English)
                                   : QLocale(QString::fromStdString(language)));
  order.setCaseSensitivity(Qt::CaseInsensitive);
  order.setNumericMode(true);
  std::stable_sort(entries.begin(), entries.end(), [&](const IndexEntry& a, const IndexEntry& b) {
    const int compared = order.compare(a.name, b.name);
    return compared != 0 ? compared < 0 : a.name < b.name;
  });
  std::vector<IndexEntry> sorted;
  for (IndexEntry& entry : entries)
    if (!sorted.empty() && sorted.back().name == entry.name)
      sorted.back().pages.merge(entry.pages);
    else
      sorted.push_back(std::move(entry));
  return sorted;
}

std::vector<QString> setIndex(const LessonSetting& setting, const QString& heading,
                              const std::vector<IndexEntry>& entries) {
  std::vector<QString> shortened;
  Rows rows(setting, heading, indexRow, indexColumns(setting.layout));
  for (const IndexEntry& entry : entries) {
    const glm::vec2 at = rows.next();
    const float baseline = at.y + 0.5f * (indexRow + capHeightMm(indexPoints));
    float x = at.x + rows.width();
    // From the last on, as their right ends are in line.
    for (auto page = entry.pages.rbegin(); page != entry.pages.rend(); ++page) {
      x -= setPageNumber(setting, *page, {x, baseline}, indexPoints);
      if (std::next(page) == entry.pages.rend())
        break;
      const QString comma = QStringLiteral(", ");
      x -= textWidthMm(comma, indexPoints);
      setLine(setting.pages.painter(), comma, {x, baseline}, indexPoints);
    }
    const float room = std::max(x - gap - at.x, 20.0f);
    const QString fitted = elidedText(entry.name, indexPoints, room);
    if (fitted != entry.name)
      shortened.push_back(entry.name);
    setLine(setting.pages.painter(), fitted, {at.x, baseline}, indexPoints);
  }
  return shortened;
}

}  // namespace sline::render
