// SPDX-License-Identifier: Apache-2.0
// Makes and writes label volumes for the tests, in every format, type and orientation.
#pragma once

#include <QByteArray>
#include <QString>
#include <bit>
#include <functional>
#include <glm/mat4x4.hpp>
#include <vector>

#include "model/import/volumes/formats/label_volume.h"

namespace sline::test {

/// Holds the labels of a grid of voxels, sampled at their middles in LPS millimetres.
struct WrittenVolume {
  glm::ivec3 size{0};
  glm::dmat4 toLps{1.0};
  std::vector<int> values;  ///< x fastest
};
WrittenVolume sampled(const glm::ivec3& size, const glm::dmat4& toLps,
                      const std::function<int(const glm::dvec3&)>& label);
model::LabelVolume inMemory(const WrittenVolume& volume, int labels);

enum class Number { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
QByteArray numbers(const WrittenVolume& volume, Number type, std::endian order);

struct NiftiForm {
  int version = 1;
  enum class Place { sform, qform, none } place = Place::sform;
  QByteArray extension;  ///< text of a header extension
  float slope = 0.0f;    ///< 0: values as they are
};
QByteArray niftiFile(const WrittenVolume& volume, Number type = Number::uint8,
                     std::endian order = std::endian::little, const NiftiForm& form = {});

/// Returns an NRRD file. `space` is what stands behind "space:", such as "right-anterior-superior";
/// vectors are written in that space. `encoding`: raw, gzip, bzip2, hex or ascii.
QByteArray nrrdFile(const WrittenVolume& volume, const QByteArray& space,
                    const QByteArray& encoding = "raw", Number type = Number::uint8,
                    std::endian order = std::endian::little);

QByteArray metaImageFile(const WrittenVolume& volume, bool packed, Number type = Number::uint8,
                         std::endian order = std::endian::little);

/// Returns a MINC 1 file. With `greatest` above 0, bytes stand for numbers up to it instead of for
/// themselves.
QByteArray mincFile(const WrittenVolume& volume, double greatest = 0.0);

QByteArray gzipped(const QByteArray& bytes);

}  // namespace sline::test
