// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QListView>
#include <vector>

namespace sline::widgets {

/// Shows views as cards beside each other: a click or Enter goes there, F2 or a double click
/// renames, cards are dragged (or moved with Alt and an arrow key) to their place in the tour.
class ViewRow : public QListView {
  Q_OBJECT
 public:
  explicit ViewRow(QWidget* parent = nullptr);

  /// Returns the rows that are on screen, at least in part.
  std::vector<int> visibleRows() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void goWanted(int row);
  void removeWanted(int row);
  void moveWanted(int row, int to);
  /// Tells that other rows are on screen, or in another size.
  void visibleRowsChanged();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace sline::widgets
