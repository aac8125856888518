// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_options.h"

#include <QtGlobal>
#include <array>

#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace {

constexpr ExportOption deck{
    .id = "deck",
    .flag = "--deck",
    .value = "NAME",
    .help =
        "What Anki's deck is called, else as the view; \"::\" parts decks from those in them, such "
        "as "
        "those of all views",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Deck"),
    .tip =
        QT_TRANSLATE_NOOP("sline::render::ExportOption", "Its name in Anki; else the view's name"),
    .kind = TextOption{.longest = 1000},
    .field = boundTo([](auto& o) -> auto& { return o.template of<AnkiOptions>().deck; }),
    .kept = false};

constexpr ExportOption findIt{
    .id = "cardsFind",
    .flag = "--find-cards,!--no-find-cards",
    .help = "Anki's cards name something and ask which number it has in the picture",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Which number is it?"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "A card for each name, which asks for its number in the picture"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<AnkiOptions>().findIt; })};

constexpr ExportOption cover{
    .id = "cardsCover",
    .flag = "--cover-cards,!--no-cover-cards",
    .help = "Anki's cards show all names but one, which is covered",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Which name is covered?"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "A card for each label, which covers its name among the others"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<AnkiOptions>().cover; })};

}  // namespace

constinit const ExportOption cardsOption{
    .id = "cardsName",
    .flag = "--name-cards,!--no-name-cards",
    .help = "Anki's cards mark a place and ask what it is",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "What is this?"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "A card for each label, which marks the place and asks what it is"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<AnkiOptions>().nameIt; })};

OptionList ankiOptions() {
  static constexpr std::array all{
      &viewsOption, &deck,        &cardsOption,      &findIt,
      &cover,       &askedOption, &askedNamesOption, &askCalloutsOption};
  return all;
}

bool hasCards(const AnkiOptions& options) {
  return options.nameIt || options.findIt || options.cover;
}

}  // namespace sline::render
