// SPDX-License-Identifier: Apache-2.0
// The labels of one picture, laid out and painted by whoever draws the picture, so that they belong
// to it and the window has only to show them.
#pragma once

#include <QImage>
#include <QPoint>
#include <QString>
#include <map>
#include <memory>
#include <optional>

#include "render/lettering/label_painter.h"

namespace sline::widgets {

/// How labels are wanted in a window's picture.
struct LabelWish {
  render::LabelStyle style{.mode = render::LabelMode::off};
  glm::vec2 size{0.0f};  ///< the window's picture, in its pixels
  float pixelsPerMm = 96.0f / 25.4f;
  double ratio = 1.0;   ///< the screen's pixels to the window's
  int document = 0;     ///< another one has nothing to do with the labels before
  bool moving = false;  ///< the camera is on its way: who has just jumped does not jump again
  int arrivals = 0;     ///< another one is another view: labels stand as if there were none before
};

struct LabelSheet {
  model::Camera camera;
  LabelWish wish;
  render::LabelPlate plate;
  model::Camera settled;  ///< of the last layout that followed no other
  QImage image;           ///< of all that is painted; transparent elsewhere
  QPointF corner;         ///< where it lies, in the window's pixels

  bool empty() const { return plate.layout.labels.empty(); }
  /// Some labels were left out only because the camera moved.
  bool waits() const { return wish.moving && !plate.layout.waiting.empty(); }
};
/// The picture is so much larger or smaller that labels that followed it may stand anywhere.
bool outgrown(const model::Camera& settled, const model::Camera& camera);

using LabelSheetPtr = std::shared_ptr<const LabelSheet>;

/// Lives where pictures are drawn. Each sheet starts from the one before, so that labels are steady
/// while the camera turns.
class LabelDrawer {
 public:
  /// Nothing while meshes must be sorted first, which takes longer than a picture may.
  LabelSheetPtr draw(const model::Scene& scene, const model::Camera& camera, const LabelWish& wish);
  /// Sorts one mesh; false where none is left.
  bool prepare(const model::Scene& scene);

 private:
  const render::LabelLayout* before(const model::Camera& camera, const LabelWish& wish) const;
  void paint(LabelSheet& sheet);
  void paintTexts(QPainter& painter, const LabelSheet& sheet);

  model::MeshTrees m_trees;
  LabelSheetPtr m_last;
  model::Scene m_lastScene;
  /// Texts as they were painted, by all that their looks depend on: letters with halos take longer
  /// to paint than all else, and only their places change while a camera turns.
  std::map<QString, QImage> m_texts;
};

}  // namespace sline::widgets
