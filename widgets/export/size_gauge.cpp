// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/size_gauge.h"

#include <algorithm>

#include "widgets/export/straight_image.h"

namespace sline::widgets {

namespace {

/// Tells whether the files have the same content, wherever they go.
bool alike(const render::ExportPiece& a, const render::ExportPiece& b) {
  const std::vector<const render::ExportOption*> options = render::exportOptions();
  return a.filled == b.filled && a.order.page.sizeMm == b.order.page.sizeMm &&
         a.order.page.dpi == b.order.page.dpi && a.order.viewName == b.order.viewName &&
         a.order.words == b.order.words &&
         a.order.environment.keyLight == b.order.environment.keyLight &&
         a.order.camera == b.order.camera &&
         std::all_of(options.begin(), options.end(),
                     [&](const render::ExportOption* option) {
                       return option->field.read(a.order) == option->field.read(b.order);
                     }) &&
         a.order.scene == b.order.scene;
}

}  // namespace

void SizeGauge::measure(const QString& kind, const render::ExportPiece& file, const QImage& page) {
  const render::ExportFormat* format = formatOf(kind);
  if (!format || (m_asked > 0 && kind == m_kind && alike(file, m_file)))
    return;
  m_kind = kind;
  m_file = file;
  m_bytes = 0.0;
  const int number = ++m_asked;
  m_queue.drop();
  if (!format->weigh)
    return;
  m_queue.add([this, number, format, file, page](const std::stop_token& stop) {
    const auto goOn = [&stop](double, std::string_view) { return !stop.stop_requested(); };
    const double bytes = stop.stop_requested()
                             ? 0.0
                             : format->weigh(render::readyOrder(file), straightImage(page), goOn);
    return BackgroundQueue::Sequel([this, number, bytes] {
      if (m_retired) {
        deleteLater();
        return;
      }
      if (number != m_asked)
        return;
      m_bytes = bytes;
      m_done = number;
      emit measured();
    });
  });
}

std::optional<double> SizeGauge::bytes(const QString& kind, const render::ExportPiece& file) const {
  const render::ExportFormat* format = formatOf(kind);
  if (!format || !format->weigh)
    return 0.0;
  const bool known = m_asked > 0 && m_done == m_asked && kind == m_kind && alike(file, m_file);
  return known ? std::optional(m_bytes) : std::nullopt;
}

void SizeGauge::retire() {
  m_retired = true;
  if (!m_queue.busy()) {
    deleteLater();
    return;
  }
  m_queue.drop();
  // Work that never began is dropped with its sequel.
  m_queue.add([this](const std::stop_token&) {
    return BackgroundQueue::Sequel([this] { deleteLater(); });
  });
}

}  // namespace sline::widgets

#include "moc_size_gauge.cpp"
