// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

namespace sline::widgets {

class ThumbnailCard;

/// Says between what widths the cards of a grid stretch, in pixels.
struct CardWidths {
  int least = 176;
  int most = 240;
};

/// Arranges cards of one size side by side, as many in a row as fit.
class CardGrid : public QWidget {
  Q_OBJECT
 public:
  explicit CardGrid(QWidget* parent = nullptr);
  /// Takes ownership of the cards and removes the previous ones.
  void setCards(std::vector<ThumbnailCard*> cards);
  const std::vector<ThumbnailCard*>& cards() const { return m_cards; }
  /// Limits the rows that are shown; 0 shows all.
  void setMostRows(int rows);
  void setCardWidths(const CardWidths& widths);

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Arrangement {
    int columns = 1;
    int shown = 0;
    QSize card;
  };
  Arrangement arrangementFor(int width) const;
  void place();

  std::vector<ThumbnailCard*> m_cards;
  int m_mostRows = 0;
  CardWidths m_widths;
};

}  // namespace sline::widgets
