// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_options.h"

#include <QtGlobal>
#include <array>

namespace sline::render {

namespace {

constexpr ExportOption deck{
    .id = "deck",
    .flag = "--deck",
    .value = "NAME",
    .help = "What Anki's deck is called, else as the view; \"::\" parts decks from those in them",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Deck"),
    .tip =
        QT_TRANSLATE_NOOP("sline::render::ExportOption", "Its name in Anki; else the view's name"),
    .kind = TextOption{.longest = 1000},
    .field = boundTo([](auto& o) -> auto& { return o.template of<AnkiOptions>().deck; }),
    .kept = false};

constexpr ExportOption othersShown{
    .id = "othersShown",
    .flag = "--other-labels,!--no-other-labels",
    .help = "Anki's cards show the labels that they do not ask for, too",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "S&how the other labels"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "A card asks for one label and shows the others"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<AnkiOptions>().othersShown; })};

constexpr ExportOption calloutsAsked{
    .id = "calloutsAsked",
    .flag = "--ask-callouts,!--no-ask-callouts",
    .help = "Anki's cards ask for callouts, too, not for labels alone",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Ask for &callouts, too"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Callouts explain; only labels name what a card can ask for"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<AnkiOptions>().calloutsAsked; })};

}  // namespace

OptionList ankiOptions() {
  static constexpr std::array all{&deck, &othersShown, &calloutsAsked};
  return all;
}

}  // namespace sline::render
