// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_setter.h"

#include <algorithm>

#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/pdf/sources_page.h"
#include "render/export/pdf/style_samples.h"
#include "render/export/plate/legend.h"
#include "render/export/plate/shown_questions.h"
#include "render/lettering/label_texts.h"
#include "render/lettering/patient_text.h"

namespace sline::render {

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

void setPlate(SheetPages& pages, const FigurePlate& plate, const glm::vec2& at) {
  const auto set = [&](const Lettering& lettering) {
    pages.leaveGaps(lettering, at);
    paintLettering(pages.painter(), lettering, setText);
  };
  pages.painter().save();
  pages.painter().setRenderHint(QPainter::Antialiasing);
  pages.painter().translate(qreal(at.x), qreal(at.y));
  set(plate.marks.lettering);
  if (plate.labels)
    set(letteringOf(*plate.labels));
  pages.painter().restore();
}

void withoutSourcesLine(ExportOrder& order) {
  if (order.sources == SourceCredits::page)
    order.sources = SourceCredits::off;
}

SheetSetter::SheetSetter(const ExportOrder& order)
    : m_given(order),
      m_order(sheetFigure(order)),
      m_layout(sheetLayout(order)),
      m_words(sheetWords(order.labels.language)) {
  withoutSourcesLine(m_order);
}

Status SheetSetter::draw(const std::filesystem::path& target, const ExportProgress& progress) {
  m_drawing = TRY(drawFigure(m_order, target, progress));
  ExportOrder said = m_order;
  if (!hasLabels(m_given.scene))  // those of the sheet are nobody's words
    said.labels.mode = LabelMode::off;
  m_said = altTextOf(said);
  ExportOrder test = m_order;
  test.labels.mode = LabelMode::numbers;
  m_testSaid = altTextOf(test);
  return prepare(progress);
}

Status SheetSetter::take(const QImage& figure, const ExportProgress& progress) {
  m_picture = &figure;
  return prepare(progress);
}

Status SheetSetter::prepare(const ExportProgress& progress) {
  m_plate = figurePlate(m_order, m_trees);
  noteOf(m_plate, progress);
  prepareNumbers(progress);
  if (m_order.of<SheetOptions>().kind == SheetKind::teaching)
    prepareTest(progress);
  return m_order.of<SheetOptions>().kind == SheetKind::patient ? Status(Unit{}) : prepareLegend();
}

bool SheetSetter::hasTest() const {
  return !m_answers.empty();
}

SheetRows SheetSetter::rows() const {
  return sheetRows(m_given, {.labels = m_numbers.size(), .asked = m_answers.size()}, m_legend);
}

void SheetSetter::setAll(SheetPages& pages, PageCount& count) {
  setFirst(pages, count);
  if (hasTest()) {
    setTest(pages, count);
    setKey(pages, count);
  }
  setSources(pages, count);
}

void SheetSetter::setSources(SheetPages& pages, PageCount& count) {
  const std::string text = sourcesText(m_given.scene);
  if (m_given.sources != SourceCredits::page || text.empty())
    return;
  m_pages = &pages;
  m_count = &count;
  const QString heading = QString::fromUtf8(m_words.sources);
  beginPage(heading);
  setParagraphs(text, m_layout.content, heading);
}

void SheetSetter::setFirst(SheetPages& pages, PageCount& count) {
  m_pages = &pages;
  m_count = &count;
  beginPage({});
  setFigure(m_plate, m_said);
  setCaption();
  if (m_order.of<SheetOptions>().kind == SheetKind::patient)
    setParagraphs(m_order.of<SheetOptions>().text, m_layout.text, {});
  else
    setList(rows().first, {.numbers = m_numbers, .words = {}});
}

void SheetSetter::setTest(SheetPages& pages, PageCount& count) {
  m_pages = &pages;
  m_count = &count;
  beginPage(QString::fromUtf8(m_words.selfTest));
  setInstruction();
  setNameAndDate();
  setFigure(m_testPlate, m_testSaid);
  const SheetRows rows = this->rows();
  setList(rows.test, {.numbers = m_answers, .words = {}});
  if (!rows.words.empty())
    setWordBank(rows);
}

/// Sets the answers in another order below the lines to write on.
void SheetSetter::setWordBank(const SheetRows& rows) {
  std::vector<std::string> answers;
  for (const Number& answer : m_answers)
    answers.push_back(answer.text.toStdString());
  ListFrames frames =
      framesBelow(rows.test, flowIntoColumns(rows.test, m_layout.lists), m_layout.lists);
  frames.first.low.y += wordBankSpace;
  const float heading = rowHeight(RowKind::heading);
  if (frames.first.size().y < heading + rowHeight(RowKind::word)) {
    beginPage(QString::fromUtf8(m_words.continued));
    frames.first = frames.next;
    frames.firstColumns = frames.nextColumns;
  }
  setRow(*m_pages, {.kind = RowKind::heading, .text = QString::fromUtf8(m_words.wordBank)},
         frames.first.low, frames.first.size().x);
  frames.first.low.y += heading;
  setRows(rows.words, frames, {.numbers = m_answers, .words = shuffledWords(answers)});
}

void SheetSetter::setKey(SheetPages& pages, PageCount& count) {
  m_pages = &pages;
  m_count = &count;
  beginPage(QString::fromUtf8(m_words.key));
  setFigure(m_testPlate, m_testSaid);
  setList(rows().key, {.numbers = m_answers, .words = {}});
}

std::vector<QString> SheetSetter::listed() const {
  std::vector<QString> names;
  if (m_order.labels.mode != LabelMode::off) {
    const LabelPlate& plate = *m_plate.labels;
    for (const ShownLabel& label : plate.labels)
      if (plate.layout.find(label.item.id) && (label.item.kind == model::AnnotationKind::label ||
                                               label.item.kind == model::AnnotationKind::pin))
        names.push_back(QString::fromStdString(plainText(label)).simplified());
    return names;
  }
  for (const LegendRow& row : m_legend)
    names.push_back(nameOf(*row.node));
  return names;
}

QString SheetSetter::nameOf(const model::Node& node) const {
  return QString::fromStdString(structureName(node, m_order.labels.language)).simplified();
}

/// Labels keep the places and numbers of the layout before.
FigurePlate SheetSetter::numbered(const ExportOrder& shown, const LabelLayout* before) {
  ExportOrder order = shown;
  order.labels.mode = LabelMode::numbers;
  return figurePlate(order, m_trees, {.before = before});
}

/// Numbers the labels that have a place.
void SheetSetter::prepareNumbers(const ExportProgress& progress) {
  const FigurePlate plate = numbered(m_order);
  if (m_order.of<SheetOptions>().kind == SheetKind::teaching)
    noteOf(plate, progress);
  m_numbered = plate.labels->layout;
  for (const ShownLabel& label : plate.labels->labels)
    if (plate.labels->layout.find(label.item.id))
      m_numbers.push_back(
          {label.number,
           QString::fromStdString(keyLine(m_order.scene, label, m_order.labels)).simplified()});
  if (!numbersInLegend(m_given) || m_order.labels.mode != LabelMode::numbers)
    return;
  for (const model::Annotation& annotation : m_order.scene.annotations())
    for (const ShownLabel& label : plate.labels->labels)
      if (label.item.id == annotation.id && plate.labels->layout.find(annotation.id))
        m_numberOf[std::get<model::SurfacePoint>(annotation.anchors.front()).structure] =
            label.number;
}

/// Numbers what the test asks for as the first page does.
void SheetSetter::prepareTest(const ExportProgress& progress) {
  const ShownQuestions shown = shownQuestions(m_order, m_trees);
  const std::vector<model::Question>& questions = shown.questions;
  progress.note(shown.notes);
  m_testPlate = numbered(askedAlone(m_order, questions), &m_numbered);
  std::map<model::AnnotationId, const model::Question*> asked;
  for (const model::Question& question : questions)
    for (const model::AnnotationId id : question.labels)
      asked[id] = &question;
  for (const ShownLabel& label : m_testPlate.labels->labels)
    if (const auto question = asked.find(label.item.id);
        question != asked.end() && m_testPlate.labels->layout.find(label.item.id))
      m_answers.push_back(
          {label.number, QString::fromStdString(question->second->words).simplified()});
}

Status SheetSetter::prepareLegend() {
  m_legend = legendRows(m_order.scene, m_given.legend);
  if (m_legend.empty() && m_given.legendInPicture())
    addNote(m_notes, {.kind = ExportNote::Kind::legendEmpty, .names = {}, .detail = {}});
  std::vector<model::NodeId> ids;
  for (const LegendRow& row : m_legend)
    ids.push_back(row.node->id);
  m_samples = TRY(styleSamples(m_order, ids));
  for (const model::HiddenLines how : hiddenLinesShown(m_order.scene)) {
    VectorDrawing sample = TRY(hiddenLinesSample(m_order, how));
    m_hiddenSamples.push_back(std::move(sample));
  }
  return Unit{};
}

void SheetSetter::beginPage(const QString& kind) {
  const QString title = QString::fromStdString(m_order.of<SheetOptions>().title).simplified();
  if (!beginSheetPage(*m_pages, *m_count, m_layout, {title, kind}))
    addShortened(title);
}

void SheetSetter::noteOf(const FigurePlate& plate, const ExportProgress& progress) const {
  progress.note(hasLabels(m_given.scene) ? plate.notes : plate.marks.notes);
}

void SheetSetter::addShortened(const QString& text) {
  addNote(m_notes,
          {.kind = ExportNote::Kind::textShortened, .names = {text.toStdString()}, .detail = {}});
}

/// Sets lines for name and date at the foot of the test.
void SheetSetter::setNameAndDate() {
  const float baseline = m_layout.paper.y - 8.5f;
  float x = m_layout.content.low.x;
  for (const auto& [word, room] : {std::pair(QString::fromUtf8(m_words.name), 62.0f),
                                   std::pair(QString::fromUtf8(m_words.date), 30.0f)}) {
    constexpr float points = 8.5f;
    setQuietLine(painter(), word, {x, baseline}, points);
    x += textWidthMm(word, points) + 2.0f;
    setRule(painter(), {x, baseline + 0.6f}, room, 0.2f);
    x += room + 6.0f;
  }
}

/// Says above the test's figure what is to be done.
void SheetSetter::setInstruction() {
  const LabelBox& box = m_layout.instruction;
  const QString text = QString::fromUtf8(m_order.of<TestOptions>().wordBank ? m_words.chooseNames
                                                                            : m_words.writeNames);
  float points = 9.5f;
  while (points > 7.0f && textWidthMm(text, points) > box.size().x)
    points -= 0.5f;
  const QString fitted = elidedText(text, points, box.size().x);
  if (fitted != text)
    addShortened(text);
  setLine(painter(), fitted, {box.low.x, box.low.y + capHeightMm(points)}, points);
}

void SheetSetter::setFigure(const FigurePlate& plate, const AltText& said) {
  m_pages->describe(said);
  const glm::vec2 spare = m_layout.figure.size() - m_order.page.sizeMm;
  const glm::vec2 corner = m_layout.figure.low + 0.5f * spare;
  if (m_picture) {
    QPainter& painter = m_pages->painter();
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(qreal(corner.x), qreal(corner.y), qreal(m_order.page.sizeMm.x),
                             qreal(m_order.page.sizeMm.y)),
                      *m_picture);
    painter.restore();
  } else {
    m_pages->place(m_drawing, {corner, {corner, corner + m_order.page.sizeMm}});
  }
  setPlate(*m_pages, plate, corner);
}

/// Sets what the view says below the figure; a test has none, as it might tell the answers.
void SheetSetter::setCaption() {
  const std::optional<Caption> caption = sheetCaption(m_given, m_layout.caption);
  if (!caption) {
    if (hasCaption(m_given))
      addNote(m_notes,
              {.kind = ExportNote::Kind::marksWithoutRoom, .names = {"caption"}, .detail = {}});
    return;
  }
  setText(m_pages->painter(), *caption->item.text);
  if (caption->shortened)
    addShortened(plainText(caption->item.text->lines.front()));
}

QString SheetSetter::headingOf(RowKind first) const {
  return QString::fromUtf8(first == RowKind::number ? m_words.labels : m_words.legend);
}

void SheetSetter::setList(const std::vector<RowKind>& kinds, const ListWords& words) {
  setRows(kinds, m_layout.lists, words);
}

void SheetSetter::setRows(const std::vector<RowKind>& kinds, const ListFrames& frames,
                          const ListWords& words) {
  const std::vector<RowPosition> places = flowIntoColumns(kinds, frames);
  std::size_t page = 0;
  ListProgress progress;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (; page < places[i].page; ++page)
      beginPage(QString::fromUtf8(m_words.continued));
    SheetRow row = rowOf(kinds[i], progress, words);
    if (kinds[i] == RowKind::heading)
      row.text = headingOf(kinds[i + 1]);
    const LabelBox& frame = page == 0 ? frames.first : frames.next;
    const int columns = page == 0 ? frames.firstColumns : frames.nextColumns;
    if (!setRow(*m_pages, row, places[i].at, columnWidth(frame, columns)))
      addShortened(row.text);
  }
}

SheetRow SheetSetter::rowOf(RowKind kind, ListProgress& progress, const ListWords& words) const {
  SheetRow row{.kind = kind};
  if (kind == RowKind::group) {
    const model::Node* group = m_order.scene.find(m_legend[progress.legend].node->parent);
    row.text = group ? nameOf(*group) : QString::fromUtf8(m_words.otherStructures);
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
  } else if (kind == RowKind::word) {
    row.text = QString::fromStdString(words.words[progress.word++]);
  } else if (kind != RowKind::heading) {
    row.number = words.numbers[progress.number].number;
    row.text = words.numbers[progress.number++].text;
  }
  return row;
}

/// Sets a text into the frame and over as many further pages of that kind as it needs.
void SheetSetter::setParagraphs(const std::string& text, LabelBox frame, const QString& kind) {
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

}  // namespace sline::render
