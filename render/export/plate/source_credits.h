// SPDX-License-Identifier: Apache-2.0
// Gathers whose work the surfaces of a picture are.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/scene/scene.h"
#include "render/export/order/export_notes.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// What is said of so many structures: "BodyParts3D, DBCLS, CC BY 4.0". It names none of them.
struct SourceLine {
  std::string text;
  std::size_t structures = 0;
};

/// Returns what visible structures say of whose work they are, each line once, that of most
/// structures first.
std::vector<SourceLine> sourceLines(const model::Scene& scene);
/// Returns those under terms that ask to be named: all but public domain and CC0.
std::vector<SourceLine> sourcesToName(const model::Scene& scene);
/// Returns the note that a file without credits lacks them: where surfaces come under such terms,
/// the order's pictures have no credits in them and nobody has chosen that there be none.
ExportNotes creditNotes(const ExportOrder& order);
/// Returns all of them in one line, parted by semicolons.
std::string sourcesInOne(const model::Scene& scene);

}  // namespace sline::render
