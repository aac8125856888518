// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/drawing_pictures.h"

#include <algorithm>

#include "model/disk/process.h"
#include "widgets/gamma/drawing_panel.h"
#include "widgets/gamma/stage_previews.h"

namespace sline::widgets {

namespace {

/// Milliseconds after the last change, because small pictures can wait while something moves.
constexpr int drawingsRestAfter = 300;
// Pictures are drawn twice as large and averaged, with lines as wide as in a print of that size.
constexpr int drawingSamples = 2;
constexpr double drawingPen = 0.8;
constexpr int mostDrawings = 16;

render::Background backgroundFor(const model::DrawingStyle& style) {
  return style.background == "dark"    ? render::Background::dark
         : style.background == "paper" ? render::Background::paper
                                       : render::Background::white;
}

/// Returns the scene without its labels, whose letters would be a pixel high, and its views.
model::Scene withoutWords(model::Scene scene) {
  scene.setViews({});
  scene.setAnnotations({});
  return scene;
}

}  // namespace

DrawingPictures::DrawingPictures(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport) {
  m_pool.setMaxThreadCount(1);
  m_rest.setSingleShot(true);
  m_rest.setInterval(drawingsRestAfter);
  connect(&m_rest, &QTimer::timeout, this, &DrawingPictures::ask);
  connect(&session, &Session::documentChanged, this, &DrawingPictures::restart);
  connect(&viewport, &Viewport::cameraChanged, this, &DrawingPictures::restart);
  connect(&viewport, &Viewport::previewed, this, &DrawingPictures::took);
}

DrawingPictures::~DrawingPictures() {
  m_stop.request_stop();
  m_pool.waitForDone();
}

void DrawingPictures::want(bool wanted) {
  m_wanted = wanted;
  restart();
}

model::Scene DrawingPictures::base() const {
  const model::Scene& now = m_session.sceneBeforePreview();
  return m_before && now == m_after ? *m_before : model::withOwnColours(now);
}

DrawingPictures::Key DrawingPictures::keyNow() const {
  const double ratio = m_viewport.devicePixelRatioF();
  const double aspect = double(m_viewport.width()) / double(std::max(1, m_viewport.height()));
  return {.base = withoutWords(base()),
          .camera = m_viewport.camera(),
          .size = DrawingPanel::pictureSize(aspect) * ratio,
          .ratio = ratio,
          .keyLight = m_viewport.keyLight()};
}

void DrawingPictures::restart() {
  if (m_wanted)
    m_rest.start();
}

void DrawingPictures::ask() {
  if (!m_wanted || m_session.previewing())
    return;
  Key key = keyNow();
  if (m_asked && key == *m_asked)
    return;
  const bool sameScene = m_asked && key.base == m_asked->base;
  m_asked = std::move(key);
  if (sameScene && m_previews.size() == model::drawingStyles().size()) {
    askPictures();
    return;
  }
  workOut();
}

void DrawingPictures::workOut() {
  m_stop.request_stop();
  m_stop = std::stop_source();
  m_previews.clear();
  const int round = ++m_round;
  m_viewport.askPreviews({.previews = {}, .asker = PreviewsOf::drawings});
  m_pool.start([this, round, key = *m_asked, forms = m_forms, stop = m_stop.get_token()] {
    static thread_local const bool stoodBack = (model::standBack(), true);
    static_cast<void>(stoodBack);
    int number = 0;
    for (const model::DrawingStyle& style : model::drawingStyles()) {
      const model::Scene scene =
          model::withDrawingStyle(key.base, style, *forms, {.camera = key.camera}, stop).scene;
      if (stop.stop_requested())
        return;
      const int index = number++;
      QMetaObject::invokeMethod(this, [=, this] { takeScene(round, index, scene); });
    }
    forms->trim();
  });
}

void DrawingPictures::takeScene(int round, int style, const model::Scene& scene) {
  if (round != m_round || !m_asked)
    return;
  m_previews.push_back({.id = style, .scene = scene, .samples = drawingSamples});
  // All are asked for at once, as a request replaces the one before.
  if (m_previews.size() == model::drawingStyles().size())
    askPictures();
}

void DrawingPictures::askPictures() {
  PreviewRequest request{.asker = PreviewsOf::drawings};
  ++m_round;
  const QSize size = drawingSamples * m_asked->size;
  const SmallLines lines =
      smallLines(size.height(), m_asked->ratio * double(drawingSamples), drawingPen);
  for (PreviewRequest::Preview preview : m_previews) {
    const model::DrawingStyle& style = model::drawingStyles()[std::size_t(preview.id)];
    preview.id += m_round * mostDrawings;
    preview.scene = withSmallLines(preview.scene, lines);
    preview.camera = m_asked->camera;
    preview.settings = {
        .width = size.width(),
        .height = size.height(),
        .environment = {
            .background = backgroundFor(style), .light = {}, .keyLight = m_asked->keyLight}};
    request.previews.push_back(std::move(preview));
  }
  m_viewport.askPreviews(std::move(request));
}

void DrawingPictures::took(PreviewsOf asker, int id, const QImage& image) {
  if (asker == PreviewsOf::drawings && id / mostDrawings == m_round)
    emit made(id % mostDrawings, image);
}

void DrawingPictures::choose(const model::DrawingStyle& style, const QString& step) {
  // A click need not wait for pictures; they are asked for again once the scene has changed.
  if (m_previews.size() < model::drawingStyles().size()) {
    m_stop.request_stop();
    m_asked.reset();
    ++m_round;
  }
  const Choice choice{++m_choice, &style, step, m_session.scene()};
  m_pool.start(
      [this, choice, scene = base(), camera = m_viewport.camera(), forms = m_forms] {
        const model::Scene drawn =
            model::withDrawingStyle(scene, *choice.style, *forms, {.camera = camera}).scene;
        QMetaObject::invokeMethod(this, [=, this] { takeChoice(choice, drawn); });
      },
      1);
  restart();
}

void DrawingPictures::takeChoice(const Choice& choice, const model::Scene& scene) {
  if (choice.number != m_choice || m_session.previewing() || !(m_session.scene() == choice.asked))
    return;
  m_before = base();
  m_after = scene;
  m_session.apply(choice.step, {scene, !(scene == choice.asked)});
  emit drawn(*choice.style);
}

}  // namespace sline::widgets

#include "moc_drawing_pictures.cpp"
