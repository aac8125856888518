// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/volumes/written_volumes.h"

#include <bzlib.h>
#include <zlib.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "tests/model/import/readers/mesh_files.h"

namespace sline::test {

namespace {

QByteArray text(double value) {
  return QByteArray::number(value, 'g', 17);
}

QByteArray vectorText(const glm::dvec3& v) {
  return '(' + text(v.x) + ',' + text(v.y) + ',' + text(v.z) + ')';
}

QByteArray deflated(const QByteArray& bytes, int windowBits) {
  z_stream stream{};
  if (deflateInit2(&stream, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    qFatal("zlib");
  QByteArray packed(qsizetype(deflateBound(&stream, uLong(bytes.size()))), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = uInt(packed.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END)
    qFatal("deflate");
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

QByteArray bzipped(const QByteArray& bytes) {
  QByteArray packed(bytes.size() + bytes.size() / 50 + 600, '\0');
  auto size = unsigned(packed.size());
  if (BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(bytes.data()),
                               unsigned(bytes.size()), 9, 0, 0) != BZ_OK)
    qFatal("bzip2");
  packed.resize(size);
  return packed;
}

template <class T>
void appendAs(QByteArray& bytes, int value, std::endian order) {
  append(bytes, T(value), order);
}

void appendNumber(QByteArray& bytes, int value, Number type, std::endian order) {
  switch (type) {
    case Number::int8:
      return appendAs<std::int8_t>(bytes, value, order);
    case Number::uint8:
      return appendAs<std::uint8_t>(bytes, value, order);
    case Number::int16:
      return appendAs<std::int16_t>(bytes, value, order);
    case Number::uint16:
      return appendAs<std::uint16_t>(bytes, value, order);
    case Number::int32:
      return appendAs<std::int32_t>(bytes, value, order);
    case Number::uint32:
      return appendAs<std::uint32_t>(bytes, value, order);
    case Number::int64:
      return appendAs<std::int64_t>(bytes, value, order);
    case Number::uint64:
      return appendAs<std::uint64_t>(bytes, value, order);
    case Number::float32:
      return appendAs<float>(bytes, value, order);
    case Number::float64:
      return appendAs<double>(bytes, value, order);
  }
}

template <class T>
void put(QByteArray& bytes, qsizetype at, T value, std::endian order) {
  QByteArray raw;
  append(raw, value, order);
  bytes.replace(at, raw.size(), raw);
}

glm::dmat4 rasOf(glm::dmat4 matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 2; ++row)
      matrix[column][row] *= -1.0;
  return matrix;
}

/// Holds the vector part of the rotation's quaternion (a ≥ 0), and −1 if the third axis is turned.
struct Quaternion {
  glm::dvec3 v{0.0};
  double sign = 1.0;
};
Quaternion quaternionOf(const glm::dmat4& matrix) {
  glm::dmat3 m(matrix);
  for (int i = 0; i < 3; ++i)
    m[i] = glm::normalize(m[i]);
  Quaternion q;
  if (glm::determinant(m) < 0.0) {
    q.sign = -1.0;
    m[2] = -m[2];
  }
  const double trace = m[0][0] + m[1][1] + m[2][2];
  if (trace > -0.999) {
    const double a = 0.5 * std::sqrt(1.0 + trace);
    q.v = glm::dvec3(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]) / (4.0 * a);
    return q;
  }
  // For half a turn the axis is in the diagonal, its signs in one column.
  int largest = 0;
  for (int i = 1; i < 3; ++i)
    if (m[i][i] > m[largest][largest])
      largest = i;
  glm::dvec3 axis = m[largest];
  axis[largest] += 1.0;
  q.v = glm::normalize(axis);
  return q;
}

}  // namespace

WrittenVolume sampled(const glm::ivec3& size, const glm::dmat4& toLps,
                      const std::function<int(const glm::dvec3&)>& label) {
  WrittenVolume volume{size, toLps, {}};
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        volume.values.push_back(label(glm::dvec3(toLps * glm::dvec4(x, y, z, 1.0))));
  return volume;
}

model::LabelVolume inMemory(const WrittenVolume& volume, int labels) {
  model::LabelVolume result;
  result.size = volume.size;
  result.toLps = volume.toLps;
  result.frame = model::Frame::lps;
  for (const int value : volume.values)
    result.voxels.push_back(std::uint16_t(value));
  for (int i = 1; i <= labels; ++i)
    result.labels.push_back({i, "label " + std::to_string(i), {}, {}});
  return result;
}

QByteArray numbers(const WrittenVolume& volume, Number type, std::endian order) {
  QByteArray bytes;
  for (const int value : volume.values)
    appendNumber(bytes, value, type, order);
  return bytes;
}

QByteArray niftiFile(const WrittenVolume& volume, Number type, std::endian order,
                     const NiftiForm& form) {
  static constexpr std::int16_t codes[] = {256, 2, 4, 512, 8, 768, 1024, 1280, 16, 64};
  static constexpr std::int16_t bits[] = {8, 8, 16, 16, 32, 32, 64, 64, 32, 64};
  const bool first = form.version == 1;
  const qsizetype header = first ? 348 : 540;
  QByteArray bytes(header + 4, '\0');
  QByteArray extension = form.extension;
  if (!extension.isEmpty()) {
    extension.append(16 - (extension.size() + 8) % 16, '\0');
    bytes[header] = 1;
    append(bytes, std::int32_t(extension.size() + 8), order);
    append(bytes, std::int32_t(0), order);
    bytes += extension;
  }
  bytes.append((16 - bytes.size() % 16) % 16, '\0');
  const auto whole = [&](qsizetype at, int i, std::int64_t value) {
    first ? put(bytes, at + 2 * i, std::int16_t(value), order)
          : put(bytes, at + 8 * i, value, order);
  };
  const auto real = [&](qsizetype at, int i, double value) {
    first ? put(bytes, at + 4 * i, float(value), order) : put(bytes, at + 8 * i, value, order);
  };
  put(bytes, 0, std::int32_t(header), order);
  bytes.replace(first ? 344 : 4, 4, QByteArray(first ? "n+1\0" : "n+2\0", 4));
  const std::int64_t dim[] = {3, volume.size.x, volume.size.y, volume.size.z, 1, 1, 1, 1};
  for (int i = 0; i < 8; ++i)
    whole(first ? 40 : 16, i, dim[i]);
  put(bytes, first ? 70 : 12, codes[int(type)], order);
  put(bytes, first ? 72 : 14, bits[int(type)], order);
  const glm::dmat4 ras = rasOf(volume.toLps);
  const Quaternion q = quaternionOf(ras);
  real(first ? 76 : 104, 0, q.sign);
  for (int i = 0; i < 3; ++i)
    real(first ? 76 : 104, i + 1, glm::length(glm::dvec3(volume.toLps[i])));
  first ? put(bytes, 108, float(bytes.size()), order)
        : put(bytes, 168, std::int64_t(bytes.size()), order);
  real(first ? 112 : 176, 0, form.slope);
  first ? put(bytes, 123, std::int8_t(2), order) : put(bytes, 500, std::int32_t(2), order);
  const bool qform = form.place == NiftiForm::Place::qform;
  const bool sform = form.place == NiftiForm::Place::sform;
  first ? put(bytes, 252, std::int16_t(qform), order) : put(bytes, 344, std::int32_t(qform), order);
  first ? put(bytes, 254, std::int16_t(sform), order) : put(bytes, 348, std::int32_t(sform), order);
  for (int i = 0; qform && i < 3; ++i) {
    real(first ? 256 : 352, i, q.v[i]);
    real(first ? 256 : 352, i + 3, ras[3][i]);
  }
  for (int row = 0; sform && row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      real(first ? 280 : 400, 4 * row + column, ras[column][row]);
  return bytes + numbers(volume, type, order);
}

QByteArray nrrdFile(const WrittenVolume& volume, const QByteArray& space,
                    const QByteArray& encoding, Number type, std::endian order) {
  static const char* const names[] = {"signed char", "uchar",        "short",     "unsigned short",
                                      "int32",       "unsigned int", "long long", "uint64",
                                      "float",       "double"};
  glm::dvec3 turn(1.0);
  if (space == "right-anterior-superior" || space == "RAS")
    turn = {-1.0, -1.0, 1.0};
  if (space == "left-anterior-superior")
    turn = {1.0, -1.0, 1.0};
  const glm::dmat4& m = volume.toLps;
  QByteArray header = "NRRD0005\n# made by a test\ntype: ";
  header += QByteArray(names[int(type)]) + "\ndimension: 3\nspace: " + space;
  header +=
      "\nsizes: " + text(volume.size.x) + ' ' + text(volume.size.y) + ' ' + text(volume.size.z);
  header += "\nspace directions:";
  for (int i = 0; i < 3; ++i)
    header += ' ' + vectorText(glm::dvec3(m[i]) * turn);
  header += "\nkinds: domain domain domain\nendian: ";
  header += order == std::endian::little ? "little" : "big";
  header += "\nencoding: " + encoding;
  header += "\nspace origin: " + vectorText(glm::dvec3(m[3]) * turn) + "\n\n";
  const QByteArray raw = numbers(volume, type, order);
  if (encoding == "gzip")
    return header + gzipped(raw);
  if (encoding == "bzip2")
    return header + bzipped(raw);
  if (encoding == "hex")
    return header + raw.toHex();
  if (encoding != "ascii")
    return header + raw;
  for (const int value : volume.values)
    header += QByteArray::number(value) + ' ';
  return header;
}

QByteArray metaImageFile(const WrittenVolume& volume, bool packed, Number type, std::endian order) {
  static const char* const names[] = {"CHAR", "UCHAR",     "SHORT",      "USHORT", "INT",
                                      "UINT", "LONG_LONG", "ULONG_LONG", "FLOAT",  "DOUBLE"};
  const glm::dmat4& m = volume.toLps;
  QByteArray header = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = ";
  header += order == std::endian::big ? "True" : "False";
  header += QByteArray("\nCompressedData = ") + (packed ? "True" : "False");
  header += "\nTransformMatrix =";
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(m[i]));
    header += ' ' + text(axis.x) + ' ' + text(axis.y) + ' ' + text(axis.z);
  }
  header += "\nOffset = " + text(m[3].x) + ' ' + text(m[3].y) + ' ' + text(m[3].z);
  header += "\nElementSpacing =";
  for (int i = 0; i < 3; ++i)
    header += ' ' + text(glm::length(glm::dvec3(m[i])));
  header +=
      "\nDimSize = " + text(volume.size.x) + ' ' + text(volume.size.y) + ' ' + text(volume.size.z);
  header += QByteArray("\nElementType = MET_") + names[int(type)] + "\nElementDataFile = LOCAL\n";
  const QByteArray raw = numbers(volume, type, order);
  return header + (packed ? deflated(raw, 15) : raw);
}

QByteArray gzipped(const QByteArray& bytes) {
  return deflated(bytes, 15 + 16);
}

}  // namespace sline::test
