// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/test_options.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <random>
#include <utility>

namespace sline::render {

namespace {

constexpr std::array askedOfs{
    OptionChoice{.id = "all",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "All with a label"),
                 .value = int(AskedOf::labelled)},
    OptionChoice{.id = "focus",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Those in focus"),
                 .value = int(AskedOf::focus)}};

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

std::vector<std::string> shuffledWords(const std::vector<std::string>& answers) {
  std::vector<std::string> bank = answers;
  // From the alphabet's order, so that the order of the answers leaves no trace.
  std::sort(bank.begin(), bank.end());
  std::mt19937 random(20011);
  for (std::size_t i = bank.size(); i > 1; --i)
    std::swap(bank[i - 1], bank[random() % i]);
  for (std::size_t i = 1; i < bank.size() && bank == answers; ++i)
    std::rotate(bank.begin(), bank.begin() + 1, bank.end());
  return bank;
}

ExportOrder askedAlone(const ExportOrder& order, const std::vector<model::Question>& questions) {
  ExportOrder alone = order;
  alone.scene = model::withQuestionsAlone(order.scene, questions);
  return alone;
}

}  // namespace sline::render
