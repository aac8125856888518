// SPDX-License-Identifier: Apache-2.0
// Handles the scene and what lies over its picture; graphics are in viewport_graphics.cpp, cameras
// in viewport_camera.cpp and input in viewport_input.cpp.
#include "widgets/viewport/viewport.h"

#include <utility>

#include "model/scene/framing.h"
#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

/// Milliseconds without a move after which the camera counts as resting.
constexpr int restAfter = 150;
/// Milliseconds between the steps of a flight.
constexpr int flightStep = 15;
/// Milliseconds that the mouse rests on a structure before its name is shown.
constexpr int nameAfter = 180;

}  // namespace

Viewport::Viewport(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_cameraTool(*this),
      m_boxTool(*this, m_cameraTool, [this](const BoxTool::Box& box) { select(box); }) {
  setObjectName(QStringLiteral("viewport"));
  setAccessibleName(tr("Picture"));
  m_screen = makePictureScreen(*this, {.ready = [this] { openGraphics(); },
                                       .closing = [this] { closeGraphics(); },
                                       .shown = [this](std::uint64_t number) { shown(number); }});
  m_screen->setPaper(paper());
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
  connect(&session, &Session::selectionChanged, this, [this] { refresh(); });
  connect(&m_marks->cube(), &CubeMark::viewRequested, this, &Viewport::viewFrom);
  connect(&m_marks->cube(), &CubeMark::turned, this, &Viewport::turnByCube);
  connect(&m_marks->cube(), &CubeMark::turnEnded, this, [this](bool kept) {
    if (!kept)
      move(m_beforeTurn);
  });
}

Viewport::~Viewport() {
  closeGraphics();
  m_screen.reset();
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

void Viewport::setBackground(render::Background background) {
  if (background == m_background)
    return;
  m_background = background;
  m_screen->setPaper(paper());
  m_marks->setBackground(background);
  const bool dark = background == render::Background::dark;
  m_labels->setGround(background);
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
    // Nothing of the document before stays on screen until this one has its picture.
    m_screen->blank(m_asked);
    m_marked = {};
    m_marksAwait = m_asked + 1;
    m_camera = firstCamera(now.scene);
  }
  if (!another && m_session.previewing() && before.scene.sections() != now.scene.sections()) {
    m_cutting = true;
    keepMoving();
  }
  if (another || m_marked.scene != markedScene(now.scene))
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
                .scene = markedScene(m_session.scene())};
  m_marks->place(m_marked.camera, m_marked.scene);
  showTools();
}

void Viewport::addTool(std::unique_ptr<Tool> tool) {
  tool->setDark(m_background == render::Background::dark);
  m_added.push_back(std::move(tool));
  // Whatever a tool put lowest over the picture stays over it.
  m_screen->widget().lower();
  showTools();
}

std::vector<Tool*> Viewport::tools() {
  std::vector<Tool*> all;
  for (const std::unique_ptr<Tool>& tool : m_added)
    all.push_back(tool.get());
  if (!m_instead) {
    all.push_back(&m_labels->tool());
    all.push_back(&m_boxTool);
  }
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
