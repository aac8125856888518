// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <optional>
#include <span>
#include <vector>

#include "render/picture/picture.h"

namespace sline::widgets {

/// Says which structures have lines around them in the window: those that are selected, the one
/// under the mouse, and the one that an open menu tells of.
class PictureOutlines {
 public:
  /// Sets the structure under the mouse; returns whether that is another one.
  bool point(std::optional<model::NodeId> id);
  /// Sets the structure that a menu tells of; returns whether that is another one.
  bool light(std::optional<model::NodeId> id);

  struct Look {
    QColor accent;  ///< the theme's
    render::Background background = render::Background::white;
    float pixels = 1.0f;  ///< of the picture per pixel of the window
    bool pointed = true;  ///< the structure under the mouse has one
  };
  /// Returns the lines for a picture of the scene; those around groups are around what is in them.
  std::vector<render::Outline> around(const model::Scene& scene,
                                      std::span<const model::NodeId> selection,
                                      const Look& look) const;

 private:
  std::optional<model::NodeId> m_pointed;
  std::optional<model::NodeId> m_lit;
};

}  // namespace sline::widgets
