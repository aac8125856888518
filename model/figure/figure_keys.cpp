// SPDX-License-Identifier: Apache-2.0
#include "model/figure/figure_keys.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>

#include "model/figure/figure_rows.h"
#include "model/scene/near_names.h"
#include "model/scene/scene_limits.h"

namespace sline::model {

namespace {

constexpr std::size_t longestPath = 1000;
constexpr std::size_t longestName = 400;
constexpr std::size_t longestLetter = 8;
constexpr int figureFormat = 1;

std::string shortText(float value) {
  return value == std::floor(value) ? std::to_string(int(value))
                                    : FigureJson(jsonNumber(value)).dump();
}

float numberIn(const JsonValue& value, const Limits<float>& limits) {
  const float number = value.number();
  if (!limits.contain(number))
    value.fail("a number from " + shortText(limits.low) + " to " + shortText(limits.high) +
               " is expected here");
  return number;
}

std::string textOf(const JsonValue& value, std::size_t longest) {
  std::string text = value.text();
  if (text.size() > longest)
    value.fail("the text is longer than " + std::to_string(longest) + " bytes");
  const auto controls = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  if (std::any_of(text.begin(), text.end(), controls))
    value.fail("the text has control characters");
  return text;
}

template <std::size_t count>
std::size_t choiceOf(const JsonValue& value, const std::array<std::string_view, count>& names) {
  const std::optional<std::size_t> place = value.oneOf(names);
  if (place)
    return *place;
  std::string list;
  for (std::size_t i = 0; i < count; ++i)
    list += (i == 0 ? "\"" : i + 1 == count ? "\" or \"" : "\", \"") + std::string(names[i]);
  value.fail(list + "\" is expected here");
  return 0;
}

FigureBox boxOf(const JsonValue& value, float least) {
  const std::array<float, 4> numbers = value.numbers<4>();
  const FigureBox box{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
  const Limits<float> places{0.0f, figureHeightLimits.high};
  for (const float number : numbers)
    if (!places.contain(number))
      value.fail("left, top, width and height from 0 to " + shortText(places.high) +
                 " mm are expected here");
  if (box.size.x < least || box.size.y < least)
    value.fail("it is narrower or lower than " + shortText(least) + " mm");
  return box;
}

FigureJson jsonOf(const FigureBox& box) {
  return {jsonNumber(box.at.x), jsonNumber(box.at.y), jsonNumber(box.size.x),
          jsonNumber(box.size.y)};
}

/// Reads weights, or a number of equal ones.
std::vector<float> tracksOf(const JsonValue& value) {
  if (value.json().is_number())
    return std::vector<float>(std::size_t(value.whole(1, std::int64_t(mostTracks))), 1.0f);
  std::vector<float> weights;
  if (value.json().is_array() && (value.json().empty() || value.json().size() > mostTracks))
    value.fail("one to " + std::to_string(mostTracks) + " weights are expected here");
  value.forEach(
      [&weights](const JsonValue& each) { weights.push_back(numberIn(each, trackWeightLimits)); });
  return weights;
}

FigureJson jsonOf(const std::vector<float>& weights) {
  if (std::all_of(weights.begin(), weights.end(), [](float w) { return w == 1.0f; }))
    return weights.size();
  FigureJson list = FigureJson::array();
  for (const float weight : weights)
    list.push_back(jsonNumber(weight));
  return list;
}

/// Reads millimetres, or the name of a width that journals print.
float widthOf(const JsonValue& value) {
  if (!value.json().is_string())
    return numberIn(value, figureWidthLimits);
  for (const FigureWidth& width : figureWidths)
    if (value.json().get_ref<const std::string&>() == width.name)
      return width.mm;
  value.fail("millimetres or \"single\", \"middle\" or \"double\" is expected here");
  return Figure().widthMm;
}

FigureJson jsonOfWidth(float mm) {
  for (const FigureWidth& width : figureWidths)
    if (mm == width.mm)
      return std::string(width.name);
  return jsonNumber(mm);
}

// A field as JSON; null where it is as an object without it has it.
template <class Owner, class Field>
FigureJson numberUnless(const Owner& owner, Field Owner::*field) {
  return owner.*field == Owner().*field ? FigureJson() : FigureJson(jsonNumber(owner.*field));
}
template <class Owner, class Field>
FigureJson valueUnless(const Owner& owner, Field Owner::*field) {
  return owner.*field == Owner().*field ? FigureJson() : FigureJson(owner.*field);
}
template <class Owner, class Field>
FigureJson valueIfAny(const Owner& owner, std::optional<Field> Owner::*field) {
  return owner.*field ? FigureJson(*(owner.*field)) : FigureJson();
}
template <class Owner, class Choice, std::size_t count>
FigureJson choiceUnless(const Owner& owner, Choice Owner::*field,
                        const std::array<std::string_view, count>& names) {
  return owner.*field == Owner().*field ? FigureJson()
                                        : FigureJson(names[std::size_t(owner.*field)]);
}

template <auto field>
constexpr auto readFlag = [](const JsonValue& value, auto& owner) { owner.*field = value.flag(); };
template <auto field>
constexpr auto writeValue = [](const auto& owner) { return valueUnless(owner, field); };
template <auto field>
constexpr auto writeIfAny = [](const auto& owner) { return valueIfAny(owner, field); };
template <auto field>
constexpr auto writeNumber = [](const auto& owner) { return numberUnless(owner, field); };
template <auto field, const Limits<float>& limits>
constexpr auto readNumber =
    [](const JsonValue& value, auto& owner) { owner.*field = numberIn(value, limits); };
template <auto field, std::size_t longest>
constexpr auto readText =
    [](const JsonValue& value, auto& owner) { owner.*field = textOf(value, longest); };
template <auto field, const auto& names>
constexpr auto readChoice = [](const JsonValue& value, auto& owner) {
  using Choice = std::decay_t<decltype(owner.*field)>;
  owner.*field = Choice(choiceOf(value, names));
};
template <auto field, const auto& names>
constexpr auto writeChoice = [](const auto& owner) { return choiceUnless(owner, field, names); };
template <auto field>
constexpr auto readBox =
    [](const JsonValue& value, auto& owner) { owner.*field = boxOf(value, leastPanelMm); };
template <auto field>
constexpr auto writeBox =
    [](const auto& owner) { return owner.*field ? jsonOf(*(owner.*field)) : FigureJson(); };
template <auto field>
constexpr auto readSpan = [](const JsonValue& value, auto& owner) {
  owner.*field = int(value.whole(1, std::int64_t(mostTracks)));
};

void readFormat(const JsonValue& value, Figure&) {
  if (value.whole(1, 1'000'000) != figureFormat)
    value.fail("this program reads figures of format 1");
}

void readPanels(const JsonValue& value, Figure& figure) {
  if (value.json().is_array() && value.json().size() > mostPanels)
    value.fail("a figure has at most " + std::to_string(mostPanels) + " panels");
  value.forEach([&figure](const JsonValue& each) {
    readByRows(each, panelRows(), figure.panels.emplace_back());
  });
}

FigureJson jsonOfPanels(const Figure& figure) {
  FigureJson list = FigureJson::array();
  for (const FigurePanel& panel : figure.panels)
    list.push_back(writtenByRows(panelRows(), panel));
  return list;
}

constexpr FigureRow<Figure> sizeTable[] = {
    {"sline_figure", "1", "The format of the file; every figure says it", readFormat,
     [](const Figure&) { return FigureJson(figureFormat); }},
    {"width", "single|middle|double|MM",
     "How wide the page is: one column of a journal (85 mm), one and a half (114 mm), two (174 mm) "
     "or so many millimetres",
     [](const JsonValue& value, Figure& figure) { figure.widthMm = widthOf(value); },
     [](const Figure& figure) { return jsonOfWidth(figure.widthMm); }},
    {"height", "MM",
     "How high it is; without it the panels of the grid are 4 by 3 and the legend has its room",
     [](const JsonValue& value, Figure& figure) {
       figure.heightMm = numberIn(value, figureHeightLimits);
     },
     [](const Figure& figure) {
       return figure.heightMm ? FigureJson(jsonNumber(*figure.heightMm)) : FigureJson();
     }},
    {"gap", "MM", "Between panels", readNumber<&Figure::gapMm, figureGapLimits>,
     writeNumber<&Figure::gapMm>},
    {"columns", "N|[WEIGHT, …]", "The columns of the grid: how many, or their weights",
     [](const JsonValue& value, Figure& figure) { figure.columns = tracksOf(value); },
     [](const Figure& figure) { return jsonOf(figure.columns); }},
    {"rows", "N|[WEIGHT, …]", "The rows of the grid; without it as many as there are panels for",
     [](const JsonValue& value, Figure& figure) { figure.rows = tracksOf(value); },
     [](const Figure& figure) { return figure.rows.empty() ? FigureJson() : jsonOf(figure.rows); }},
};

constexpr FigureRow<Figure> sightTable[] = {
    {"scene", "FILE.sline",
     "The scene of all panels that name none: a scene file in the figure's folder or below it",
     readText<&Figure::scene, longestPath>, writeValue<&Figure::scene>},
    {"projection", "saved|parallel",
     "How panels see: as their views were saved, or all without perspective, so that a scale bar "
     "is true everywhere",
     readChoice<&Figure::projection, figureProjectionNames>,
     writeChoice<&Figure::projection, figureProjectionNames>},
    {"same_scale", "true|false",
     "All panels at one scale, so that sizes compare: the smallest that any would have by itself, "
     "said by one scale bar; insets keep how much they enlarge",
     readFlag<&Figure::sameScale>, writeValue<&Figure::sameScale>},
    {"letters", "lower|upper|none",
     "The panels' letters: a, b, c or A, B, C, bold at the upper left",
     readChoice<&Figure::letters, panelLetterNames>,
     writeChoice<&Figure::letters, panelLetterNames>},
    {"letter_points", "PT", "The size of the panels' letters",
     readNumber<&Figure::letterPoints, figureLetterLimits>, writeNumber<&Figure::letterPoints>},
    {"points", "PT", "The size of labels; scale bars and the legend have 0.8 of it",
     readNumber<&Figure::points, figureLetterLimits>, writeNumber<&Figure::points>},
    {"language", "TAG", "The language of labels, scale bars and legend: de, la, de+la",
     readText<&Figure::language, longestName>, writeValue<&Figure::language>},
    {"labels", "true|false", "Labels in all panels", readFlag<&Figure::labels>,
     writeValue<&Figure::labels>},
    {"scale_bars", "true|false", "A scale bar in each panel", readFlag<&Figure::scaleBars>,
     writeValue<&Figure::scaleBars>},
    {"sides", "true|false", "R, L and the other sides of the body", readFlag<&Figure::sides>,
     writeValue<&Figure::sides>},
};

constexpr FigureRow<Figure> printTable[] = {
    {"legend", "none|all|labelled|focus",
     "One legend for all panels, at the page's foot: of all that any of them shows, of what their "
     "labels point at, or of what is in focus",
     readChoice<&Figure::legend, figureLegendNames>,
     writeChoice<&Figure::legend, figureLegendNames>},
    {"pen", "PT", "How wide contours are, the same in all panels, insets too",
     readNumber<&Figure::penPoints, figurePenLimits>, writeNumber<&Figure::penPoints>},
    {"black_and_white", "true|false", "Ink alone, without tones and colours",
     readFlag<&Figure::blackAndWhite>, writeValue<&Figure::blackAndWhite>},
    {"least_points", "PT", "Smaller letters are refused",
     readNumber<&Figure::leastPoints, figureLeastLimits>, writeNumber<&Figure::leastPoints>},
    {"least_line", "PT", "The thinnest line that prints",
     readNumber<&Figure::leastLine, figureLeastLimits>, writeNumber<&Figure::leastLine>},
    {"thin_lines", "raised|refused|kept",
     "What becomes of thinner ones: they are drawn that wide, the figure is refused, or they stay. "
     "Hatching and patterns of cut tissue fade by getting thinner and stay as they are",
     readChoice<&Figure::thinLines, thinLineNames>, writeChoice<&Figure::thinLines, thinLineNames>},
    {"panels", "[PANEL, …]", "The panels, in the order of their letters", readPanels, jsonOfPanels},
};

constexpr FigureRow<FigurePanel> panelTable[] = {
    {"scene", "FILE.sline", "The panel's own scene", readText<&FigurePanel::scene, longestPath>,
     writeValue<&FigurePanel::scene>},
    {"view", "NAME",
     "A saved view of it, or anterior, posterior, left, right, superior or inferior, fitted to "
     "what "
     "is visible; anterior if not given",
     readText<&FigurePanel::view, longestSceneName>, writeValue<&FigurePanel::view>},
    {"letter", "TEXT", "Its letter, in place of the next one; \"\" for none",
     readText<&FigurePanel::letter, longestLetter>, writeIfAny<&FigurePanel::letter>},
    {"camera", "CAMERA", "Where it is seen from, if not from where its view was saved",
     [](const JsonValue& value, FigurePanel& panel) {
       readByRows(value, cameraRows(), panel.camera.emplace());
     },
     [](const FigurePanel& panel) {
       return panel.camera ? writtenByRows(cameraRows(), *panel.camera) : FigureJson();
     }},
    {"inset", "INSET", "It shows a part of another panel enlarged",
     [](const JsonValue& value, FigurePanel& panel) {
       PanelInset& inset = panel.inset.emplace();
       readByRows(value, insetRows(), inset);
       if (inset.part == FigureBox())
         value.fail("\"part\" is missing");
     },
     [](const FigurePanel& panel) {
       return panel.inset ? writtenByRows(insetRows(), *panel.inset) : FigureJson();
     }},
};

constexpr FigureRow<FigurePanel> placeTable[] = {
    {"at", "[LEFT, TOP, WIDTH, HEIGHT]",
     "Its place on the page in millimetres; without it the next free one of the grid",
     readBox<&FigurePanel::at>, writeBox<&FigurePanel::at>},
    {"columns", "N", "How many columns of the grid it spans", readSpan<&FigurePanel::columns>,
     writeValue<&FigurePanel::columns>},
    {"rows", "N", "How many rows it spans", readSpan<&FigurePanel::rows>,
     writeValue<&FigurePanel::rows>},
    {"labels", "true|false", "Its labels, if not as in the others", readFlag<&FigurePanel::labels>,
     writeIfAny<&FigurePanel::labels>},
    {"scale_bar", "true|false", "Its scale bar", readFlag<&FigurePanel::scaleBar>,
     writeIfAny<&FigurePanel::scaleBar>},
    {"sides", "true|false", "Its R, L and other sides of the body", readFlag<&FigurePanel::sides>,
     writeIfAny<&FigurePanel::sides>},
};

constexpr FigureRow<PanelCamera> cameraTable[] = {
    {"like", "LETTER",
     "The panel whose direction and scale this one has, too, so that what both show compares",
     readText<&PanelCamera::like, longestLetter>, writeValue<&PanelCamera::like>},
    {"centred", "true|false", "With \"like\": moved aside to the middle of what this panel shows",
     readFlag<&PanelCamera::centred>, writeValue<&PanelCamera::centred>},
    {"fit", "true|false", "Moved so that all that is visible fills the panel beside its labels",
     readFlag<&PanelCamera::fit>, writeValue<&PanelCamera::fit>},
};

constexpr FigureRow<PanelInset> insetTable[] = {
    {"of", "LETTER", "The panel of which it shows a part", readText<&PanelInset::of, longestLetter>,
     writeValue<&PanelInset::of>},
    {"part", "[LEFT, TOP, WIDTH, HEIGHT]",
     "That part, in millimetres from that panel's upper left corner; its frame is drawn there",
     [](const JsonValue& value, PanelInset& inset) { inset.part = boxOf(value, leastPartMm); },
     [](const PanelInset& inset) { return jsonOf(inset.part); }},
    {"inside", "[LEFT, TOP, WIDTH, HEIGHT]",
     "Where the inset lies on that panel, in millimetres; without it beside it, in the grid or "
     "\"at\" its place",
     readBox<&PanelInset::inside>, writeBox<&PanelInset::inside>},
    {"lines", "true|false", "Lines from the frame's corners to the inset's",
     readFlag<&PanelInset::lines>, writeValue<&PanelInset::lines>},
};

template <class Owner>
std::vector<FigureRow<Owner>> joined(
    std::initializer_list<std::span<const FigureRow<Owner>>> parts) {
  std::vector<FigureRow<Owner>> all;
  for (const std::span<const FigureRow<Owner>>& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

template <class Owner>
void addNotes(std::vector<FigureKeyNote>& notes, const char* object,
              std::span<const FigureRow<Owner>> rows) {
  for (const FigureRow<Owner>& row : rows)
    notes.push_back({object, row.id, row.value, row.help});
}

}  // namespace

std::span<const FigureRow<Figure>> figureRows() {
  static const auto all = joined<Figure>({sizeTable, sightTable, printTable});
  return all;
}
std::span<const FigureRow<FigurePanel>> panelRows() {
  static const auto all = joined<FigurePanel>({panelTable, placeTable});
  return all;
}
std::span<const FigureRow<PanelCamera>> cameraRows() {
  return cameraTable;
}
std::span<const FigureRow<PanelInset>> insetRows() {
  return insetTable;
}

template <class Owner>
void readByRows(const JsonValue& value, std::span<const FigureRow<Owner>> rows, Owner& owner) {
  JsonObject object(value);
  std::vector<std::string> names;
  for (const FigureRow<Owner>& row : rows) {
    names.emplace_back(row.id);
    if (value.fault().any())
      return;
    if (const std::optional<JsonValue> held = object.take(row.id))
      row.read(*held, owner);
  }
  const Json rest = object.rest();
  if (value.fault().any() || rest.empty())
    return;
  const std::string key = rest.begin().key().substr(0, longestName);
  std::string near = nearNamesText(key, names);
  value.fail("no key is called " + Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) +
             (near.empty() ? "" : ". " + near));
}

template void readByRows(const JsonValue&, std::span<const FigureRow<Figure>>, Figure&);
template void readByRows(const JsonValue&, std::span<const FigureRow<FigurePanel>>, FigurePanel&);
template void readByRows(const JsonValue&, std::span<const FigureRow<PanelCamera>>, PanelCamera&);
template void readByRows(const JsonValue&, std::span<const FigureRow<PanelInset>>, PanelInset&);

const std::vector<FigureKeyNote>& figureKeyNotes() {
  static const std::vector<FigureKeyNote> all = [] {
    std::vector<FigureKeyNote> notes;
    addNotes(notes, "figure", figureRows());
    addNotes(notes, "panel", panelRows());
    addNotes(notes, "camera", cameraRows());
    addNotes(notes, "inset", insetRows());
    return notes;
  }();
  return all;
}

const char* figureKeyHelp(std::string_view object, std::string_view id) {
  const auto& all = figureKeyNotes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const FigureKeyNote& note) {
    return note.object == object && note.id == id;
  });
  assert(found != all.end());
  return found == all.end() ? "" : found->help;
}

}  // namespace sline::model
