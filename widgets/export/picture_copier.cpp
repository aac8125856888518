// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/picture_copier.h"

#include <QClipboard>
#include <QGuiApplication>

#include "widgets/export/finished_page.h"

namespace sline::widgets {

namespace {
constexpr int finer = 2;        // times as fine as on screen
constexpr int copySamples = 2;  // averaged for each pixel, in each direction
constexpr float dpi = 96.0f;    // assumed for a screen, so that letters keep their size
}  // namespace

PictureCopier::PictureCopier(Viewport& viewport, QObject* parent)
    : QObject(parent), m_viewport(viewport) {
  connect(&viewport, &Viewport::previewed, this, &PictureCopier::took);
}

void PictureCopier::copy(const ExportSource& source, const render::ExportOrder& order) {
  ExportDraft draft;
  draft.order = order;
  draft.order.page = {render::millimetresPerInch / dpi *
                          glm::vec2(float(m_viewport.width()), float(m_viewport.height())),
                      dpi};
  m_order = exportFiles(draft, source).front().order;
  const QSize size = finer * m_viewport.size();
  PreviewRequest request{.previews = {}, .asker = PreviewsOf::exported};
  request.previews.push_back({.id = --m_wanted,
                              .scene = m_order.scene,
                              .camera = m_order.camera,
                              .settings = {.width = copySamples * size.width(),
                                           .height = copySamples * size.height(),
                                           .environment = m_order.environment},
                              .samples = copySamples});
  m_viewport.askPreviews(std::move(request));
}

void PictureCopier::took(PreviewsOf asker, int number, const QImage& image) {
  if (asker != PreviewsOf::exported || number != m_wanted)
    return;
  m_queue.add([this, image, order = m_order](const std::stop_token&) {
    return BackgroundQueue::Sequel(
        [this, page = finishedPages(image, order, image.width()).images.front()] {
          QGuiApplication::clipboard()->setImage(page);
          emit copied();
        });
  });
}

}  // namespace sline::widgets

#include "moc_picture_copier.cpp"
