// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/plain_screen.h"

#include <QPainter>
#include <new>
#include <span>
#include <utility>

#include "model/base/parallel.h"

namespace sline::widgets {

namespace {

/// Fills `pixels`, in rows of that width, with the means of squares of samples, opaque all.
void average(std::span<const std::uint32_t> samples, int side, std::size_t width,
             std::span<std::uint32_t> pixels) {
  const std::size_t n = std::size_t(side);
  const std::uint32_t count = std::uint32_t(side * side);
  parallelFor(pixels.size() / width, 16, [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t red = count / 2;
      std::uint32_t green = count / 2;
      std::uint32_t blue = count / 2;
      for (std::size_t i = 0; i < n * n; ++i) {
        const std::uint32_t s = samples[(y * n + i / n) * width * n + x * n + i % n];
        red += (s >> 16U) & 255U;
        green += (s >> 8U) & 255U;
        blue += s & 255U;
      }
      pixels[y * width + x] =
          0xff000000U | (red / count) << 16U | (green / count) << 8U | blue / count;
    }
  });
}

}  // namespace

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

QImage PlainScreen::picture() {
  showNewest();
  const render::gpu::TextureSize size = pixelsOf(*this);
  QImage image(size.width, size.height, QImage::Format_RGB32);
  image.fill(m_paper);
  if (m_showing.number != 0) {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(image.rect(), m_showing.image);
  }
  image.setDevicePixelRatio(devicePixelRatioF());
  return image;
}

Result<const render::gpu::Target*> PlainScreen::begin(render::gpu::TextureSize size) {
  m_size = size;
  return m_readback.begin(size);
}

void PlainScreen::publish(std::uint64_t number, int samples) {
  const QSize size(m_size.width / samples, m_size.height / samples);
  if (m_drawn.image.size() != size)
    m_drawn.image = QImage(size, QImage::Format_RGB32);
  if (m_drawn.image.isNull())
    throw std::bad_alloc();
  const std::span pixels(reinterpret_cast<std::uint32_t*>(m_drawn.image.bits()),
                         std::size_t(size.width()) * std::size_t(size.height()));
  if (samples == 1) {
    m_readback.read(pixels);
  } else {
    m_samples.resize(std::size_t(m_size.width) * std::size_t(m_size.height));
    m_readback.read(m_samples);
    average(m_samples, samples, std::size_t(size.width()), pixels);
    m_samples = {};
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
  if (m_showing.number == 0) {
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
