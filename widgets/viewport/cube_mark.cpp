// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/cube_mark.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

constexpr int side = 92;  ///< of the widget; the cube's diagonals fit

QPolygonF polygon(const std::array<glm::vec2, 4>& corners) {
  return QPolygonF({point(corners[0]), point(corners[1]), point(corners[2]), point(corners[3])});
}

}  // namespace

CubeMark::CubeMark(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("orientationCube"));
  name();
  setMouseTracking(true);
  resize(sizeHint());
  m_faces = cubeFaces(m_camera, half());
}

void CubeMark::name() {
  setAccessibleName(tr("Orientation cube"));
  setAccessibleDescription(tr("The keys A, P, L, R, S and I look from the same sides."));
}

void CubeMark::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange)
    name();
}

QSize CubeMark::sizeHint() const {
  return {side, side};
}

float CubeMark::half() const {
  return float(side) / 2.0f / 1.78f;  // √3, and a line's width
}

void CubeMark::setCamera(const model::Camera& camera, const model::KnownSides& sides) {
  m_camera = camera;
  m_sides = sides;
  m_faces = cubeFaces(camera, half());
  update();
}

void CubeMark::setDark(bool dark) {
  m_dark = dark;
  update();
}

std::optional<CubeDirection> CubeMark::directionAt(const QPointF& at) const {
  const QPointF way = at - QRectF(rect()).center();
  return cubeDirectionAt(m_faces, {float(way.x()), float(way.y())});
}

std::optional<QPointF> CubeMark::placeOf(const CubeDirection& part) const {
  const auto patches = cubePatches(m_faces, part);
  if (patches.empty())
    return std::nullopt;
  const QPolygonF outline = polygon(patches.front());
  return QRectF(rect()).center() + (outline[0] + outline[2]) / 2.0;
}

void CubeMark::mark(std::optional<CubeDirection> part) {
  if (part == m_marked)
    return;
  m_marked = part;
  setCursor(part ? Qt::PointingHandCursor : Qt::ArrowCursor);
  update();
}

void CubeMark::mousePressEvent(QMouseEvent* event) {
  m_pressed = directionAt(event->position());
  m_from = event->position();
  m_turning = false;
  if (!m_pressed || event->button() != Qt::LeftButton) {
    m_pressed.reset();
    event->ignore();
  }
}

void CubeMark::mouseMoveEvent(QMouseEvent* event) {
  if (!m_pressed) {
    mark(event->buttons() == Qt::NoButton ? directionAt(event->position()) : std::nullopt);
    event->setAccepted(m_marked.has_value());
    return;
  }
  const QPointF way = event->position() - m_from;
  if (!m_turning && way.manhattanLength() < QApplication::startDragDistance())
    return;
  if (!m_turning)
    emit turned({0.0f, 0.0f});
  m_turning = true;
  mark(std::nullopt);
  emit turned({float(way.x()), float(way.y())});
}

void CubeMark::mouseReleaseEvent(QMouseEvent* event) {
  if (!m_pressed) {
    event->ignore();
    return;
  }
  if (m_turning)
    emit turnEnded(true);
  else if (directionAt(event->position()) == m_pressed)
    emit viewRequested(*m_pressed);
  m_pressed.reset();
  m_turning = false;
}

bool CubeMark::cancel() {
  const bool turning = m_turning;
  m_pressed.reset();
  m_turning = false;
  if (turning)
    emit turnEnded(false);
  return turning;
}

void CubeMark::leaveEvent(QEvent*) {
  mark(std::nullopt);
}

QString CubeMark::letterOf(const CubeFace& face) const {
  if (!m_sides.any)
    return QString::fromStdString(axisOf(face.part));
  const int axis = face.part.x != 0 ? 0 : face.part.y != 0 ? 1 : 2;
  return QLatin1Char(face.letter) + (m_sides.inDoubt(axis) ? QStringLiteral("?") : QString());
}

void CubeMark::paintFace(QPainter& painter, const CubeFace& face) const {
  const QColor body = m_dark ? QColor(70, 72, 76) : QColor(250, 249, 246);
  const QColor shade = m_dark ? QColor(44, 46, 50) : QColor(214, 211, 204);
  const QColor edge = m_dark ? QColor(120, 123, 128) : QColor(138, 133, 124);
  const auto blend = [&](int a, int b) {
    return int(float(a) * face.facing + float(b) * (1.0f - face.facing));
  };
  painter.setBrush(QColor(blend(body.red(), shade.red()), blend(body.green(), shade.green()),
                          blend(body.blue(), shade.blue()), 235));
  painter.setPen(QPen(edge, 1.0));
  painter.drawPolygon(polygon(face.corners()));
  if (!m_marked)
    return;
  painter.setPen(Qt::NoPen);
  QColor accent = palette().color(QPalette::Highlight);
  accent.setAlpha(110);
  painter.setBrush(accent);
  for (const auto& patch : cubePatches({face}, *m_marked))
    painter.drawPolygon(polygon(patch));
}

void CubeMark::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(QRectF(rect()).center());
  for (const CubeFace& face : m_faces)
    paintFace(painter, face);
  // Letters lie on their faces and could not be read on a face that is turned far from the eye.
  constexpr float legible = 0.25f;
  constexpr double em = 100.0;
  QFont font = this->font();
  font.setPixelSize(int(em));
  font.setBold(true);
  painter.setFont(font);
  for (const CubeFace& face : m_faces) {
    if (face.facing < legible)
      continue;
    painter.save();
    const double scale = 1.05 / em;
    painter.setTransform(QTransform(scale * double(face.right.x), scale * double(face.right.y),
                                    -scale * double(face.up.x), -scale * double(face.up.y),
                                    double(face.centre.x), double(face.centre.y)),
                         true);
    QColor ink = m_dark ? QColor(232, 232, 232) : QColor(58, 55, 50);
    ink.setAlphaF(std::min(1.0f, (face.facing - legible) / 0.35f));
    painter.setPen(ink);
    painter.drawText(QRectF(-em, -em, 2 * em, 2 * em), Qt::AlignCenter, letterOf(face));
    painter.restore();
  }
}

}  // namespace sline::widgets

#include "moc_cube_mark.cpp"
