// SPDX-License-Identifier: Apache-2.0
// Writes a drawing as an SVG 1.1 document of its own with two layers, the fills and above them the
// lines; each has a group for every structure under its name.
#pragma once

#include <span>
#include <string>

#include "model/scene/scene.h"
#include "render/export/order/export_order.h"
#include "render/export/svg/svg_lettering.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Returns the document. The page and its coordinates are in millimetres throughout. Lines lie in
/// groups nested as the scene's tree is, the farther below the nearer. Of the scene, only the names
/// of groups and structures that the drawing shows are written, and of the program no more than the
/// drawing needs: no file, date or machine, and no person but for the credit that was ordered.
/// Writings lie above the drawing.
std::string svgDocument(const VectorDrawing& drawing, const model::Scene& scene,
                        std::span<const SvgWriting> writings = {}, const ExportCredit& credit = {});

/// Returns what the document's element says of its title and description; nothing where it has
/// none.
std::string describedBy(const ExportCredit& credit);
/// Appends what the document shows: its first sentence as the title, which programs show, too, and
/// all of it as the description.
void appendDescription(std::string& text, const ExportCredit& credit);

/// Appends the credit as Inkscape writes and reads it: Dublin Core about the document.
void appendCredit(std::string& text, const ExportCredit& credit);

}  // namespace sline::render
