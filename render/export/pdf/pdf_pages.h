// SPDX-License-Identifier: Apache-2.0
// Makes pages of a PDF file: drawings below, and above them text and shapes from a painter.
#pragma once

#include <QBuffer>
#include <QPainter>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/export/pdf/pdf_navigation.h"
#include "render/export/pdf/sheet_pages.h"
#include "render/lettering/lettering.h"

class QPdfWriter;

namespace sline::render {

class PdfPages : public SheetPages {
 public:
  /// Makes pages of that size and begins the first. The language (BCP 47) is for programs that read
  /// aloud.
  PdfPages(const glm::vec2& sizeMm, const std::string& language);
  ~PdfPages() override;
  PdfPages(const PdfPages&) = delete;
  PdfPages& operator=(const PdfPages&) = delete;

  void newPage() override;
  /// Text that it draws stays text.
  QPainter& painter() override { return m_painter; }
  /// The drawing lies below everything painted on the page, whenever that was.
  void place(const VectorDrawing& drawing, const PdfPlacement& place) override;
  void leaveGaps(const Lettering& lettering, const glm::vec2& at) override;
  void describe(const AltText& said) override { m_said[m_page] = said; }

  /// Returns the whole file. It holds no more than what the pages show, the credit and, if there is
  /// one, the title that viewers show above them: no program, date or machine.
  Result<QByteArray> finish(const ExportCredit& credit = {}, const std::string& title = {},
                            PdfNavigation navigation = {});

 private:
  struct Placed {
    std::size_t page;
    const VectorDrawing* drawing;
    PdfPlacement place;
  };

  glm::vec2 m_size;
  std::string m_language;
  std::size_t m_page = 0;
  std::vector<Placed> m_placed;
  std::map<std::size_t, std::string> m_gaps;  ///< in the drawings of pages, as operators
  std::map<std::size_t, AltText> m_said;      ///< of pages
  QBuffer m_bytes;
  std::unique_ptr<QPdfWriter> m_writer;
  QPainter m_painter;
};

/// Sets text that stays text, in the labels' font; it is a TextSetter.
void setText(QPainter& painter, const LetteringText& text);

}  // namespace sline::render
