// SPDX-License-Identifier: Apache-2.0
// Writes the parts of a presentation that are about one slide (ECMA-376 part 1, §13.3, §19.3).
#pragma once

#include <string>
#include <vector>

#include "render/export/slides/slide_deck.h"

namespace sline::render {

/// The namespaces that the elements of a presentation's parts declare.
inline constexpr const char* slideNamespaces =
    "xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" "
    "xmlns:r=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships\" "
    "xmlns:p=\"http://schemas.openxmlformats.org/presentationml/2006/main\"";
inline constexpr const char* xmlStart =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
/// What a tree of shapes begins with.
inline constexpr const char* shapeTreeStart =
    "<p:spTree><p:nvGrpSpPr><p:cNvPr id=\"1\" name=\"\"/><p:cNvGrpSpPr/><p:nvPr/></p:nvGrpSpPr>"
    "<p:grpSpPr><a:xfrm><a:off x=\"0\" y=\"0\"/><a:ext cx=\"0\" cy=\"0\"/>"
    "<a:chOff x=\"0\" y=\"0\"/><a:chExt cx=\"0\" cy=\"0\"/></a:xfrm></p:grpSpPr>\n";

/// The relationships that a slide's part uses.
inline constexpr const char* slidePngId = "rId2";
inline constexpr const char* slideSvgId = "rId3";

/// Tells which layout a slide has: title and figure; those and a text; title and list.
enum class SlideLayout { figure, text, list };
SlideLayout layoutOf(const Slide& slide);

std::string slidePart(const SlideDeck& deck, const Slide& slide);
/// Returns the page of notes; the slide must have some.
std::string notesPart(const Slide& slide);
/// Returns the animation by which shapes appear, each with a click; nothing for none.
std::string appearOnClick(const std::vector<int>& shapes);

}  // namespace sline::render
