// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/viewport.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/viewport/orientation_letters.h"

namespace sline::widgets {

namespace {

/// Milliseconds without a move after which the camera counts as resting.
constexpr int restAfter = 150;

glm::vec2 vec(const QPointF& p) {
  return {float(p.x()), float(p.y())};
}

int scaled(int pixels, float scale) {
  return std::max(1, int(std::lround(float(pixels) * scale)));
}

QSurfaceFormat pictureFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

}  // namespace

Viewport::Viewport(Session& session, QWidget* parent) : QOpenGLWidget(parent), m_session(session) {
  setObjectName(QStringLiteral("viewport"));
  setAccessibleName(tr("Picture"));
  setFormat(pictureFormat());
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  m_rest.setSingleShot(true);
  m_rest.setInterval(restAfter);
  m_pickers.setMaxThreadCount(1);
  connect(&m_rest, &QTimer::timeout, this, &Viewport::rest);
  connect(&session, &Session::documentChanged, this, &Viewport::documentChange);
  for (QLabel*& letter : m_letters) {
    letter = new QLabel(this);
    letter->setAttribute(Qt::WA_TransparentForMouseEvents);
    letter->setAlignment(Qt::AlignCenter);
    letter->hide();
  }
  m_letters[0]->setObjectName(QStringLiteral("letterLeft"));
  m_letters[1]->setObjectName(QStringLiteral("letterRight"));
  m_letters[2]->setObjectName(QStringLiteral("letterTop"));
  m_letters[3]->setObjectName(QStringLiteral("letterBottom"));
  styleLetters();
}

Viewport::~Viewport() {
  m_pickers.waitForDone();
  closeGraphics();
}

render::gpu::TextureSize Viewport::pixels() const {
  const double ratio = devicePixelRatioF();
  return {.width = std::max(1, int(std::lround(width() * ratio))),
          .height = std::max(1, int(std::lround(height() * ratio)))};
}

void Viewport::initializeGL() {
  // A widget that moves to another window, or whose context was lost, begins anew.
  closeGraphics();
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::closeGraphics,
          Qt::UniqueConnection);
  const auto text = [gl = context()->functions()](GLenum name) {
    return QString::fromUtf8(reinterpret_cast<const char*>(gl->glGetString(name)));
  };
  m_driver = text(GL_RENDERER) + QStringLiteral(", ") + text(GL_VERSION);
  m_handoff = std::make_unique<render::gpu::Handoff>();
  m_thread = std::make_unique<RenderThread>(*context(), *m_handoff, m_factory);
  connect(m_thread.get(), &RenderThread::drawn, this, &Viewport::took);
  connect(m_thread.get(), &RenderThread::previewed, this, &Viewport::previewed);
  connect(m_thread.get(), &RenderThread::failed, this, &Viewport::failed);
  refresh();
}

void Viewport::closeGraphics() {
  if (!m_handoff)
    return;
  m_thread.reset();
  makeCurrent();
  m_handoff->releaseShowing();
  m_handoff.reset();
  doneCurrent();
  m_shown = 0;
}

void Viewport::paintGL() {
  if (!m_handoff)
    return;
  if (m_shown == 0)
    m_handoff->warmUp();
  const std::uint64_t shown = m_handoff->show(pixels());
  if (shown == m_shown)
    return;
  m_shown = shown;
  // Whoever listens may ask for things that must not happen within a paint event.
  QMetaObject::invokeMethod(this, &Viewport::pictureShown, Qt::QueuedConnection);
}

void Viewport::resizeGL(int, int) {
  refresh();
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  placeLetters();
}

void Viewport::changeEvent(QEvent* event) {
  QOpenGLWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange)
    placeLetters();
}

void Viewport::refresh() {
  if (!m_thread)
    return;
  m_askedScale = m_moving ? m_quality.scale() : 1.0f;
  const render::gpu::TextureSize size = pixels();
  PictureRequest request{.number = ++m_asked,
                         .scene = m_session.scene(),
                         .camera = m_camera,
                         .settings = {.width = scaled(size.width, m_askedScale),
                                      .height = scaled(size.height, m_askedScale),
                                      .background = m_background,
                                      .keyLight = keyLight()},
                         .scale = m_askedScale,
                         .moving = m_moving};
  m_thread->ask(std::move(request));
}

void Viewport::askPreviews(PreviewRequest request) {
  if (m_thread)
    m_thread->ask(std::move(request));
}

void Viewport::took(const PictureReport& report) {
  m_lastMilliseconds = report.milliseconds;
  m_lastLayersDrawn = report.layersDrawn;
  // Only pictures of a moving camera are drawn anew as a whole; others keep most layers.
  if (report.moving)
    m_quality.took(report.milliseconds, report.scale);
  update();
}

bool Viewport::upToDate() const {
  return m_shown != 0 && m_shown == m_asked && m_askedScale == 1.0f && !m_moving;
}

void Viewport::move(const model::Camera& camera) {
  if (camera == m_camera || model::cameraFault(camera))
    return;
  m_camera = camera;
  m_moving = true;
  m_rest.start();
  placeLetters();
  refresh();
  emit cameraChanged();
}

void Viewport::rest() {
  m_moving = false;
  if (m_askedScale != 1.0f)
    refresh();
}

void Viewport::setCamera(const model::Camera& camera) {
  if (camera == m_camera || model::cameraFault(camera))
    return;
  m_camera = camera;
  placeLetters();
  refresh();
  emit cameraChanged();
}

std::vector<glm::vec3> Viewport::visibleCorners() const {
  // Of each structure's box: a whole body has too many vertices to look at within a frame.
  std::vector<glm::vec3> corners;
  for (const model::Node& node : m_session.scene().nodes()) {
    if (node.isGroup() || node.mesh->bounds().empty() ||
        !m_session.scene().resolve(node.id).visible)
      continue;
    const model::Box& box = node.mesh->bounds();
    for (int i = 0; i < 8; ++i)
      corners.emplace_back((i & 1) != 0 ? box.high.x : box.low.x,
                           (i & 2) != 0 ? box.high.y : box.low.y,
                           (i & 4) != 0 ? box.high.z : box.low.z);
  }
  return corners;
}

model::Camera Viewport::cameraFrom(model::AnatomicalView view) const {
  const model::Box bounds = m_session.scene().visibleBounds();
  const float aspect = size2().x / size2().y;
  return model::fitted(model::anatomicalCamera(view, bounds, aspect), visibleCorners(), aspect);
}

void Viewport::pivotToMiddle() {
  const model::Box bounds = m_session.scene().visibleBounds();
  if (!bounds.empty())
    m_pivot = bounds.centre();
}

void Viewport::showFrom(model::AnatomicalView view) {
  pivotToMiddle();
  setCamera(cameraFrom(view));
}

model::Camera Viewport::overview() const {
  // Views are saved for pictures of 4:3; a narrower window steps back so that the sides stay in.
  const float narrow = std::min(1.0f, size2().x / size2().y * 3.0f / 4.0f);
  for (const model::View& view : m_session.scene().views())
    if (view.name == "Overview" && !model::cameraFault(view.camera))
      return zoomed(view.camera, view.camera.target, narrow);
  return cameraFrom(model::AnatomicalView::anterior);
}

void Viewport::fitAll() {
  const model::Box bounds = m_session.scene().visibleBounds();
  if (bounds.empty())
    return;
  m_pivot = bounds.centre();
  setCamera(model::fitted(m_camera, visibleCorners(), size2().x / size2().y));
}

void Viewport::setBackground(render::Background background) {
  if (background == m_background)
    return;
  m_background = background;
  styleLetters();
  refresh();
  emit backgroundChanged();
}

bool Viewport::keyLight() const {
  const auto& own = m_session.scene().keyLight();
  return own ? own->shades : m_keyLight;
}

void Viewport::setKeyLight(bool on) {
  if (on == m_keyLight)
    return;
  m_keyLight = on;
  refresh();
}

void Viewport::documentChange(const Document& before, const Document& now) {
  const bool another = before.opening != now.opening;
  if (!another && before.scene == now.scene)
    return;
  if (another) {
    m_drag.reset();
    m_quality = {};
    pivotToMiddle();
    m_camera = overview();
  }
  if (another || before.scene.nodes().empty() != now.scene.nodes().empty())
    placeLetters();
  refresh();
  if (another)
    emit cameraChanged();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  const bool pan =
      event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && shift);
  if (m_drag || (!pan && event->button() != Qt::LeftButton))
    return;
  m_pressed = event->position();
  m_dragged = false;
  m_drag.emplace(CameraDrag::Start{.kind = pan ? CameraDrag::Kind::pan : CameraDrag::Kind::orbit,
                                   .pixel = vec(m_pressed),
                                   .camera = m_camera,
                                   .pivot = m_pivot});
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  if (!m_drag)
    return;
  const QPointF way = event->position() - m_pressed;
  m_dragged = m_dragged || way.manhattanLength() >= QApplication::startDragDistance();
  if (m_dragged)
    move(m_drag->at(vec(event->position()), size2()));
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (!m_drag || (event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) != 0)
    return;
  m_drag.reset();
  if (!m_dragged && event->button() == Qt::LeftButton)
    pick(event->position(),
         event->modifiers().testFlag(Qt::ControlModifier) ? PickFor::addition : PickFor::selection);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    pick(event->position(), PickFor::pivot);
}

void Viewport::wheelEvent(QWheelEvent* event) {
  constexpr float perNotch = 1.15f;  // a notch is 120 units
  const float notches = float(event->angleDelta().y()) / 120.0f;
  const glm::vec3 at = pointAtDepthOf(m_camera, m_pivot, vec(event->position()), size2());
  const model::Camera camera = zoomed(m_camera, at, std::pow(perNotch, notches));
  // Far enough out that all is a speck, or so near that floats cannot tell one place from another.
  const model::Box bounds = m_session.scene().visibleBounds();
  const float size = bounds.empty() ? 1000.0f : glm::length(bounds.size());
  const float distance = glm::length(camera.eye - m_pivot);
  if (distance > 1e-3f * size && distance < 50.0f * size)
    move(camera);
  event->accept();
}

void Viewport::pick(const QPointF& at, PickFor purpose) {
  const model::Ray ray = sightThrough(m_camera, vec(at), size2());
  // The first pick of a mesh sorts its triangles, which takes longer than a frame.
  m_pickers.start([this, picks = m_picks, scene = m_session.scene(), ray, purpose] {
    const std::optional<Pick> found = picks->pick(scene, ray);
    QMetaObject::invokeMethod(this, [this, found, purpose] { picked(found, purpose); });
  });
}

void Viewport::picked(const std::optional<Pick>& pick, PickFor purpose) {
  const model::Node* node = pick ? m_session.scene().find(pick->id) : nullptr;
  if (purpose == PickFor::pivot) {
    if (!node)
      return;
    m_pivot = pick->position;
    emit pivotChosen(QString::fromStdString(node->name));
    return;
  }
  NodeIds ids;
  if (purpose == PickFor::addition)
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

void Viewport::styleLetters() {
  const bool dark = m_background == render::Background::dark;
  for (QLabel* label : m_letters)
    label->setStyleSheet(dark ? QStringLiteral("color: #9a9a9a; font-weight: 600;")
                              : QStringLiteral("color: #8a857c; font-weight: 600;"));
}

void Viewport::placeLetters() {
  const EdgeLetters letters = edgeLetters(m_camera);
  const std::array<const std::string*, 4> texts{&letters.left, &letters.right, &letters.top,
                                                &letters.bottom};
  constexpr int margin = 10;
  const QPoint middle = rect().center();
  for (std::size_t i = 0; i < m_letters.size(); ++i) {
    QLabel& label = *m_letters[i];
    label.setText(QString::fromStdString(*texts[i]));
    label.adjustSize();
    QRect box = label.rect();
    box.moveCenter(middle);
    if (i == 0)
      box.moveLeft(margin);
    else if (i == 1)
      box.moveRight(width() - margin);
    else if (i == 2)
      box.moveTop(margin);
    else
      box.moveBottom(height() - margin);
    label.setGeometry(box);
    label.setVisible(!m_session.scene().nodes().empty());
  }
}

}  // namespace sline::widgets
