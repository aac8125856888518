// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/test_options.h"

#include <QtGlobal>
#include <algorithm>
#include <array>

namespace sline::render {

namespace {

constexpr std::array askedOfs{
    OptionChoice{.id = "all",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "All with a label"),
                 .value = int(AskedOf::labelled)},
    OptionChoice{.id = "focus",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Those in focus"),
                 .value = int(AskedOf::focus)}};

constexpr std::array keyPlaces{
    OptionChoice{.id = "next",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "After each test"),
                 .value = int(KeyPlace::next)},
    OptionChoice{.id = "end",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "At the end"),
                 .value = int(KeyPlace::end)}};

}  // namespace

constinit const ExportOption askedOption{
    .id = "asked",
    .flag = "--ask",
    .help = "What self-tests and cards ask for: all that has a label, or only what is in focus",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Test asks for"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "The fewer, the easier"),
    .kind = ChoiceOption{askedOfs},
    .field = boundTo([](auto& o) -> auto& { return o.template of<TestOptions>().of; })};

constinit const ExportOption askedNamesOption{
    .id = "askedNames",
    .flag = "--ask-only",
    .value = "NAMES",
    .help = "Structures or groups that self-tests and cards ask for, with commas between them",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Of these alone"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Names of structures or groups, with commas; empty: of all"),
    .kind = TextOption{.longest = 10'000},
    .field = boundTo([](auto& o) -> auto& { return o.template of<TestOptions>().names; }),
    .kept = false};

constinit const ExportOption askCalloutsOption{
    .id = "calloutsAsked",
    .flag = "--ask-callouts,!--no-ask-callouts",
    .help = "Self-tests and cards ask for callouts, too, not for labels alone",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Callouts, too"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Callouts explain; only labels name what can be asked for"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<TestOptions>().callouts; })};

constinit const ExportOption wordBankOption{
    .id = "wordBank",
    .flag = "--word-bank,!--no-word-bank",
    .help = "The self-test of a sheet has the answers to choose from, in another order",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Word bank"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "The self-test has the answers below, in another order"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<TestOptions>().wordBank; })};

constinit const ExportOption keyPlaceOption{
    .id = "keyPlace",
    .flag = "--key",
    .help =
        "Where the keys of all views' self-tests stand, each on a page of its own: after each "
        "test, or all at the end",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Key"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Where the answers stand, each test's on a page of its own"),
    .kind = ChoiceOption{keyPlaces},
    .field = boundTo([](auto& o) -> auto& { return o.template of<TestOptions>().key; })};

std::vector<std::string> askedNames(const ExportOrder& order) {
  constexpr const char* blanks = " \t\r\n";
  const std::string& all = order.of<TestOptions>().names;
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= all.size();) {
    const std::size_t to = std::min(all.find(',', from), all.size());
    const std::string name = all.substr(from, to - from);
    const std::size_t first = name.find_first_not_of(blanks);
    if (first != std::string::npos)
      names.push_back(name.substr(first, name.find_last_not_of(blanks) + 1 - first));
    from = to + 1;
  }
  return names;
}

std::vector<model::Question> questionsOf(const ExportOrder& order) {
  const TestOptions& test = order.of<TestOptions>();
  return model::questionsOf(order.scene, order.labels.language,
                            {.focusAlone = test.of == AskedOf::focus,
                             .names = askedNames(order),
                             .callouts = test.callouts,
                             .inSpace = true});
}

ExportOrder askedAlone(const ExportOrder& order, const std::vector<model::Question>& questions) {
  ExportOrder alone = order;
  alone.scene = model::withQuestionsAlone(order.scene, questions);
  return alone;
}

}  // namespace sline::render
