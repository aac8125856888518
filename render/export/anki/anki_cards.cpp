// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_cards.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/export/anki/anki_options.h"
#include "render/export/anki/card_painter.h"
#include "render/export/description/alt_text.h"
#include "render/export/order/sheet_words.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/shown_questions.h"
#include "render/lettering/typesetting.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

AnkiDeck emptyDeck(const ExportOrder& order) {
  AnkiDeck deck;
  const std::string& name = order.of<AnkiOptions>().deck;
  deck.name = !name.empty()                                      ? name
              : !order.viewName.empty() && !wantsAllViews(order) ? order.viewName
                                                                 : "Anatomy";
  deck.description = fileCredit(order, {}).line();
  return deck;
}

/// Makes the cards of one deck, view by view.
class Cards {
 public:
  Cards(const ExportOrder& order, HeadlessPicture& painter, const ExportProgress& progress)
      : m_order(order),
        m_words(sheetWords(order.labels.language)),
        m_painter(painter),
        m_progress(progress),
        m_deck(emptyDeck(order)) {}

  Result<AnkiDeck> make() {
    if (!hasCards(m_order.of<AnkiOptions>()))
      return Error{.reason = "no kind of card is wanted",
                   .remedy =
                       "Choose what cards ask: what something is, its number, or which name "
                       "is covered"};
    if (!wantsAllViews(m_order)) {
      TRY(addView(m_order, {}));
    } else {
      const std::vector<model::View>& views = m_order.scene.views();
      m_share = 1.0 / double(views.size());
      for (const model::View& view : views) {
        const ExportOrder one = pictureOfView(m_order, view);
        TRY(addView(one, titleOfView(view, language(), model::knownSides(one.scene))));
        m_done += m_share;
      }
    }
    if (m_deck.notes.empty())
      return Error{.reason = "the picture has no labels to ask for",
                   .remedy = "Label structures, or choose a view that shows some"};
    return std::move(m_deck);
  }

 private:
  using Ids = std::set<model::AnnotationId>;

  std::string language() const { return model::firstLanguage(m_order.labels.language); }

  bool goesOn(double share, const std::string& what) const {
    return !m_progress || m_progress(0.95 * (m_done + m_share * share), what);
  }

  /// Adds a picture; its name is derived from its bytes.
  std::string picture(std::string png) {
    std::string name = "sline-" + hexOf(fingerprintOf(png)) + ".png";
    if (m_names.insert(name).second)
      m_deck.media.push_back({name, std::move(png)});
    return name;
  }
  Status addPicture(Result<std::string> png, std::string& name) {
    if (!png.ok())
      return png.error();
    name = picture(std::move(*png));
    return Unit{};
  }

  /// Draws the picture with its marks, without any label.
  Status drawGround(const ExportOrder& order, const Marks& marks, std::string& name) {
    const glm::ivec2 size = cardPixels(order.page);
    const Image drawn =
        TRY(m_painter->render(order.scene, order.camera,
                              {.width = size.x, .height = size.y, .environment = order.environment},
                              samplesAtOnce(size)));
    return addPicture(CardPainter(order).ground(drawn, marks), name);
  }

  /// Holds what the cards of one view share.
  struct Sheet {
    ExportOrder order;  ///< with the labels that are asked for, and letters for phones
    LabelPlate named;
    std::map<model::AnnotationId, int> numbers;
    std::string ground;
    std::string numbered;  ///< what stands over the ground where numbers do
    std::string shows;     ///< in words that name nothing
  };

  Status addView(const ExportOrder& order, const std::string& title) {
    if (!goesOn(0.0, "preparing surfaces"))
      return givenUp({});
    ShownQuestions asking = shownQuestions(order, m_trees);
    std::vector<model::Question>& questions = asking.questions;
    m_progress.note(asking.notes);
    Sheet sheet{.order = forPhones(askedAlone(order, questions))};
    sheet.order.labels.mode = LabelMode::on;
    sheet.order.words = {};  // they might tell the answers
    if (!title.empty())
      sheet.order.marks.viewName = false;  // its deck is called so
    const FigurePlate plate = figurePlate(sheet.order, m_trees, {.anywhere = true});
    sheet.named = *plate.labels;
    for (ExportNote note : plate.notes) {
      if (note.kind == ExportNote::Kind::labelsWithoutRoom)
        note.kind = ExportNote::Kind::cardsWithoutRoom;
      m_progress.note(std::move(note));
    }
    if (questions.empty() || plate.labels->layout.labels.empty())
      return Unit{};
    TRY(drawGround(sheet.order, plate.marks, sheet.ground));
    ExportOrder asked = sheet.order;
    asked.labels.mode = LabelMode::numbers;  // a question names nothing
    sheet.shows = altTextOf(asked).text;
    TRY(addNumbers(sheet, questions));
    addPart(order, title);
    for (std::size_t i = 0; i < questions.size(); ++i) {
      if (!goesOn(0.2 + 0.75 * double(i) / double(questions.size()),
                  "drawing card " + std::to_string(i + 1)))
        return givenUp({});
      TRY(addQuestion(sheet, questions[i]));
    }
    return Unit{};
  }

  void addPart(const ExportOrder& order, const std::string& title) {
    AnkiPart part{.title = title, .tags = {"Sline"}};
    const auto taken = [&](const std::string& name) {
      return std::any_of(m_deck.parts.begin(), m_deck.parts.end(),
                         [&name](const AnkiPart& each) { return each.title == name; });
    };
    for (int i = 2; taken(part.title); ++i)
      part.title = title + ' ' + std::to_string(i);
    if (!order.viewName.empty())
      part.tags.push_back(ankiTag(order.viewName));
    m_deck.parts.push_back(std::move(part));
  }

  /// Adds the picture with numbers, in whose order the questions come.
  Status addNumbers(Sheet& sheet, std::vector<model::Question>& questions) {
    if (!sheet.order.of<AnkiOptions>().findIt)
      return Unit{};
    ExportOrder order = sheet.order;
    order.labels.mode = LabelMode::numbers;
    const FigurePlate plate = figurePlate(order, m_trees, {.whole = true});
    for (const ShownLabel& label : plate.labels->labels)
      if (plate.labels->layout.find(label.item.id))
        sheet.numbers[label.item.id] = label.number;
    putInOrderOfNumbers(questions, *plate.labels);
    return addPicture(CardPainter(order).labels(*plate.labels), sheet.numbered);
  }

  /// Adds a note for each of the labels that has a place; that of the first asks for the numbers of
  /// all.
  Status addQuestion(const Sheet& sheet, const model::Question& question) {
    const Ids labels(question.labels.begin(), question.labels.end());
    std::set<int> found;
    for (const model::AnnotationId id : question.labels)
      if (const auto number = sheet.numbers.find(id); number != sheet.numbers.end())
        found.insert(number->second);
    std::string numbers;
    for (const int number : found)
      numbers += (numbers.empty() ? "" : ", ") + std::to_string(number);
    for (const model::AnnotationId id : question.labels) {
      const auto shown = std::find_if(sheet.named.labels.begin(), sheet.named.labels.end(),
                                      [id](const ShownLabel& each) { return each.item.id == id; });
      if (shown == sheet.named.labels.end() || !sheet.named.layout.find(id))
        continue;
      AnkiNote note{.part = m_deck.parts.size() - 1};
      note.id = hexOf(fingerprintOf(m_deck.name + '\n' + sheet.order.viewName + '\n' +
                                    std::to_string(id.value) + '\n' + shown->text));
      note.label = question.words;
      TRY(addFaces(note, sheet, id, labels));
      if (!numbers.empty()) {
        note.numbered = {question.words + ": " + m_words.whichNumber, sheet.ground, sheet.numbered,
                         sheet.shows};
        note.numbers = std::exchange(numbers, {});
      }
      if (!note.marked.empty() || !note.numbered.empty() || !note.covered.empty())
        m_deck.notes.push_back(std::move(note));
    }
    return Unit{};
  }

  Status addFaces(AnkiNote& note, const Sheet& sheet, model::AnnotationId id, const Ids& labels) {
    const auto& wanted = sheet.order.of<AnkiOptions>();
    const CardPainter painter(sheet.order);
    const LabelPlate alone = onlyThose(sheet.named, {id});
    note.named.ground = sheet.ground;
    // An answer names what it answers alone: others are asked for later.
    if (!sheet.shows.empty())
      note.named.shows = sheet.shows + ' ' + note.label;
    TRY(addPicture(painter.labels(alone), note.named.over));
    if (wanted.nameIt) {
      note.marked = {m_words.whatIsMarked, sheet.ground, {}, sheet.shows};
      TRY(addPicture(painter.question(alone, {id}), note.marked.over));
    }
    if (!wanted.cover)
      return Unit{};
    // Others of the same name would tell it.
    Ids shown{id};
    for (const ShownLabel& label : sheet.named.labels)
      if (!labels.contains(label.item.id))
        shown.insert(label.item.id);
    note.covered = {m_words.whatIsHidden, sheet.ground, {}, sheet.shows};
    return addPicture(painter.question(onlyThose(sheet.named, shown), {id}), note.covered.over);
  }

  const ExportOrder& m_order;
  const SheetWords& m_words;
  HeadlessPicture& m_painter;
  const ExportProgress& m_progress;
  model::MeshTrees m_trees;
  AnkiDeck m_deck;
  std::set<std::string> m_names;  ///< of pictures
  double m_done = 0.0;
  double m_share = 1.0;  ///< that each view has of all
};

}  // namespace

Result<AnkiDeck> ankiCards(const ExportOrder& order, const ExportProgress& progress) {
  if (progress && !progress(0.0, "preparing surfaces"))
    return givenUp({});
  const auto typesetting = TRY(Typesetting::create());  // as long as text is set
  HeadlessPicture painter = TRY(HeadlessPicture::create());
  return Cards(order, painter, progress).make();
}

}  // namespace sline::render
