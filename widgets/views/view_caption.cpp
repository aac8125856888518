// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_caption.h"

#include <QPainter>
#include <algorithm>

namespace sline::widgets {

namespace {

constexpr int air = 2;            // pixels around the box, for its pen
constexpr int footMargin = 12;    // pixels
constexpr int sideMargin = 24;    // pixels
constexpr float tallest = 0.45f;  // of the picture's height

}  // namespace

ViewCaption::ViewCaption(Viewport& viewport) : QWidget(&viewport), m_viewport(viewport) {
  setObjectName(QStringLiteral("viewCaption"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void ViewCaption::say(const std::string& markup, Place place, int clear) {
  m_markup = markup;
  m_place = place;
  m_clear = clear;
  this->place();
}

std::optional<render::Caption> ViewCaption::made() const {
  const LabelWish wish = m_viewport.labels().wish();
  const float scale = wish.pixelsPerMm;
  const glm::vec2 size = wish.size / scale;
  const float side = sideMargin / scale;
  render::CaptionPlace place{.middle = 0.5f * size.x,
                             .foot = size.y - float(footMargin + m_clear) / scale,
                             .width = render::captionShare * size.x,
                             .height = tallest * size.y};
  if (m_place == Place::corner)
    place.width = std::min(0.36f * size.x, size.x - 2.0f * side);
  std::optional<render::Caption> caption = render::captionOf(m_markup, wish.style, place);
  if (!caption || m_place == Place::foot)
    return caption;
  place.middle = side + 0.5f * caption->box.size().x;
  return render::captionOf(m_markup, wish.style, place);
}

void ViewCaption::place() {
  m_caption = made();
  setVisible(m_caption.has_value());
  if (!m_caption)
    return setGeometry({});
  const auto scale = qreal(m_viewport.labels().wish().pixelsPerMm);
  const render::LabelBox& box = m_caption->box;
  const QRectF area(qreal(box.low.x) * scale, qreal(box.low.y) * scale, qreal(box.size().x) * scale,
                    qreal(box.size().y) * scale);
  setGeometry(area.toAlignedRect().adjusted(-air, -air, air, air));
  const auto& lines = m_caption->item.text->lines;
  setAccessibleName(render::plainText(lines));
  raise();
  update();
}

std::vector<render::LinkPlace> ViewCaption::links() const {
  return m_caption ? render::linkPlaces(m_markup, *m_caption->item.text)
                   : std::vector<render::LinkPlace>();
}

void ViewCaption::paintEvent(QPaintEvent*) {
  if (!m_caption)
    return;
  const LabelWish wish = m_viewport.labels().wish();
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.translate(-pos());
  painter.scale(qreal(wish.pixelsPerMm), qreal(wish.pixelsPerMm));
  render::paintLettering(painter, {.ground = render::letteringColours(wish.style.ground).ground,
                                   .items = {m_caption->item}});
}

}  // namespace sline::widgets

#include "moc_view_caption.cpp"
