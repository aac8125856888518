// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/drawing_choice.h"

#include <QVBoxLayout>

#include "widgets/start/card_grid.h"
#include "widgets/start/thumbnail_card.h"

namespace sline::widgets {

namespace {

// All styles stand in one row of a page of usual width.
constexpr CardWidths cardWidths{.least = 136, .most = 170};
constexpr const char* styleOfCard = "drawing";

}  // namespace

DrawingChoice::DrawingChoice(PictureCache built, QWidget* parent)
    : QWidget(parent), m_built(std::move(built)), m_cards(new CardGrid) {
  setObjectName(QStringLiteral("startDrawings"));
  m_cards->setCardWidths(cardWidths);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_cards);
}

void DrawingChoice::offer(const std::vector<OfferedDrawing>& drawings) {
  std::vector<ThumbnailCard*> cards;
  for (const OfferedDrawing& drawing : drawings) {
    auto* card = new ThumbnailCard(drawing.name);
    card->setObjectName(QStringLiteral("startDrawing-") + drawing.id);
    card->setProperty(styleOfCard, drawing.id);
    card->setToolTip(drawing.description);
    card->setAccessibleDescription(drawing.description);
    card->setStandIn(QStringLiteral("context"));
    card->setPicture(m_built.find(drawing.picture));
    card->setCheckable(true);
    card->setAutoExclusive(true);
    connect(card, &ThumbnailCard::clicked, this, [this, id = drawing.id] { emit chosen(id); });
    cards.push_back(card);
  }
  m_cards->setCards(std::move(cards));
}

void DrawingChoice::setChosen(const QString& id) {
  // Among exclusive buttons the checked one cannot be unchecked, and is the only stop of Tab.
  for (ThumbnailCard* card : m_cards->cards()) {
    card->setAutoExclusive(false);
    card->setChecked(card->property(styleOfCard).toString() == id);
  }
  bool any = false;
  for (const ThumbnailCard* card : m_cards->cards())
    any = any || card->isChecked();
  for (ThumbnailCard* card : m_cards->cards()) {
    card->setAutoExclusive(true);
    card->setFocusPolicy(!any || card->isChecked() ? Qt::StrongFocus : Qt::ClickFocus);
  }
}

}  // namespace sline::widgets

#include "moc_drawing_choice.cpp"
