// SPDX-License-Identifier: Apache-2.0
// Makes requests for labels, and finds promises of a layout that do not hold, with mathematics of
// the tests' own.
#pragma once

#include <QString>
#include <glm/vec2.hpp>
#include <vector>

#include "render/labels/layout.h"

namespace sline::test {

struct Line {
  glm::dvec2 a;
  glm::dvec2 b;
};

std::vector<Line> linesOf(const render::Leader& leader);

/// Tells whether the lines meet by solving a + s (b − a) = c + t (d − c); parallel lines count as
/// not meeting.
bool meet(const Line& one, const Line& two);

bool meets(const Line& line, const render::LabelBox& box);

/// Returns a label or leader that lies where it must not; empty if there is none.
QString inReserved(const render::LabelRequest& request, const render::LabelLayout& layout);

/// Returns what is wrong between a label and its own place: its leader runs through its text, or
/// the text covers the dot or the measured line.
QString broken(const render::LabelItem& item, const render::PlacedLabel& label);

/// Returns that the label's leader passes a dot of another item; empty if it does not.
QString passing(const render::LabelItem& item, const render::PlacedLabel& label);

/// Returns a promise that does not hold; empty if all do.
QString broken(const render::LabelRequest& request, const render::LabelLayout& layout);

/// Returns eight structures' places in the middle of a wide picture.
render::LabelRequest roomy();

}  // namespace sline::test
