// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/gamma_curve.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace sline::widgets {

namespace {

constexpr double radius = 5.0;     // of a point's disc
constexpr double nearest = 12.0;   // a point is taken hold of from no farther than this
constexpr float snap = 0.05f;      // offsets are multiples of this
constexpr float leastGap = 0.01f;  // between neighbours, as a share of the range

// What these keys do elsewhere they do not do here.
constexpr std::array ownKeys{Qt::Key_Space, Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_Insert,
                             Qt::Key_Plus,  Qt::Key_Left,   Qt::Key_Right,     Qt::Key_Up,
                             Qt::Key_Down,  Qt::Key_PageUp, Qt::Key_PageDown};

/// Returns the scalars that the field shows.
Limits<float> rangeOf(model::GammaScalar scalar, const std::vector<model::GammaPoint>& points) {
  Limits<float> range{0.0f, 1.0f};
  if (scalar == model::GammaScalar::curvature)
    range = {-4.0f, 4.0f};
  if (scalar == model::GammaScalar::distance)
    range = {0.0f, 50.0f};
  constexpr float room = 1.25f;
  if (!points.empty() && points.front().scalar < range.low)
    range.low = room * points.front().scalar;
  if (!points.empty() && points.back().scalar > range.high / (range.high > 1.0f ? room : 1.0f))
    range.high = room * points.back().scalar;
  return range;
}

QString offsetText(const QLocale& locale, float offset) {
  return (offset > 0.0f ? QStringLiteral("+") : QString()) +
         locale.toString(double(offset), 'f', std::abs(offset) == 5.0f ? 0 : 2);
}

}  // namespace

GammaCurve::GammaCurve(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Curve of Γ"));
  setToolTip(
      tr("What is added to Γ, from left to right along the value. Drag a point; a double click or "
         "Insert adds one, Delete takes one away. Arrow keys move the chosen point, Space "
         "chooses the next"));
}

void GammaCurve::showCurve(model::GammaScalar scalar,
                           const std::vector<model::GammaPoint>& points) {
  m_points = points;
  if (scalar != m_scalar || !m_dragging)
    m_range = rangeOf(scalar, points);
  m_scalar = scalar;
  choose(std::min(m_chosen, m_points.empty() ? 0 : m_points.size() - 1));
}

QRectF GammaCurve::field() const {
  const double letters = QFontMetricsF(font()).height();
  return QRectF(rect()).adjusted(2.0 * letters, 6.0, -8.0, -letters - 4.0);
}

QPointF GammaCurve::placeOf(const model::GammaPoint& point) const {
  const QRectF at = field();
  const double along = double(point.scalar - m_range.low) / double(m_range.high - m_range.low);
  const double up = double(point.offset - model::gammaOffsets.low) /
                    double(model::gammaOffsets.high - model::gammaOffsets.low);
  return {at.left() + along * at.width(), at.bottom() - up * at.height()};
}

model::GammaPoint GammaCurve::pointAt(const QPointF& place) const {
  const QRectF at = field();
  const auto along = float((place.x() - at.left()) / std::max(at.width(), 1.0));
  const auto up = float((at.bottom() - place.y()) / std::max(at.height(), 1.0));
  return {std::lerp(m_range.low, m_range.high, along),
          std::lerp(model::gammaOffsets.low, model::gammaOffsets.high, up)};
}

std::optional<std::size_t> GammaCurve::pointNear(const QPointF& place) const {
  std::optional<std::size_t> found;
  double least = nearest;
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    const QPointF way = placeOf(m_points[i]) - place;
    if (const double length = std::hypot(way.x(), way.y()); length < least) {
      least = length;
      found = i;
    }
  }
  return found;
}

void GammaCurve::choose(std::size_t which) {
  m_chosen = which;
  if (m_chosen < m_points.size())
    setAccessibleDescription(
        tr("Point %1 of %2: %3 at %4")
            .arg(m_chosen + 1)
            .arg(m_points.size())
            .arg(offsetText(locale(), m_points[m_chosen].offset),
                 locale().toString(double(m_points[m_chosen].scalar), 'g', 3)));
  update();
}

void GammaCurve::moveTo(std::size_t which, model::GammaPoint to) {
  const float gap = leastGap * (m_range.high - m_range.low);
  const float low = which > 0 ? m_points[which - 1].scalar + gap : m_range.low;
  const float high = which + 1 < m_points.size() ? m_points[which + 1].scalar - gap : m_range.high;
  to.scalar = std::clamp(to.scalar, low, std::max(low, high));
  to.offset = std::clamp(snap * std::round(to.offset / snap), model::gammaOffsets.low,
                         model::gammaOffsets.high);
  m_points[which] = to;
  choose(which);
}

bool GammaCurve::add(const model::GammaPoint& point) {
  if (m_points.size() >= model::mostGammaPoints)
    return false;
  const auto after = std::find_if(m_points.begin(), m_points.end(),
                                  [&](const auto& each) { return each.scalar > point.scalar; });
  const auto place = std::size_t(after - m_points.begin());
  const std::vector<model::GammaPoint> before = m_points;
  m_points.insert(after, point);
  moveTo(place, point);
  if (!model::curveFault(m_points))
    return true;
  m_points = before;  // there is no room between two neighbours
  choose(std::min(m_chosen, m_points.size() - 1));
  return false;
}

bool GammaCurve::remove(std::size_t which) {
  if (m_points.size() <= model::fewestGammaPoints || which >= m_points.size())
    return false;
  m_points.erase(m_points.begin() + std::ptrdiff_t(which));
  choose(std::min(which, m_points.size() - 1));
  return true;
}

bool GammaCurve::event(QEvent* event) {
  // Delete takes a point away and no structure, Escape ends a drag before it closes anything.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* pressed = static_cast<QKeyEvent*>(event);
    const bool own = pressed->key() == Qt::Key_Escape ? m_dragging
                                                      : std::find(ownKeys.begin(), ownKeys.end(),
                                                                  pressed->key()) != ownKeys.end();
    if (own && !(pressed->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void GammaCurve::mousePressEvent(QMouseEvent* event) {
  const std::optional<std::size_t> found = pointNear(event->position());
  if (event->button() != Qt::LeftButton || !found)
    return;
  choose(*found);
  m_dragging = true;
  emit dragStarted();
}

void GammaCurve::mouseMoveEvent(QMouseEvent* event) {
  if (!m_dragging)
    return;
  moveTo(m_chosen, pointAt(event->position()));
  emit dragged();
}

void GammaCurve::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && std::exchange(m_dragging, false))
    emit dragFinished();
}

void GammaCurve::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !pointNear(event->position()) &&
      add(pointAt(event->position())))
    emit changed();
}

bool GammaCurve::moveByKey(int key, float step) {
  model::GammaPoint to = m_points[m_chosen];
  const float along = 0.02f * (m_range.high - m_range.low);
  if (key == Qt::Key_Left)
    to.scalar -= along;
  else if (key == Qt::Key_Right)
    to.scalar += along;
  else if (key == Qt::Key_Up || key == Qt::Key_PageUp)
    to.offset += step;
  else if (key == Qt::Key_Down || key == Qt::Key_PageDown)
    to.offset -= step;
  else
    return false;
  moveTo(m_chosen, to);
  return true;
}

void GammaCurve::keyPressEvent(QKeyEvent* event) {
  if (m_dragging && event->key() == Qt::Key_Escape) {
    m_dragging = false;
    emit dragCancelled();
    return;
  }
  if (m_dragging || m_chosen >= m_points.size())
    return QWidget::keyPressEvent(event);
  const int key = event->key();
  bool done = false;
  if (key == Qt::Key_Space) {
    choose((m_chosen + 1) % m_points.size());
    return;
  }
  if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
    done = remove(m_chosen);
  } else if (key == Qt::Key_Insert || key == Qt::Key_Plus) {
    const std::size_t first = std::min(m_chosen, m_points.size() - 2);
    const model::GammaPoint& a = m_points[first];
    const model::GammaPoint& b = m_points[first + 1];
    done = add({std::midpoint(a.scalar, b.scalar), std::midpoint(a.offset, b.offset)});
  } else {
    const bool pages = key == Qt::Key_PageUp || key == Qt::Key_PageDown;
    done = moveByKey(key, pages ? 1.0f : snap);
    if (!done)
      return QWidget::keyPressEvent(event);
  }
  if (done)
    emit changed();
}

void GammaCurve::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF at = field();
  QColor faint = palette().color(QPalette::WindowText);
  faint.setAlpha(90);
  painter.setPen(QPen(faint, 1.0));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRect(at);
  const double middle = placeOf({m_range.low, 0.0f}).y();
  painter.drawLine(QPointF(at.left(), middle), QPointF(at.right(), middle));
  painter.setPen(
      palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
  const double letters = QFontMetricsF(font()).height();
  for (const float offset : {5.0f, 0.0f, -5.0f})
    painter.drawText(
        QRectF(0.0, placeOf({0.0f, offset}).y() - 0.5 * letters, at.left() - 4.0, letters),
        Qt::AlignRight | Qt::AlignVCenter,
        offset == 0.0f ? QStringLiteral("0") : offsetText(locale(), offset));
  const QRectF below(at.left(), at.bottom() + 2.0, at.width(), letters);
  painter.drawText(below, Qt::AlignLeft, locale().toString(double(m_range.low), 'g', 3));
  painter.drawText(below, Qt::AlignRight, locale().toString(double(m_range.high), 'g', 3));
  if (m_points.empty())
    return;
  QPolygonF line{QPointF(at.left(), placeOf(m_points.front()).y())};
  for (const model::GammaPoint& point : m_points)
    line << placeOf(point);
  line << QPointF(at.right(), placeOf(m_points.back()).y());
  const QColor ink =
      palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Highlight);
  painter.setClipRect(at.adjusted(-radius - 2.0, -radius - 2.0, radius + 2.0, radius + 2.0));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ink, 2.0));
  painter.drawPolyline(line);
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    const bool chosen = i == m_chosen && hasFocus();
    painter.setBrush(chosen ? ink : palette().color(QPalette::Base));
    painter.drawEllipse(placeOf(m_points[i]), radius, radius);
  }
}

}  // namespace sline::widgets

#include "moc_gamma_curve.cpp"
