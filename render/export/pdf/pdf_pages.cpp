// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_pages.h"

#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>

#include "render/export/pdf/pdf_document.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr int unitsPerMillimetre = 100;
constexpr int unitsPerInch = 2540;

}  // namespace

PdfPages::PdfPages(const glm::vec2& sizeMm, const std::string& language)
    : m_size(sizeMm), m_language(language) {
  m_bytes.open(QIODevice::WriteOnly);
  m_writer = std::make_unique<QPdfWriter>(&m_bytes);
  m_writer->setResolution(unitsPerInch);
  m_writer->setPageLayout(
      QPageLayout(QPageSize(QSizeF(double(sizeMm.x), double(sizeMm.y)), QPageSize::Millimeter,
                            QString(), QPageSize::ExactMatch),
                  QPageLayout::Portrait, QMarginsF(), QPageLayout::Millimeter));
  m_painter.begin(m_writer.get());
  m_painter.scale(unitsPerMillimetre, unitsPerMillimetre);
}

PdfPages::~PdfPages() {
  if (m_painter.isActive())
    m_painter.end();
}

void PdfPages::newPage() {
  m_writer->newPage();
  ++m_page;
}

void PdfPages::place(const VectorDrawing& drawing, const PdfPlacement& place) {
  m_placed.push_back({m_page, &drawing, place});
}

void PdfPages::leaveGaps(const Lettering& lettering, const glm::vec2& at) {
  if (lettering.clear)
    m_gaps[m_page] += gapsOf(lettering, at, pointsPerMillimetre * double(m_size.y));
}

Result<QByteArray> PdfPages::finish(const ExportCredit& credit, const std::string& title,
                                    PdfNavigation navigation) {
  m_painter.end();
  m_writer.reset();
  const glm::dvec2 size = pointsPerMillimetre * glm::dvec2(m_size);
  std::vector<PdfContent> below(m_page + 1);
  for (const Placed& placed : m_placed)
    appendDrawing(below[placed.page], *placed.drawing, placed.place, size.y);
  for (auto& [page, gaps] : m_gaps)
    below[page].gaps = std::move(gaps);
  for (const auto& [page, said] : m_said) {
    below[page].said = said.text;
    below[page].language = said.language;
  }
  return joinedPdf(m_bytes.data(), below,
                   {.pageSize = size,
                    .language = m_language,
                    .title = title,
                    .credit = credit,
                    .navigation = std::move(navigation)});
}

void setText(QPainter& painter, const LetteringText& text) {
  const qreal scale = qreal(text.points * millimetresPerPoint) / labelFontPixels;
  painter.save();
  painter.setPen(painterColour(text.ink));
  painter.translate(qreal(text.at.x), qreal(text.at.y));
  painter.scale(scale, scale);
  qreal baseline = 0.0;
  for (const TextLine& line : text.lines) {
    const std::vector<float> places = runPlaces(text, line);
    for (std::size_t i = 0; i < line.runs.size(); ++i) {
      painter.setFont(labelFont(line.runs[i].style));
      painter.drawText(QPointF(qreal(places[i]) / scale, baseline), line.runs[i].text);
    }
    baseline += qreal(text.leading) / scale;
  }
  painter.restore();
}

}  // namespace sline::render
