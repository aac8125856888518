// SPDX-License-Identifier: Apache-2.0
// Lays out and paints the labels of one picture on the thread that draws the picture, so that they
// belong to it and the window only has to show them.
#pragma once

#include <QImage>
#include <QPoint>
#include <QString>
#include <map>
#include <memory>
#include <optional>

#include "render/lettering/label_painter.h"
#include "widgets/annotations/label_sights.h"

namespace sline::widgets {

/// Describes how labels are to appear in a window's picture.
struct LabelWish {
  render::LabelStyle style{.mode = render::LabelMode::off};
  glm::vec2 size{0.0f};  ///< the window's picture, in its pixels
  float pixelsPerMm = 96.0f / 25.4f;
  double ratio = 1.0;   ///< screen pixels per pixel of the window
  int document = 0;     ///< a new document has no relation to the labels before it
  bool moving = false;  ///< the camera is moving: a label that has just jumped does not jump again
  int arrivals = 0;     ///< changes with the view: labels then stand as if none were before
};

struct LabelSheet {
  model::Camera camera;
  LabelWish wish;
  render::LabelPlate plate;
  model::Camera settled;  ///< the camera of the last layout that did not follow another one
  QImage image;           ///< everything that is painted; transparent elsewhere
  QPointF corner;         ///< the image's corner, in the window's pixels

  bool empty() const { return plate.layout.labels.empty(); }
  /// Tells whether labels were left out, or places not looked for, because the camera was moving.
  bool waits() const { return wish.moving && !plate.labels.empty(); }
};
/// Tells whether the picture has grown or shrunk so much that labels that followed it may stand
/// anywhere.
bool outgrown(const model::Camera& settled, const model::Camera& camera);

/// Returns which labels the sheet lacks or has with a dashed leader; none where no labels are
/// wanted.
LabelSightsById sightsOf(const LabelSheet& sheet);

using LabelSheetPtr = std::shared_ptr<const LabelSheet>;

/// Draws label sheets on the thread that draws pictures. Each sheet starts from the one before, so
/// that labels are steady while the camera turns.
class LabelDrawer {
 public:
  /// Returns null while meshes must be sorted first, which takes longer than a picture may.
  LabelSheetPtr draw(const model::Scene& scene, const model::Camera& camera, const LabelWish& wish);
  /// Sorts one mesh; returns false where none is left.
  bool prepare(const model::Scene& scene);

 private:
  std::optional<render::LabelLayout> before(const model::Camera& camera,
                                            const LabelWish& wish) const;
  void paint(LabelSheet& sheet);
  void paintTexts(QPainter& painter, const LabelSheet& sheet);

  model::MeshTrees m_trees;
  LabelSheetPtr m_last;
  model::Scene m_lastScene;
  /// Painted texts, keyed by everything that their looks depend on: letters with halos take longer
  /// to paint than all else, and only their places change while a camera turns.
  std::map<QString, QImage> m_texts;
};

}  // namespace sline::widgets
