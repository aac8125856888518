// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/demo_pictures.h"

#include "model/disk/process.h"
#include "render/picture/card_picture.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::widgets {

namespace {

QImage drawDemo(const model::Scene& scene) {
  const auto picture =
      render::HeadlessPicture::create({.painter = render::PictureOptions::Painter::processor});
  if (!picture.ok())
    return {};
  const render::CardPicture card = render::cardPicture(scene);
  const Result<render::Image> image =
      (*picture)->render(scene, card.camera, card.settings, card.samples);
  if (!image.ok())
    return {};
  return QImage(image->rgba.data(), image->width, image->height, 4 * image->width,
                QImage::Format_RGBA8888)
      .convertToFormat(QImage::Format_RGB32);
}

/// Returns the picture; null where drawing was stopped.
QImage drawDemo(const DemoScene& demo, const std::stop_token& stop) {
  const Result<LoadedDocument> made =
      demo.make([&stop](float, const std::string&) { return !stop.stop_requested(); }, stop);
  return made.ok() && !stop.stop_requested() ? drawDemo(made->scene) : QImage();
}

}  // namespace

std::filesystem::path builtDemoPictures() {
  return model::programFile().parent_path().parent_path() / "share/sline/demos";
}

DemoPictures::DemoPictures(PictureCache built, PictureCache cache, QObject* parent)
    : QObject(parent), m_built(std::move(built)), m_cache(std::move(cache)) {}

DemoPictures::~DemoPictures() {
  m_queue.drop();
}

void DemoPictures::stop() {
  m_missing = Missing::leave;
  m_queue.drop();
}

void DemoPictures::ask(const std::vector<DemoScene>& demos, Missing missing) {
  m_missing = missing;
  for (const DemoScene& demo : demos)
    if (const QImage picture = m_built.find(demo.key); !picture.isNull())
      emit drawn(demo.id, picture);
    else
      findOrDraw(demo);
}

void DemoPictures::findOrDraw(const DemoScene& demo) {
  m_queue.add([this, demo, cache = m_cache](const std::stop_token&) -> BackgroundQueue::Sequel {
    const QImage picture = cache.find(demo.key);
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
        const QImage picture = sline::widgets::drawDemo(demo, stop);
        if (picture.isNull())
          return {};
        cache.keep(demo.key, picture);
        return [this, id = demo.id, picture] { emit drawn(id, picture); };
      });
}

}  // namespace sline::widgets

#include "moc_demo_pictures.cpp"
