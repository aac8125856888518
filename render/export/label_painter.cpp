// SPDX-License-Identifier: Apache-2.0
#include "render/export/label_painter.h"

#include <QPainterPath>
#include <algorithm>

namespace sline::render {

namespace {

// Millimetres of the output.
constexpr qreal leaderWidth = 0.2;
constexpr qreal haloWidth = 0.5;  // on either side of letters
constexpr qreal lineHalo = 0.35;  // and of lines
constexpr qreal dotRadius = 0.5;
constexpr qreal pinRadius = 0.8;

QPointF point(const glm::vec2& p) {
  return {qreal(p.x), qreal(p.y)};
}
QRectF rect(const LabelBox& box) {
  return {point(box.low), point(box.high)};
}

float widestText(float pictureWidthMm, const LabelStyle& style) {
  const float em = style.points * millimetresPerPoint;
  return std::max(6.0f * em, std::min(14.0f * em, 0.22f * pictureWidthMm));
}

/// Paints one plate; everything's halo first, so that none covers another's ink.
class Painting {
 public:
  Painting(QPainter& painter, const LabelPlate& plate)
      : m_painter(painter),
        m_plate(plate),
        m_ink(plate.style.onDark ? QColor(240, 240, 240) : QColor(17, 17, 17)),
        m_ground(plate.style.onDark ? QColor(28, 28, 30) : QColor(Qt::white)) {}

  void paint() {
    for (const bool halo : {true, false})
      for (std::size_t i = 0; i < m_plate.labels.size(); ++i)
        if (const PlacedLabel* placed = m_plate.layout.find(m_plate.labels[i].item.id)) {
          paintLeader(*placed, halo);
          paintPlaces(i, halo);
          paintBox(i, *placed, halo);
        }
  }

 private:
  QPen pen(qreal width, bool halo) const {
    return {halo ? m_ground : m_ink, halo ? width + 2.0 * lineHalo : width, Qt::SolidLine,
            halo ? Qt::RoundCap : Qt::FlatCap, Qt::RoundJoin};
  }

  void paintLeader(const PlacedLabel& placed, bool halo) {
    if (placed.leader.size() < 2)
      return;
    QPen line = pen(leaderWidth, halo);
    if (placed.hidden && !halo)
      line.setDashPattern({5.0, 4.0});
    m_painter.setPen(line);
    m_painter.setBrush(Qt::NoBrush);
    QPolygonF points;
    for (const glm::vec2& p : placed.leader)
      points.push_back(point(p));
    m_painter.drawPolyline(points);
  }

  void paintPlaces(std::size_t i, bool halo) {
    const LabelItem& item = m_plate.labels[i].item;
    if (item.kind == model::AnnotationKind::distance) {
      paintDistance(item, halo);
      return;
    }
    const qreal radius = item.kind == model::AnnotationKind::pin ? pinRadius : dotRadius;
    for (const glm::vec2& place : item.places)
      paintDot(point(place), radius, i, halo);
  }

  void paintDot(const QPointF& place, qreal radius, std::size_t i, bool halo) {
    const std::optional<Colour>& own = m_plate.labels[i].colour;
    const QColor colour = own ? QColor(own->red, own->green, own->blue) : m_ink;
    if (halo) {
      m_painter.setPen(Qt::NoPen);
      m_painter.setBrush(m_ground);
      m_painter.drawEllipse(place, radius + 0.4, radius + 0.4);
      return;
    }
    const bool hidden = m_plate.labels[i].item.hidden;
    m_painter.setPen(hidden ? QPen(colour, leaderWidth) : QPen(Qt::NoPen));
    m_painter.setBrush(hidden ? m_ground : colour);
    m_painter.drawEllipse(place, radius, radius);
  }

  /// A line with a bar across at either end.
  void paintDistance(const LabelItem& item, bool halo) {
    if (item.places.size() != 2)
      return;
    QPen line = pen(1.25 * leaderWidth, halo);
    m_painter.setPen(line);
    const QLineF way(point(item.places[0]), point(item.places[1]));
    const QPointF across =
        way.length() > 0.0 ? (way.normalVector().unitVector().p2() - way.p1()) : QPointF(0.0, 1.0);
    for (const QPointF& end : {way.p1(), way.p2()})
      m_painter.drawLine(end - 1.2 * across, end + 1.2 * across);
    if (item.hidden && !halo)
      line.setDashPattern({5.0, 4.0});
    m_painter.setPen(line);
    m_painter.drawLine(way);
  }

  void paintBox(std::size_t i, const PlacedLabel& placed, bool halo) {
    if (m_plate.style.mode == LabelMode::numbers)
      paintBadge(placed, halo);
    else if (m_plate.labels[i].item.kind == model::AnnotationKind::callout)
      paintFrame(placed, halo);
    if (m_plate.style.mode == LabelMode::blank)
      paintBlank(i, placed, halo);
    else
      paintText(i, placed, halo);
  }

  void paintBadge(const PlacedLabel& placed, bool halo) {
    const QRectF box = rect(placed.box);
    m_painter.setPen(pen(leaderWidth, halo));
    m_painter.setBrush(m_ground);
    m_painter.drawRoundedRect(box, 0.5 * box.height(), 0.5 * box.height());
  }

  void paintFrame(const PlacedLabel& placed, bool halo) {
    m_painter.setPen(pen(leaderWidth, halo));
    m_painter.setBrush(m_ground);
    m_painter.drawRoundedRect(rect(placed.box), 0.6, 0.6);
  }

  /// A line to write on, which goes on from the leader; a callout's frame is enough.
  void paintBlank(std::size_t i, const PlacedLabel& placed, bool halo) {
    if (m_plate.labels[i].item.kind == model::AnnotationKind::callout)
      return;
    const QRectF box = rect(placed.box);
    m_painter.setPen(pen(leaderWidth, halo));
    m_painter.drawLine(QPointF(box.left(), box.center().y()),
                       QPointF(box.right(), box.center().y()));
  }

  /// Towards the place: in the left column to the right, in the right one and beside to the left.
  Qt::Alignment alignmentOf(std::size_t i, const PlacedLabel& placed) const {
    if (m_plate.style.mode == LabelMode::numbers)
      return Qt::AlignHCenter;
    const float place = m_plate.labels[i].item.places.front().x;
    if (placed.post == LabelPost::left ||
        (placed.post == LabelPost::beside && placed.box.high.x < place))
      return Qt::AlignRight;
    return Qt::AlignLeft;
  }

  void paintText(std::size_t i, const PlacedLabel& placed, bool halo) {
    const LabelText& text = m_plate.texts[i];
    const QFont font = labelFont();
    const QFontMetricsF metrics(font);
    const qreal scale = qreal(m_plate.style.points * millimetresPerPoint) / labelFontPixels;
    const qreal height = qreal(lineHeightMm(m_plate.style));
    const glm::vec2 padding = paddingOf(m_plate.labels[i].item.kind, m_plate.style);
    const QRectF box = rect(placed.box).adjusted(qreal(padding.x), 0.0, -qreal(padding.x), 0.0);
    const Qt::Alignment alignment = alignmentOf(i, placed);
    qreal top = box.center().y() - 0.5 * height * qreal(text.lines.size());
    QPainterPath letters;
    for (const QString& line : text.lines) {
      const qreal spare = box.width() - scale * metrics.horizontalAdvance(line);
      const qreal left = box.left() + (alignment == Qt::AlignRight     ? spare
                                       : alignment == Qt::AlignHCenter ? 0.5 * spare
                                                                       : 0.0);
      // Capitals stand in the middle of their line.
      const qreal baseline = top + 0.5 * height + 0.5 * scale * metrics.capHeight();
      QPainterPath path;
      path.addText(0.0, 0.0, font, line);
      letters.addPath(QTransform(scale, 0.0, 0.0, scale, left, baseline).map(path));
      top += height;
    }
    letters.setFillRule(Qt::WindingFill);
    if (halo)
      m_painter.strokePath(letters, pen(2.0 * (haloWidth - lineHalo), true));
    else
      m_painter.fillPath(letters, m_ink);
  }

  QPainter& m_painter;
  const LabelPlate& m_plate;
  QColor m_ink;
  QColor m_ground;
};

}  // namespace

LabelPlate labelPlate(const model::Scene& scene, const Screen& screen, const LabelStyle& style,
                      SightTrees& trees, const LabelTurn& turn) {
  LabelPlate plate{.style = style,
                   .labels = shownLabels(scene, screen, style.language, trees),
                   .texts = {},
                   .layout = {}};
  LabelRequest request{.items = {},
                       .space = {screen.size()},
                       .obstacles = {},
                       .towardsEye = model::cameraFrame(screen.camera()).back,
                       .moving = turn.moving};
  for (ShownLabel& label : plate.labels) {
    plate.texts.push_back(textOf(label, style, widestText(screen.size().x, style)));
    label.item.box = plate.texts.back().box;
    request.items.push_back(label.item);
  }
  if (!request.items.empty())
    request.obstacles = obstaclesOf(scene, screen);
  plate.layout = layOutLabels(request, turn.before);
  return plate;
}

void paintLabels(QPainter& painter, const LabelPlate& plate) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  Painting(painter, plate).paint();
  painter.restore();
}

float columnRoomMm(const model::Scene& scene, const LabelStyle& style, float pictureWidthMm) {
  float widest = 0.0f;
  int number = 0;
  for (const model::Annotation& annotation : scene.annotations()) {
    if (!annotation.visible)
      continue;
    ShownLabel label;
    label.item.kind = annotation.kind;
    label.text = model::textIn(annotation, style.language);
    label.number = ++number;
    widest = std::max(widest, textOf(label, style, widestText(pictureWidthMm, style)).box.x);
  }
  constexpr float besideText = 8.0f;  // the output's edge, the leader's level piece, air
  return widest > 0.0f ? widest + besideText : 0.0f;
}

}  // namespace sline::render
