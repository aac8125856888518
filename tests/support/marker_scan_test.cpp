// SPDX-License-Identifier: Apache-2.0
// Tests that the search for planted markers finds one however a file hides it: otherwise it would
// prove nothing.
#include <zlib.h>

#include <QTest>

#include "tests/support/marker_scan.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

const QString marker = QStringLiteral("QZXMüller-4711");

/// Returns the bytes packed as `bits` of deflateInit2 say.
QByteArray packed(const QByteArray& bytes, int bits) {
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, bits, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    qFatal("zlib does not start");
  QByteArray made(qsizetype(deflateBound(&stream, uLong(bytes.size())) + 32), '\0');
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.constData()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(made.data());
  stream.avail_out = uInt(made.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END)
    qFatal("zlib does not pack");
  made.resize(qsizetype(stream.total_out));
  deflateEnd(&stream);
  return made;
}

QByteArray number(quint32 value, int size, bool big) {
  QByteArray bytes;
  for (int i = 0; i < size; ++i)
    bytes += char(value >> (8 * (big ? size - 1 - i : i)));
  return bytes;
}

/// Returns a member of a ZIP file, with its local header.
QByteArray zipMember(const QByteArray& name, const QByteArray& content, bool deflated) {
  const QByteArray data = deflated ? packed(content, -MAX_WBITS) : content;
  return QByteArray("PK\x03\x04") + number(20, 2, false) + number(0, 2, false) +
         number(deflated ? 8 : 0, 2, false) + number(0, 4, false) +
         number(quint32(crc32(0, reinterpret_cast<const Bytef*>(content.constData()),
                              uInt(content.size()))),
                4, false) +
         number(quint32(data.size()), 4, false) + number(quint32(content.size()), 4, false) +
         number(quint32(name.size()), 2, false) + number(0, 2, false) + name + data;
}

/// Returns a chunk of PNG; the check sum does not matter here.
QByteArray chunk(const QByteArray& kind, const QByteArray& data) {
  return number(quint32(data.size()), 4, true) + kind + data + "crc!";
}

QByteArray utf16(const QString& text, bool big) {
  QByteArray bytes;
  for (const QChar each : text)
    bytes += number(each.unicode(), 2, big);
  return bytes;
}

QByteArray escaped(const QString& text, const char* form) {
  QByteArray bytes;
  for (const QChar each : text)
    bytes += QString::asprintf(form, unsigned(each.unicode())).toUtf8();
  return bytes;
}

QByteArray octal(const QByteArray& text) {
  QByteArray bytes;
  for (const char each : text)
    bytes += QString::asprintf("\\%03o", unsigned(std::uint8_t(each))).toUtf8();
  return bytes;
}

}  // namespace

class MarkerScanTest : public QObject {
  Q_OBJECT

 private slots:
  void finds_data() {
    QTest::addColumn<QByteArray>("file");
    const QByteArray plain = marker.toUtf8();
    const QByteArray filler(300, 'x');
    const QByteArray png = "\x89PNG\r\n\x1a\n";
    const auto row = [&filler](const char* name, const QByteArray& bytes) {
      QTest::newRow(name) << filler + bytes + filler;
    };
    row("UTF-8", plain);
    row("capitals", marker.toUpper().toUtf8());
    row("capitals of ASCII", plain.toUpper());
    row("Latin-1", marker.toLatin1());
    row("UTF-16, little end first", utf16(marker, false));
    row("UTF-16, big end first", utf16(marker, true));
    row("SVG comment", "<svg><!-- " + plain + " --></svg>");
    row("XML, hexadecimal", escaped(marker, "&#x%x;"));
    row("XML, decimal", escaped(marker, "&#%u;"));
    row("JSON of glTF", "{\"extras\":\"" + escaped(marker, "\\u%04x") + "\"}");
    row("address", plain.toPercentEncoding());
    row("base64 in SVG", "href=\"data:image/png;base64," + (filler + plain).toBase64() + "\"");
    row("packed in base64", "data:;base64," + packed(filler + plain, MAX_WBITS).toBase64());
    row("PDF stream", "stream\n" + packed("BT (" + plain + ") Tj ET", MAX_WBITS) + "\nendstream");
    row("PDF hexadecimal", "/Title <" + plain.toHex() + ">");
    row("PDF hexadecimal UTF-16", "/Title <FEFF" + utf16(marker, true).toHex() + ">");
    row("PDF octal", "/Title (" + octal(marker.toLatin1()) + ")");
    row("PNG tEXt", png + chunk("tEXt", QByteArray("Author\0", 7) + marker.toLatin1()));
    row("PNG zTXt",
        png + chunk("zTXt", QByteArray("Author\0\0", 8) + packed(marker.toLatin1(), MAX_WBITS)));
    row("PNG iTXt",
        png + chunk("iTXt", QByteArray("Author\0\1\0\0\0", 11) + packed(plain, MAX_WBITS)));
    row("TIFF tag", QByteArray("II*\0\x08\0\0\0", 8) + plain + '\0');
    row("MP4 box", number(quint32(plain.size() + 8), 4, true) + "\251nam" + plain);
    row("WebP chunk", "RIFF....WEBPEXIF" + number(quint32(plain.size()), 4, false) + plain);
    row("ZIP member's name", zipMember(plain, "x", false));
    row("ZIP, stored", zipMember("a.txt", filler + plain, false));
    row("ZIP, deflated", zipMember("a.txt", filler + plain, true));
    row("ZIP in a ZIP", zipMember("a.zip", zipMember("b.txt", filler + plain, true), true));
    row("gzip", packed(plain, MAX_WBITS + 16));
    row("PNG in a ZIP", zipMember("a.png",
                                  png + chunk("zTXt", QByteArray("A\0\0", 3) +
                                                          packed(marker.toLatin1(), MAX_WBITS)),
                                  true));
  }
  void finds() {
    QFETCH(QByteArray, file);
    QCOMPARE(markersIn(file, {marker, QStringLiteral("absent-marker")}), QStringList{marker});
  }

  void invents() {
    QByteArray noise;
    quint32 state = 1;
    for (int i = 0; i < 20000; ++i) {
      state = state * 1664525u + 1013904223u;
      noise += char(state >> 24);
    }
    QCOMPARE(markersIn(noise, {marker}), QStringList());
    QCOMPARE(markersIn({}, {marker}), QStringList());
    QCOMPARE(markersIn(marker.chopped(1).toUtf8(), {marker}), QStringList());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::MarkerScanTest)
#include "marker_scan_test.moc"
