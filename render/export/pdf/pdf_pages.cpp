// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_pages.h"

#include <QByteArrayList>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <algorithm>

#include "render/export/label_texts.h"
#include "render/export/xmp_packet.h"

namespace sline::render {

namespace {

constexpr int unitsPerMillimetre = 100;
constexpr int unitsPerInch = 2540;

QByteArray decimal(double value) {
  return QByteArray::number(value, 'f', 4);
}

QByteArray reference(PdfId id) {
  return QByteArray::number(id.value) + " 0 R";
}

/// Puts entries into one of an object's dictionaries.
bool insertInto(QByteArray& object, const QByteArray& dictionary, const QByteArray& entries) {
  const qsizetype at = object.indexOf(dictionary + " <<\n");
  if (at < 0)
    return entries.isEmpty();
  object.insert(at + dictionary.size() + 4, entries);
  return true;
}

void replaceValue(QByteArray& object, const QByteArray& name, const QByteArray& value) {
  const qsizetype at = object.indexOf(name + ' ');
  if (at >= 0)
    object.replace(at, object.indexOf('\n', at) - at, name + ' ' + value);
}

/// Letters, digits and hyphens: what a language's tag may hold.
QByteArray tagOf(const std::string& language) {
  QByteArray tag;
  for (const char c : language)
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-')
      tag += c;
  return tag.isEmpty() ? QByteArray("en") : tag.left(20);
}

/// A text string of PDF (ISO 32000-1, 7.9.2.2): UTF-16 with its mark, in hexadecimal.
QByteArray textString(const std::string& text) {
  QByteArray hex("<FEFF");
  const QString characters = QString::fromStdString(text);
  for (const QChar each : characters)
    hex += QByteArray::number(each.unicode(), 16).rightJustified(4, '0');
  return hex + '>';
}

/// In the document's information, where all programs look; the credit as XMP, too.
void addInformation(PdfObjects& objects, const ExportCredit& credit, const std::string& title) {
  if (credit.empty() && title.empty())
    return;
  QByteArray info("<<");
  if (!title.empty())
    info += "/Title " + textString(title);
  if (!credit.author.empty())
    info += "/Author " + textString(credit.author);
  if (!credit.copyright.empty())
    info += "/Copyright " + textString(credit.copyright);
  objects.setInfo(objects.add(info + ">>\n"));
  const auto addToCatalog = [&objects](const QByteArray& entry) {
    QByteArray& catalog = objects[objects.catalog()];
    catalog.insert(catalog.indexOf("/Type"), entry);
  };
  if (!title.empty())
    addToCatalog("/ViewerPreferences <</DisplayDocTitle true>>\n");
  if (credit.empty())
    return;
  const PdfId xmp = objects.addPlainStream(QByteArray::fromStdString(xmpPacket(credit)),
                                           "/Type/Metadata/Subtype/XML");
  addToCatalog("/Metadata " + reference(xmp) + '\n');
}

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

void PdfPages::place(const VectorDrawing& drawing, const PdfPlace& place) {
  m_placed.push_back({m_page, &drawing, place});
}

void PdfPages::join(PdfObjects& objects, PdfId page, const PdfContent& content) const {
  const double width = double(m_size.x) * pointsPerMillimetre;
  const double height = double(m_size.y) * pointsPerMillimetre;
  // QPdfWriter's pages are whole points high: its upper edge is moved to the page's.
  const QByteArray box = objects[page].mid(objects[page].indexOf("/MediaBox ["));
  const double itsHeight = box.left(box.indexOf(']')).split(' ').last().toDouble();
  const PdfId below =
      objects.addStream(content.operators + "q 1 0 0 1 0 " + decimal(height - itsHeight) + " cm\n");
  const PdfId above = objects.addStream("Q\n");
  const auto painted = objects.reference(page, "/Contents");
  const auto resources = objects.reference(page, "/Resources");
  if (!painted || !resources)
    return;
  replaceValue(objects[page], "/Contents",
               '[' + reference(below) + ' ' + reference(*painted) + ' ' + reference(above) + ']');
  replaceValue(objects[page], "/MediaBox", "[0 0 " + decimal(width) + ' ' + decimal(height) + ']');
  insertInto(objects[*resources], "/ExtGState", content.states);
  insertInto(objects[*resources], "/XObject", content.forms);
}

Result<QByteArray> PdfPages::finish(const ExportCredit& credit, const std::string& title) {
  m_painter.end();
  m_writer.reset();
  std::optional<PdfObjects> objects = PdfObjects::read(m_bytes.data());
  if (!objects || objects->pages().size() != m_page + 1)
    return Error{.reason = "Qt's PDF has a shape that is not known",
                 .remedy = "Report this, with the version of Qt"};
  const std::vector<PdfId> pages = objects->pages();
  for (std::size_t i = 0; i < pages.size(); ++i) {
    PdfContent content;
    for (const Placed& placed : m_placed)
      if (placed.page == i)
        appendDrawing(content, *objects, *placed.drawing, placed.place,
                      double(m_size.y) * pointsPerMillimetre);
    join(*objects, pages[i], content);
  }
  QByteArray& catalog = (*objects)[objects->catalog()];
  catalog.insert(catalog.indexOf("/Type"), "/Lang (" + tagOf(m_language) + ")\n");
  addInformation(*objects, credit, title);
  return objects->written();
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
