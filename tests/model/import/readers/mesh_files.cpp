// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/readers/mesh_files.h"

#include <QFile>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

namespace sline::test {

using model::Triangle;

namespace {
constexpr std::endian little = std::endian::little;
constexpr std::endian big = std::endian::big;

QByteArray number(double value) {
  return QByteArray::number(value, 'g', 9);
}

/// Returns "x y z" for each vertex, with `before` and `between` around it.
QByteArray positionText(const char* before, const char* between) {
  QByteArray text;
  for (const glm::vec3& p : cubePositions())
    text += before + number(double(p.x)) + ' ' + number(double(p.y)) + ' ' + number(double(p.z)) +
            between;
  return text;
}

QByteArray triangleText(const char* before, int first) {
  QByteArray text;
  for (const Triangle& t : cubeTriangles())
    text += before + QByteArray::number(int(t[0]) + first) + ' ' +
            QByteArray::number(int(t[1]) + first) + ' ' + QByteArray::number(int(t[2]) + first) +
            '\n';
  return text;
}

QByteArray positionBytes(std::endian order) {
  QByteArray bytes;
  for (const glm::vec3& p : cubePositions())
    for (int axis = 0; axis < 3; ++axis)
      append(bytes, p[axis], order);
  return bytes;
}

template <class T>
QByteArray indexBytes(std::endian order) {
  QByteArray bytes;
  for (const Triangle& t : cubeTriangles())
    for (const std::uint32_t v : t)
      append(bytes, T(v), order);
  return bytes;
}

template <class T>
QByteArray offsetBytes(int first, std::endian order) {
  QByteArray bytes;
  for (int i = first; i <= 12; ++i)
    append(bytes, T(3) * T(i), order);
  return bytes;
}

QByteArray stlText() {
  QByteArray text = "solid cube\n";
  for (const Triangle& t : cubeTriangles()) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const std::uint32_t v : t) {
      const glm::vec3& p = cubePositions()[v];
      text += "vertex " + number(double(p.x)) + ' ' + number(double(p.y)) + ' ' +
              number(double(p.z)) + '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cube\n";
}

QByteArray stlBinary() {
  QByteArray bytes(80, ' ');
  append(bytes, std::uint32_t(12), little);
  for (const Triangle& t : cubeTriangles()) {
    bytes.append(12, '\0');
    for (const std::uint32_t v : t)
      for (int axis = 0; axis < 3; ++axis)
        append(bytes, cubePositions()[v][axis], little);
    append(bytes, std::uint16_t(0), little);
  }
  return bytes;
}

QByteArray plyHeader(const char* format) {
  return QByteArray("ply\nformat ") + format +
         " 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
}

QByteArray plyBinary(std::endian order) {
  QByteArray bytes =
      plyHeader(order == big ? "binary_big_endian" : "binary_little_endian") + positionBytes(order);
  for (const Triangle& t : cubeTriangles()) {
    bytes += char(3);
    for (const std::uint32_t v : t)
      append(bytes, std::int32_t(v), order);
  }
  return bytes;
}

QByteArray vtkHeader(const char* version, const char* encoding) {
  return QByteArray("# vtk DataFile Version ") + version + "\ncube\n" + encoding +
         "\nDATASET POLYDATA\nPOINTS 8 float\n";
}

QByteArray vtk42Binary() {
  QByteArray bytes = vtkHeader("4.2", "BINARY") + positionBytes(big) + "\nPOLYGONS 12 48\n";
  for (const Triangle& t : cubeTriangles()) {
    append(bytes, std::int32_t(3), big);
    for (const std::uint32_t v : t)
      append(bytes, std::int32_t(v), big);
  }
  return bytes + "\nPOINT_DATA 8\nNORMALS n float\n" + positionBytes(big) + '\n';
}

QByteArray vtk51Text() {
  QByteArray text =
      vtkHeader("5.1", "ASCII") + positionText("", "\n") + "POLYGONS 13 36\nOFFSETS vtktypeint64\n";
  for (int i = 0; i <= 12; ++i)
    text += QByteArray::number(3 * i) + ' ';
  return text + "\nCONNECTIVITY vtktypeint64\n" + triangleText("", 0);
}

QByteArray vtk51Binary() {
  return vtkHeader("5.1", "BINARY") + positionBytes(big) +
         "\nPOLYGONS 13 36\nOFFSETS vtktypeint64\n" + offsetBytes<std::int64_t>(0, big) +
         "\nCONNECTIVITY vtktypeint64\n" + indexBytes<std::int64_t>(big) + '\n';
}

QByteArray vtpAround(const QByteArray& attributes, const QByteArray (&content)[3],
                     const QByteArray& tail) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<PolyData>\n"
         "<Piece NumberOfPoints=\"8\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
         "NumberOfStrips=\"0\" NumberOfPolys=\"12\">\n<Points>\n"
         "<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" " +
         attributes + content[0] + "</DataArray>\n</Points>\n<Polys>\n" +
         "<DataArray type=\"Int32\" Name=\"connectivity\" " + attributes + content[1] +
         "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" " + attributes + content[2] +
         "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n" + tail + "</VTKFile>\n";
}

QByteArray block(const QByteArray& bytes) {
  QByteArray header;
  append(header, std::uint32_t(bytes.size()), little);
  return header + bytes;
}

QByteArray vtpText() {
  QByteArray offsets;
  for (int i = 1; i <= 12; ++i)
    offsets += QByteArray::number(3 * i) + ' ';
  return vtpAround("format=\"ascii\">\n", {positionText("", "\n"), triangleText("", 0), offsets},
                   {});
}

QByteArray vtpBinary() {
  return vtpAround("format=\"binary\">\n",
                   {block(positionBytes(little)).toBase64() + '\n',
                    block(indexBytes<std::int32_t>(little)).toBase64() + '\n',
                    block(offsetBytes<std::int32_t>(1, little)).toBase64() + '\n'},
                   {});
}

QByteArray vtpAppended() {
  const QByteArray points = block(positionBytes(little));
  const QByteArray corners = block(indexBytes<std::int32_t>(little));
  const QByteArray offsets = block(offsetBytes<std::int32_t>(1, little));
  const auto at = [](qsizetype offset) { return "offset=\"" + QByteArray::number(offset) + "\">"; };
  return vtpAround(
      "format=\"appended\" ", {at(0), at(points.size()), at(points.size() + corners.size())},
      "<AppendedData encoding=\"raw\">\n_" + points + corners + offsets + "\n</AppendedData>\n");
}

QByteArray gltfJson(const QByteArray& buffer) {
  return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
         "\"nodes\":[{\"name\":\"group\",\"children\":[1]},{\"name\":\"cube\",\"mesh\":0}],"
         "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
         "\"buffers\":[{" +
         buffer +
         "\"byteLength\":168}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":96},"
         "{\"buffer\":0,\"byteOffset\":96,\"byteLength\":72}],"
         "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"},"
         "{\"bufferView\":1,\"componentType\":5123,\"count\":36,\"type\":\"SCALAR\"}]}";
}

QByteArray gltfBuffer() {
  return positionBytes(little) + indexBytes<std::uint16_t>(little);
}
}  // namespace

std::span<const glm::vec3> cubePositions() {
  static const glm::vec3 positions[] = {
      {-0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, -0.5f}, {-0.5f, 0.5f, -0.5f},
      {-0.5f, -0.5f, 0.5f},  {0.5f, -0.5f, 0.5f},  {0.5f, 0.5f, 0.5f},  {-0.5f, 0.5f, 0.5f}};
  return positions;
}

std::span<const Triangle> cubeTriangles() {
  static const Triangle triangles[] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                                       {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                                       {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return triangles;
}

QByteArray glb(QByteArray json, QByteArray binary) {
  json.append((4 - json.size() % 4) % 4, ' ');
  binary.append((4 - binary.size() % 4) % 4, '\0');
  QByteArray bytes = "glTF";
  append(bytes, std::uint32_t(2), little);
  append(bytes, std::uint32_t(12 + 8 + json.size() + 8 + binary.size()), little);
  append(bytes, std::uint32_t(json.size()), little);
  bytes += "JSON" + json;
  append(bytes, std::uint32_t(binary.size()), little);
  return bytes + QByteArray("BIN\0", 4) + binary;
}

std::vector<MeshFile> cubeFiles() {
  return {{"obj", ".obj", "# cube\n" + positionText("v ", "\n") + triangleText("f ", 1)},
          {"stl text", ".stl", stlText()},
          {"stl binary", ".stl", stlBinary()},
          {"ply text", ".ply", plyHeader("ascii") + positionText("", "\n") + triangleText("3 ", 0)},
          {"ply little endian", ".ply", plyBinary(little)},
          {"ply big endian", ".ply", plyBinary(big)},
          {"off", ".off", "OFF\n8 12 0\n" + positionText("", "\n") + triangleText("3 ", 0)},
          {"vtk 4.2 text", ".vtk",
           vtkHeader("4.2", "ASCII") + positionText("", "\n") + "POLYGONS 12 48\n" +
               triangleText("3 ", 0)},
          {"vtk 4.2 binary", ".vtk", vtk42Binary()},
          {"vtk 5.1 text", ".vtk", vtk51Text()},
          {"vtk 5.1 binary", ".vtk", vtk51Binary()},
          {"vtp text", ".vtp", vtpText()},
          {"vtp binary", ".vtp", vtpBinary()},
          {"vtp appended", ".vtp", vtpAppended()},
          {"gltf", ".gltf",
           gltfJson("\"uri\":\"data:application/octet-stream;base64," + gltfBuffer().toBase64() +
                    "\",")},
          {"glb", ".glb", glb(gltfJson({}), gltfBuffer())}};
}

QByteArray cubeFile(const char* kind) {
  for (const MeshFile& file : cubeFiles())
    if (std::strcmp(file.kind, kind) == 0)
      return file.bytes;
  qFatal("no cube of kind %s", kind);
}

Result<model::RawMeshes> readBytes(const QTemporaryDir& folder, const QString& name,
                                   const QByteArray& bytes, const model::ReadLimits& limits) {
  const QString path = folder.filePath(name);
  // Overwriting in place makes some file systems wait for the disk, so the old file goes first.
  QFile::remove(path);
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    qFatal("cannot write %s", qPrintable(path));
  file.close();
  return model::readSurfaces(path.toStdString(), {.limits = limits});
}

std::size_t triangleCount(const model::RawMeshes& read) {
  std::size_t count = 0;
  for (const model::RawMesh& mesh : read.meshes)
    count += mesh.triangles.size();
  return count;
}

std::size_t vertexCount(const model::RawMeshes& read) {
  std::size_t count = 0;
  for (const model::RawMesh& mesh : read.meshes)
    count += mesh.positions.size();
  return count;
}

QString warningText(const model::RawMeshes& read) {
  QString text;
  for (const model::ImportWarning& warning : read.warnings)
    text += QString::fromStdString(warning.reason) + " | ";
  return text;
}

bool isSound(const model::RawMeshes& read) {
  return !read.meshes.empty() &&
         std::all_of(read.meshes.begin(), read.meshes.end(), [](const model::RawMesh& mesh) {
           const auto finite = [](const glm::vec3& p) {
             return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
           };
           const auto inRange = [&](const Triangle& t) {
             return std::max({t[0], t[1], t[2]}) < mesh.positions.size();
           };
           return !mesh.triangles.empty() &&
                  std::all_of(mesh.positions.begin(), mesh.positions.end(), finite) &&
                  std::all_of(mesh.triangles.begin(), mesh.triangles.end(), inRange);
         });
}

double volume(const model::RawMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
    sum += glm::dot(glm::dvec3(mesh.positions[t[0]]),
                    glm::cross(glm::dvec3(mesh.positions[t[1]]), glm::dvec3(mesh.positions[t[2]])));
  return sum;
}

}  // namespace sline::test
