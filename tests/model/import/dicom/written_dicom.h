// SPDX-License-Identifier: Apache-2.0
// Writes DICOM files for the tests, in each way that elements may be written.
#pragma once

#include <QByteArray>
#include <glm/vec3.hpp>
#include <vector>

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
/// Returns a place as the text of three decimal numbers.
QByteArray decimals(const glm::dvec3& p);
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

}  // namespace sline::test
