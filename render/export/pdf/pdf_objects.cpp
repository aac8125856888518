// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_objects.h"

#include <QByteArrayList>
#include <algorithm>
#include <cstddef>

namespace sline::render {

namespace {

/// The number that follows a name, in an object or a trailer.
std::optional<int> numberAfter(const QByteArray& text, const QByteArray& name) {
  const qsizetype at = text.indexOf(name + ' ');
  if (at < 0)
    return std::nullopt;
  qsizetype end = at + name.size() + 1;
  const qsizetype start = end;
  while (end < text.size() && text[end] >= '0' && text[end] <= '9')
    ++end;
  bool ok = false;
  const int value = text.mid(start, end - start).toInt(&ok);
  return ok ? std::optional<int>(value) : std::nullopt;
}

/// Where each object begins, by its number; 0 where there is none.
std::optional<std::vector<qsizetype>> placesOf(const QByteArray& file) {
  const qsizetype start = file.lastIndexOf("startxref\n");
  if (start < 0)
    return std::nullopt;
  qsizetype at = file.mid(start + 10).trimmed().split('\n').front().toLongLong();
  if (at <= 0 || at >= file.size() || !file.mid(at, 5).startsWith("xref\n"))
    return std::nullopt;
  at = file.indexOf('\n', at) + 1;
  const qsizetype lineEnd = file.indexOf('\n', at);
  const QList<QByteArray> range = file.mid(at, lineEnd - at).split(' ');
  constexpr qsizetype row = 20;
  const qsizetype count = range.size() == 2 ? range[1].toLongLong() : 0;
  if (range.size() != 2 || range[0] != "0" || count < 2 || lineEnd + 1 + count * row > file.size())
    return std::nullopt;
  std::vector<qsizetype> places(std::size_t(count), 0);
  for (qsizetype i = 1; i < count; ++i) {
    const QByteArray entry = file.mid(lineEnd + 1 + i * row, row);
    if (entry[17] != 'n')
      continue;
    const qsizetype place = entry.left(10).toLongLong();
    if (place <= 0 || place >= file.size())
      return std::nullopt;
    places[std::size_t(i)] = place;
  }
  return places;
}

/// The object's own bytes, where another begins at `end` or later.
std::optional<QByteArray> objectAt(const QByteArray& file, qsizetype place, qsizetype end) {
  const qsizetype body = file.indexOf(" obj\n", place);
  const qsizetype last = file.lastIndexOf("endobj", end);
  if (body < 0 || last < body || body - place > 20)
    return std::nullopt;
  return file.mid(body + 5, last - body - 5);
}

}  // namespace

std::optional<PdfObjects> PdfObjects::read(const QByteArray& file) {
  const auto places = placesOf(file);
  const qsizetype trailerAt = file.lastIndexOf("trailer");
  if (!places || trailerAt < 0)
    return std::nullopt;
  std::vector<qsizetype> ends = *places;
  ends.push_back(file.lastIndexOf("xref\n", file.lastIndexOf("startxref") - 1));
  std::sort(ends.begin(), ends.end());
  PdfObjects objects;
  objects.m_objects.resize(places->size());
  for (std::size_t i = 1; i < places->size(); ++i) {
    const qsizetype place = (*places)[i];
    if (place == 0)
      continue;
    const qsizetype next = *std::upper_bound(ends.begin(), ends.end(), place);
    const auto object = objectAt(file, place, next);
    if (!object)
      return std::nullopt;
    objects.m_objects[i] = *object;
  }
  const QByteArray trailer = file.mid(trailerAt);
  const auto known = [&](const std::optional<int>& id) {
    return id && *id > 0 && std::size_t(*id) < objects.m_objects.size();
  };
  const auto root = numberAfter(trailer, "/Root");
  if (!known(root))
    return std::nullopt;
  objects.m_catalog = {*root};
  if (const auto info = numberAfter(trailer, "/Info"); known(info))
    objects.m_objects[std::size_t(*info)].clear();
  const auto tree = objects.reference(objects.m_catalog, "/Pages");
  if (!tree)
    return std::nullopt;
  const QByteArray& kids = objects[*tree];
  const qsizetype from = kids.indexOf('[', kids.indexOf("/Kids"));
  const QByteArrayList words =
      kids.mid(from + 1, kids.indexOf(']', from) - from - 1).simplified().split(' ');
  for (qsizetype i = 0; i + 2 < words.size(); i += 3)
    objects.m_pages.push_back({words[i].toInt()});
  const bool allKnown = std::all_of(objects.m_pages.begin(), objects.m_pages.end(),
                                    [&](PdfId page) { return known(page.value); });
  return allKnown && !objects.m_pages.empty() ? std::optional<PdfObjects>(std::move(objects))
                                              : std::nullopt;
}

std::optional<PdfId> PdfObjects::reference(PdfId from, const QByteArray& name) const {
  const auto id = numberAfter((*this)[from], name);
  if (!id || *id < 1 || std::size_t(*id) >= m_objects.size())
    return std::nullopt;
  return PdfId{*id};
}

PdfId PdfObjects::add(QByteArray object) {
  m_objects.push_back(std::move(object));
  return {int(m_objects.size()) - 1};
}

PdfId PdfObjects::addStream(const QByteArray& bytes, const QByteArray& entries) {
  // Qt writes the length before what zlib writes.
  const QByteArray packed = qCompress(bytes, 9).mid(4);
  return add("<<" + entries + "/Filter/FlateDecode/Length " + QByteArray::number(packed.size()) +
             ">>\nstream\n" + packed + "\nendstream\n");
}

PdfId PdfObjects::addPlainStream(const QByteArray& bytes, const QByteArray& entries) {
  return add("<<" + entries + "/Length " + QByteArray::number(bytes.size()) + ">>\nstream\n" +
             bytes + "\nendstream\n");
}

QByteArray PdfObjects::written() const {
  // Objects that nobody refers to any more are left out, and the others count on.
  QByteArray file = "%PDF-1.5\n%\xE2\xE3\xCF\xD3\n";
  std::vector<qsizetype> places(m_objects.size(), 0);
  for (std::size_t i = 1; i < m_objects.size(); ++i) {
    if (m_objects[i].isEmpty())
      continue;
    places[i] = file.size();
    file += QByteArray::number(qulonglong(i)) + " 0 obj\n" + m_objects[i] + "endobj\n";
  }
  const qsizetype table = file.size();
  const QByteArray count = QByteArray::number(qulonglong(m_objects.size()));
  file += "xref\n0 " + count + "\n0000000000 65535 f \n";
  for (std::size_t i = 1; i < places.size(); ++i)
    file += places[i] == 0 ? QByteArray("0000000000 65535 f \n")
                           : QByteArray::number(places[i]).rightJustified(10, '0') + " 00000 n \n";
  const QByteArray info =
      m_info.value > 0 ? "/Info " + QByteArray::number(m_info.value) + " 0 R" : QByteArray();
  return file + "trailer\n<</Size " + count + "/Root " + QByteArray::number(m_catalog.value) +
         " 0 R" + info + ">>\nstartxref\n" + QByteArray::number(table) + "\n%%EOF\n";
}

}  // namespace sline::render
