// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_file.h"

#include "model/base/letters.h"
#include "model/disk/whole_file.h"
#include "model/disk/whole_folder.h"
#include "render/export/anki/anki_cards.h"
#include "render/export/anki/anki_options.h"
#include "render/export/anki/anki_package.h"
#include "render/export/anki/anki_text.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

constexpr const char* textName = "deck.txt";

Status fillFolder(const AnkiDeck& deck, const fs::path& folder) {
  for (const model::ZipMember& picture : deck.media)
    TRY(model::writeText(folder / picture.name, picture.bytes));
  return model::writeText(folder / textName, ankiText(deck));
}

Result<std::string> zippedText(const AnkiDeck& deck) {
  const model::ZipMember text{textName, ankiText(deck)};
  std::vector<const model::ZipMember*> members{&text};
  for (const model::ZipMember& picture : deck.media)
    members.push_back(&picture);
  return model::zipped(members);
}

}  // namespace

std::size_t ankiCardsAtMost(const ExportOrder& order) {
  const auto& options = order.of<AnkiOptions>();
  const auto cardsOf = [&options](const ExportOrder& one) {
    std::size_t cards = 0;
    for (const model::Question& question : questionsOf(one)) {
      cards += question.labels.size() * (std::size_t(options.nameIt) + std::size_t(options.cover));
      cards += std::size_t(options.findIt);
    }
    return cards;
  };
  if (!wantsAllViews(order))
    return cardsOf(order);
  std::size_t cards = 0;
  for (const model::View& view : order.scene.views())
    cards += cardsOf(pictureOfView(order, view));
  return cards;
}

Status writeAnki(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  const auto named = [&target](Error error) {
    error.file = target.string();
    return error;
  };
  const auto write = [&](const auto& put) -> Status {
    const AnkiDeck deck = TRY(ankiCards(order, progress));
    if (progress && !progress(0.95, "writing the deck"))
      return givenUp(target);
    return put(deck);
  };
  const std::string extension = lowerExtension(target);
  Status written =
      extension == ".apkg" || extension == ".zip"
          ? write([&](const AnkiDeck& deck) -> Status {
              const Result<std::string> bytes =
                  extension == ".apkg" ? ankiPackage(deck) : zippedText(deck);
              return bytes.ok() ? model::writeText(target, *bytes) : Status(bytes.error());
            })
          : model::writeFolder(target, [&](const fs::path& folder) {
              return write([&](const AnkiDeck& deck) { return fillFolder(deck, folder); });
            });
  return written.ok() ? written : Status(named(written.error()));
}

}  // namespace sline::render
