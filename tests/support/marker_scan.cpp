// SPDX-License-Identifier: Apache-2.0
#include "tests/support/marker_scan.h"

#include <zlib.h>

#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <algorithm>
#include <vector>

namespace sline::test {

namespace {

constexpr int deepest = 4;
constexpr std::size_t mostInflated = std::size_t(64) * 1024 * 1024;

/// Returns the bytes with ASCII letters in lower case; other bytes stay.
QByteArray lower(QByteArray bytes) {
  for (char& each : bytes)
    if (each >= 'A' && each <= 'Z')
      each = char(each - 'A' + 'a');
  return bytes;
}

/// Returns what zlib unpacks from there on; `bits` as inflateInit2's. Empty if the bytes are not
/// packed that way.
QByteArray inflated(const QByteArray& bytes, qsizetype at, int bits) {
  z_stream stream{};
  if (inflateInit2(&stream, bits) != Z_OK)
    return {};
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.constData() + at));
  stream.avail_in = uInt(bytes.size() - at);
  QByteArray all;
  QByteArray piece(65536, '\0');
  int state = Z_OK;
  while (state == Z_OK && std::size_t(all.size()) < mostInflated) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = uInt(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    if (state != Z_OK && state != Z_STREAM_END)
      break;
    const auto made = piece.size() - qsizetype(stream.avail_out);
    if (made == 0 && state == Z_OK)
      break;
    all.append(piece.constData(), made);
  }
  inflateEnd(&stream);
  return all;
}

std::uint32_t little(const QByteArray& bytes, qsizetype at, int size) {
  std::uint32_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = (value << 8) | std::uint8_t(bytes[at + i]);
  return value;
}

/// Returns everything packed in the bytes.
QList<QByteArray> unpacked(const QByteArray& bytes) {
  QList<QByteArray> found;
  const auto keep = [&found](const QByteArray& made) {
    constexpr qsizetype chance = 4;  // bytes that only look packed give a few at most
    if (made.size() > chance)
      found << made;
  };
  for (qsizetype at = 0; at + 4 < bytes.size(); ++at) {
    const auto first = std::uint8_t(bytes[at]);
    const auto second = std::uint8_t(bytes[at + 1]);
    // RFC 1950 gives the method, and a check of the first two bytes.
    if ((first & 0x0f) == 8 && first <= 0x78 && (first * 256 + second) % 31 == 0)
      keep(inflated(bytes, at, MAX_WBITS));
    else if (first == 0x1f && second == 0x8b)
      keep(inflated(bytes, at, MAX_WBITS + 16));
    else if (bytes.mid(at, 4) == "PK\x03\x04" && at + 30 < bytes.size() &&
             little(bytes, at + 8, 2) == 8)
      keep(inflated(bytes, at + 30 + little(bytes, at + 26, 2) + little(bytes, at + 28, 2),
                    -MAX_WBITS));
  }
  return found;
}

using Decode = QByteArray (*)(const QString& captured);

/// Returns the bytes with all that the pattern finds decoded.
QByteArray replaced(const QByteArray& bytes, const QRegularExpression& pattern, Decode decode) {
  const QString text = QString::fromLatin1(bytes);
  QByteArray result;
  qsizetype from = 0;
  for (auto each = pattern.globalMatch(text); each.hasNext();) {
    const QRegularExpressionMatch match = each.next();
    result += bytes.mid(from, match.capturedStart() - from);
    result += decode(match.captured(1));
    from = match.capturedEnd();
  }
  return from == 0 ? QByteArray() : result + bytes.mid(from);
}

/// Returns the content without the escapes by which different formats may hide it.
QList<QByteArray> unescaped(const QByteArray& bytes) {
  static const QRegularExpression json(QStringLiteral("\\\\u([0-9a-fA-F]{4})"));
  static const QRegularExpression xmlHex(QStringLiteral("&#x([0-9a-fA-F]+);"));
  static const QRegularExpression xml(QStringLiteral("&#([0-9]+);"));
  static const QRegularExpression octal(QStringLiteral("\\\\([0-7]{3})"));
  static const QRegularExpression hexadecimal(QStringLiteral("<([0-9a-fA-F\\s]{8,})>"));
  static const QRegularExpression base64(QStringLiteral("([A-Za-z0-9+/\\-_]{8,}={0,2})"));
  const Decode ofHexCode = [](const QString& code) {
    return QString(QChar(char16_t(code.toUInt(nullptr, 16)))).toUtf8();
  };
  const Decode ofCode = [](const QString& code) {
    return QString(QChar(char16_t(code.toUInt()))).toUtf8();
  };
  const Decode ofOctal = [](const QString& code) {
    return QByteArray(1, char(code.toUInt(nullptr, 8)));
  };
  QList<QByteArray> found{
      bytes.contains('%') ? QByteArray::fromPercentEncoding(bytes) : QByteArray(),
      replaced(bytes, json, ofHexCode),
      replaced(bytes, xmlHex, ofHexCode),
      replaced(bytes, xml, ofCode),
      replaced(bytes, octal, ofOctal),
      replaced(bytes, hexadecimal,
               [](const QString& digits) { return QByteArray::fromHex(digits.toLatin1()); }),
      replaced(bytes, base64,
               [](const QString& text) { return QByteArray::fromBase64(text.toLatin1()); })};
  found.removeAll(QByteArray());
  return found;
}

/// Returns the forms that a marker may have in bytes once `lower` has been over them, which leaves
/// letters beyond ASCII as large as they are.
QList<QByteArray> shapesOf(const QString& marker) {
  QList<QByteArray> shapes;
  for (const QString& form : {marker, marker.toLower(), marker.toUpper()}) {
    QByteArray little16;
    QByteArray big16;
    for (const QChar each : form) {
      little16 += char(each.unicode() & 0xff);
      little16 += char(each.unicode() >> 8);
      big16 += char(each.unicode() >> 8);
      big16 += char(each.unicode() & 0xff);
    }
    shapes << lower(form.toUtf8()) << lower(form.toLatin1()) << lower(little16) << lower(big16);
  }
  return shapes;
}

/// Holds all shapes of all markers and finds them in one walk over the bytes: pixels are many.
class Shapes {
 public:
  explicit Shapes(const QStringList& markers) {
    for (const QString& marker : markers)
      for (const QByteArray& shape : shapesOf(marker)) {
        std::vector<Shape>& same = m_beginning[beginningOf(shape, 0)];
        if (std::none_of(same.begin(), same.end(),
                         [&](const Shape& each) { return each.bytes == shape; }))
          same.push_back({shape, marker});
      }
  }

  void findIn(const QByteArray& bytes, QSet<QString>& found) const {
    const QByteArray small = lower(bytes);
    for (qsizetype at = 0; at + 1 < small.size(); ++at)
      for (const Shape& shape : m_beginning[beginningOf(small, at)])
        if (QByteArrayView(small).sliced(at).startsWith(shape.bytes))
          found << shape.marker;
  }

 private:
  struct Shape {
    QByteArray bytes;
    QString marker;
  };

  static std::size_t beginningOf(const QByteArray& bytes, qsizetype at) {
    return std::size_t(std::uint8_t(bytes[at])) << 8 | std::uint8_t(bytes[at + 1]);
  }

  /// Holds the shapes by their first two bytes.
  std::vector<std::vector<Shape>> m_beginning{65536};
};

void scan(const QByteArray& bytes, const Shapes& shapes, int depth, QSet<QString>& found) {
  shapes.findIn(bytes, found);
  if (depth >= deepest)
    return;
  for (const QByteArray& inner : unpacked(bytes))
    scan(inner, shapes, depth + 1, found);
  // Escapes hide texts, which are short; pixels have none.
  constexpr qsizetype longestText = 8'000'000;
  if (bytes.size() > longestText)
    return;
  for (const QByteArray& inner : unescaped(bytes)) {
    shapes.findIn(inner, found);
    // Text that is hidden once may be packed, too; hiding it twice does not happen by mistake.
    for (const QByteArray& deeper : unpacked(inner))
      scan(deeper, shapes, depth + 1, found);
  }
}

QByteArray outputOf(const QString& program, const QStringList& arguments) {
  if (QStandardPaths::findExecutable(program).isEmpty())
    return {};
  QProcess process;
  process.start(program, arguments);
  return process.waitForFinished() ? process.readAllStandardOutput() : QByteArray();
}

}  // namespace

QStringList markersIn(const QByteArray& file, const QStringList& markers) {
  QSet<QString> found;
  scan(file, Shapes(markers), 0, found);
  QStringList sorted(found.begin(), found.end());
  sorted.sort();
  return sorted;
}

QByteArray textOfPdf(const QString& path) {
  return outputOf(QStringLiteral("pdftotext"), {path, QStringLiteral("-")}) +
         outputOf(QStringLiteral("pdfinfo"), {path});
}

}  // namespace sline::test
