// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/lettering.h"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainterPathStroker>
#include <algorithm>
#include <cmath>

#include "render/drawn/surface_fill.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

/// A quarter of a circle as one Bézier has its control points this far along the tangents.
constexpr float quarter = 0.5522847f;

/// The height of small letters as a share of that of capitals.
constexpr float smallLetters = 0.75f;

QPointF point(const glm::vec2& p) {
  return {qreal(p.x), qreal(p.y)};
}

QPen pen(const LetteringShape& shape, const Colour& colour, float width, bool halo) {
  QPen made(painterColour(colour), qreal(width), Qt::SolidLine, halo ? Qt::RoundCap : Qt::FlatCap,
            Qt::RoundJoin);
  if (shape.dashed && !halo)
    made.setDashPattern({qreal(dashPens), qreal(gapPens)});
  return made;
}

/// Tells whether what is painted on is a page of a PDF, whose drawing lies below it.
bool isPdf(QPainter& painter) {
  return painter.paintEngine() && painter.paintEngine()->type() == QPaintEngine::Pdf;
}

/// Tells whether parts of what is painted on may be clear.
bool hasAlpha(QPainter& painter) {
  const QPaintDevice* device = painter.device();
  return device && device->devType() == QInternal::Image &&
         static_cast<const QImage*>(device)->hasAlphaChannel();
}

void paintHalo(QPainter& painter, const LetteringItem& item, const Colour& ground) {
  for (const LetteringShape& shape : item.shapes) {
    if (shape.ground)
      painter.fillPath(painterPath(shape.path), painterColour(ground));
    if (shape.halo <= 0.0f)
      continue;
    painter.setPen(pen(shape, ground, shape.pen + 2.0f * shape.halo, true));
    painter.setBrush(shape.fill ? QBrush(painterColour(ground)) : QBrush(Qt::NoBrush));
    painter.drawPath(painterPath(shape.path));
  }
  if (item.text)
    painter.strokePath(haloOf(*item.text), QPen(painterColour(ground), qreal(2.0f * textHalo),
                                                Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

/// Returns the dashes as areas: of a pen narrower than a pixel, painters of pixels take the pattern
/// for that of a pen one pixel wide, and dashes stand elsewhere than in vectors.
QPainterPath dashesOf(const LetteringShape& shape) {
  QPainterPathStroker stroker;
  stroker.setWidth(qreal(shape.pen));
  stroker.setCapStyle(Qt::FlatCap);
  stroker.setJoinStyle(Qt::RoundJoin);
  stroker.setDashPattern({qreal(dashPens), qreal(gapPens)});
  return stroker.createStroke(painterPath(shape.path));
}

void paintInk(QPainter& painter, const LetteringItem& item, const TextSetter& setText) {
  const bool pixels = painter.paintEngine()->type() == QPaintEngine::Raster;
  for (const LetteringShape& shape : item.shapes) {
    if (shape.ground)
      continue;
    if (pixels && shape.dashed && shape.pen > 0.0f && !shape.fill) {
      painter.fillPath(dashesOf(shape), painterColour(shape.ink));
      continue;
    }
    painter.setPen(shape.pen > 0.0f ? pen(shape, shape.ink, shape.pen, false) : QPen(Qt::NoPen));
    painter.setBrush(shape.fill ? QBrush(painterColour(*shape.fill)) : QBrush(Qt::NoBrush));
    painter.drawPath(painterPath(shape.path));
  }
  if (item.text && setText)
    setText(painter, *item.text);
  else if (item.text)
    painter.fillPath(outlineOf(*item.text), painterColour(item.text->ink));
}

}  // namespace

LetteringColours letteringColours(Background background) {
  const bool clear = background == Background::transparent;
  const glm::vec4 ground = 255.0f * backgroundColour(clear ? Background::white : background);
  const auto part = [](float value) { return std::uint8_t(std::lround(value)); };
  return {.ink = background == Background::dark ? Colour{240, 240, 240} : Colour{0, 0, 0},
          .ground = {part(ground.r), part(ground.g), part(ground.b)},
          .clear = clear};
}

QColor painterColour(const Colour& colour) {
  return {colour.red, colour.green, colour.blue};
}

Path polyline(const std::vector<glm::vec2>& points) {
  if (points.empty())
    return {};
  Curve curve{.start = points.front(), .pieces = {}, .closed = false};
  for (std::size_t i = 1; i < points.size(); ++i)
    curve.pieces.push_back({points[i - 1], points[i], points[i]});
  return {curve};
}

Path circle(const glm::vec2& middle, float radius) {
  return roundedBox(middle - radius, middle + radius, radius);
}

Path roundedBox(const glm::vec2& low, const glm::vec2& high, float radius) {
  const float r = std::min({radius, 0.5f * (high.x - low.x), 0.5f * (high.y - low.y)});
  const float k = (1.0f - quarter) * r;  // distance of a control point from the corner
  Curve curve{.start = {low.x + r, low.y}, .pieces = {}, .closed = true};
  glm::vec2 last = curve.start;
  const auto line = [&](const glm::vec2& end) {
    if (end != last)
      curve.pieces.push_back({last, end, end});
    last = end;
  };
  const auto bend = [&](const glm::vec2& a, const glm::vec2& b, const glm::vec2& end) {
    curve.pieces.push_back({a, b, end});
    last = end;
  };
  line({high.x - r, low.y});
  bend({high.x - k, low.y}, {high.x, low.y + k}, {high.x, low.y + r});
  line({high.x, high.y - r});
  bend({high.x, high.y - k}, {high.x - k, high.y}, {high.x - r, high.y});
  line({low.x + r, high.y});
  bend({low.x + k, high.y}, {low.x, high.y - k}, {low.x, high.y - r});
  line({low.x, low.y + r});
  bend({low.x, low.y + k}, {low.x + k, low.y}, {low.x + r, low.y});
  return {curve};
}

QPainterPath painterPath(const Path& path) {
  QPainterPath made;
  for (const Curve& curve : path) {
    made.moveTo(point(curve.start));
    for (const Cubic& piece : curve.pieces)
      made.cubicTo(point(piece.control1), point(piece.control2), point(piece.end));
    if (curve.closed)
      made.closeSubpath();
  }
  return made;
}

std::vector<float> runPlaces(const LetteringText& text, const TextLine& line) {
  const float em = text.points * millimetresPerPoint;
  const float width = textWidthMm(line, text.points);
  float left = text.anchor == TextAnchor::end      ? -width
               : text.anchor == TextAnchor::middle ? -0.5f * width
                                                   : 0.0f;
  left += line.indent * em;
  std::vector<float> places;
  for (const TextRun& run : line.runs) {
    places.push_back(left);
    left += float(QFontMetricsF(labelFont(run.style)).horizontalAdvance(run.text)) * em /
            float(labelFontPixels);
  }
  return places;
}

QPainterPath outlineOf(const LetteringText& text) {
  const qreal scale = qreal(text.points * millimetresPerPoint) / labelFontPixels;
  QPainterPath letters;
  qreal baseline = qreal(text.at.y);
  for (const TextLine& line : text.lines) {
    const std::vector<float> places = runPlaces(text, line);
    for (std::size_t i = 0; i < line.runs.size(); ++i) {
      QPainterPath path;
      path.addText(0.0, 0.0, labelFont(line.runs[i].style), line.runs[i].text);
      const qreal left = qreal(text.at.x + places[i]);
      letters.addPath(QTransform(scale, 0.0, 0.0, scale, left, baseline).map(path));
    }
    baseline += qreal(text.leading);
  }
  letters.setFillRule(Qt::WindingFill);
  return letters;
}

QPainterPath haloOf(const LetteringText& text) {
  QPainterPath halo = outlineOf(text);
  // Bars as high as small letters, as many as cover that height without a gap.
  const float high = smallLetters * capHeightMm(text.points);
  const int bars = std::max(1, int(std::ceil((high - 2.0f * textHalo) / (2.0f * textHalo))) + 1);
  const float between = bars > 1 ? (high - 2.0f * textHalo) / float(bars - 1) : 0.0f;
  float baseline = text.at.y;
  for (const TextLine& line : text.lines) {
    const std::vector<float> places = runPlaces(text, line);
    if (!places.empty() &&
        line.runs.size() + std::size_t(plainText({line}).count(QChar(' '))) > 1) {
      const float left = text.at.x + places.front();
      const float right =
          left + textWidthMm(line, text.points) - line.indent * text.points * millimetresPerPoint;
      for (int i = 0; i < bars; ++i) {
        const float y = baseline - textHalo - float(i) * between;
        halo.moveTo(QPointF(qreal(left), qreal(y)));
        halo.lineTo(QPointF(qreal(right), qreal(y)));
      }
    }
    baseline += text.leading;
  }
  return halo;
}

void paintLettering(QPainter& painter, const Lettering& lettering, const TextSetter& setText) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (lettering.clear && hasAlpha(painter))
    painter.setCompositionMode(QPainter::CompositionMode_DestinationOut);
  const bool halos = !lettering.clear || !isPdf(painter);
  for (const LetteringItem& item : lettering.items)
    if (halos)
      paintHalo(painter, item, lettering.ground);
  painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
  for (const LetteringItem& item : lettering.items)
    paintInk(painter, item, setText);
  painter.restore();
}

}  // namespace sline::render
