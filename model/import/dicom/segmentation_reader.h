// SPDX-License-Identifier: Apache-2.0
// Reads the masks of a segmentation. Its frames are stacked and measured (segmentation_reader.cpp),
// then painted into volumes of labels (segmentation_painting.cpp).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "model/import/dicom/dicom_file.h"
#include "model/import/dicom/frame_attributes.h"
#include "model/import/dicom/pixel_frames.h"
#include "model/import/dicom/segment_table.h"
#include "model/import/dicom/segmentation.h"

namespace sline::model {

/// Pixels of 16 bits have so many values.
inline constexpr std::size_t pixelValues = 65'536;

class SegmentationReader {
 public:
  SegmentationReader(const DicomFile& file, const ReadOptions& options)
      : m_file(file), m_options(options) {}

  Result<LabelVolumes> read();

 private:
  /// Holds voxels of one row that follow each other.
  struct Run {
    std::size_t begin = 0;
    std::size_t length = 0;
  };

  /// Bounds the part of the frames that is not empty, as half-open ranges of columns, rows and
  /// slices.
  struct Region {
    glm::ivec3 low{0x7fffffff};
    glm::ivec3 high{0};
    bool empty() const { return low.x >= high.x; }
  };

  Error given() const { return m_file.source().whole("was not read to its end"); }

  /// Reads what values mean: in a binary segmentation inside and outside; of fractions, half the
  /// greatest and more is inside; in a label map each value is a segment's number and one is the
  /// background.
  std::optional<Error> readType();
  /// Reads the values of a frame: 0 outside; 1 inside or, in a label map, the segment's number.
  Status values(std::size_t frame, std::vector<std::uint16_t>& values) const;
  /// Determines which slice each frame is.
  std::optional<Error> stack();
  /// Returns the smallest distance between neighbours, or what the file says where there is but one
  /// slice or only every other slice has a frame.
  double spacingOf(const std::set<double>& places) const;
  int sliceOf(const FrameAttributes& frame) const;
  std::optional<Error> measure();
  /// Paints segments one after another, each into the first volume in which its voxels are free.
  std::optional<Error> paint();
  void warnEmpty(const Segment& segment);
  Error tooLarge() const;
  /// Paints all segments at once, into one volume.
  std::optional<Error> paintMap();
  std::optional<Error> collect(const std::vector<std::size_t>& frames,
                               std::vector<Run>& runs) const;
  /// Returns a volume, or null where there may be no further one.
  LabelVolume* volumeFor(const std::vector<Run>& runs);
  LabelVolume* addVolume();

  const DicomFile& m_file;
  const ReadOptions& m_options;
  std::map<std::uint32_t, Segment> m_segments;
  std::optional<PixelFrames> m_pixels;
  bool m_labelMap = false;
  std::uint16_t m_inside = 1;      ///< values from here on are inside
  std::uint16_t m_background = 0;  ///< in a label map
  std::vector<bool> m_occurs = std::vector<bool>(pixelValues, false);
  std::vector<FrameAttributes> m_frames;
  glm::dvec3 m_normal{0, 0, 1};
  double m_low = 0.0;  ///< lowest slice, in mm from the first frame
  double m_spacing = 1.0;
  Region m_region;
  LabelVolumes m_result;
};

}  // namespace sline::model
