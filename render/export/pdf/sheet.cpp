// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet.h"

#include <algorithm>
#include <map>

#include "model/scene/label_words.h"
#include "render/export/pdf/patient_text.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/picture_pages.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_lists.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/pdf/sheet_pictures.h"
#include "render/export/pdf/sheet_words.h"
#include "render/export/pdf/sources_page.h"
#include "render/export/pdf/style_samples.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/legend.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float titlePoints = 18.0f;
constexpr float leastTitlePoints = 10.0f;

Result<VectorDrawing> drawFigure(const ExportOrder& order, const std::filesystem::path& target,
                                 const ExportProgress& progress) {
  bool wanted = true;
  Result<VectorDrawing> drawing = drawVectors(
      order.scene, order.camera, {.sizeMm = order.page.sizeMm, .environment = order.environment},
      [&](double share, std::string_view what) {
        wanted = wanted && (!progress || progress(0.8 * share, what));
      });
  wanted = wanted && (!progress || progress(0.8, "setting the pages"));
  if (drawing.ok() && !wanted)
    return givenUp(target);
  return drawing;
}

void setPlate(QPainter& painter, const FigurePlate& plate) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (plate.labels)
    paintLettering(painter, letteringOf(*plate.labels), setText);
  paintLettering(painter, plate.marks.lettering, setText);
}

/// Takes the line of sources from a figure that has a page of them.
void withoutSourcesLine(ExportOrder& order) {
  if (order.sources == SourceCredits::page)
    order.sources = SourceCredits::off;
}

/// Makes one sheet.
class Sheet {
 public:
  explicit Sheet(const ExportOrder& order)
      : m_given(order),
        m_order(sheetFigure(order)),
        m_layout(sheetLayout(order)),
        m_words(sheetWords(order.labels.language)) {
    withoutSourcesLine(m_order);
  }

  Result<QByteArray> make(const std::filesystem::path& target, const ExportProgress& progress) {
    Result<VectorDrawing> drawing = drawFigure(m_order, target, progress);
    if (!drawing.ok())
      return drawing.error();
    m_drawing = std::move(*drawing);
    m_said = altTextOf(m_order);
    m_testSaid = altTextOf(inMode(LabelMode::numbers));
    if (const Status ready = prepare(progress); !ready.ok())
      return ready.error();
    if (progress && !progress(0.9, "setting the pages"))
      return givenUp(target);
    const std::unique_ptr<PdfPages> pages = setAll([this] {
      return std::make_unique<PdfPages>(m_layout.paper,
                                        model::firstLanguage(m_order.labels.language));
    });
    progress.note(m_notes);
    return pages->finish(fileCredit(m_given, {}), m_given.of<SheetOptions>().title);
  }

  Result<std::vector<QImage>> picture(const QImage& figure, int width,
                                      const ExportProgress& progress) {
    m_picture = &figure;
    if (const Status ready = prepare(progress); !ready.ok())
      return ready.error();
    const std::unique_ptr<PicturePages> pages =
        setAll([&] { return std::make_unique<PicturePages>(m_layout.paper, width); });
    progress.note(m_notes);
    return pages->finish();
  }

 private:
  /// Prepares all that is set besides the figure's drawing.
  Status prepare(const ExportProgress& progress) {
    m_plate = figurePlate(m_order, m_trees);
    noteOf(m_plate, progress);
    prepareNumbers(progress);
    return m_order.of<SheetOptions>().kind == SheetKind::patient ? Status(Unit{}) : prepareLegend();
  }

  /// Sets the pages twice: to count them, and with their numbers.
  template <class Begin>
  std::invoke_result_t<Begin> setAll(const Begin& begin) {
    m_total = 0;
    std::invoke_result_t<Begin> pages;
    for (const bool counting : {true, false}) {
      pages = begin();
      m_pages = pages.get();
      m_page = 0;
      setPages();
      if (counting)
        m_total = m_page;
    }
    return pages;
  }

  void setPages() {
    if (m_order.of<SheetOptions>().kind == SheetKind::patient) {
      beginPage({});
      setFigure(m_plate, m_said);
      setCaption();
      setParagraphs(m_order.of<SheetOptions>().text, m_layout.text, {});
      setSources();
      return;
    }
    setTeachingPages();
    setSources();
  }

  /// Sets whose work the surfaces are on a page of its own, where that is wanted.
  void setSources() {
    const std::string text = sourcesText(m_given.scene);
    if (m_given.sources != SourceCredits::page || text.empty())
      return;
    beginPage(QString::fromUtf8(m_words.sources));
    setParagraphs(text, m_layout.content, QString::fromUtf8(m_words.sources));
  }

  void setTeachingPages() {
    beginPage({});
    setFigure(m_plate, m_said);
    setCaption();
    const SheetRows rows = sheetRows(m_given, m_numbers.size(), m_legend);
    setList(rows.first);
    if (rows.test.empty())
      return;
    beginPage(QString::fromUtf8(m_words.selfTest));
    setFigure(plateIn(LabelMode::numbers), m_testSaid);
    setList(rows.test);
    beginPage(QString::fromUtf8(m_words.key));
    setFigure(plateIn(LabelMode::numbers), m_testSaid);
    setList(rows.key);
  }

  QString nameOf(const model::Node& node) const {
    return QString::fromStdString(structureName(node.name, m_order.labels.language)).simplified();
  }

  ExportOrder inMode(LabelMode mode) const {
    ExportOrder order = m_order;
    order.labels.mode = mode;
    return order;
  }
  FigurePlate plateIn(LabelMode mode) { return figurePlate(inMode(mode), m_trees); }

  /// Numbers the labels that have a place; on the test's page labels are numbered, so they need a
  /// place there.
  void prepareNumbers(const ExportProgress& progress) {
    const FigurePlate numbered = plateIn(LabelMode::numbers);
    if (m_order.of<SheetOptions>().kind == SheetKind::teaching)
      noteOf(numbered, progress);
    for (const ShownLabel& label : numbered.labels->labels)
      if (numbered.labels->layout.find(label.item.id))
        m_numbers.push_back(
            {label.number, QString::fromStdString(keyText(label, m_order.labels)).simplified()});
    if (!numbersInLegend(m_given) || m_order.labels.mode != LabelMode::numbers)
      return;
    for (const model::Annotation& annotation : m_order.scene.annotations())
      for (const ShownLabel& label : numbered.labels->labels)
        if (label.item.id == annotation.id && numbered.labels->layout.find(annotation.id))
          m_numberOf[std::get<model::SurfacePoint>(annotation.anchors.front()).structure] =
              label.number;
  }

  Status prepareLegend() {
    m_legend = legendRows(m_order.scene, m_given.legend);
    if (m_legend.empty() && m_given.legendInPicture())
      addNote(m_notes, {.kind = ExportNote::Kind::legendEmpty, .names = {}, .detail = {}});
    std::vector<model::NodeId> ids;
    for (const LegendRow& row : m_legend)
      ids.push_back(row.node->id);
    Result<std::vector<VectorDrawing>> samples = styleSamples(m_order, ids);
    if (!samples.ok())
      return samples.error();
    m_samples = std::move(*samples);
    for (const model::HiddenLines how : hiddenLinesShown(m_order.scene)) {
      Result<VectorDrawing> sample = hiddenLinesSample(m_order, how);
      if (!sample.ok())
        return sample.error();
      m_hiddenSamples.push_back(std::move(*sample));
    }
    return Unit{};
  }

  /// Begins a page with the title, and the kind of page at its right.
  void beginPage(const QString& kind) {
    if (m_page > 0)
      m_pages->newPage();
    ++m_page;
    QPainter& painter = m_pages->painter();
    painter.setRenderHint(QPainter::Antialiasing);
    const LabelBox& content = m_layout.content;
    const float width = content.size().x;
    const float baseline = content.low.y - 7.0f;
    constexpr float kindPoints = 11.0f;
    const QString title = QString::fromStdString(m_order.of<SheetOptions>().title).simplified();
    const bool test = kind == QString::fromUtf8(m_words.selfTest);
    const float besideTitle = kind.isEmpty() ? 0.0f : textWidthMm(kind, kindPoints) + 8.0f;
    if (!title.isEmpty()) {
      float points = titlePoints;
      while (points > leastTitlePoints && textWidthMm(title, points) > width - besideTitle)
        points -= 0.5f;
      const QString fitted = elidedText(title, points, width - besideTitle);
      if (fitted != title)
        addShortened(title);
      line(fitted, {content.low.x, baseline}, points);
    }
    if (!kind.isEmpty())
      line(kind, {content.high.x, baseline}, kindPoints, TextAnchor::end, quietInk);
    if (!title.isEmpty() || !kind.isEmpty())
      setRule(painter, {content.low.x, baseline + 2.6f}, width, 0.25f);
    if (m_total > 1)
      line(QStringLiteral("%1 / %2").arg(m_page).arg(m_total),
           {content.high.x, m_layout.paper.y - 8.5f}, 7.5f, TextAnchor::end, quietInk);
    if (test)
      setNameAndDate();
  }

  /// Notes what is missing, but not of labels that the sheet adds, as the order does not ask for
  /// them.
  void noteOf(const FigurePlate& plate, const ExportProgress& progress) const {
    progress.note(hasLabels(m_given.scene) ? plate.notes : plate.marks.notes);
  }

  void addShortened(const QString& text) {
    addNote(m_notes,
            {.kind = ExportNote::Kind::textShortened, .names = {text.toStdString()}, .detail = {}});
  }

  /// Sets lines for name and date at the foot of the test.
  void setNameAndDate() {
    const float baseline = m_layout.paper.y - 8.5f;
    float x = m_layout.content.low.x;
    for (const auto& [word, room] : {std::pair(QString::fromUtf8(m_words.name), 62.0f),
                                     std::pair(QString::fromUtf8(m_words.date), 30.0f)}) {
      constexpr float points = 8.5f;
      line(word, {x, baseline}, points, TextAnchor::start, quietInk);
      x += textWidthMm(word, points) + 2.0f;
      setRule(m_pages->painter(), {x, baseline + 0.6f}, room, 0.2f);
      x += room + 6.0f;
    }
  }

  void line(const QString& text, const glm::vec2& at, float points,
            TextAnchor anchor = TextAnchor::start, const Colour& ink = textInk) {
    setText(m_pages->painter(), {.lines = {text},
                                 .at = at,
                                 .leading = 0.0f,
                                 .points = points,
                                 .anchor = anchor,
                                 .ink = ink});
  }

  void setFigure(const FigurePlate& plate, const AltText& said) {
    m_pages->describe(said);
    const glm::vec2 spare = m_layout.figure.size() - m_order.page.sizeMm;
    const glm::vec2 corner = m_layout.figure.low + 0.5f * spare;
    QPainter& painter = m_pages->painter();
    painter.save();
    if (m_picture) {
      painter.setRenderHint(QPainter::SmoothPixmapTransform);
      painter.drawImage(QRectF(qreal(corner.x), qreal(corner.y), qreal(m_order.page.sizeMm.x),
                               qreal(m_order.page.sizeMm.y)),
                        *m_picture);
    } else {
      m_pages->place(m_drawing, {corner, {corner, corner + m_order.page.sizeMm}});
    }
    painter.translate(qreal(corner.x), qreal(corner.y));
    setPlate(painter, plate);
    painter.restore();
  }

  /// Sets what the view says below the figure; a test has none, as it might tell the answers.
  void setCaption() {
    const std::optional<Caption> caption = sheetCaption(m_given, m_layout.caption);
    if (!caption)
      return;
    setText(m_pages->painter(), *caption->item.text);
    if (caption->shortened)
      addShortened(plainText(caption->item.text->lines.front()));
  }

  /// Counts the numbers and legend entries of a list that are already set, row by row.
  struct Progress {
    std::size_t number = 0;
    std::size_t legend = 0;
    std::size_t hidden = 0;
  };

  void setList(const std::vector<RowKind>& kinds) {
    const std::vector<RowPosition> places = flowIntoColumns(kinds, m_layout.lists);
    std::size_t page = 0;
    Progress progress;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      for (; page < places[i].page; ++page)
        beginPage(QString::fromUtf8(m_words.continued));
      SheetRow row = rowOf(kinds[i], progress);
      if (kinds[i] == RowKind::heading)
        row.text =
            QString::fromUtf8(kinds[i + 1] == RowKind::number ? m_words.labels : m_words.legend);
      const LabelBox& frame = page == 0 ? m_layout.lists.first : m_layout.lists.next;
      const int columns = page == 0 ? m_layout.lists.firstColumns : m_layout.lists.nextColumns;
      if (!setRow(*m_pages, row, places[i].at, columnWidth(frame, columns)))
        addShortened(row.text);
    }
  }

  SheetRow rowOf(RowKind kind, Progress& progress) const {
    SheetRow row{.kind = kind};
    if (kind == RowKind::group) {
      row.text = nameOf(*m_order.scene.find(m_legend[progress.legend].node->parent));
    } else if (kind == RowKind::legend) {
      const model::Node& node = *m_legend[progress.legend].node;
      const auto number = m_numberOf.find(node.id);
      row.text = nameOf(node);
      row.number = number == m_numberOf.end() ? 0 : number->second;
      row.indented = !m_numberOf.empty();
      row.colour = m_order.scene.resolve(node.id).colour;
      row.sample = &m_samples[progress.legend++];
    } else if (kind == RowKind::hidden) {
      row.text = QString::fromUtf8(m_words.hiddenOutline);
      row.indented = !m_numberOf.empty();
      row.sample = &m_hiddenSamples[progress.hidden++];
    } else if (kind != RowKind::heading) {
      row.number = m_numbers[progress.number].number;
      row.text = m_numbers[progress.number++].text;
    }
    return row;
  }

  void setParagraphs(const std::string& text, LabelBox frame, const QString& kind);

  const ExportOrder& m_given;
  ExportOrder m_order;  ///< that of the figure
  SheetLayout m_layout;
  const SheetWords& m_words;
  model::MeshTrees m_trees;
  VectorDrawing m_drawing;            ///< the figure
  const QImage* m_picture = nullptr;  ///< shown in its place
  FigurePlate m_plate;
  AltText m_said;      ///< what the figure shows
  AltText m_testSaid;  ///< and what it shows on a test
  struct Number {
    int number;
    QString text;
  };
  std::vector<Number> m_numbers;
  std::map<model::NodeId, int> m_numberOf;  ///< the numbers that the legend shows
  std::vector<LegendRow> m_legend;
  std::vector<VectorDrawing> m_samples;
  std::vector<VectorDrawing> m_hiddenSamples;  ///< in the order of `hiddenLinesShown`
  SheetPages* m_pages = nullptr;
  ExportNotes m_notes;
  int m_page = 0;
  int m_total = 0;
};

/// Sets a text into the frame and over as many further pages of that kind as it needs.
void Sheet::setParagraphs(const std::string& text, LabelBox frame, const QString& kind) {
  const qreal scale = qreal(patientPoints * millimetresPerPoint) / labelFontPixels;
  float y = frame.low.y;
  const auto needLine = [&] {
    if (y + patientLeading <= frame.high.y)
      return;
    beginPage(kind);
    frame = m_layout.content;
    y = frame.low.y;
  };
  for (const auto& paragraph : patientParagraphs(text, frame.size().x)) {
    for (int i = 0; paragraph && i < paragraph->lineCount(); ++i) {
      needLine();
      const QTextLine one = paragraph->lineAt(i);
      QPainter& painter = m_pages->painter();
      painter.save();
      painter.setPen(painterColour(textInk));
      painter.translate(qreal(frame.low.x), qreal(y));
      painter.scale(scale, scale);
      one.draw(&painter, QPointF(0.0, -one.y()));
      painter.restore();
      y += patientLeading;
    }
    y += patientParagraphSpace;
  }
}

}  // namespace

Result<QByteArray> sheetDocument(const ExportOrder& order, const std::filesystem::path& target,
                                 const ExportProgress& progress) {
  if (const auto fault = model::cameraFault(order.camera))
    return Error{.where = "camera", .reason = std::string(*fault), .remedy = "Correct the camera"};
  return Sheet(order).make(target, progress);
}

Result<std::vector<QImage>> sheetPictures(const ExportOrder& order, const QImage& figure, int width,
                                          ExportNotes* notes) {
  if (const auto fault = model::cameraFault(order.camera))
    return Error{.where = "camera", .reason = std::string(*fault), .remedy = "Correct the camera"};
  const auto goOn = [](double, std::string_view) { return true; };
  return Sheet(order).picture(figure, width, {goOn, notes});
}

Result<QByteArray> figureDocument(const ExportOrder& order, const std::filesystem::path& target,
                                  const ExportProgress& progress) {
  const Result<VectorDrawing> drawing = drawFigure(order, target, progress);
  if (!drawing.ok())
    return drawing.error();
  PdfPages pages(order.page.sizeMm, model::firstLanguage(order.labels.language));
  pages.place(*drawing, {{}, {{}, order.page.sizeMm}});
  pages.describe(altTextOf(order));
  ExportOrder figure = order;
  withoutSourcesLine(figure);
  const FigurePlate plate = figurePlate(figure);
  progress.note(plate.notes);
  setPlate(pages.painter(), plate);
  setSourcesPage(pages, order);
  return pages.finish(fileCredit(order, {}));
}

}  // namespace sline::render
