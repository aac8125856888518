// SPDX-License-Identifier: Apache-2.0
// Writes DICOM files for the tests, in each way that elements may be written.
#pragma once

#include <QByteArray>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "model/import/dicom/tag.h"

namespace sline::test {

struct WrittenElement;
using WrittenSet = std::vector<WrittenElement>;

/// Holds one element, with its value as bytes (padded when it is written) or with its items.
struct WrittenElement {
  model::Tag tag;
  QByteArray vr;
  QByteArray value;
  std::vector<WrittenSet> items;
};
WrittenElement text(model::Tag tag, const char* vr, const QByteArray& value);
WrittenElement shorts(model::Tag tag, const std::vector<std::uint16_t>& values);
WrittenElement sequence(model::Tag tag, std::vector<WrittenSet> items);
/// Returns a frame in runs (PS3.5 annex G): with two bytes a pixel, the plane of the high ones
/// comes first.
QByteArray runs(const std::vector<QByteArray>& planes);
/// Returns packed pixel data, one piece per frame behind an empty offset table.
WrittenElement pieces(const std::vector<QByteArray>& frames);
/// Returns the same pixel data, but each frame in pieces of `size` bytes, behind a table of where
/// each begins.
WrittenElement cutPieces(const std::vector<QByteArray>& frames, qsizetype size);

enum class Syntax {
  implicitLittle,
  explicitLittle,
  deflated,
  runLength,
  explicitBig,
  jpeg2000,
  htj2k,  ///< newer than the DCMTK used here
  mpeg    ///< no reader used here reads it
};

struct Manner {
  Syntax syntax = Syntax::explicitLittle;
  bool openLengths = false;  ///< sequences and items end with delimiters
  bool preamble = true;      ///< followed by a meta header
};
/// Returns the file; `set` has the SOP class.
QByteArray dicomFile(const WrittenSet& set, const Manner& manner = {});
/// Returns a sequence element alone, in items nested `depth` deep.
WrittenSet nested(int depth);

/// Returns what identifies a patient in every file written here; none of it may be found anywhere
/// else.
const std::vector<QByteArray>& identities();
WrittenSet identifying(const char* sopClass);

struct WrittenRegion {
  QByteArray name;
  QByteArray type = "ORGAN";
  std::optional<Colour> colour;
  std::vector<std::vector<glm::dvec3>> contours;
  QByteArray geometry = "CLOSED_PLANAR";
};
WrittenSet structureSet(const std::vector<WrittenRegion>& regions);

/// Returns corners of a circle in the plane z, counter-clockwise.
std::vector<glm::dvec3> circle(const glm::dvec3& centre, double radius, int corners = 60);
/// Returns a ball cut at z = first, first + step, …
std::vector<std::vector<glm::dvec3>> ball(const glm::dvec3& centre, double radius, double first,
                                          double step);
std::vector<std::vector<glm::dvec3>> rod(const glm::dvec3& centre, double radius,
                                         const std::vector<double>& heights);

struct WrittenSegment {
  std::uint16_t number = 1;
  QByteArray label;
  QByteArray category;
  std::vector<std::uint16_t> lab;
};
/// Holds the pixels of one frame, 0 … 255, in rows, and the position of its first pixel.
struct WrittenFrame {
  std::uint16_t segment = 1;
  glm::dvec3 position{0.0};
  std::vector<std::uint8_t> pixels;
};
struct WrittenSegmentation {
  int columns = 8;
  int rows = 8;
  double columnSpacing = 1.0;
  double rowSpacing = 1.0;
  double sliceSpacing = 2.0;
  QByteArray orientation = "1\\0\\0\\0\\1\\0";
  int bits = 1;  ///< bits of a pixel: 1, 8 or 16
  bool fractional = false;
  bool labelMap = false;                 ///< a pixel is the number of its segment
  std::optional<std::uint16_t> padding;  ///< a label map's background
  bool sharedOrientation = true;
  bool runLength = false;
  std::function<QByteArray(const WrittenFrame&)> pack;  ///< packs a frame's pixels
  std::vector<WrittenSegment> segments;
  std::vector<WrittenFrame> frames;
};
WrittenSet segmentation(const WrittenSegmentation& written);

}  // namespace sline::test
