// SPDX-License-Identifier: Apache-2.0
// Has pictures drawn and puts them on screen.
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/drawn/surface_fill.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

int scaled(int pixels, float scale) {
  return std::max(1, int(std::lround(float(pixels) * scale)));
}

}  // namespace

QColor Viewport::paper() const {
  const glm::vec4 colour = render::backgroundColour(m_background);
  return QColor::fromRgbF(colour.r, colour.g, colour.b);
}

void Viewport::openGraphics() {
  if (!m_screen->start())
    return;
  m_thread = std::make_unique<RenderThread>(*m_screen, m_factory);
  connect(m_thread.get(), &RenderThread::drawn, this, &Viewport::took);
  connect(m_thread.get(), &RenderThread::labelled, this, [this](const LabelSheetPtr& sheet) {
    if (m_marksAwait == 0)
      m_labels->took(sheet, m_drawnCamera.value_or(m_camera));
  });
  connect(m_thread.get(), &RenderThread::refined, this, [this](std::uint64_t number) {
    if (number == m_asked)
      m_screen->showNewest();
  });
  connect(m_thread.get(), &RenderThread::previewed, this, &Viewport::previewed);
  connect(m_thread.get(), &RenderThread::failed, this, &Viewport::failure);
  connect(m_thread.get(), &RenderThread::labelsFailed, this, &Viewport::failed);
  // What was asked for while it was ending has nobody who draws it.
  connect(m_thread.get(), &RenderThread::finished, this, [this] {
    if (m_thread && m_thread->isFinished() && m_asked != m_askedAtOpening)
      rebuildSoon();
  });
  refresh();
  m_askedAtOpening = m_asked;
}

void Viewport::closeGraphics() {
  if (!m_thread)
    return;
  m_thread.reset();
  m_screen->stop();
  m_shown = 0;
}

void Viewport::failure(const Error& error) {
  // Recovery is tried once: a lost context is made anew, with all that was drawn in it. A second
  // failure has another reason.
  if (m_rebuilt) {
    m_failure = error;
    emit failed(error);
    return;
  }
  m_rebuilt = true;
  rebuildSoon();
}

void Viewport::rebuildSoon() {
  // Graphics must not be rebuilt within a signal of the thread that is then destroyed.
  if (!std::exchange(m_toRebuild, true))
    QMetaObject::invokeMethod(this, &Viewport::rebuildGraphics, Qt::QueuedConnection);
}

void Viewport::rebuildGraphics() {
  m_toRebuild = false;
  if (!m_thread)
    return;
  closeGraphics();
  openGraphics();
}

void Viewport::shown(std::uint64_t number) {
  m_shown = number;
  // Receivers may ask for things that must not happen within a paint event.
  QMetaObject::invokeMethod(this, &Viewport::pictureShown, Qt::QueuedConnection);
}

void Viewport::refresh() {
  refresh(m_blend ? m_blend->at(flownPart()) : shownScene());
}

void Viewport::refresh(model::Scene scene) {
  if (!m_thread)
    return;
  if (m_thread->isFinished() && !m_moving) {
    // It could not draw, and said so; perhaps it can by now.
    rebuildSoon();
    return;
  }
  // A moving section keeps to the fineness of the camera's moves, because another draws everything
  // anew.
  m_askedFineness = m_moving ? m_quality.fineness() : render::Fineness{};
  const render::gpu::TextureSize size = pixelsOf(*this);
  PictureRequest request{.number = ++m_asked,
                         .scene = std::move(scene),
                         .camera = m_camera,
                         .settings = {.width = scaled(size.width, m_askedFineness.scale),
                                      .height = scaled(size.height, m_askedFineness.scale),
                                      .environment = environment(),
                                      .surfaceStep = m_askedFineness.surfaceStep,
                                      .hurried = m_moving},
                         .fineness = m_askedFineness,
                         .moving = m_moving,
                         // Where pixels are too small to be seen, so are their stairs.
                         .refined = devicePixelRatioF() < 1.5,
                         .labels = m_labels->wish(m_moving),
                         .outlines = outlines()};
  m_thread->ask(std::move(request));
}

std::vector<render::Outline> Viewport::outlines() const {
  // What is shown instead of the document has only those that it asks for.
  return m_outlines.around(shownScene(), m_instead ? NodeIds() : m_session.selection(),
                           {.accent = palette().color(QPalette::Active, QPalette::Highlight),
                            .background = m_background,
                            .pixels = m_askedFineness.scale * float(devicePixelRatioF()),
                            .pointed = !m_instead});
}

void Viewport::askPreviews(PreviewRequest request) {
  if (m_thread)
    m_thread->ask(std::move(request));
}

void Viewport::took(const PictureReport& report) {
  m_rebuilt = false;
  if (const auto failure = std::exchange(m_failure, std::nullopt))
    emit mended(*failure);
  m_took = report.number;
  if (m_marksAwait != 0 && m_took < m_marksAwait)
    return;  // of the scene before: its labels must not come back
  m_last = report;
  // Only pictures of a moving camera are drawn anew as a whole; others keep most layers.
  if (report.moving && !m_cutting)
    m_quality.took(report.milliseconds, report.fineness);
  m_marks->showTime(report.milliseconds, report.fineness.scale);
  m_drawnCamera = report.camera;
  m_labels->took(report.labels, report.camera);
  const bool first = m_marksAwait != 0 && m_took >= m_marksAwait;
  if (first)
    m_marksAwait = 0;
  // Of a quick move no picture may have been drawn but the one at rest.
  if (report.moving || first || m_marked.camera != report.camera)
    placeMarks();
  else
    showTools();
  if (m_took == m_asked)
    dragOn();
  m_screen->showNewest();
}

bool Viewport::upToDate() const {
  return m_shown != 0 && m_shown == m_asked && m_took == m_asked && m_askedFineness.full() &&
         !m_moving && !m_flight && m_labels->ready();
}

}  // namespace sline::widgets
