// SPDX-License-Identifier: Apache-2.0
// A drawing as an SVG 1.1 document of its own: two layers, the fills and above them the lines, in
// each a group for every structure under its name.
#pragma once

#include <span>
#include <string>

#include "model/scene/scene.h"
#include "render/export/order/export_order.h"
#include "render/export/svg/svg_lettering.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Millimetres throughout: the page, and the coordinates in it. Lines lie in groups nested as the
/// scene's tree is, what is farther below what is nearer. Of the scene nothing is said but the
/// names of groups and structures that the drawing shows, and of the program no more than
/// what the drawing needs: no file, date, machine and, but for the credit that was ordered, person.
/// Writings lie above the drawing.
std::string svgDocument(const VectorDrawing& drawing, const model::Scene& scene,
                        std::span<const SvgWriting> writings = {}, const ExportCredit& credit = {});

}  // namespace sline::render
