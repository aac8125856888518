// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/card_grid.h"

#include <algorithm>

#include "widgets/start/thumbnail_card.h"

namespace sline::widgets {

namespace {
constexpr int gap = 16;
}  // namespace

CardGrid::CardGrid(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void CardGrid::setCards(std::vector<ThumbnailCard*> cards) {
  // The cards are deleted later, because one of them may just be handling a click.
  for (ThumbnailCard* card : m_cards) {
    card->setParent(nullptr);
    card->deleteLater();
  }
  m_cards = std::move(cards);
  for (ThumbnailCard* card : m_cards) {
    card->setParent(this);
    card->show();
  }
  place();
  updateGeometry();
}

void CardGrid::setMostRows(int rows) {
  m_mostRows = rows;
  place();
  updateGeometry();
}

void CardGrid::setCardWidths(const CardWidths& widths) {
  m_widths = widths;
  place();
  updateGeometry();
}

CardGrid::Arrangement CardGrid::arrangementFor(int width) const {
  Arrangement places;
  places.columns = std::max(1, (width + gap) / (m_widths.least + gap));
  const int each = std::clamp((width - gap * (places.columns - 1)) / places.columns,
                              std::min(width, m_widths.least), m_widths.most);
  int height = 0;
  for (const ThumbnailCard* card : m_cards)
    height = std::max(height, card->heightForWidth(each));
  places.card = {each, height};
  places.shown = int(m_cards.size());
  if (m_mostRows > 0)
    places.shown = std::min(places.shown, m_mostRows * places.columns);
  return places;
}

int CardGrid::heightForWidth(int width) const {
  const Arrangement places = arrangementFor(width);
  const int rows = (places.shown + places.columns - 1) / places.columns;
  return rows * places.card.height() + std::max(0, rows - 1) * gap;
}

QSize CardGrid::sizeHint() const {
  constexpr int usual = 5;
  const int width = usual * (m_widths.least + gap) - gap;
  return {width, heightForWidth(width)};
}

QSize CardGrid::minimumSizeHint() const {
  return {m_widths.least, heightForWidth(std::max(1, width()))};
}

void CardGrid::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
  updateGeometry();
}

void CardGrid::place() {
  const Arrangement places = arrangementFor(width());
  for (int i = 0; i < int(m_cards.size()); ++i) {
    const QPoint at(i % places.columns * (places.card.width() + gap),
                    i / places.columns * (places.card.height() + gap));
    m_cards[std::size_t(i)]->setGeometry({at, places.card});
    m_cards[std::size_t(i)]->setVisible(i < places.shown);
  }
}

}  // namespace sline::widgets

#include "moc_card_grid.cpp"
