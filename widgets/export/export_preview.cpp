// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_preview.h"

#include <QPainter>
#include <cmath>

#include "widgets/export/finished_page.h"

namespace sline::widgets {

namespace {

/// Milliseconds after the last change, so that a number is drawn only once all of it is typed.
constexpr int restAfter = 200;
constexpr int previewSamples = 2;
constexpr int margin = 14;
constexpr int leastPixels = 16;

}  // namespace

ExportPreview::ExportPreview(Viewport& viewport, QWidget* parent)
    : QWidget(parent), m_viewport(&viewport) {
  setObjectName(QStringLiteral("exportPreview"));
  setAccessibleName(tr("Preview"));
  setMinimumSize(280, 240);
  m_rest.setSingleShot(true);
  m_rest.setInterval(restAfter);
  connect(&m_rest, &QTimer::timeout, this, &ExportPreview::ask);
  connect(&viewport, &Viewport::previewed, this, &ExportPreview::took);
}

ExportPreview::~ExportPreview() {
  m_queue.drop();
  if (m_viewport)
    m_viewport->askPreviews({.previews = {}, .asker = PreviewsOf::exported});
}

void ExportPreview::show(const render::ExportPiece& file) {
  m_file = file;
  ++m_wanted;
  m_rest.start();
  update();
}

QRect ExportPreview::pageRect() const {
  if (!m_file)
    return {};
  const glm::vec2 size = paperMm(m_file->order);
  const QRectF room = QRectF(rect()).adjusted(margin, margin, -margin, -margin);
  const qreal scale = std::min(room.width() / qreal(size.x), room.height() / qreal(size.y));
  QRectF page(0.0, 0.0, scale * qreal(size.x), scale * qreal(size.y));
  page.moveCenter(room.center());
  return page.toRect();
}

QSize ExportPreview::pixels() const {
  return (QSizeF(pageRect().size()) * devicePixelRatioF()).toSize();
}

void ExportPreview::turnTo(std::size_t page) {
  m_page = page;
  update();
}

void ExportPreview::ask() {
  if (!m_file || pageRect().isEmpty())
    return;
  m_queue.drop();
  m_queue.add([this, file = *m_file, number = m_wanted](const std::stop_token& stop) {
    if (stop.stop_requested())
      return BackgroundQueue::Sequel();
    return BackgroundQueue::Sequel(
        [this, number, order = render::readyOrder(file)] { draw(number, order); });
  });
}

void ExportPreview::draw(int number, const render::ExportOrder& order) {
  if (number != m_wanted || !m_viewport)
    return;
  m_drawn = order;
  // A sheet's figure is a part of its paper.
  const glm::vec2 share = order.page.sizeMm / paperMm(order);
  const QSize page(int(std::lround(float(pixels().width()) * share.x)),
                   int(std::lround(float(pixels().height()) * share.y)));
  PreviewRequest request{.previews = {}, .asker = PreviewsOf::exported};
  request.previews.push_back(
      {.id = number,
       .scene = order.scene,
       .camera = order.camera,
       .settings = {.width = previewSamples * std::max(page.width(), leastPixels),
                    .height = previewSamples * std::max(page.height(), leastPixels),
                    .environment = order.environment},
       .samples = previewSamples});
  m_viewport->askPreviews(std::move(request));
}

void ExportPreview::took(PreviewsOf asker, int number, const QImage& image) {
  if (asker != PreviewsOf::exported || number != m_wanted)
    return;
  m_queue.add([this, number, image, order = m_drawn,
               width = pixels().width()](const std::stop_token& stop) {
    if (stop.stop_requested())
      return BackgroundQueue::Sequel();
    return BackgroundQueue::Sequel([this, number, all = finishedPages(image, order, width)] {
      if (number != m_wanted)
        return;
      m_pages = all.images;
      m_notes = all.notes;
      m_shown = number;
      update();
      emit drawn();
    });
  });
}

void ExportPreview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (m_file)
    show(render::ExportPiece(*m_file));
}

void ExportPreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Mid));
  const QRect page = pageRect();
  if (page.isEmpty())
    return;
  painter.fillRect(page.translated(2, 2), QColor(0, 0, 0, 40));
  painter.fillRect(page, Qt::white);
  if (m_file->order.environment.background == render::Background::transparent) {
    // Transparent parts are shown as squares, as is usual.
    painter.setBrushOrigin(page.topLeft());
    painter.fillRect(page, QBrush(QColor(222, 222, 222), Qt::Dense4Pattern));
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (const QImage picture = this->picture(); !picture.isNull()) {
    // Until the new picture is there the old one takes its place, undistorted.
    QSize size = picture.size().scaled(page.size(), Qt::KeepAspectRatio);
    if (upToDate())
      size = page.size();
    QRect place(QPoint(), size);
    place.moveCenter(page.center());
    painter.setOpacity(upToDate() ? 1.0 : 0.4);
    painter.drawImage(place, picture);
  }
  painter.setOpacity(1.0);
  painter.setPen(palette().color(QPalette::Dark));
  painter.drawRect(QRectF(page).adjusted(-0.5, -0.5, 0.5, 0.5));
  if (upToDate())
    return;
  painter.setPen(QColor(70, 70, 70));
  painter.drawText(page, Qt::AlignCenter, tr("Drawing…"));
}

}  // namespace sline::widgets

#include "moc_export_preview.cpp"
