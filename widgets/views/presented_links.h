// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "model/scene/link_target.h"
#include "render/lettering/link_places.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Returns where a link in a text leads; names are compared in every language.
std::optional<model::LinkTarget> followed(const model::MarkupLink& link, Session& session);

/// Underlines the links of a presented picture's texts, and tells which one is at a place. The
/// mouse goes through it.
class PresentedLinks : public QWidget {
  Q_OBJECT
 public:
  PresentedLinks(Session& session, QWidget& picture);

  /// Takes the links of the texts that are shown; `pixelsPerMm` tells how large these are. Links
  /// that lead nowhere are plain words.
  void take(const std::vector<render::LinkPlace>& places, float pixelsPerMm);
  void clear();
  /// Returns where the link at that pixel leads.
  std::optional<model::LinkTarget> at(const QPointF& pixel) const;
  /// Returns the areas of links, in pixels.
  std::vector<QRectF> areas() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Link {
    QRectF area;
    double baseline = 0.0;
    double thickness = 1.0;
    model::LinkTarget target;
  };

  Session& m_session;
  std::vector<Link> m_links;
};

}  // namespace sline::widgets
