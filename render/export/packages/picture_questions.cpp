// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/picture_questions.h"

#include <QImage>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/export/anki/anki_deck.h"
#include "render/export/anki/card_painter.h"
#include "render/export/description/alt_text.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/packages/accepted_names.h"
#include "render/export/packages/package_options.h"
#include "render/export/packages/package_words.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/shown_questions.h"
#include "render/export/students/asked_things.h"
#include "render/lettering/typesetting.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

/// Pixels: wide enough for any page of a learning system.
constexpr glm::ivec2 largePicture{800, 600};
/// Pixels: Moodle shrinks larger pictures under markers, but not the zones on them.
constexpr glm::ivec2 markerPicture{600, 400};
constexpr std::size_t otherChoices = 3;

QImage imageOf(const Image& drawn) {
  return QImage(drawn.rgba.data(), drawn.width, drawn.height, qsizetype(4) * drawn.width,
                QImage::Format_RGBA8888)
      .convertToFormat(QImage::Format_RGBA8888_Premultiplied);
}

Result<QuestionPicture> pictureOf(Result<std::string> png, const glm::ivec2& size) {
  if (!png.ok())
    return png.error();
  return QuestionPicture{"sline-" + hexOf(fingerprintOf(*png)) + ".png", std::move(*png), size};
}

/// Returns the size of the page's shape that fits into that many pixels.
glm::ivec2 fittedSize(const glm::vec2& pageMm, const glm::ivec2& most) {
  const float scale = std::min(float(most.x) / pageMm.x, float(most.y) / pageMm.y);
  return glm::max(glm::ivec2(pageMm * scale), glm::ivec2(16));
}

/// Returns the order as it is drawn for questions: nothing written in it names anything.
ExportOrder forQuestions(const ExportOrder& order, const std::vector<model::Question>& questions) {
  ExportOrder asked = forPhones(askedAlone(order, questions));
  asked.labels.mode = LabelMode::on;
  asked.words = {};
  asked.marks.viewName = false;
  asked.marks.words = false;
  asked.marks.sectionState = false;
  asked.legend = LegendList::none;
  if (order.altText != "off")
    asked.altText.clear();  // it may name what is asked for
  return asked;
}

/// Knows names that are right answers, and such as are not.
class NameSource {
 public:
  explicit NameSource(const ExportOrder& order)
      : m_order(ofOneView(order)),
        m_words(wordsOf(m_order)),
        m_asked(askedThings(m_order, m_words)),
        m_distractors(m_order, m_words, m_asked) {}

  /// Fills in the names of what the label names.
  void fill(SheetThing& thing, model::AnnotationId label) const {
    thing.accepted = typedNames(thing.words, {});
    for (const AskedThing& each : m_asked) {
      if (std::find(each.labels.begin(), each.labels.end(), label) == each.labels.end())
        continue;
      thing.accepted = typedNames(thing.words, each.accepted);
      for (const WordsByLanguage& other : m_distractors.of(each, otherChoices)) {
        const auto said = other.find(m_words.language());
        thing.wrong.push_back((said == other.end() ? other.begin() : said)->second);
      }
      return;
    }
  }

 private:
  static PageWords wordsOf(const ExportOrder& order) {
    PageWords words(order, {});
    if (order.labels.language.empty())
      words.keepNames();
    return words;
  }
  static ExportOrder ofOneView(const ExportOrder& order) {
    ExportOrder one = order;
    one.scene.setViews({});
    return one;
  }

  ExportOrder m_order;
  PageWords m_words;
  std::vector<AskedThing> m_asked;
  Distractors m_distractors;
};

/// Makes the questions of one view.
class SheetMaker {
 public:
  SheetMaker(const ExportOrder& order, HeadlessPicture& painter, model::MeshTrees& trees)
      : m_asked(shownQuestions(order, trees)),
        m_order(forQuestions(order, m_asked.questions)),
        m_painter(painter),
        m_trees(trees) {}

  /// Returns a sheet without things where nothing that can be asked for is in the picture.
  Result<QuestionSheet> make(const std::string& title, const ExportProgress& progress) {
    QuestionSheet sheet{.title = title};
    progress.note(m_asked.notes);
    if (m_asked.questions.empty())
      return sheet;
    const FigurePlate plate = figurePlate(m_order, m_trees, {.anywhere = true});
    for (ExportNote note : plate.notes) {
      if (note.kind == ExportNote::Kind::labelsWithoutRoom)
        note.kind = ExportNote::Kind::cardsWithoutRoom;
      progress.note(std::move(note));
    }
    if (plate.labels->layout.labels.empty())
      return sheet;
    TRY(drawGrounds(sheet, plate.marks));
    TRY(addNumbers(sheet, plate.marks));
    TRY(addThings(sheet, plate));
    addOthers(sheet);
    return sheet;
  }

 private:
  Result<Image> drawn(const glm::ivec2& size) const {
    return m_painter->render(
        m_order.scene, m_order.camera,
        {.width = size.x, .height = size.y, .environment = m_order.environment},
        samplesAtOnce(size));
  }

  Status drawGrounds(QuestionSheet& sheet, const Marks& marks) {
    ExportOrder silent = m_order;
    silent.labels.mode = LabelMode::numbers;
    const AltText said = altTextOf(silent);
    sheet.shows = said.text;
    m_order.credit = fileCredit(silent, said);
    for (const auto& [most, picture] :
         {std::pair{largePicture, &sheet.ground}, std::pair{markerPicture, &sheet.small}}) {
      const glm::ivec2 size = fittedSize(m_order.page.sizeMm, most);
      const Image bare = TRY(drawn(size));
      if (picture == &sheet.ground)
        m_ground = imageOf(bare);
      *picture =
          TRY(pictureOf(paintedPng(m_order, imageOf(bare),
                                   [&marks](QPainter& painter) { paintMarks(painter, marks); }),
                        size));
    }
    return Unit{};
  }

  Status addNumbers(QuestionSheet& sheet, const Marks& marks) {
    ExportOrder order = m_order;
    order.labels.mode = LabelMode::numbers;
    const FigurePlate plate = figurePlate(order, m_trees, {.whole = true});
    for (const ShownLabel& label : plate.labels->labels)
      if (plate.labels->layout.find(label.item.id))
        m_numbers[label.item.id] = label.number;
    putInOrderOfNumbers(m_asked.questions, *plate.labels);
    sheet.numbered = TRY(pictureOf(paintedPng(order, m_ground,
                                              [&](QPainter& painter) {
                                                paintMarks(painter, marks);
                                                paintLabels(painter, *plate.labels);
                                              }),
                                   sheet.ground.size));
    return Unit{};
  }

  Status addThings(QuestionSheet& sheet, const FigurePlate& plate) {
    const NameSource names(m_order);
    const SeenMap seen(m_order.scene, pageScreen(m_order), &m_trees);
    for (const model::Question& question : m_asked.questions) {
      SheetThing thing{.words = plainWords(question)};
      const model::AnnotationId* shown = nullptr;
      for (const model::AnnotationId& id : question.labels) {
        if (!shown && plate.labels->layout.find(id))
          shown = &id;
        if (const auto number = m_numbers.find(id); number != m_numbers.end())
          thing.numbers.push_back(number->second);
      }
      if (!shown || thing.words.empty())
        continue;
      std::sort(thing.numbers.begin(), thing.numbers.end());
      thing.id = std::to_string(shown->value);
      names.fill(thing, *shown);
      thing.zone = zoneOf(seen.areaOf(question.structures), m_order.page.sizeMm);
      thing.marked = TRY(markedPicture(plate, *shown, sheet.ground.size));
      m_places.push_back(placeOf(plate, *shown));
      sheet.things.push_back(std::move(thing));
    }
    return Unit{};
  }

  static std::string plainWords(const model::Question& question) {
    std::string words = question.words;
    std::replace(words.begin(), words.end(), '\n', ' ');
    return words;
  }

  Result<QuestionPicture> markedPicture(const FigurePlate& plate, model::AnnotationId id,
                                        const glm::ivec2& size) const {
    const LabelPlate alone = onlyThose(*plate.labels, {id});
    return pictureOf(paintedPng(m_order, m_ground,
                                [&](QPainter& painter) {
                                  paintMarks(painter, plate.marks);
                                  paintQuestion(painter, alone, {id}, m_order.page.sizeMm.x);
                                }),
                     size);
  }

  static glm::vec2 placeOf(const FigurePlate& plate, model::AnnotationId id) {
    for (const ShownLabel& label : plate.labels->labels)
      if (label.item.id == id)
        return label.item.places.front();
    return {};
  }

  /// Finds what is near each.
  void addOthers(QuestionSheet& sheet) const {
    for (std::size_t i = 0; i < sheet.things.size(); ++i) {
      std::vector<std::pair<float, std::size_t>> ranked;
      for (std::size_t j = 0; j < sheet.things.size(); ++j)
        if (j != i && sheet.things[j].numbers != sheet.things[i].numbers)
          ranked.emplace_back(glm::distance(m_places[i], m_places[j]), j);
      std::sort(ranked.begin(), ranked.end());
      for (std::size_t k = 0; k < std::min(otherChoices, ranked.size()); ++k)
        sheet.things[i].others.push_back(ranked[k].second);
      std::sort(sheet.things[i].others.begin(), sheet.things[i].others.end());
    }
  }

  ShownQuestions m_asked;
  ExportOrder m_order;
  HeadlessPicture& m_painter;
  model::MeshTrees& m_trees;
  QImage m_ground;
  std::map<model::AnnotationId, int> m_numbers;
  std::vector<glm::vec2> m_places;  ///< of the things
};

QuestionBook emptyBook(const ExportOrder& order) {
  QuestionBook book;
  book.language = model::firstLanguage(order.labels.language);
  if (book.language.empty())
    book.language = "en";
  book.title = !order.viewName.empty() && !wantsAllViews(order)
                   ? order.viewName
                   : packageWords(book.language).questions;
  book.credit = fileCredit(order, {});
  book.passing = order.of<PackageOptions>().passing;
  return book;
}

}  // namespace

Result<QuestionBook> pictureQuestions(const ExportOrder& order, const ExportProgress& progress) {
  if (!questionKinds(order).any())
    return Error{.reason = "no kind of question is wanted",
                 .remedy = "Choose what is asked: where something is, or its name"};
  if (progress && !progress(0.0, "preparing surfaces"))
    return givenUp({});
  const auto typesetting = TRY(Typesetting::create());  // as long as text is set
  HeadlessPicture painter = TRY(HeadlessPicture::create());
  QuestionBook book = emptyBook(order);
  model::MeshTrees trees;
  std::vector<std::pair<std::string, ExportOrder>> views;
  if (!wantsAllViews(order))
    views.emplace_back(book.title, order);
  else
    for (const model::View& view : order.scene.views()) {
      ExportOrder one = pictureOfView(order, view);
      std::string title = titleOfView(view, book.language, model::knownSides(one.scene));
      views.emplace_back(std::move(title), std::move(one));
    }
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (progress && !progress(0.9 * double(i) / double(views.size()), "drawing questions"))
      return givenUp({});
    QuestionSheet sheet =
        TRY(SheetMaker(views[i].second, painter, trees).make(views[i].first, progress));
    for (SheetThing& thing : sheet.things)
      thing.id = "v" + std::to_string(i + 1) + "-" + thing.id;
    if (!sheet.things.empty())
      book.sheets.push_back(std::move(sheet));
  }
  if (book.sheets.empty())
    return Error{.reason = "the picture has no labels to ask for",
                 .remedy = "Label structures, or choose a view that shows some"};
  return book;
}

std::size_t questionsAtMost(const ExportOrder& order) {
  const QuestionKinds wanted = questionKinds(order);
  const std::size_t each =
      std::size_t(wanted.find) + std::size_t(wanted.name) + std::size_t(wanted.choose);
  if (!wantsAllViews(order))
    return each * questionsOf(order).size();
  std::size_t questions = 0;
  for (const model::View& view : order.scene.views())
    questions += each * questionsOf(pictureOfView(order, view)).size();
  return questions;
}

std::string numberText(const SheetThing& thing) {
  std::string text;
  for (const int number : thing.numbers)
    text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text;
}

}  // namespace sline::render
