// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/volumes/written_brain.h"

#include <zlib.h>

#include <glm/geometric.hpp>

#include "tests/model/import/readers/mesh_files.h"

namespace sline::test {

namespace {
constexpr std::endian big = std::endian::big;

template <class T>
void set(QByteArray& bytes, qsizetype at, T value, std::endian order) {
  QByteArray raw;
  append(raw, value, order);
  bytes.replace(at, raw.size(), raw);
}

QByteArray zlibbed(const QByteArray& bytes) {
  QByteArray packed(qsizetype(compressBound(uLong(bytes.size()))), '\0');
  uLongf size = uLongf(packed.size());
  if (compress(reinterpret_cast<Bytef*>(packed.data()), &size,
               reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size())) != Z_OK)
    qFatal("zlib");
  packed.resize(qsizetype(size));
  return packed;
}

/// Returns the numbers of a table of three columns in the form's order and encoding.
template <class T>
QByteArray giftiData(std::vector<T> numbers, const GiftiForm& form) {
  if (form.columnsFirst) {
    std::vector<T> turned;
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t i = column; i < numbers.size(); i += 3)
        turned.push_back(numbers[i]);
    numbers = turned;
  }
  QByteArray bytes;
  for (const T number : numbers)
    if (form.encoding == "ASCII")
      bytes += QByteArray::number(number) + ' ';
    else
      append(bytes, number, form.order);
  if (form.encoding == "Base64Binary")
    return bytes.toBase64();
  return form.encoding == "GZipBase64Binary" ? zlibbed(bytes).toBase64() : bytes;
}

QByteArray giftiArray(const QByteArray& intent, const char* type, std::size_t rows,
                      const GiftiForm& form) {
  return "<DataArray Intent=\"" + intent + "\" DataType=\"" + type + "\" ArrayIndexingOrder=\"" +
         (form.columnsFirst ? "ColumnMajorOrder" : "RowMajorOrder") +
         "\" Dimensionality=\"2\" Dim0=\"" + QByteArray::number(qulonglong(rows)) +
         "\" Dim1=\"3\" Encoding=\"" + form.encoding + "\" Endian=\"" +
         (form.order == big ? "BigEndian" : "LittleEndian") +
         "\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n";
}
}  // namespace

PairBytes niftiPair(const WrittenVolume& volume, std::endian order) {
  QByteArray bytes = niftiFile(volume, Number::int16, order);
  const qsizetype voxels = 352;
  PairBytes pair{bytes.left(348), bytes.mid(voxels)};
  set(pair.header, 108, 0.0f, order);
  pair.header.replace(344, 4, QByteArray("ni1\0", 4));
  return pair;
}

PairBytes analyzePair(const WrittenVolume& volume, const AnalyzeForm& form) {
  PairBytes pair = niftiPair(volume);
  // In place of NIfTI's unit, forms and magic, Analyze has dates and names.
  pair.header.replace(120, 228, QByteArray(228, '\0'));
  pair.header[252] = form.orientation;
  for (int i = 0; i < 3; ++i)
    set(pair.header, 253 + 2 * i, std::int16_t(form.origin[i]), std::endian::little);
  return pair;
}

QByteArray mghFile(const WrittenVolume& volume, Number type, const MghForm& form) {
  const auto code = type == Number::uint8     ? 0
                    : type == Number::int32   ? 1
                    : type == Number::float32 ? 3
                    : type == Number::int16   ? 4
                                              : 10;
  QByteArray bytes(284, '\0');
  set(bytes, 0, std::int32_t(1), big);
  for (int i = 0; i < 3; ++i)
    set(bytes, 4 + 4 * i, std::int32_t(volume.size[i]), big);
  set(bytes, 16, std::int32_t(1), big);
  set(bytes, 20, std::int32_t(code), big);
  set(bytes, 28, form.placeKnown, big);
  const glm::dvec4 middle = volume.toLps * glm::dvec4(0.5 * glm::dvec3(volume.size), 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(glm::dvec3(volume.toLps[axis]));
    set(bytes, 30 + 4 * axis, float(length), big);
    for (int i = 0; i < 3; ++i)
      set(bytes, 42 + 12 * axis + 4 * i,
          float((i < 2 ? -1.0 : 1.0) * volume.toLps[axis][i] / length), big);
    set(bytes, 78 + 4 * axis, float((axis < 2 ? -1.0 : 1.0) * middle[axis]), big);
  }
  return bytes + numbers(volume, type, big) + QByteArray(20, '\0') + form.footer;
}

QByteArray mghColourTable() {
  QByteArray table;
  const auto whole = [&table](int number) { append(table, std::int32_t(number), big); };
  const auto text = [&](const char* word) {
    whole(int(std::strlen(word)) + 1);
    table += QByteArray(word) + '\0';
  };
  whole(3);  // a tag to pass over, with its length
  append(table, std::int64_t(5), big);
  table += "mri_x";
  whole(1);
  whole(-2);
  whole(10);
  text("table.txt");
  whole(2);
  const auto entry = [&](int number, const char* name, std::array<int, 3> colour) {
    whole(number);
    text(name);
    for (const int channel : colour)
      whole(channel);
    whole(0);
  };
  entry(7, "strange_thing", {12, 240, 7});
  entry(9, "left_kidney", {1, 2, 3});
  return table;
}

QByteArray freeSurferCube(const QByteArray& footer) {
  QByteArray bytes =
      "\xff\xff\xfe"
      "created by a test\n\n";
  append(bytes, std::int32_t(cubePositions().size()), big);
  append(bytes, std::int32_t(cubeTriangles().size()), big);
  for (const glm::vec3& p : cubePositions())
    for (int i = 0; i < 3; ++i)
      append(bytes, p[i], big);
  for (const model::Triangle& t : cubeTriangles())
    for (const std::uint32_t vertex : t)
      append(bytes, std::int32_t(vertex), big);
  return bytes + footer;
}

QByteArray freeSurferGeometry(const glm::dmat3& axes, const glm::dvec3& middle) {
  QByteArray footer;
  for (const int number : {2, 0, 20})
    append(footer, std::int32_t(number), big);
  const auto line = [](const char* key, const glm::dvec3& v) {
    return QByteArray(key) + " = " + QByteArray::number(v.x) + ' ' + QByteArray::number(v.y) + ' ' +
           QByteArray::number(v.z) + '\n';
  };
  return footer + "valid = 1  # volume info valid\nfilename = orig.mgz\nvolume = 256 256 256\n" +
         "voxelsize = 1 1 1\n" + line("xras  ", axes[0]) + line("yras  ", axes[1]) +
         line("zras  ", axes[2]) + line("cras  ", middle);
}

QByteArray giftiCube(const GiftiForm& form) {
  std::vector<float> points;
  for (const glm::vec3& p : cubePositions())
    for (int i = 0; i < 3; ++i)
      points.push_back(p[i]);
  std::vector<std::int32_t> corners;
  for (const model::Triangle& t : cubeTriangles())
    for (const std::uint32_t vertex : t)
      corners.push_back(std::int32_t(vertex));
  const auto cdata = [](const QByteArray& text) { return "<![CDATA[" + text + "]]>"; };
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
         "\"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n<GIFTI Version=\"1.0\" "
         "NumberOfDataArrays=\"2\">\n<MetaData/>\n" +
         giftiArray(form.intent, "NIFTI_TYPE_FLOAT32", points.size() / 3, form) +
         "<MetaData><MD><Name>" + cdata("AnatomicalStructurePrimary") + "</Name><Value>" +
         cdata(form.anatomy) + "</Value></MD></MetaData>\n<CoordinateSystemTransformMatrix>" +
         "<DataSpace>" + cdata(form.space) + "</DataSpace><TransformedSpace>" +
         cdata(form.toSpace) + "</TransformedSpace><MatrixData>" + form.matrix +
         "</MatrixData></CoordinateSystemTransformMatrix>\n<Data>" + giftiData(points, form) +
         "</Data></DataArray>\n" +
         giftiArray("NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", corners.size() / 3, form) +
         "<Data>" + giftiData(corners, form) + "</Data></DataArray>\n</GIFTI>\n";
}

}  // namespace sline::test
