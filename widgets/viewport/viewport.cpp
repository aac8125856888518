// SPDX-License-Identifier: Apache-2.0
// Handles pictures and cameras; input is in viewport_input.cpp.
#include "widgets/viewport/viewport.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/strokes/surface_fill.h"
#include "widgets/viewport/framing.h"
#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

/// Milliseconds without a move after which the camera counts as resting.
constexpr int restAfter = 150;
/// Milliseconds that a flight takes.
constexpr int flightTime = 220;
/// Milliseconds that a flight takes in which looks change: long enough to follow each change.
constexpr int travelTime = 700;
constexpr int flightStep = 15;
/// Milliseconds that the mouse rests on a structure before its name is shown.
constexpr int nameAfter = 180;

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

Viewport::Viewport(Session& session, QWidget* parent)
    : QOpenGLWidget(parent), m_session(session), m_cameraTool(*this) {
  setObjectName(QStringLiteral("viewport"));
  setAccessibleName(tr("Picture"));
  setFormat(pictureFormat());
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  m_rest.setSingleShot(true);
  m_rest.setInterval(restAfter);
  m_nameRest.setSingleShot(true);
  m_nameRest.setInterval(nameAfter);
  m_flightTick.setInterval(flightStep);
  m_marks = new PictureMarks(*this);
  m_labels = new PictureLabels({.picture = *this,
                                .session = session,
                                .picker = m_picker,
                                .question = [this](const QPointF& at) { return question(at); },
                                .marks = [this] { return m_marks->places(); }});
  m_marks->setBackground(m_background);
  connect(&m_rest, &QTimer::timeout, this, &Viewport::rest);
  connect(&m_nameRest, &QTimer::timeout, this, &Viewport::wantName);
  connect(&m_flightTick, &QTimer::timeout, this, &Viewport::flyOn);
  connect(m_labels, &PictureLabels::wishChanged, this, [this] { refresh(); });
  connect(m_labels, &PictureLabels::makingChanged, this, &Viewport::showCursor);
  connect(&session, &Session::documentChanged, this, &Viewport::documentChange);
  connect(&m_marks->cube(), &CubeMark::viewRequested, this, &Viewport::viewFrom);
  connect(&m_marks->cube(), &CubeMark::turned, this, &Viewport::turnByCube);
  connect(&m_marks->cube(), &CubeMark::turnEnded, this, [this](bool kept) {
    if (!kept)
      move(m_beforeTurn);
  });
}

Viewport::~Viewport() {
  // QOpenGLWidget's destructor destroys the context when there is no Viewport any more that could
  // react.
  if (context())
    context()->disconnect(this);
  closeGraphics();
}

render::gpu::TextureSize Viewport::pixels() const {
  const double ratio = devicePixelRatioF();
  return {.width = std::max(1, int(std::lround(width() * ratio))),
          .height = std::max(1, int(std::lround(height() * ratio)))};
}

void Viewport::initializeGL() {
  // A widget that moves to another window, or has lost its context, begins anew.
  closeGraphics();
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::closeGraphics,
          Qt::UniqueConnection);
  const auto text = [gl = context()->functions()](GLenum name) {
    return QString::fromUtf8(reinterpret_cast<const char*>(gl->glGetString(name)));
  };
  m_driver = text(GL_RENDERER) + QStringLiteral(", ") + text(GL_VERSION);
  openGraphics();
}

void Viewport::openGraphics() {
  m_handoff = std::make_unique<render::gpu::Handoff>();
  m_thread = std::make_unique<RenderThread>(*context(), *m_handoff, m_factory);
  connect(m_thread.get(), &RenderThread::drawn, this, &Viewport::took);
  connect(m_thread.get(), &RenderThread::labelled, this, [this](const LabelSheetPtr& sheet) {
    m_labels->took(sheet, m_drawnCamera.value_or(m_camera));
  });
  connect(m_thread.get(), &RenderThread::previewed, this, &Viewport::previewed);
  connect(m_thread.get(), &RenderThread::failed, this, &Viewport::failure);
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

void Viewport::failure(const Error& error) {
  // Recovery is tried once: a lost context is made anew, with all that was drawn in it. A second
  // failure has another reason.
  if (m_rebuilt || !context()) {
    emit failed(error);
    return;
  }
  m_rebuilt = true;
  // Graphics must not be rebuilt within a signal of the thread that is then destroyed.
  QMetaObject::invokeMethod(this, &Viewport::rebuildGraphics, Qt::QueuedConnection);
}

void Viewport::rebuildGraphics() {
  if (!m_handoff || !context())
    return;
  closeGraphics();
  openGraphics();
}

void Viewport::paintGL() {
  if (!m_handoff)
    return;
  if (m_shown == 0) {
    // The background is shown until there is a picture.
    const glm::vec4 paper = render::backgroundColour(m_background);
    context()->functions()->glClearColor(paper.r, paper.g, paper.b, 1.0f);
    context()->functions()->glClear(GL_COLOR_BUFFER_BIT);
    m_handoff->warmUp();
  }
  const std::uint64_t shown = m_handoff->show(pixels());
  if (shown == m_shown)
    return;
  m_shown = shown;
  // Receivers may ask for things that must not happen within a paint event.
  QMetaObject::invokeMethod(this, &Viewport::pictureShown, Qt::QueuedConnection);
}

void Viewport::resizeGL(int, int) {
  refresh();
}

void Viewport::refresh() {
  refresh(m_blend ? m_blend->at(flownPart()) : shownScene());
}

void Viewport::refresh(model::Scene scene) {
  if (!m_thread)
    return;
  // A moving section keeps to the scale of the camera's moves, because another size draws
  // everything anew.
  m_askedScale = m_moving ? m_quality.scale() : 1.0f;
  const render::gpu::TextureSize size = pixels();
  PictureRequest request{.number = ++m_asked,
                         .scene = std::move(scene),
                         .camera = m_camera,
                         .settings = {.width = scaled(size.width, m_askedScale),
                                      .height = scaled(size.height, m_askedScale),
                                      .environment = environment()},
                         .scale = m_askedScale,
                         .moving = m_moving,
                         .labels = m_labels->wish(m_moving)};
  m_thread->ask(std::move(request));
}

void Viewport::askPreviews(PreviewRequest request) {
  if (m_thread)
    m_thread->ask(std::move(request));
}

void Viewport::took(const PictureReport& report) {
  m_rebuilt = false;
  m_took = report.number;
  m_lastMilliseconds = report.milliseconds;
  m_lastLayersDrawn = report.layersDrawn;
  // Only pictures of a moving camera are drawn anew as a whole; others keep most layers.
  if (report.moving && !m_cutting)
    m_quality.took(report.milliseconds, report.scale);
  m_marks->showTime(report.milliseconds, report.scale);
  m_drawnCamera = report.camera;
  m_labels->took(report.labels, report.camera);
  const bool first = m_marksAwait != 0 && m_took >= m_marksAwait;
  if (first)
    m_marksAwait = 0;
  if (report.moving || first)
    placeMarks();
  else
    showTools();
  if (m_took == m_asked)
    dragOn();
  update();
}

bool Viewport::upToDate() const {
  return m_shown != 0 && m_shown == m_asked && m_took == m_asked && m_askedScale == 1.0f &&
         !m_moving && !m_flight && m_labels->ready();
}

void Viewport::keepMoving() {
  m_moving = true;
  m_rest.start();
  forgetName();
}

void Viewport::move(const model::Camera& camera) {
  if (camera == m_camera || model::cameraFault(camera))
    return;
  m_camera = camera;
  m_cutting = false;
  keepMoving();
  // The marks follow with the picture, because a software driver redraws the whole window to paint
  // them.
  refresh();
  emit cameraChanged();
}

void Viewport::rest() {
  m_moving = false;
  m_cutting = false;
  const bool arrived = std::exchange(m_arrived, false) && m_labels->arrive();
  if (arrived || m_askedScale != 1.0f || m_labels->waits() || m_labels->outgrown())
    refresh();
}

void Viewport::stopFlight() {
  m_flight.reset();
  m_flightTick.stop();
  if (!m_blend)
    return;
  m_blend.reset();
  refresh();
}

double Viewport::flownPart() const {
  return double(m_flown.elapsed()) / double(m_flightTime);
}

void Viewport::startFlight(const model::Camera& camera, int milliseconds) {
  m_flight.emplace(m_camera, camera);
  m_flightTime = milliseconds;
  m_flown.start();
  m_flightTick.start();
}

void Viewport::travelTo(const model::Camera& camera, const model::Scene& from,
                        const model::Scene& to) {
  if (model::cameraFault(camera))
    return;
  m_pivot = camera.target;
  if (!m_flights || !isVisible()) {
    stopFlight();
    m_camera = camera;
    placeMarks();
    // The looks that will be the document's are shown at once, because there is no picture in
    // between.
    refresh(to);
    emit cameraChanged();
    return;
  }
  m_blend.emplace(from, to);
  startFlight(camera, travelTime);
  keepMoving();
}

const model::Scene& Viewport::shownScene() const {
  return m_instead ? *m_instead : m_session.scene();
}

void Viewport::showInstead(std::optional<model::Scene> scene) {
  m_instead = std::move(scene);
  m_labels->setShut(m_instead.has_value());
  forgetName();
  refresh();
}

void Viewport::setCamera(const model::Camera& camera) {
  stopFlight();
  if (camera == m_camera || model::cameraFault(camera))
    return;
  m_camera = camera;
  placeMarks();
  refresh();
  emit cameraChanged();
}

void Viewport::flyTo(const model::Camera& camera) {
  if (!m_flights || !isVisible() || camera == m_camera || model::cameraFault(camera)) {
    setCamera(camera);
    return;
  }
  stopFlight();
  startFlight(camera, flightTime);
}

void Viewport::flyOn() {
  if (!m_flight)
    return;
  const double part = flownPart();
  const model::Camera camera = m_flight->at(part);
  const bool looks = m_blend.has_value();
  if (part >= 1.0) {
    m_arrived = true;
    m_flight.reset();
    m_blend.reset();
    m_flightTick.stop();
  }
  if (looks && camera == m_camera) {
    keepMoving();
    refresh();
  }
  move(camera);
}

void Viewport::pivotToMiddle() {
  const model::Box bounds = shownScene().visibleBounds();
  if (!bounds.empty())
    m_pivot = bounds.centre();
}

void Viewport::setPivot(const glm::vec3& pivot) {
  m_pivot = pivot;
  placeMarks();
}

float Viewport::aspectBesideLabels(const model::Camera& camera) const {
  return aspect() * m_labels->shareBeside(m_session.scene(), camera);
}

void Viewport::showFrom(model::AnatomicalView view) {
  pivotToMiddle();
  const model::Scene& scene = m_session.scene();
  const model::Camera there = cameraFrom(scene, view, aspect());
  flyTo(cameraFrom(scene, view, aspectBesideLabels(there)));
}

void Viewport::viewFrom(const CubeDirection& from) {
  flyTo(turnedTo(m_camera, m_pivot, glm::vec3(from), upwardsFrom(from)));
}

void Viewport::fitAll() {
  fitTo({model::rootId});
}

void Viewport::fitTo(const NodeIds& ids) {
  const model::Box bounds = visibleBounds(m_session.scene(), ids);
  if (bounds.empty())
    return;
  m_pivot = bounds.centre();
  flyTo(fitted(m_camera, m_session.scene(), ids, aspectBesideLabels(m_camera)));
}

void Viewport::setBackground(render::Background background) {
  if (background == m_background)
    return;
  m_background = background;
  m_marks->setBackground(background);
  const bool dark = background == render::Background::dark;
  m_labels->setDark(dark);
  for (const std::unique_ptr<Tool>& tool : m_added)
    tool->setDark(dark);
  refresh();
  emit backgroundChanged();
}

bool Viewport::keyLight() const {
  const auto& own = shownScene().keyLight();
  return own ? own->shades : m_keyLight;
}

void Viewport::setKeyLight(bool on) {
  if (on == m_keyLight)
    return;
  m_keyLight = on;
  refresh();
}

void Viewport::setHeadroom(int pixels) {
  m_marks->setHeadroom(pixels);
  placeMarks();
  labelsGiveWay();
}

void Viewport::chooseMarks(const MarkChoice& choice) {
  m_marks->choose(choice);
  labelsGiveWay();
}

void Viewport::setPresented(bool presented, const QRect& covered) {
  m_labels->setPresented(presented);
  m_marks->setPresented(presented, covered);
  placeMarks();
  labelsGiveWay();
}

void Viewport::labelsGiveWay() {
  if (!shownScene().annotations().empty())
    refresh();
}

void Viewport::documentChange(const Document& before, const Document& now) {
  const bool another = before.opening != now.opening;
  if (!another && before.scene == now.scene)
    return;
  forgetName();
  if (m_blend && !m_instead && !(m_blend->end() == now.scene))
    m_blend.reset();  // the looks were changed elsewhere meanwhile
  if (another) {
    m_instead.reset();
    m_labels->setShut(false);
    cancelDrag();
    m_drawnCamera.reset();
    m_quality = {};
    pivotToMiddle();
    stopFlight();
    m_marksAwait = m_asked + 1;
    m_camera = overview(now.scene, aspectBesideLabels(overview(now.scene, aspect())));
  }
  if (!another && m_session.previewing() && before.scene.sections() != now.scene.sections()) {
    m_cutting = true;
    keepMoving();
  }
  if (another || before.scene.nodes().empty() != now.scene.nodes().empty())
    placeMarks();
  else
    showTools();
  refresh();
  if (another)
    emit cameraChanged();
}

void Viewport::placeMarks() {
  if (m_marksAwait == 0)
    m_marked = {.camera = m_moving ? m_drawnCamera.value_or(m_camera) : m_camera,
                .pivot = m_pivot,
                .scene = !m_session.scene().nodes().empty()};
  m_marks->place(m_marked.camera, m_marked.pivot, m_marked.scene);
  showTools();
}

void Viewport::addTool(std::unique_ptr<Tool> tool) {
  tool->setDark(m_background == render::Background::dark);
  m_added.push_back(std::move(tool));
  showTools();
}

std::vector<Tool*> Viewport::tools() {
  std::vector<Tool*> all;
  for (const std::unique_ptr<Tool>& tool : m_added)
    all.push_back(tool.get());
  if (!m_instead)
    all.push_back(&m_labels->tool());
  all.push_back(&m_cameraTool);
  return all;
}

void Viewport::showTools() {
  // Tools refer to the picture that is shown, which may lag behind the camera.
  const ShownPicture picture{
      .camera = m_drawnCamera.value_or(m_camera),
      .size = size2(),
      .mouse = !m_held && underMouse() ? std::optional(vec(m_mouse)) : std::nullopt};
  for (const std::unique_ptr<Tool>& tool : m_added)
    tool->show(picture);
}

}  // namespace sline::widgets

#include "moc_viewport.cpp"
