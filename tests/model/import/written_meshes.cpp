// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/written_meshes.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cstring>
#include <map>

namespace sline::test {

using model::Frame;
using model::Mesh;

namespace {

QByteArray number(float value) {
  return QByteArray::number(double(value), 'g', 9);
}
QByteArray point(const glm::vec3& p) {
  return number(p.x) + ' ' + number(p.y) + ' ' + number(p.z);
}
QByteArray space(std::optional<Frame> header) {
  return *header == Frame::ras ? "SPACE=RAS" : "SPACE=LPS";
}
template <class T>
void append(QByteArray& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

QByteArray obj(const Mesh& mesh, std::optional<Frame> header) {
  QByteArray text = header ? "# " + space(header) + '\n' : QByteArray();
  for (const glm::vec3& p : mesh.positions())
    text += "v " + point(p) + '\n';
  for (const model::Triangle& t : mesh.triangles())
    text += "f " + QByteArray::number(t[0] + 1) + ' ' + QByteArray::number(t[1] + 1) + ' ' +
            QByteArray::number(t[2] + 1) + '\n';
  return text;
}

QByteArray off(const Mesh& mesh, std::optional<Frame> header) {
  QByteArray text = "OFF\n" + (header ? "# " + space(header) + '\n' : QByteArray());
  text += QByteArray::number(qsizetype(mesh.vertexCount())) + ' ' +
          QByteArray::number(qsizetype(mesh.triangleCount())) + " 0\n";
  for (const glm::vec3& p : mesh.positions())
    text += point(p) + '\n';
  for (const model::Triangle& t : mesh.triangles())
    text += "3 " + QByteArray::number(t[0]) + ' ' + QByteArray::number(t[1]) + ' ' +
            QByteArray::number(t[2]) + '\n';
  return text;
}

QByteArray stl(const Mesh& mesh, std::optional<Frame> header) {
  QByteArray bytes = header ? space(header) : QByteArray("made by a test");
  bytes = bytes.leftJustified(80, ' ');
  append(bytes, std::uint32_t(mesh.triangleCount()));
  for (const model::Triangle& t : mesh.triangles()) {
    append(bytes, glm::vec3(0.0f));
    for (const std::uint32_t v : t)
      append(bytes, mesh.positions()[v]);
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

QByteArray ply(const Mesh& mesh, std::optional<Frame> header) {
  QByteArray bytes = "ply\nformat binary_little_endian 1.0\n";
  if (header)
    bytes += "comment " + space(header) + '\n';
  bytes += "element vertex " + QByteArray::number(qsizetype(mesh.vertexCount())) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           QByteArray::number(qsizetype(mesh.triangleCount())) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const glm::vec3& p : mesh.positions())
    append(bytes, p);
  for (const model::Triangle& t : mesh.triangles()) {
    append(bytes, std::uint8_t(3));
    append(bytes, t);
  }
  return bytes;
}

QByteArray vtk(const Mesh& mesh, std::optional<Frame> header) {
  QByteArray text = "# vtk DataFile Version 3.0\n" +
                    (header ? "model " + space(header) : QByteArray("model")) +
                    "\nASCII\nDATASET POLYDATA\nPOINTS " +
                    QByteArray::number(qsizetype(mesh.vertexCount())) + " float\n";
  for (const glm::vec3& p : mesh.positions())
    text += point(p) + '\n';
  text += "POLYGONS " + QByteArray::number(qsizetype(mesh.triangleCount())) + ' ' +
          QByteArray::number(qsizetype(4 * mesh.triangleCount())) + '\n';
  for (const model::Triangle& t : mesh.triangles())
    text += "3 " + QByteArray::number(t[0]) + ' ' + QByteArray::number(t[1]) + ' ' +
            QByteArray::number(t[2]) + '\n';
  return text;
}

QByteArray vtp(const Mesh& mesh, std::optional<Frame> header) {
  QByteArray text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
      "byte_order=\"LittleEndian\"><PolyData>";
  if (header) {
    text +=
        "<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">";
    for (const char c : space(header).mid(6))
      text += QByteArray::number(int(c)) + ' ';
    text += "0</Array></FieldData>";
  }
  text += "<Piece NumberOfPoints=\"" + QByteArray::number(qsizetype(mesh.vertexCount())) +
          "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
          QByteArray::number(qsizetype(mesh.triangleCount())) +
          "\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">";
  for (const glm::vec3& p : mesh.positions())
    text += point(p) + ' ';
  text +=
      "</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" "
      "format=\"ascii\">";
  for (const model::Triangle& t : mesh.triangles())
    for (const std::uint32_t v : t)
      text += QByteArray::number(v) + ' ';
  text += "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">";
  for (std::size_t i = 1; i <= mesh.triangleCount(); ++i)
    text += QByteArray::number(qsizetype(3 * i)) + ' ';
  return text + "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
}

QByteArray gltf(const Mesh& mesh) {
  QByteArray binary;
  for (const model::Triangle& t : mesh.triangles())
    append(binary, t);
  const qsizetype indexBytes = binary.size();
  model::Box box;
  for (const glm::vec3& p : mesh.positions()) {
    // The frame changes from LPS millimetres to metres with y up and z to the front.
    const glm::vec3 q = glm::vec3(p.x, p.z, -p.y) * 0.001f;
    append(binary, q);
    box.add(q);
  }
  const auto list = [](const glm::vec3& p) {
    return '[' + number(p.x) + ',' + number(p.y) + ',' + number(p.z) + ']';
  };
  const QByteArray count = QByteArray::number(qsizetype(mesh.vertexCount()));
  return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{"
         "\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}"
         "]"
         "}],\"buffers\":[{\"byteLength\":" +
         QByteArray::number(binary.size()) + ",\"uri\":\"data:application/octet-stream;base64," +
         binary.toBase64() +
         "\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + QByteArray::number(indexBytes) +
         "},{\"buffer\":0,\"byteOffset\":" + QByteArray::number(indexBytes) +
         ",\"byteLength\":" + QByteArray::number(binary.size() - indexBytes) +
         "}],\"accessors\":[{\"bufferView\":0,\"componentType\":5125,\"count\":" +
         QByteArray::number(qsizetype(3 * mesh.triangleCount())) +
         ",\"type\":\"SCALAR\"},{\"bufferView\":1,\"componentType\":5126,\"count\":" + count +
         ",\"type\":\"VEC3\",\"min\":" + list(box.low) + ",\"max\":" + list(box.high) + "}]}";
}

}  // namespace

std::span<const char* const> meshFormats() {
  static constexpr std::array formats{"obj", "stl", "ply", "off", "vtk", "vtp", "gltf"};
  return formats;
}

void writeText(const QString& path, const QByteArray& text) {
  QDir().mkpath(QFileInfo(path).path());
  QFile file(path);
  const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
  if (!written)
    qFatal("cannot write %s", qPrintable(path));
}

void writeMesh(const QString& path, const Mesh& mesh, std::optional<Frame> header) {
  const QString format = QFileInfo(path).suffix();
  using Writer = QByteArray (*)(const Mesh&, std::optional<Frame>);
  const std::map<QString, Writer> writers{{"obj", obj}, {"off", off}, {"stl", stl},
                                          {"ply", ply}, {"vtk", vtk}, {"vtp", vtp}};
  const auto writer = writers.find(format);
  writeText(path, writer == writers.end() ? gltf(mesh) : writer->second(mesh, header));
}

model::MeshPtr octahedron(const glm::vec3& centre, float radius) {
  std::vector<glm::vec3> positions;
  for (const glm::vec3& axis : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
    positions.push_back(centre + radius * axis);
  return std::make_shared<const Mesh>(
      Mesh::create(
          std::move(positions),
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}})
          .value());
}

model::MeshPtr voxelSurface(int n, bool (*inside)(const glm::vec3&)) {
  std::map<std::array<int, 3>, std::uint32_t> index;
  std::vector<glm::vec3> positions;
  std::vector<model::Triangle> triangles;
  const auto filled = [&](const std::array<int, 3>& v) {
    const bool within = std::all_of(v.begin(), v.end(), [n](int c) { return c >= 0 && c < n; });
    return within && inside(glm::vec3(v[0], v[1], v[2]) + 0.5f);
  };
  const auto vertex = [&](const std::array<int, 3>& corner) {
    const auto [entry, fresh] = index.try_emplace(corner, std::uint32_t(positions.size()));
    if (fresh)
      positions.push_back(glm::vec3(corner[0], corner[1], corner[2]));
    return entry->second;
  };
  const auto addFace = [&](const std::array<int, 3>& voxel, std::size_t axis, int side) {
    const std::size_t b = (axis + 1) % 3;
    const std::size_t c = (axis + 2) % 3;
    std::array<std::uint32_t, 4> quad{};
    const std::array<std::array<int, 2>, 4> steps{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> corner = voxel;
      corner[axis] += side;
      corner[b] += steps[k][0];
      corner[c] += steps[k][1];
      quad[k] = vertex(corner);
    }
    if (side == 0)
      std::swap(quad[1], quad[3]);
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
  };
  for (int i = 0; i < n * n * n; ++i) {
    const std::array<int, 3> voxel{i % n, i / n % n, i / n / n};
    if (!filled(voxel))
      continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        std::array<int, 3> next = voxel;
        next[axis] += side == 0 ? -1 : 1;
        if (!filled(next))
          addFace(voxel, axis, side);
      }
  }
  return std::make_shared<const Mesh>(
      Mesh::create(std::move(positions), std::move(triangles)).value());
}

const model::Node& named(const model::Scene& scene, const std::string& name) {
  static const model::Node none;
  const auto ids = scene.named(name);
  return ids.size() == 1 ? *scene.find(ids.front()) : none;
}

QString warningsOf(const model::Imported& imported) {
  QString text;
  for (const model::ImportWarning& warning : imported.report.warnings)
    text += QString::fromStdString(warning.file + ": " + warning.reason + " | ");
  return text;
}

}  // namespace sline::test
