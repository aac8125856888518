// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <exception>

#include "model/disk/process.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::widgets {

namespace {

std::atomic<bool>& refining() {
  static std::atomic<bool> on = true;
  return on;
}

/// Calls body(), whatever it throws: an exception that left the thread would end the program, and
/// with it what is not saved. Returns what was wrong.
template <class Body>
Status guarded(const Body& body) {
  std::string reason;
  try {
    body();
    return Unit{};
  } catch (const std::exception& failure) {
    reason = failure.what();
  } catch (...) {
    reason = "no reason is given";
  }
  return Error{.reason = "the picture could not be drawn: " + reason,
               .remedy = "Hide some structures, or close other programs to free memory"};
}

/// Returns what was wrong with the graphics since it was last asked. A driver that has run out of
/// memory, or has lost its context, draws on into nothing and says so only here.
Status driverState(QOpenGLContext& context) {
  constexpr GLenum contextLost = 0x0507;
  constexpr int most = 64;  // a lost context may have no end of errors
  QOpenGLFunctions& gl = *context.functions();
  bool full = false;
  bool lost = !context.isValid();
  for (int i = 0; i < most && !lost; ++i) {
    const GLenum error = gl.glGetError();
    if (error == GL_NO_ERROR)
      break;
    full = full || error == GL_OUT_OF_MEMORY;
    lost = error == contextLost;
  }
  if (lost)
    return Error{.reason = "the graphics driver has lost what it had drawn",
                 .remedy = "Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1"};
  if (full)
    return Error{.reason = "the graphics driver has no memory left for the picture",
                 .remedy = "Hide some structures, or close other programs to free memory"};
  return Unit{};
}

/// Draws with a picture: one that a pointer keeps.
template <class PicturePointer>
class RendererPainter : public PicturePainter {
 public:
  explicit RendererPainter(PicturePointer picture) : m_picture(std::move(picture)) {}
  Result<bool> paint(const PictureRequest& request,
                     const render::Picture::TargetJob& job) override {
    return m_picture->drawInto(job, request.scene, request.camera, request.settings);
  }
  Result<std::optional<render::Image>> preview(const PreviewRequest::Preview& preview,
                                               const std::atomic<bool>& unwanted) override {
    return m_picture->preview(preview.scene, preview.camera, preview.settings, &unwanted);
  }
  Result<bool> refine(const PictureRequest& request,
                      const render::Picture::TargetJob& job) override {
    return m_picture->refineInto(job, request.scene, request.camera, request.settings);
  }
  void makeReady(const PictureRequest& request, const std::atomic<bool>& unwanted) override {
    render::PictureSettings moving = request.settings;
    moving.surfaceStep = render::MotionQuality::coarsestStep;
    m_picture->prepare(request.scene, request.camera, moving, 1, &unwanted);
  }
  int layersDrawn() const override { return m_picture->timings().layersDrawn; }
  bool makeshift() const override { return m_picture->timings().makeshift; }

 private:
  PicturePointer m_picture;
};

template <class PicturePointer>
Result<std::unique_ptr<PicturePainter>> painterWith(Result<PicturePointer> picture) {
  if (!picture)
    return picture.error();
  return std::unique_ptr<PicturePainter>(
      std::make_unique<RendererPainter<PicturePointer>>(std::move(*picture)));
}

}  // namespace

Result<std::unique_ptr<PicturePainter>> makePicturePainter() {
  if (QOpenGLContext::currentContext())
    return painterWith(render::Picture::create());
  return painterWith(
      render::HeadlessPicture::create({.painter = render::PictureOptions::Painter::processor}));
}

void chooseRefinement(bool on) {
  refining() = on;
}

RenderThread::RenderThread(PictureScreen& screen, PainterFactory factory)
    : m_screen(screen), m_factory(std::move(factory)) {
  setObjectName(QStringLiteral("render"));
  if (QOpenGLContext* shared = screen.shared()) {
    m_context = std::make_unique<QOpenGLContext>();
    m_context->setFormat(shared->format());
    m_context->setShareContext(shared);
    m_surface = std::make_unique<QOffscreenSurface>();
    m_surface->setFormat(shared->format());
    m_surface->create();
    if (m_context->create())
      m_context->moveToThread(this);
  }
  start();
}

RenderThread::~RenderThread() {
  {
    const std::lock_guard lock(m_mutex);
    m_quit = true;
    m_unwanted = true;
  }
  m_wake.notify_one();
  wait();
}

void RenderThread::ask(PictureRequest request) {
  {
    const std::lock_guard lock(m_mutex);
    if (m_previewing || m_refining ||
        (m_resting && (request.moving || !(*m_resting == request.camera))))
      m_unwanted = true;
    m_request = std::move(request);
  }
  m_wake.notify_one();
}

void RenderThread::ask(PreviewRequest request) {
  {
    const std::lock_guard lock(m_mutex);
    Waiting& waiting = m_waiting[std::size_t(request.asker)];
    waiting.previews = std::move(request.previews);
    std::reverse(waiting.previews.begin(), waiting.previews.end());
    ++waiting.round;
    if (m_previewing == request.asker || m_refining)
      m_unwanted = true;
  }
  m_wake.notify_one();
}

bool RenderThread::previewsWait() const {
  return std::any_of(m_waiting.begin(), m_waiting.end(),
                     [](const Waiting& waiting) { return !waiting.previews.empty(); });
}

RenderThread::Work RenderThread::next() {
  // Between two pictures of a drag there is less time than a preview may take.
  constexpr std::chrono::milliseconds quiet(200);
  // What one looks at for a while is refined, and not what one passes by.
  constexpr std::chrono::milliseconds calm(500);
  std::unique_lock lock(m_mutex);
  m_refining = false;
  for (;;) {
    m_wake.wait(lock, [this] {
      return m_quit || m_request || m_unlabelled || previewsWait() || m_unrefined;
    });
    if (m_quit)
      return {};
    if (m_unlabelled && !m_request)
      return {.labels = true};
    const bool previews = previewsWait();
    const auto other = [&] { return m_quit || m_request || previews != previewsWait(); };
    if (m_request || !m_wake.wait_until(lock, m_pictureEnd + (previews ? quiet : calm), other))
      break;
  }
  m_unwanted = false;
  m_resting.reset();
  m_previewing.reset();
  for (std::size_t i = 0; !m_request && i < previewAskers; ++i) {
    std::vector<PreviewRequest::Preview>& previews = m_waiting[i].previews;
    if (previews.empty())
      continue;
    m_previewing = PreviewsOf(i);
    Work work{.preview = std::move(previews.back()), .asker = *m_previewing};
    previews.pop_back();
    return work;
  }
  if (!m_request) {
    m_refining = true;
    return {.refinement = true};
  }
  // Pictures of a moving camera are always finished, or a long move would show none.
  if (!m_request->moving)
    m_resting = m_request->camera;
  return {.picture = std::exchange(m_request, std::nullopt)};
}

Result<bool> RenderThread::draw(PicturePainter& painter, const PictureRequest& request) {
  Result<bool> drawn = false;
  const Status done = guarded([&] {
    const auto target =
        m_screen.begin({.width = request.settings.width, .height = request.settings.height});
    drawn = target ? painter.paint(
                         request,
                         {.target = *target, .unwanted = &m_unwanted, .outlines = request.outlines})
                   : Result<bool>(target.error());
    if (!drawn || !*drawn)
      return;
    if (const Status state = m_context ? driverState(*m_context) : Status(Unit{}); !state.ok()) {
      drawn = state.error();
      return;
    }
    // The labels are drawn before the picture is published, so that both appear together.
    m_sheet = m_labels.draw(request.scene, request.camera, request.labels);
    m_unlabelled.reset();
    if (!m_sheet)
      m_unlabelled = request;
    m_screen.publish(request.number);
  });
  return done ? drawn : Result<bool>(done.error());
}

void RenderThread::makeReady(PicturePainter& painter, const PictureRequest& request) {
  // A picture that needs what could not be made ready says so itself.
  static_cast<void>(guarded([&] { painter.makeReady(request, m_unwanted); }));
}

void RenderThread::drawPicture(PicturePainter& painter, const PictureRequest& request) {
  QElapsedTimer clock;
  clock.start();
  m_unrefined.reset();
  if (const Result<bool> done = draw(painter, request); !done) {
    emit failed(done.error());
  } else if (*done) {
    if (request.refined && request.fineness.full() && refining())
      m_unrefined = request;
    emit drawn({.number = request.number,
                .milliseconds = double(clock.nsecsElapsed()) * 1e-6,
                .fineness = request.fineness,
                .moving = request.moving,
                .camera = request.camera,
                .layersDrawn = painter.layersDrawn(),
                .makeshift = painter.makeshift(),
                .labels = m_sheet});
  }
  if (!request.moving && !m_unwanted)
    makeReady(painter, request);
  const std::lock_guard lock(m_mutex);
  m_pictureEnd = std::chrono::steady_clock::now();
}

void RenderThread::refine(PicturePainter& painter) {
  // Without it the picture is only less smooth, which is not worth a message.
  static_cast<void>(guarded([&] {
    const PictureRequest request = *std::exchange(m_unrefined, std::nullopt);
    const auto target =
        m_screen.begin({.width = request.settings.width, .height = request.settings.height});
    if (!target)
      return;
    const Result<bool> done = painter.refine(
        request, {.target = *target, .unwanted = &m_unwanted, .outlines = request.outlines});
    if (done && *done) {
      m_screen.publish(request.number);
      emit refined(request.number);
    } else if (done && m_unwanted) {
      // It may have made way for a preview.
      m_unrefined = request;
    }
  }));
}

void RenderThread::drawLabels() {
  bool ready = false;
  const Status done = guarded([&] {
    ready = !m_labels.prepare(m_unlabelled->scene);
    if (ready)
      m_sheet = m_labels.draw(m_unlabelled->scene, m_unlabelled->camera, m_unlabelled->labels);
  });
  if (!done) {
    auto none = std::make_shared<LabelSheet>();
    none->camera = m_unlabelled->camera;
    none->wish = m_unlabelled->labels;
    m_sheet = std::move(none);
    emit labelsFailed(done.error());
  } else if (!ready) {
    return;
  }
  m_unlabelled.reset();
  emit labelled(m_sheet);
}

void RenderThread::drawPreview(PicturePainter& painter, const PreviewRequest::Preview& preview,
                               PreviewsOf asker) {
  Waiting& waiting = m_waiting[std::size_t(asker)];
  std::uint64_t round = 0;
  {
    const std::lock_guard lock(m_mutex);
    round = waiting.round;
  }
  Result<std::optional<render::Image>> image = std::optional<render::Image>();
  const Status done = guarded([&] { image = painter.preview(preview, m_unwanted); });
  // Without this one the panel only lacks a small picture, which is not worth a message.
  if (!done || !image)
    return;
  if (!*image) {
    // The large picture comes first; then this one again, unless others are wanted instead.
    const std::lock_guard lock(m_mutex);
    if (m_unwanted && waiting.round == round && !m_quit)
      waiting.previews.push_back(preview);
    return;
  }
  const render::Image small =
      preview.samples > 1 ? render::averaged(**image, preview.samples) : std::move(**image);
  emit previewed(
      asker, preview.id,
      QImage(small.rgba.data(), small.width, small.height, 4 * small.width, QImage::Format_RGBA8888)
          .copy());
}

void RenderThread::draw(PicturePainter& painter) {
  for (;;) {
    const Work work = next();
    if (work.picture)
      drawPicture(painter, *work.picture);
    else if (work.refinement)
      refine(painter);
    else if (work.labels)
      drawLabels();
    else if (work.preview)
      drawPreview(painter, *work.preview, work.asker);
    else
      return;
  }
}

void RenderThread::run() {
  model::standBack();
  if (m_context && (!m_context->isValid() || !m_context->makeCurrent(m_surface.get()))) {
    emit failed({.reason = "the graphics driver gives no OpenGL context to draw with",
                 .remedy = "Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1"});
    return;
  }
  std::unique_ptr<PicturePainter> painter;
  const Status done = guarded([&] {
    auto made = m_factory();
    if (!made) {
      emit failed(made.error());
      return;
    }
    painter = std::move(*made);
    draw(*painter);
  });
  if (!done)
    emit failed(done.error());
  painter.reset();
  m_screen.releaseDrawing();
  if (m_context)
    m_context->doneCurrent();
  m_context.reset();  // on the thread that it belongs to
}

}  // namespace sline::widgets

#include "moc_render_thread.cpp"
