// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_options.h"

#include <QtGlobal>
#include <array>

#include "render/export/order/common_options.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace {

constexpr std::array sheetKinds{
    OptionChoice{.id = "none",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "The figure alone"),
                 .value = int(SheetKind::none)},
    OptionChoice{.id = "figure",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "With title and legend"),
                 .value = int(SheetKind::figure)},
    OptionChoice{
        .id = "teaching",
        .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "For teaching, with self-test"),
        .value = int(SheetKind::teaching)},
    OptionChoice{.id = "patient",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "For a patient"),
                 .value = int(SheetKind::patient)}};

constexpr std::array papers{
    OptionChoice{.id = "a4",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "A4"),
                 .value = int(Paper::a4)},
    OptionChoice{.id = "letter",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "US Letter"),
                 .value = int(Paper::letter)}};

bool isSheet(const ExportOrder& order) {
  return hasSheet(order) || order.of<ViewsOptions>().subject == ViewSubject::all;
}

constexpr ExportOption paper{
    .id = "sheetPaper",
    .flag = "--paper",
    .help = "The sheet's paper",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Paper of the sheet"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Of sheets alone"),
    .kind = ChoiceOption{papers},
    .field = boundTo([](auto& o) -> auto& { return o.template of<SheetOptions>().paper; }),
    .applies = isSheet};

constexpr ExportOption title{
    .id = "sheetTitle",
    .flag = "--title",
    .value = "TEXT",
    .help = "Above the sheet's figure",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "T&itle"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "At the head of a sheet"),
    .kind = TextOption{.longest = 10'000},
    .field = boundTo([](auto& o) -> auto& { return o.template of<SheetOptions>().title; }),
    .kept = false,
    .applies = isSheet};

constexpr ExportOption text{
    .id = "sheetText",
    .flag = "--text",
    .value = "FILE_OR_TEXT",
    .help =
        "What the sheet for a patient says, or the name of a text file; each line is a paragraph",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Text"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Of a sheet for a patient; each line is a paragraph"),
    .kind = TextOption{.longest = 1'000'000, .lines = 3, .fromFile = true},
    .field = boundTo([](auto& o) -> auto& { return o.template of<SheetOptions>().text; }),
    .kept = false,
    .applies = isSheet};

constexpr ExportOption landscape{
    .id = "sheetLandscape",
    .flag = "--landscape",
    .help = "The sheet's paper lies on its side",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Landscape"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Wider than high"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<SheetOptions>().landscape; }),
    .applies = isSheet};

bool hasTest(const ExportOrder& order) {
  return order.of<SheetOptions>().kind == SheetKind::teaching;
}

bool hasTests(const ExportOrder& order) {
  return hasTest(order) && order.of<ViewsOptions>().subject == ViewSubject::all;
}

constexpr std::array keyPlaces{
    OptionChoice{.id = "next",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "After each test"),
                 .value = int(KeyPlace::next)},
    OptionChoice{.id = "end",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "At the end"),
                 .value = int(KeyPlace::end)}};

constexpr ExportOption wordBank{
    .id = "wordBank",
    .flag = "--word-bank,!--no-word-bank",
    .help = "The self-test of a sheet has the answers to choose from, in another order",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Word bank"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "The self-test has the answers below, in another order"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<TestOptions>().wordBank; }),
    .applies = hasTest};

constexpr ExportOption keyPlace{
    .id = "keyPlace",
    .flag = "--key",
    .help =
        "Where the keys of all views' self-tests stand, each on a page of its own: after each "
        "test, or all at the end",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Key"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Where the answers stand, each test's on a page of its own"),
    .kind = ChoiceOption{keyPlaces},
    .field = boundTo([](auto& o) -> auto& { return o.template of<TestOptions>().key; }),
    .applies = hasTests};

}  // namespace

constinit const ExportOption sheetOption{
    .id = "sheet",
    .flag = "--sheet",
    .help =
        "Makes the PDF a sheet of paper. figure: with title and legend; teaching: besides, "
        "numbered labels, a page without them to test oneself and the key (a scene without labels "
        "gets its structures labelled); patient: large labels and a text of one's own. The figure "
        "is as large as the paper lets it, and so are pictures of it that are written besides. "
        "With "
        "all views each has its sheet, with its title and text, between contents and an index",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Shee&t"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "The page around the figure, of a paper of its own"),
    .kind = ChoiceOption{sheetKinds},
    .field = boundTo([](auto& o) -> auto& { return o.template of<SheetOptions>().kind; })};

bool hasSheet(const ExportOrder& order) {
  return order.of<SheetOptions>().kind != SheetKind::none;
}

OptionList sheetOptions() {
  static constexpr std::array all{
      &pureInkOption, &viewsOption,      &sheetOption,       &paper,    &title,   &text, &landscape,
      &askedOption,   &askedNamesOption, &askCalloutsOption, &wordBank, &keyPlace};
  return all;
}

OptionList paperOptions() {
  static constexpr std::array all{&paper, &title, &text, &landscape};
  return all;
}

}  // namespace sline::render
