// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

namespace sline::widgets {

class ThumbnailCard;

/// Cards side by side, as many in a row as fit, all of one size.
class CardGrid : public QWidget {
  Q_OBJECT
 public:
  explicit CardGrid(QWidget* parent = nullptr);
  /// Takes them; those that were there go.
  void setCards(std::vector<ThumbnailCard*> cards);
  const std::vector<ThumbnailCard*>& cards() const { return m_cards; }
  /// Cards beyond these rows are not shown; 0: all are.
  void setMostRows(int rows);

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Places {
    int columns = 1;
    int shown = 0;
    QSize card;
  };
  Places placesFor(int width) const;
  void place();

  std::vector<ThumbnailCard*> m_cards;
  int m_mostRows = 0;
};

}  // namespace sline::widgets
