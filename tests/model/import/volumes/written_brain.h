// SPDX-License-Identifier: Apache-2.0
// What programs for brains write: volumes in two files, FreeSurfer's volumes and surfaces, GIFTI.
#pragma once

#include <QByteArray>
#include <bit>
#include <vector>

#include "tests/model/import/volumes/written_volumes.h"

namespace sline::test {

/// The bytes of the two files of a pair.
struct PairBytes {
  QByteArray header;
  QByteArray image;
};
/// A NIfTI-1 file as .hdr and .img.
PairBytes niftiPair(const WrittenVolume& volume, std::endian order = std::endian::little);

struct AnalyzeForm {
  char orientation = 0;
  glm::ivec3 origin{0};  ///< counted from 1; 0: none
};
/// The voxel sizes of the volume alone, as Analyze has them.
PairBytes analyzePair(const WrittenVolume& volume, const AnalyzeForm& form = {});

struct MghForm {
  bool placeKnown = true;
  QByteArray footer;  ///< behind the numbers of the scan
};
QByteArray mghFile(const WrittenVolume& volume, Number type = Number::int32,
                   const MghForm& form = {});
/// A tag with a colour table in which 7 is "strange thing" and 9 "left kidney".
QByteArray mghColourTable();

/// The cube of mesh_files as FreeSurfer writes a surface; `footer` stands behind the triangles.
QByteArray freeSurferCube(const QByteArray& footer = {});
/// The footer of a volume with these axes and this middle.
QByteArray freeSurferGeometry(const glm::dmat3& axes, const glm::dvec3& middle);

struct GiftiForm {
  QByteArray encoding = "ASCII";
  std::endian order = std::endian::little;
  bool columnsFirst = false;
  QByteArray intent = "NIFTI_INTENT_POINTSET";
  QByteArray space = "NIFTI_XFORM_SCANNER_ANAT";
  QByteArray toSpace = "NIFTI_XFORM_SCANNER_ANAT";
  QByteArray matrix = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
  QByteArray anatomy;  ///< "CortexLeft"
};
/// The cube of mesh_files.
QByteArray giftiCube(const GiftiForm& form = {});

}  // namespace sline::test
