// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/demo_pictures.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "render/picture/picture.h"

namespace sline::widgets {

namespace {

constexpr int width = 480;  // as large as a card on a screen of twice the density
constexpr int height = 360;
constexpr int samples = 2;  // per pixel in each direction

QSurfaceFormat pictureFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

QString nameOf(const DemoScene& demo) {
  return QStringLiteral("demo-%1-%2").arg(demo.id, QCoreApplication::applicationVersion());
}

QImage drawDemo(const model::Scene& scene) {
  const auto picture = render::Picture::create();
  if (!picture.ok())
    return {};
  const model::Camera camera =
      scene.views().empty() ? model::anatomicalCamera(model::AnatomicalView::anterior,
                                                      scene.visibleBounds(), float(width) / height)
                            : scene.views().front().camera;
  const Result<render::Image> image = (*picture)->render(
      scene, camera,
      {.width = width, .height = height, .environment = {.background = render::Background::paper}},
      samples);
  if (!image.ok())
    return {};
  return QImage(image->rgba.data(), image->width, image->height, 4 * image->width,
                QImage::Format_RGBA8888)
      .convertToFormat(QImage::Format_RGB32);
}

/// Returns the picture; null where drawing was stopped, or where there is no OpenGL to draw it
/// with.
QImage drawDemo(const DemoScene& demo, QOffscreenSurface& surface, const std::stop_token& stop) {
  const Result<LoadedDocument> made =
      demo.make([&stop](float, const std::string&) { return !stop.stop_requested(); }, stop);
  if (!made.ok() || stop.stop_requested())
    return {};
  QOpenGLContext context;
  context.setFormat(surface.format());
  if (!context.create() || !context.makeCurrent(&surface))
    return {};
  QImage picture = drawDemo(made->scene);
  context.doneCurrent();
  return picture;
}

}  // namespace

DemoPictures::DemoPictures(PictureCache cache, QObject* parent)
    : QObject(parent), m_cache(std::move(cache)) {}

DemoPictures::~DemoPictures() {
  m_queue.drop();
}

void DemoPictures::stop() {
  m_missing = Missing::leave;
  m_queue.drop();
}

void DemoPictures::ask(const std::vector<DemoScene>& demos, Missing missing) {
  m_missing = missing;
  if (!m_surface) {
    m_surface = std::make_unique<QOffscreenSurface>();
    m_surface->setFormat(pictureFormat());
    m_surface->create();
  }
  for (const DemoScene& demo : demos)
    findOrDraw(demo);
}

void DemoPictures::findOrDraw(const DemoScene& demo) {
  m_queue.add([this, demo, cache = m_cache](const std::stop_token&) -> BackgroundQueue::Sequel {
    const QImage picture = cache.find(nameOf(demo));
    if (picture.isNull())
      return [this, demo] { draw(demo); };
    return [this, id = demo.id, picture] { emit drawn(id, picture); };
  });
}

void DemoPictures::draw(const DemoScene& demo) {
  if (m_missing == Missing::leave)
    return;
  m_queue.add(
      [this, demo, cache = m_cache](const std::stop_token& stop) -> BackgroundQueue::Sequel {
        const QImage picture = sline::widgets::drawDemo(demo, *m_surface, stop);
        if (picture.isNull())
          return {};
        cache.keep(nameOf(demo), picture);
        return [this, id = demo.id, picture] { emit drawn(id, picture); };
      });
}

}  // namespace sline::widgets

#include "moc_demo_pictures.cpp"
