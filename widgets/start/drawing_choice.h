// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/start/picture_cache.h"

namespace sline::widgets {

class CardGrid;

/// Holds a drawing style that the start page offers.
struct OfferedDrawing {
  QString id;       ///< what is told of a choice
  QString picture;  ///< its name among the pictures that came with the program
  QString name;
  QString description;
};

/// Lets one drawing style be chosen for what is opened next, by cards of which one is checked: one
/// stop of the Tab key, within which the arrow keys choose, as among radio buttons.
class DrawingChoice : public QWidget {
  Q_OBJECT
 public:
  explicit DrawingChoice(PictureCache built, QWidget* parent = nullptr);
  void offer(const std::vector<OfferedDrawing>& drawings);
  /// Checks the style of that id, or none if it is not among them; tells nobody.
  void setChosen(const QString& id);

 signals:
  void chosen(const QString& id);

 private:
  PictureCache m_built;
  CardGrid* m_cards;
};

}  // namespace sline::widgets
