// SPDX-License-Identifier: Apache-2.0
// Writes files of MINC 1, which are files of NetCDF.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/written_volumes.h"

namespace sline::test {

namespace {

/// Writes NetCDF's classic format: everything big-endian and filled up to four bytes.
class NetcdfWriter {
 public:
  void word(qsizetype value) { append(m_bytes, std::uint32_t(value), std::endian::big); }
  void name(const QByteArray& text) {
    word(text.size());
    m_bytes += text.leftJustified((text.size() + 3) / 4 * 4, '\0');
  }
  void list(int mark, qsizetype count) {
    word(count == 0 ? 0 : mark);
    word(count);
  }
  void attribute(const QByteArray& key, const QByteArray& text) {
    name(key);
    word(2);
    name(text);
  }
  void attribute(const QByteArray& key, const std::vector<double>& numbers) {
    name(key);
    word(6);
    word(qsizetype(numbers.size()));
    for (const double number : numbers)
      append(m_bytes, number, std::endian::big);
  }
  QByteArray& bytes() { return m_bytes; }

 private:
  QByteArray m_bytes;
};

/// Holds the axes as MINC names them: each goes with the world's axis that it runs along most,
/// forwards.
struct MincAxes {
  std::array<int, 3> world{};         ///< for each of the volume's axes
  std::array<glm::dvec3, 3> cosines;  ///< in RAS
  std::array<double, 3> steps{};
  glm::dvec3 start{0.0};  ///< along the volume's axes
};

MincAxes mincAxes(const glm::dmat4& toLps) {
  MincAxes axes;
  std::array<bool, 3> taken{};
  glm::dmat3 directions(1.0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 along(-toLps[i].x, -toLps[i].y, toLps[i].z);
    int most = -1;
    for (int k = 0; k < 3; ++k)
      if (!taken[std::size_t(k)] && (most < 0 || std::abs(along[k]) > std::abs(along[most])))
        most = k;
    taken[std::size_t(most)] = true;
    axes.world[std::size_t(i)] = most;
    axes.steps[std::size_t(i)] = along[most] < 0.0 ? -glm::length(along) : glm::length(along);
    axes.cosines[std::size_t(i)] = along / axes.steps[std::size_t(i)];
    directions[i] = axes.cosines[std::size_t(i)];
  }
  axes.start = glm::inverse(directions) * glm::dvec3(-toLps[3].x, -toLps[3].y, toLps[3].z);
  return axes;
}

}  // namespace

QByteArray mincFile(const WrittenVolume& volume, double greatest) {
  static const QByteArray names[] = {"xspace", "yspace", "zspace"};
  const MincAxes axes = mincAxes(volume.toLps);
  const double most = greatest > 0.0 ? greatest : 255.0;
  QByteArray voxels;
  for (const int value : volume.values)
    voxels += char(std::lround(value * 255.0 / most));
  // The place of the values is known only when the header is complete.
  qsizetype begin = 0;
  QByteArray header;
  for (int pass = 0; pass < 2; ++pass) {
    NetcdfWriter file;
    file.bytes() = QByteArray("CDF\1\0\0\0\0", 8);
    file.list(10, 3);
    for (int i = 2; i >= 0; --i) {
      file.name(names[axes.world[std::size_t(i)]]);
      file.word(volume.size[i]);
    }
    file.list(12, 0);
    file.list(11, 6);
    const auto place = [&](int type, qsizetype bytes, qsizetype at) {
      file.word(type);
      file.word(bytes);
      file.word(begin + at);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      file.name(names[axes.world[i]]);
      file.word(0);
      file.list(12, 4);
      file.attribute("units", "mm");
      file.attribute("step", std::vector<double>{axes.steps[i]});
      file.attribute("start", std::vector<double>{axes.start[int(i)]});
      const glm::dvec3& along = axes.cosines[i];
      file.attribute("direction_cosines", std::vector<double>{along.x, along.y, along.z});
      place(6, 8, 0);
    }
    for (const char* limit : {"image-min", "image-max"}) {
      file.name(limit);
      file.word(0);
      file.list(12, 0);
      place(6, 8, limit == QByteArray("image-min") ? 0 : 8);
    }
    file.name("image");
    file.word(3);
    for (int i = 0; i < 3; ++i)
      file.word(i);
    file.list(12, 2);
    file.attribute("signtype", QByteArray("unsigned"));
    file.attribute("valid_range", std::vector<double>{0.0, 255.0});
    place(1, voxels.size(), 16);
    header = file.bytes();
    begin = header.size();
  }
  append(header, 0.0, std::endian::big);
  append(header, most, std::endian::big);
  return header + voxels;
}

}  // namespace sline::test
