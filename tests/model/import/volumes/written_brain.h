// SPDX-License-Identifier: Apache-2.0
// Writes files as programs for brains do: volumes in two files, FreeSurfer's volumes and surfaces,
// GIFTI.
#pragma once

#include <QByteArray>
#include <bit>
#include <vector>

#include "tests/model/import/volumes/written_volumes.h"

namespace sline::test {

/// Holds the bytes of the two files of a pair.
struct PairBytes {
  QByteArray header;
  QByteArray image;
};
/// Returns a NIfTI-1 file as .hdr and .img.
PairBytes niftiPair(const WrittenVolume& volume, std::endian order = std::endian::little);

struct AnalyzeForm {
  char orientation = 0;
  glm::ivec3 origin{0};  ///< counted from 1; 0: none
};
/// Returns an Analyze file, which takes only the voxel sizes from the volume.
PairBytes analyzePair(const WrittenVolume& volume, const AnalyzeForm& form = {});

struct MghForm {
  std::int16_t placeKnown = 1;  ///< only what is above 0 says so
  QByteArray footer;            ///< follows the numbers of the scan
};
QByteArray mghFile(const WrittenVolume& volume, Number type = Number::int32,
                   const MghForm& form = {});
/// Returns a tag with a colour table in which 7 is "strange thing" and 9 "left kidney".
QByteArray mghColourTable();

/// Returns the cube of mesh_files as FreeSurfer writes a surface; `footer` stands behind the
/// triangles.
QByteArray freeSurferCube(const QByteArray& footer = {});
/// Returns the footer of a volume with these axes and this middle.
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
/// Returns the cube of mesh_files as GIFTI.
QByteArray giftiCube(const GiftiForm& form = {});

}  // namespace sline::test
