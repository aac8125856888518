// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/lesson.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/pdf/lesson_lists.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/pdf/sheet_setter.h"
#include "render/export/pdf/sources_page.h"

namespace sline::render {

namespace {

/// Holds one view's sheet, and the pages of its parts, counted from 0.
struct LessonPart {
  explicit LessonPart(ExportOrder sheet) : order(std::move(sheet)), setter(order) {}

  const ExportOrder order;
  SheetSetter setter;
  std::size_t first = 0;
  std::size_t test = 0;
  std::size_t key = 0;
};

class Lesson {
 public:
  explicit Lesson(const ExportOrder& order)
      : m_order(order),
        m_language(model::firstLanguage(order.labels.language)),
        m_words(sheetWords(m_language)),
        m_title(QString::fromStdString(order.of<SheetOptions>().title).simplified()) {}

  Result<QByteArray> make(const std::filesystem::path& target, const ExportProgress& progress) {
    TRY(draw(target, progress));
    if (progress && !progress(0.9, "setting the pages"))
      return givenUp(target);
    std::unique_ptr<PdfPages> pages;
    // Once to count the pages, and once with their numbers.
    for (const bool counting : {true, false}) {
      pages = std::make_unique<PdfPages>(m_parts.front()->setter.layout().paper, m_language);
      m_navigation = {};
      PageCount count{.page = 0, .total = counting ? 0 : m_total};
      setPages(*pages, count);
      m_total = count.page;
    }
    for (const auto& part : m_parts)
      progress.note(part->setter.notes());
    progress.note(m_notes);
    return pages->finish(fileCredit(m_order, {}), m_order.of<SheetOptions>().title,
                         std::move(m_navigation));
  }

 private:
  Status draw(const std::filesystem::path& target, const ExportProgress& progress) {
    const std::vector<model::View>& views = m_order.scene.views();
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (const auto fault = model::cameraFault(views[i].camera))
        return Error{.where = "camera of the view " + views[i].name,
                     .reason = std::string(*fault),
                     .remedy = "Correct the camera"};
      ExportNotes notes;
      const auto tell = [&](double share, std::string_view what) {
        return !progress || progress(0.9 * (double(i) + share) / double(views.size()), what);
      };
      m_parts.push_back(std::make_unique<LessonPart>(lessonSheet(m_order, views[i])));
      TRY(m_parts.back()->setter.draw(target, {tell, &notes}));
      progress.note(notes);
    }
    return Unit{};
  }

  void setPages(SheetPages& pages, PageCount& count) {
    const LessonSetting setting{.pages = pages,
                                .count = count,
                                .layout = m_parts.front()->setter.layout(),
                                .links = m_navigation.links,
                                .title = m_title};
    bookmark(m_words.contents, 0, false);
    noteShortened(setContents(setting, QString::fromUtf8(m_words.contents), contents()));
    const bool keysLast = m_order.of<TestOptions>().key == KeyPlace::end;
    for (const auto& part : m_parts) {
      part->first = std::size_t(count.page);
      bookmark(part->order.of<SheetOptions>().title, part->first, false);
      part->setter.setFirst(pages, count);
      if (!part->setter.hasTest())
        continue;
      part->test = std::size_t(count.page);
      bookmark(m_words.selfTest, part->test, true);
      part->setter.setTest(pages, count);
      if (!keysLast)
        setKey(*part, pages, count);
    }
    m_keys = std::size_t(count.page);
    if (keysLast && hasTests()) {
      bookmark(m_words.key, m_keys, false);
      for (const auto& part : m_parts)
        if (part->setter.hasTest())
          setKey(*part, pages, count);
    }
    m_sources = std::size_t(count.page);
    m_parts.front()->setter.setSources(pages, count);
    if (hasSources())
      bookmark(m_words.sources, m_sources, false);
    m_index = std::size_t(count.page);
    const std::vector<IndexEntry> entries = index();
    if (entries.empty())
      return;
    bookmark(m_words.index, m_index, false);
    noteShortened(setIndex(setting, QString::fromUtf8(m_words.index), entries));
  }

  void setKey(LessonPart& part, SheetPages& pages, PageCount& count) {
    part.key = std::size_t(count.page);
    const bool last = m_order.of<TestOptions>().key == KeyPlace::end;
    bookmark(last ? part.order.of<SheetOptions>().title : m_words.key, part.key, true);
    part.setter.setKey(pages, count);
  }

  bool hasTests() const {
    return std::any_of(m_parts.begin(), m_parts.end(),
                       [](const auto& part) { return part->setter.hasTest(); });
  }

  bool hasSources() const {
    return m_order.sources == SourceCredits::page && !sourcesText(m_order.scene).empty();
  }

  std::vector<ContentsEntry> contents() const {
    std::vector<ContentsEntry> entries;
    for (const auto& part : m_parts)
      entries.push_back(
          {QString::fromStdString(part->order.of<SheetOptions>().title).simplified(), part->first});
    if (hasTests() && m_order.of<TestOptions>().key == KeyPlace::end)
      entries.push_back({QString::fromUtf8(m_words.key), m_keys});
    if (hasSources())
      entries.push_back({QString::fromUtf8(m_words.sources), m_sources});
    if (!index().empty())
      entries.push_back({QString::fromUtf8(m_words.index), m_index});
    return entries;
  }

  std::vector<IndexEntry> index() const {
    std::vector<IndexEntry> entries;
    for (const auto& part : m_parts)
      for (const QString& name : part->setter.listed())
        entries.push_back({name, {part->first}});
    return sortedIndex(std::move(entries), m_language);
  }

  void bookmark(const std::string& title, std::size_t page, bool inner) {
    m_navigation.bookmarks.push_back(
        {QString::fromStdString(title).simplified().toStdString(), page, inner});
  }

  void noteShortened(const std::vector<QString>& texts) {
    for (const QString& text : texts)
      addNote(
          m_notes,
          {.kind = ExportNote::Kind::textShortened, .names = {text.toStdString()}, .detail = {}});
  }

  const ExportOrder& m_order;
  std::string m_language;
  const SheetWords& m_words;
  QString m_title;
  std::vector<std::unique_ptr<LessonPart>> m_parts;
  PdfNavigation m_navigation;
  ExportNotes m_notes;
  std::size_t m_keys = 0;
  std::size_t m_index = 0;
  std::size_t m_sources = 0;
  int m_total = 0;
};

/// Returns the width that labels take at either side of a figure, millimetres.
float labelColumn(SheetKind kind, LabelMode mode) {
  constexpr float words = 32.0f;
  constexpr float numbers = 10.0f;
  const bool asKind = mode == LabelMode::off;
  if (mode == LabelMode::numbers || (asKind && kind == SheetKind::teaching))
    return numbers;
  return asKind && kind != SheetKind::patient ? 0.0f : words;
}

}  // namespace

ExportOrder lessonSheet(const ExportOrder& order, const model::View& view) {
  ExportOrder one = orderOfView(order, view);
  auto& sheet = one.of<SheetOptions>();
  if (sheet.kind == SheetKind::none) {
    sheet.kind = SheetKind::figure;
    if (one.legend == LegendList::onSheets)
      one.legend = LegendList::none;
  }
  sheet.title =
      titleOfView(view, model::firstLanguage(order.labels.language), model::knownSides(one.scene));
  one.words.title = {};  // it is the sheet's
  one.marks.viewName = false;
  one.page.sizeMm = sheetFigureMm(one);
  const float room = one.page.sizeMm.x - 2.0f * labelColumn(sheet.kind, one.labels.mode);
  one.camera = fittedToPage(one.scene, one.camera, room / one.page.sizeMm.y);
  return one;
}

std::size_t lessonPages(const ExportOrder& order) {
  std::size_t pages = 0;
  std::size_t entries = order.scene.views().size() + 1;  // with the index
  std::set<std::string> names;
  std::optional<SheetLayout> lists;
  bool keys = false;
  for (const model::View& view : order.scene.views()) {
    const ExportOrder sheet = lessonSheet(order, view);
    const SheetLayout layout = sheetLayout(sheet);
    const LabelCounts counts = labelCounts(sheet);
    const SheetRows rows = sheetRows(sheet, counts, legendRows(sheet.scene, sheet.legend));
    const auto pagesOf = [&layout](const std::vector<RowKind>& list) {
      return list.empty() ? 1 : flowIntoColumns(list, layout.lists).back().page + 1;
    };
    pages += pagesOf(rows.first);
    if (!rows.test.empty())
      pages += pagesOf(rows.test) + pagesOf(rows.key);
    if (!rows.words.empty()) {
      const auto places = flowIntoColumns(rows.test, layout.lists);
      pages +=
          flowIntoColumns(rows.words, framesBelow(rows.test, places, layout.lists)).back().page;
    }
    keys = keys || !rows.test.empty();
    for (const model::Question& question : model::questionsOf(sheet.scene, sheet.labels.language))
      names.insert(question.words);
    if (!lists)
      lists = layout;
  }
  if (keys && order.of<TestOptions>().key == KeyPlace::end)
    ++entries;
  return lists ? pages + contentsPages(*lists, entries) +
                     std::max<std::size_t>(indexPages(*lists, names.size()), 1)
               : pages;
}

Result<QByteArray> lessonDocument(const ExportOrder& order, const std::filesystem::path& target,
                                  const ExportProgress& progress) {
  return Lesson(order).make(target, progress);
}

}  // namespace sline::render
