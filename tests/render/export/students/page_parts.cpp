// SPDX-License-Identifier: Apache-2.0
#include "tests/render/export/students/page_parts.h"

#include <zlib.h>

#include <QRegularExpression>

namespace sline::test {

QByteArray elementOf(const std::string& html, const QByteArray& startTag) {
  const QByteArray page = QByteArray::fromStdString(html);
  const qsizetype tag = page.indexOf(startTag);
  const qsizetype from = tag < 0 ? tag : page.indexOf('>', tag) + 1;
  if (tag < 0)
    return {};
  const QByteArray name = startTag.mid(1).split(' ').front().split('>').front();
  return page.mid(from, page.indexOf("</" + name, from) - from);
}

QByteArray attributeOf(const std::string& html, const QByteArray& startTag, const char* name) {
  const QByteArray page = QByteArray::fromStdString(html);
  const qsizetype tag = page.indexOf(startTag);
  if (tag < 0)
    return {};
  const QByteArray begin = QByteArray(name) + "=\"";
  const qsizetype from = page.indexOf(begin, tag) + begin.size();
  return page.mid(from, page.indexOf('"', from) - from);
}

nlohmann::json factsOf(const std::string& html) {
  return nlohmann::json::parse(
      elementOf(html, "<script type=\"application/json\" id=\"facts\"").toStdString(), nullptr,
      false);
}

QByteArray gunzipped(const QByteArray& packed) {
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  QByteArray out;
  int state = Z_OK;
  while (state == Z_OK) {
    QByteArray piece(1 << 16, Qt::Uninitialized);
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = uInt(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    out += piece.left(piece.size() - qsizetype(stream.avail_out));
  }
  inflateEnd(&stream);
  return state == Z_STREAM_END ? out : QByteArray();
}

QByteArray unpackedPage(const render::StudentsPage& page) {
  QByteArray all = QByteArray::fromStdString(page.html);
  for (const char* id : {"program", "scene", "scene-context"})
    all += gunzipped(QByteArray::fromBase64(
        elementOf(page.html, QByteArray("<script type=\"text/plain\" id=\"") + id + "\"")));
  for (const auto& [name, bytes] : page.files) {
    const QByteArray file = QByteArray::fromStdString(bytes);
    all += file + gunzipped(file);
  }
  return all;
}

render::StudentsPage pageOf(const render::ExportOrder& order, const render::StudentsOptions& own) {
  const Result<render::StudentsPage> page = render::studentsPage(order, own, {});
  if (!page.ok())
    qFatal("%s", page.error().text().c_str());
  return *page;
}

}  // namespace sline::test
