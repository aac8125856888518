// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_deck.h"

#include <algorithm>
#include <cmath>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/drawn/surface_fill.h"
#include "render/export/description/alt_text.h"
#include "render/export/encoding/png_image.h"
#include "render/export/order/sheet_words.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/legend.h"
#include "render/export/plate/shown_questions.h"
#include "render/export/plate/source_credits.h"
#include "render/export/svg/svg_file.h"
#include "render/lettering/mark_words.h"
#include "render/lettering/typesetting.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

Colour groundOf(Background background) {
  const glm::vec4 colour =
      backgroundColour(background == Background::transparent ? Background::white : background);
  const auto part = [](float value) { return std::uint8_t(std::lround(255.0f * value)); };
  return {part(colour.r), part(colour.g), part(colour.b)};
}

SlideWords wordsIn(const model::Wording& wording, const std::string& language) {
  return {wording.in(language), wording.texts.contains(language) ? language : std::string()};
}

/// Makes the slides of one deck, view by view.
class Making {
 public:
  Making(const ExportOrder& order, HeadlessPicture& painter, const ExportProgress& progress)
      : m_order(order),
        m_language(model::firstLanguage(order.labels.language)),
        m_painter(painter),
        m_progress(progress) {
    m_deck.shape = order.of<SlideOptions>().shape;
    m_deck.dark = order.environment.background == Background::dark;
    m_deck.ground = groundOf(order.environment.background);
    const LetteringColours colours = letteringColours(order.environment.background);
    m_deck.ink = colours.ink;
    m_deck.halo = colours.ground;
    m_deck.credit = fileCredit(order, {});
  }

  Result<SlideDeck> make() {
    if (!showsViews(m_order)) {
      const model::View* const view = shownView(m_order);
      TRY(addView(slideFigure(m_order, view), view, {0.0, 1.0}));
      addSources();
      return std::move(m_deck);
    }
    const std::vector<model::View>& views = m_order.scene.views();
    for (std::size_t i = 0; i < views.size(); ++i) {
      const Span span{double(i) / double(views.size()), 1.0 / double(views.size())};
      TRY(addView(slideOfView(m_order, views[i]), &views[i], span));
    }
    addSources();
    return std::move(m_deck);
  }

 private:
  /// The part of all work that a slide is.
  struct Span {
    double from = 0.0;
    double size = 1.0;
  };

  Status addView(ExportOrder order, const model::View* view, const Span& span) {
    order.labels.ground = order.environment.background;
    if (order.sources == SourceCredits::page)  // they have a slide
      order.sources = SourceCredits::off;
    Slide slide;
    slide.title = titleOf(order, view);
    if (view) {
      slide.text = wordsIn(view->words.text, m_language);
      slide.notes = wordsIn(view->words.notes, m_language);
    }
    slide.figure = slideFrames(m_deck.shape, hasText(view, order)).figure;
    slide.picture = TRY(addPicture(order, span));
    const FigurePlate plate = figurePlate(order, m_trees);
    m_progress.note(plate.notes);
    addWritings(slide, order, plate);
    addAltText(slide, order);
    slide.onClick = order.of<SlideOptions>().onClick;
    m_deck.slides.push_back(slide);
    if (order.of<SlideOptions>().selfTest && !slide.labels.empty())
      addTest(order, std::move(slide), plate.labels ? &plate.labels->layout : nullptr);
    return Unit{};
  }

  SlideWords titleOf(const ExportOrder& order, const model::View* view) const {
    if (view && !view->words.title.in(m_language).empty())
      return wordsIn(view->words.title, m_language);
    const model::KnownSides sides = knownSides(order.scene);
    if (!sides.any)
      return {view ? titleOfView(*view, m_language, sides) : std::string(), {}};
    return {MarkWords(m_language, sides).view(order.viewName, order.camera).toStdString(), {}};
  }

  Result<std::size_t> addPicture(const ExportOrder& order, const Span& span) {
    ExportOrder bare = order;
    bare.labels.mode = LabelMode::off;
    bare.marks = ExportMarks::none();
    bare.legend = LegendList::none;
    bare.altText = "off";  // the slide says it
    bare.sources = SourceCredits::off;
    const auto tell = [&](double share, std::string_view what) {
      return !m_progress || m_progress(0.95 * (span.from + span.size * share), what);
    };
    ExportNotes notes;
    std::string svg = TRY(
        svgText(bare, {},
                {[&tell](double share, std::string_view what) { return tell(0.7 * share, what); },
                 &notes}));
    m_progress.note(notes);
    if (!tell(0.7, "drawing"))
      return givenUp({});
    const glm::ivec2 size = pixelsOf(bare.page);
    const Image image = TRY(m_painter->render(
        bare.scene, bare.camera,
        {.width = size.x, .height = size.y, .environment = bare.environment}, samplesAtOnce(size)));
    std::string png = TRY(pngOf(image, bare.credit));
    m_deck.pictures.push_back({std::move(svg), std::move(png)});
    return m_deck.pictures.size() - 1;
  }

  std::string languageOf(const ExportOrder& order, model::AnnotationId id) const {
    const auto& all = order.scene.annotations();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [id](const model::Annotation& each) { return each.id == id; });
    return found != all.end() && found->texts.contains(m_language) ? m_language : std::string();
  }

  void addWritings(Slide& slide, const ExportOrder& order, const FigurePlate& plate) const {
    slide.marks.clear();
    slide.labels.clear();
    for (const LetteringItem& mark : plate.marks.lettering.items)
      slide.marks.push_back({mark, m_language});
    if (!plate.labels)
      return;
    std::vector<std::string> languages;
    for (const ShownLabel& label : plate.labels->labels)
      if (plate.labels->layout.find(label.item.id))
        languages.push_back(languageOf(order, label.item.id));
    // The lettering has an item for each label with a place, in their order.
    const Lettering lettering = letteringOf(*plate.labels);
    for (std::size_t i = 0; i < lettering.items.size(); ++i)
      slide.labels.push_back({lettering.items[i], languages[i]});
  }

  static void addAltText(Slide& slide, const ExportOrder& order) {
    const AltText said = altTextOf(order);
    slide.shown = {said.text, said.language};
  }

  /// Adds the slide that says whose work the surfaces are.
  void addSources() {
    if (m_order.sources != SourceCredits::page)
      return;
    Slide slide;
    slide.title = {sheetWords(m_language).sources, m_language};
    for (const SourceLine& line : sourceLines(m_order.scene))
      slide.key.push_back({0, {line.text, {}}});
    if (!slide.key.empty())
      m_deck.slides.push_back(std::move(slide));
  }

  /// Adds the slide with numbers in place of labels, and its key, where there is something to ask.
  /// Where the labels of the slide are numbers, they keep these.
  void addTest(const ExportOrder& shown, Slide slide, const LabelLayout* before) {
    const ShownQuestions asked = shownQuestions(shown, m_trees);
    m_progress.note(asked.notes);
    if (asked.questions.empty())
      return;
    ExportOrder order = askedAlone(shown, asked.questions);
    order.labels.mode = LabelMode::numbers;
    const bool numbered = shown.labels.mode == LabelMode::numbers;
    const FigurePlate plate = figurePlate(order, m_trees, {.before = numbered ? before : nullptr});
    if (plate.labels->layout.labels.empty())
      return;
    const SheetWords& words = sheetWords(m_language);
    const SlideWords title = slide.title;
    const auto headed = [&title](const char* what) {
      return SlideWords{what + (title.text.empty() ? std::string() : ": " + title.text),
                        title.language};
    };
    slide.text = {};
    slide.notes = {};
    slide.onClick = false;
    slide.figure.at.x = 0.5f * (slideSizeMm(m_deck.shape).x - slide.figure.size.x);
    slide.title = headed(words.selfTest);
    addWritings(slide, order, plate);
    addAltText(slide, order);
    Slide key;
    key.title = headed(words.key);
    for (const ShownLabel& label : plate.labels->labels)
      if (plate.labels->layout.find(label.item.id))
        key.key.push_back(
            {label.number,
             {keyLine(order.scene, label, plate.labels->style), languageOf(order, label.item.id)}});
    m_deck.slides.push_back(std::move(slide));
    m_deck.slides.push_back(std::move(key));
  }

  const ExportOrder& m_order;
  std::string m_language;
  HeadlessPicture& m_painter;
  const ExportProgress& m_progress;
  model::MeshTrees m_trees;
  SlideDeck m_deck;
};

}  // namespace

Result<SlideDeck> slideDeck(const ExportOrder& order, const ExportProgress& progress) {
  if (progress && !progress(0.0, "preparing surfaces"))
    return givenUp({});
  const auto typesetting = TRY(Typesetting::create());  // as long as text is set
  HeadlessPicture painter = TRY(HeadlessPicture::create());
  return Making(order, painter, progress).make();
}

}  // namespace sline::render
