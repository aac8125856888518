// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/presented_links.h"

#include <QPainter>
#include <algorithm>

namespace sline::widgets {

namespace {

// Of a line's height, from the baseline down.
constexpr double underline = 0.14;
constexpr double underlineWidth = 0.06;
constexpr QRgb linkInk = 0xff1f6fd0;  // 3:1 and more on white and on black

}  // namespace

std::optional<model::LinkTarget> followed(const model::MarkupLink& link, Session& session) {
  return model::linkTarget(link, session.scene(), [&session](const std::string& name) {
    std::vector<std::string> others;
    for (const QString& other : session.names().alsoCalled(QString::fromStdString(name)))
      others.push_back(other.toStdString());
    return others;
  });
}

PresentedLinks::PresentedLinks(Session& session, QWidget& picture)
    : QWidget(&picture), m_session(session) {
  setObjectName(QStringLiteral("presentedLinks"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void PresentedLinks::take(const std::vector<render::LinkPlace>& places, float pixelsPerMm) {
  m_links.clear();
  const auto scale = double(pixelsPerMm);
  for (const render::LinkPlace& place : places)
    if (const auto target = followed(place.link, m_session)) {
      const QRectF area(scale * double(place.box.low.x), scale * double(place.box.low.y),
                        scale * double(place.box.size().x), scale * double(place.box.size().y));
      m_links.push_back({.area = area,
                         .baseline = scale * double(place.baseline) + underline * area.height(),
                         .thickness = std::max(1.0, underlineWidth * area.height()),
                         .target = *target});
    }
  setGeometry(parentWidget()->rect());
  setVisible(!m_links.empty());
  if (!m_links.empty())
    raise();
  update();
}

void PresentedLinks::clear() {
  m_links.clear();
  hide();
}

std::optional<model::LinkTarget> PresentedLinks::at(const QPointF& pixel) const {
  const auto found = std::find_if(m_links.begin(), m_links.end(),
                                  [&](const Link& link) { return link.area.contains(pixel); });
  return found == m_links.end() ? std::nullopt : std::optional(found->target);
}

std::vector<QRectF> PresentedLinks::areas() const {
  std::vector<QRectF> areas;
  for (const Link& link : m_links)
    areas.push_back(link.area);
  return areas;
}

void PresentedLinks::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Link& link : m_links)
    painter.fillRect(QRectF(link.area.left(), link.baseline, link.area.width(), link.thickness),
                     QColor(linkInk));
}

}  // namespace sline::widgets

#include "moc_presented_links.cpp"
