// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/common_options.h"

#include <QtGlobal>
#include <array>

namespace sline::render {

namespace {

constexpr std::array backgrounds{
    OptionChoice{.id = "white",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "White"),
                 .value = int(Background::white)},
    OptionChoice{.id = "paper",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Paper"),
                 .value = int(Background::paper)},
    OptionChoice{.id = "dark",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Dark"),
                 .value = int(Background::dark)},
    OptionChoice{.id = "transparent",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Transparent"),
                 .value = int(Background::transparent)}};

constexpr std::array labelModes{
    OptionChoice{.id = "on",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Texts"),
                 .value = int(LabelMode::on)},
    OptionChoice{.id = "numbers",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Numbers"),
                 .value = int(LabelMode::numbers)},
    OptionChoice{
        .id = "blank",
        .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Blank lines, for a test"),
        .value = int(LabelMode::blank)},
    OptionChoice{.id = "off",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "None"),
                 .value = int(LabelMode::off)}};

constexpr ExportOption labels{
    .id = "labels",
    .group = OptionGroup::labels,
    .flag = "--labels",
    .help =
        "The scene's annotations in the picture: on with their texts, numbers with numbered badges "
        "(their key goes to standard output), blank with empty lines for a test, or off. "
        "Anatomical views leave room for them at both sides",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Labels"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "How the scene's labels stand in the picture"),
    .kind = ChoiceOption{labelModes},
    .field = boundTo([](auto& o) -> auto& { return o.labels.mode; })};

constexpr std::array legends{
    OptionChoice{.id = "sheets",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "On sheets alone"),
                 .value = int(LegendList::onSheets)},
    OptionChoice{.id = "all",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "All structures"),
                 .value = int(LegendList::all)},
    OptionChoice{.id = "labelled",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Those with a label"),
                 .value = int(LegendList::labelled)},
    OptionChoice{.id = "focus",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Those in focus"),
                 .value = int(LegendList::focus)},
    OptionChoice{.id = "none",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "None"),
                 .value = int(LegendList::none)}};

constexpr ExportOption legend{
    .id = "legend",
    .group = OptionGroup::labels,
    .flag = "--legend",
    .help =
        "Colours and names of structures, in a corner of the picture or on the sheet: all, those "
        "that a label points at, those in focus, or none; sheets: all, on sheets of paper alone",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Legend"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Colours and names, in the picture's corner or on the sheet"),
    .kind = ChoiceOption{legends},
    .field = boundTo([](auto& o) -> auto& { return o.legend; })};

constexpr ExportOption labelSize{
    .id = "labelSize",
    .group = OptionGroup::labels,
    .flag = "--label-size",
    .value = "PT",
    .help = "Of labels' letters, in points of the page, or of a picture that is 190.5 mm high",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Le&tters"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "How large the letters of labels are on paper"),
    .kind = numberWithin(letterLimitsPt, 1, 1.0,
                         QT_TRANSLATE_NOOP("sline::render::ExportOption", "pt")),
    .field = boundTo([](auto& o) -> auto& { return o.labels.points; })};

constexpr ExportOption sides{
    .id = "sides",
    .group = OptionGroup::marks,
    .flag = "sides",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Right and left"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "R and L, and the body's other directions"),
    .field = boundTo([](auto& o) -> auto& { return o.marks.sides; })};

constexpr ExportOption viewName{
    .id = "viewName",
    .group = OptionGroup::marks,
    .flag = "view",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Name of the view"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "“Anterior view”, or the saved view's name"),
    .field = boundTo([](auto& o) -> auto& { return o.marks.viewName; })};

constexpr ExportOption scaleBar{
    .id = "scaleBar",
    .group = OptionGroup::marks,
    .flag = "scale",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "S&cale bar"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "How long a centimetre is"),
    .field = boundTo([](auto& o) -> auto& { return o.marks.scaleBar; })};

constexpr ExportOption sectionState{
    .id = "sectionState",
    .group = OptionGroup::marks,
    .flag = "sections",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "S&ections"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "What sections have taken away"),
    .field = boundTo([](auto& o) -> auto& { return o.marks.sectionState; })};

constexpr ExportOption gammaKey{
    .id = "gammaKey",
    .group = OptionGroup::marks,
    .flag = "gamma",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Γ over s&urfaces"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "By what Γ varies, and how the drawing changes along it"),
    .field = boundTo([](auto& o) -> auto& { return o.marks.gammaKey; })};

constexpr ExportOption words{
    .id = "words",
    .group = OptionGroup::marks,
    .flag = "words",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Text of the &view"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Title and text of a saved view at the picture's foot, where it says "
                             "any; in films as a subtitle"),
    .field = boundTo([](auto& o) -> auto& { return o.marks.words; })};

constexpr ExportOption author{
    .id = "author",
    .group = OptionGroup::credit,
    .flag = "--author",
    .value = "NAME",
    .help =
        "Who made it, written into the file where its kind has a place for that; nothing is unless "
        "you say it here",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Author"),
    .tip = QT_TRANSLATE_NOOP(
        "sline::render::ExportOption",
        "Written into the file, which says of nobody who made it where this is empty"),
    .kind = TextOption{.longest = 500},
    .field = boundTo([](auto& o) -> auto& { return o.credit.author; }),
    .kept = false};

constexpr ExportOption copyright{
    .id = "copyright",
    .group = OptionGroup::credit,
    .flag = "--copyright",
    .value = "TEXT",
    .help = "Whose it is or what others may do with it, as in \"CC BY 4.0\"; likewise",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Rights"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Whose it is or what others may do with it, as in “CC BY 4.0”"),
    .kind = TextOption{.longest = 500},
    .field = boundTo([](auto& o) -> auto& { return o.credit.copyright; }),
    .kept = false};

constexpr ExportOption altText{
    .id = "altText",
    .group = OptionGroup::credit,
    .flag = "--alt",
    .value = "TEXT",
    .help =
        "What the picture shows, in words, for who does not see it; off for none. Without it the "
        "file says what its view does (`sline view --alt`), else what is seen, and names nothing "
        "where no labels are written out",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Description"),
    .tip = QT_TRANSLATE_NOOP(
        "sline::render::ExportOption",
        "What the picture shows, for who does not see it; where this is empty, the file says what "
        "is seen in the picture, and “off” leaves it out"),
    .kind = TextOption{.longest = 2000, .lines = 3},
    .field = boundTo([](auto& o) -> auto& { return o.altText; }),
    .kept = false};

constexpr std::array sourceChoices{
    OptionChoice{.id = "surfaces",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Beside surfaces alone"),
                 .value = int(SourceCredits::withSurfaces)},
    OptionChoice{.id = "line",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "In a line"),
                 .value = int(SourceCredits::line)},
    OptionChoice{.id = "page",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "On a page of their own"),
                 .value = int(SourceCredits::page)},
    OptionChoice{.id = "off",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Nowhere"),
                 .value = int(SourceCredits::off)}};

constexpr ExportOption sources{
    .id = "sources",
    .group = OptionGroup::credit,
    .flag = "--credits",
    .help =
        "Whose work the surfaces are (`sline credit`): in a line at the picture's foot, on a page "
        "or slide of its own where there are such, beside the surfaces in GLB files alone, or "
        "nowhere",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Sources"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Whose work the surfaces are and under what terms"),
    .kind = ChoiceOption{sourceChoices},
    .field = boundTo([](auto& o) -> auto& { return o.sources; })};

}  // namespace

constinit const ExportOption backgroundOption{
    .id = "background",
    .group = OptionGroup::picture,
    .flag = "--background",
    .help = "What lies behind the drawing",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Back&ground"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "What lies behind the drawing"),
    .kind = ChoiceOption{backgrounds},
    .field = boundTo([](auto& o) -> auto& { return o.environment.background; })};

// The available languages depend on the scene: a window offers those, and keeps none.
constinit const ExportOption languageOption{
    .id = "language",
    .group = OptionGroup::labels,
    .flag = "--language",
    .value = "TAG",
    .help =
        "The language of labels, as in de or la, or several, as in de+la; where one has no text in "
        "the first, the scene's own",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Lan&guage"),
    .tip =
        QT_TRANSLATE_NOOP("sline::render::ExportOption",
                          "Of texts and numbers; where a label has no text in it, the scene's own"),
    .kind = TextOption{.longest = 100},
    .field = boundTo([](auto& o) -> auto& { return o.labels.language; }),
    .kept = false};

constinit const ExportOption pureInkOption{
    .id = "pureInk",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Black in&k alone"),
    .tip = QT_TRANSLATE_NOOP(
        "sline::render::ExportOption",
        "For print without tones: each pixel is ink or paper; what is shaded is hatched instead"),
    .field = boundTo([](auto& o) -> auto& { return o.pureInk; })};

OptionList pictureOptions() {
  static constexpr std::array all{&backgroundOption, &labels,   &languageOption, &labelSize,
                                  &legend,           &sides,    &viewName,       &scaleBar,
                                  &sectionState,     &gammaKey, &words};
  return all;
}

OptionList creditOptions() {
  static constexpr std::array all{&author, &copyright, &altText, &sources};
  return all;
}

}  // namespace sline::render
