// SPDX-License-Identifier: Apache-2.0
// Gathers what a picture shows before it is put into words.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "render/export/order/export_order.h"

namespace sline::render {

/// A structure that one sees.
struct SeenStructure {
  model::NodeId id;
  QString name;           ///< that of its label, or its own in the language; one line
  bool labelled = false;  ///< a label of the picture points at it
  float across = 0.5f;    ///< where the middle of what one sees stands: 0 left, 1 right
};
/// A structure, and those that it hides a part of.
struct SeenBefore {
  model::NodeId before;
  std::vector<model::NodeId> behind;
};

struct PictureFacts {
  std::vector<SeenStructure> structures;  ///< those of which one sees most first
  std::vector<SeenBefore> before;         ///< what is most hidden first
  QStringList distances;  ///< what distances of the picture lead from and to, and their lengths
  /// The sides of the body that face the viewer, the most first; none where sides are not known.
  std::vector<model::AnatomicalView> from;
  std::optional<model::AnatomicalView> left;  ///< the side of the body at the picture's left edge
  std::optional<model::AnatomicalView> top;   ///< and at its upper edge, where that is not superior
  bool sidesInDoubt = false;                  ///< one of these is told, and nobody is sure of it
};

PictureFacts pictureFacts(const ExportOrder& order);

}  // namespace sline::render
