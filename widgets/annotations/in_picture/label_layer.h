// SPDX-License-Identifier: Apache-2.0
// Shows labels over the picture and finds the parts of them that can be dragged.
#pragma once

#include <QWidget>

#include "widgets/annotations/in_picture/label_sheet.h"

namespace sline::widgets {

/// A label's text, or one of the places that it points at.
struct LabelGrip {
  model::AnnotationId id;
  std::optional<std::size_t> place;
  bool operator==(const LabelGrip&) const = default;
};

/// Returns the part of the sheet that is at the pixel; places come before texts.
std::optional<LabelGrip> gripAt(const LabelSheet& sheet, const glm::vec2& pixel);
/// Returns the box of a label's text in the window's pixels; empty if it has none in the sheet.
QRectF boxOf(const LabelSheet& sheet, model::AnnotationId id);

class LabelLayer : public QWidget {
  Q_OBJECT
 public:
  explicit LabelLayer(QWidget* picture);

  /// Shows the labels of the current picture.
  void show(LabelSheetPtr sheet);
  /// Returns null where no labels are shown.
  const LabelSheet* sheet() const { return m_sheet.get(); }

  /// Holds what is marked besides the labels themselves.
  struct Marks {
    std::optional<model::AnnotationId> hovered;
    std::optional<model::AnnotationId> active;
    std::optional<glm::vec2> begun;  ///< the first place of a label that is being made
    std::optional<glm::vec2> mouse;  ///< where the second place of a distance would be
    bool operator==(const Marks&) const = default;
  };
  void mark(const Marks& marks);
  const Marks& marks() const { return m_marks; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void showState();
  void frame(QPainter& painter, model::AnnotationId id, bool active) const;

  LabelSheetPtr m_sheet;
  Marks m_marks;
};

}  // namespace sline::widgets
