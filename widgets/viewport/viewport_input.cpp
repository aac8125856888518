// SPDX-License-Identifier: Apache-2.0
// Handles input in the picture: mouse, touchpad and keys.
#include <QApplication>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/viewport/viewport.h"

#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

constexpr float perNotch = 1.15f;    ///< of a wheel, or a key
constexpr float keyDegrees = 5.0f;   ///< by an arrow key
constexpr float keyPixels = 40.0f;   ///< by an arrow key with Ctrl
constexpr float cubeDegrees = 1.1f;  ///< for each pixel that the cube is dragged
constexpr int longestUnheard = 300;  ///< milliseconds

/// Returns one step of each arrow key; the scene's near side goes that way.
glm::vec2 arrowStep(int key) {
  switch (key) {
    case Qt::Key_Left:
      return {-1.0f, 0.0f};
    case Qt::Key_Right:
      return {1.0f, 0.0f};
    case Qt::Key_Up:
      return {0.0f, -1.0f};
    case Qt::Key_Down:
      return {0.0f, 1.0f};
    default:
      return {0.0f, 0.0f};
  }
}

}  // namespace

Pointer Viewport::pointer(const QPointF& at, Qt::MouseButton button,
                          Qt::KeyboardModifiers keys) const {
  return {.pixel = vec(at), .size = size2(), .button = button, .keys = keys};
}

Picker::Question Viewport::question(const QPointF& at) const {
  return {.scene = shownScene(), .rays = render::sightsAround(m_camera, vec(at), size2())};
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  forgetName();
  m_mouse = event->position();
  if (m_button != Qt::NoButton)
    return;
  stopFlight();
  m_button = event->button();
  m_pressed = event->position();
  m_dragged = false;
  const Pointer mouse = pointer(event->position(), event->button(), event->modifiers());
  for (Tool* tool : tools())
    if (!m_held && tool->press(mouse))
      m_held = tool;
  m_labels->hover(std::nullopt);
  m_heldBack.reset();
  m_lastHeard.start();
  showTools();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  m_mouse = event->position();
  if (m_button == Qt::NoButton) {
    // The line around a structure stays until another one is found, or it would flicker.
    hideName();
    m_nameRest.start();
    showTools();
    m_labels->hover(m_mouse);
    showCursor();
    return;
  }
  const QPointF way = event->position() - m_pressed;
  m_dragged = m_dragged || way.manhattanLength() >= QApplication::startDragDistance();
  // A handle follows at once; elsewhere a hand that shakes in a click must not turn the scene.
  if (!m_held || (!m_dragged && !m_held->movesAtOnce()))
    return;
  m_heldBack = pointer(event->position(), m_button, event->modifiers());
  m_held->passes(*m_heldBack);
  // Tools move once for each picture, because what is changed and painted in between would only
  // take time from drawing. Where no picture comes, the drag goes on all the same.
  if (m_took == m_asked || m_lastHeard.hasExpired(longestUnheard))
    dragOn();
  else if (m_moving)
    m_rest.start();
}

void Viewport::showCursor() {
  const Pointer mouse = pointer(m_mouse, Qt::NoButton, {});
  std::optional<Qt::CursorShape> shape;
  for (const std::unique_ptr<Tool>& tool : m_added)
    if (!shape)
      shape = tool->cursor(mouse);
  if (!shape)
    shape = m_labels->cursor();
  if (!shape)
    shape = m_boxTool.cursor(mouse);
  setCursor(shape.value_or(Qt::ArrowCursor));
}

void Viewport::dragOn() {
  const std::optional<Pointer> mouse = std::exchange(m_heldBack, std::nullopt);
  if (!m_held || !mouse)
    return;
  m_lastHeard.start();
  m_held->move(*mouse);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != m_button)
    return;
  const bool taken = m_held && m_held->keepsClicks();
  dragOn();
  if (m_held)
    m_held->release(pointer(event->position(), m_button, event->modifiers()));
  m_held = nullptr;
  m_button = Qt::NoButton;
  showTools();
  m_labels->hover(event->position());
  if (m_dragged || taken)
    return;
  if (event->button() == Qt::LeftButton && m_labels->click(event->position()))
    return;
  const Qt::KeyboardModifiers keys = event->modifiers();
  if (event->button() == Qt::RightButton)
    click(event->position(), ClickFor::menu);
  else if (event->button() == Qt::MiddleButton)
    click(event->position(), ClickFor::deeper);
  else if (event->button() == Qt::LeftButton)
    click(event->position(), keys.testFlag(Qt::AltModifier)       ? ClickFor::deeper
                             : keys.testFlag(Qt::ControlModifier) ? ClickFor::addition
                                                                  : ClickFor::selection);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && m_labels->doubleClick(event->position()))
    return;
  const Pointer mouse = pointer(event->position(), Qt::LeftButton, {});
  const bool gripped = std::any_of(m_added.begin(), m_added.end(),
                                   [&](const auto& tool) { return tool->grips(mouse); });
  if (event->button() == Qt::LeftButton && !m_labels->making() && !gripped)
    click(event->position(), ClickFor::pivot);
  else
    mousePressEvent(event);
}

void Viewport::cancelDrag() {
  if (m_held)
    m_held->cancel();
  m_held = nullptr;
  m_heldBack.reset();
  m_marks->cube().cancel();
  showTools();
}

void Viewport::zoomAt(const QPointF& at, float factor) {
  const glm::vec3 place = pointAtDepthOf(m_camera, m_pivot, vec(at), size2());
  move(zoomedWithin(m_camera, place, factor, zoomEnds()));
}

void Viewport::wheelEvent(QWheelEvent* event) {
  stopFlight();
  // A touchpad reports how many pixels two fingers went, and when they were lifted; a wheel reports
  // neither.
  const bool fingers = event->phase() != Qt::NoScrollPhase && !event->pixelDelta().isNull();
  if (fingers && !event->modifiers().testFlag(Qt::ControlModifier))
    move(panned(m_camera, m_pivot, vec(event->pixelDelta()), size2().y));
  else
    zoomAt(event->position(), std::pow(perNotch, float(event->angleDelta().y()) / 120.0f));
  event->accept();
}

bool Viewport::nativeGesture(const QNativeGestureEvent& event) {
  stopFlight();
  switch (event.gestureType()) {
    case Qt::ZoomNativeGesture:
      zoomAt(event.position(), std::clamp(1.0f + float(event.value()), 0.2f, 5.0f));
      return true;
    case Qt::RotateNativeGesture:
      move(rolled(m_camera, float(event.value())));
      return true;
    case Qt::PanNativeGesture:
      move(panned(m_camera, m_pivot, vec(event.delta()), size2().y));
      return true;
    default:
      return false;
  }
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  const glm::vec2 arrow = arrowStep(event->key());
  const bool control = event->modifiers().testFlag(Qt::ControlModifier);
  if (event->key() == Qt::Key_Escape && (m_held || m_button != Qt::NoButton)) {
    cancelDrag();
    m_dragged = true;  // the release is no click
  } else if (event->key() == Qt::Key_Escape && m_marks->cube().cancel()) {
    return;
  } else if (event->key() == Qt::Key_Escape && m_boxTool.armed()) {
    m_boxTool.cancel();
    showCursor();
  } else if (m_labels->press(*event)) {
    return;
  } else if (arrow != glm::vec2(0.0f)) {
    stopFlight();
    move(control ? panned(m_camera, m_pivot, keyPixels * arrow, size2().y)
                 : orbited(m_camera, m_pivot, keyDegrees * arrow.x, keyDegrees * arrow.y));
  } else if ((event->key() == Qt::Key_PageDown || event->key() == Qt::Key_PageUp) && underMouse()) {
    click(m_mouse, event->key() == Qt::Key_PageDown ? ClickFor::deeper : ClickFor::nearer);
  } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) {
    zoomAt(QRectF(rect()).center(), perNotch);
  } else if (event->key() == Qt::Key_Minus) {
    zoomAt(QRectF(rect()).center(), 1.0f / perNotch);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void Viewport::contextMenuEvent(QContextMenuEvent* event) {
  // With the mouse the release opens the menu, because a press may begin a drag.
  if (event->reason() == QContextMenuEvent::Keyboard)
    emit menuWanted(mapToGlobal(rect().center()), {});
  event->accept();
}

void Viewport::turnByCube(const glm::vec2& way) {
  if (way == glm::vec2(0.0f)) {
    stopFlight();
    m_beforeTurn = m_camera;
    setFocus(Qt::MouseFocusReason);
  }
  move(orbited(m_beforeTurn, m_pivot, cubeDegrees * way.x, cubeDegrees * way.y));
}

void Viewport::askAt(const QPointF& at, Picker::Answer answer) {
  m_picker.ask(question(at), std::move(answer));
}

void Viewport::click(const QPointF& at, ClickFor purpose) {
  m_picker.ask(question(at), [this, at = at.toPoint(), purpose](const render::Picks& picks) {
    clicked(picks, at, purpose);
  });
}

void Viewport::clicked(const render::Picks& picks, const QPoint& at, ClickFor purpose) {
  std::optional<render::Pick> pick = picks.seen;
  if (purpose == ClickFor::deeper)
    pick = render::nextDeeper(picks.all, m_session.selection());
  else if (purpose == ClickFor::nearer)
    pick = render::nextDeeper({picks.all.rbegin(), picks.all.rend()}, m_session.selection());
  const model::Node* node = pick ? m_session.scene().find(pick->id) : nullptr;
  if (m_instead && purpose != ClickFor::pivot)
    return;
  if (purpose == ClickFor::menu) {
    emit menuWanted(mapToGlobal(at), picks);
    return;
  }
  if (purpose == ClickFor::pivot) {
    if (!node)
      return;
    setPivot(pick->position);
    emit pivotChosen(m_session.names().shown(node->name));
    return;
  }
  m_session.activateAnnotation(std::nullopt);
  NodeIds ids;
  if (purpose == ClickFor::addition)
    ids = m_session.selection();
  if (node) {
    const auto already = std::find(ids.begin(), ids.end(), pick->id);
    if (already != ids.end())
      ids.erase(already);
    else
      ids.push_back(pick->id);
  }
  m_session.select(std::move(ids));
}

void Viewport::setNamesWanted(bool wanted) {
  m_namesWanted = wanted;
  forgetName();
}

void Viewport::drawBox() {
  m_labels->make(std::nullopt);
  m_boxTool.arm(true);
  showCursor();
}

void Viewport::select(const BoxTool::Box& box) {
  showCursor();
  const QRectF area(box.area);
  const render::PickIndex::Box asked{.camera = m_camera,
                                     .size = size2(),
                                     .low = vec(area.topLeft()),
                                     .high = vec(area.bottomRight()),
                                     .touching = box.touching};
  m_picker.askBox(m_session.scene(), asked, [this, adding = box.adding](const NodeIds& found) {
    NodeIds ids = adding ? m_session.selection() : NodeIds();
    ids.insert(ids.end(), found.begin(), found.end());
    m_session.select(std::move(ids));
  });
}

void Viewport::light(std::optional<model::NodeId> id) {
  if (m_outlines.light(id))
    refresh();
}

void Viewport::point(std::optional<model::NodeId> id) {
  if (m_outlines.point(id))
    refresh();
}

void Viewport::wantName() {
  if (!m_namesWanted || m_button != Qt::NoButton || m_moving || !underMouse())
    return;
  m_picker.askLatest(question(m_mouse), [this](const render::Picks& picks) {
    const model::Node* node = picks.seen ? m_session.scene().find(picks.seen->id) : nullptr;
    point(node ? std::optional(node->id) : std::nullopt);
    if (node)
      m_marks->showName(m_session.names().shown(node->name), m_mouse.toPoint());
  });
}

void Viewport::hideName() {
  m_nameRest.stop();
  m_picker.forget();
  m_marks->hideName();
}

void Viewport::forgetName() {
  hideName();
  point(std::nullopt);
}

void Viewport::leaveEvent(QEvent* event) {
  forgetName();
  showTools();
  m_labels->hover(std::nullopt);
  QWidget::leaveEvent(event);
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_screen->widget().setGeometry(rect());
  placeMarks();
  refresh();
}

void Viewport::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange)
    placeMarks();
  if (event->type() == QEvent::LanguageChange)
    setAccessibleName(tr("Picture"));
}

bool Viewport::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture &&
      nativeGesture(*static_cast<QNativeGestureEvent*>(event)))
    return true;
  // Elsewhere in the window Del and F2 act on structures.
  if (event->type() == QEvent::ShortcutOverride &&
      m_labels->wants(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  const bool handled = QWidget::event(event);
  // Another screen may have finer pixels.
  if (event->type() == QEvent::ScreenChangeInternal)
    refresh();
  return handled;
}

}  // namespace sline::widgets
