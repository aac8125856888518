// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/plain_screen.h"

#include <QPainter>
#include <algorithm>
#include <new>
#include <utility>

namespace sline::widgets {

PlainScreen::PlainScreen(QWidget& parent, Told told, QString driver)
    : QWidget(&parent), m_told(std::move(told)), m_driver(std::move(driver)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void PlainScreen::setPaper(const QColor& paper) {
  m_paper = paper;
  update();
}

void PlainScreen::stop() {
  const std::lock_guard lock(m_mutex);
  m_newest = m_showing = m_drawn = {};
  m_shown = 0;
}

void PlainScreen::takeNewest() {
  const std::lock_guard lock(m_mutex);
  if (m_newest.turn > m_showing.turn)
    std::swap(m_newest, m_showing);
}

void PlainScreen::showNewest() {
  takeNewest();
  update();
}

void PlainScreen::blank(std::uint64_t upTo) {
  m_blank = upTo;
  update();
}

QImage PlainScreen::picture() {
  showNewest();
  const render::gpu::TextureSize size = pixelsOf(*this);
  QImage image(size.width, size.height, QImage::Format_RGB32);
  image.fill(m_paper);
  if (!isBlank()) {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(image.rect(), m_showing.image);
  }
  image.setDevicePixelRatio(devicePixelRatioF());
  return image;
}

Result<render::PictureTarget> PlainScreen::begin(render::gpu::TextureSize size) {
  m_size = size;
  m_rows.resize(std::size_t(size.width) * std::size_t(size.height));
  return render::PictureTarget(size.width, size.height, m_rows);
}

void PlainScreen::publish(std::uint64_t number) {
  const QSize size(m_size.width, m_size.height);
  if (m_drawn.image.size() != size)
    m_drawn.image = QImage(size, QImage::Format_RGB32);
  if (m_drawn.image.isNull())
    throw std::bad_alloc();
  const auto columns = std::size_t(m_size.width);
  for (int y = 0; y < m_size.height; ++y) {
    const std::uint32_t* from = m_rows.data() + std::size_t(m_size.height - 1 - y) * columns;
    auto* to = reinterpret_cast<QRgb*>(m_drawn.image.scanLine(y));
    std::transform(from, from + columns, to, [](std::uint32_t pixel) {
      return qRgb(int(pixel & 0xffu), int(pixel >> 8 & 0xffu), int(pixel >> 16 & 0xffu));
    });
  }
  m_drawn.number = number;
  m_drawn.turn = ++m_turn;
  const std::lock_guard lock(m_mutex);
  std::swap(m_drawn, m_newest);
}

void PlainScreen::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!std::exchange(m_opened, true))
    m_told.ready();
}

void PlainScreen::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (isBlank()) {
    painter.fillRect(rect(), m_paper);
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform,
                        m_showing.image.size() != size() * devicePixelRatioF());
  painter.drawImage(rect(), m_showing.image);
  if (std::exchange(m_shown, m_showing.number) != m_showing.number)
    m_told.shown(m_showing.number);
}

}  // namespace sline::widgets
