// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_sheet.h"

#include "model/base/colour_text.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/svg/svg_document.h"
#include "render/export/svg/svg_drawing.h"
#include "render/export/svg/svg_shapes.h"
#include "render/export/svg/svg_values.h"

namespace sline::render {

namespace {

constexpr int sheetDecimals = 3;

std::string sheetNumber(float value) {
  return number(double(value), sheetDecimals);
}

std::string sizeAttributes(const glm::vec2& size) {
  return " width=\"" + sheetNumber(size.x) + "\" height=\"" + sheetNumber(size.y) + "\"";
}

void appendLines(std::string& text, const VectorDrawing& drawing) {
  for (const VectorStructure& structure : drawing.structures)
    for (const VectorLines& lines : structure.lines) {
      text += "<g inkscape:label=\"" + std::string(lines.kind) + "\"" +
              opacityAttribute(lines.opacity) + ">\n";
      for (const VectorShape& shape : plainShapes(lines))
        appendShape(text, shape, {.decimals = sheetDecimals});
      text += "</g>\n";
    }
}

/// Appends all layers of a drawing, clipped to its size.
void appendLayers(std::string& text, const SvgFigure& figure) {
  const VectorDrawing& drawing = *figure.drawing;
  const std::string rectangle = "<rect" + sizeAttributes(drawing.sizeMm);
  text += "<clipPath id=\"" + figure.id + "-clip\">" + rectangle + "/></clipPath>\n";
  text += "<g clip-path=\"url(#" + figure.id + "-clip)\">\n";
  if (drawing.background)
    text += rectangle + " fill=\"" + colourText(*drawing.background) + "\"/>\n";
  appendSvgDrawing(text, drawing, *figure.scene,
                   {.prefix = figure.id + "-", .decimals = sheetDecimals});
  text += "</g>\n";
}

void appendFigure(std::string& text, const SvgFigure& figure) {
  text += "<g id=\"" + figure.id + "\" inkscape:label=\"" + xmlText(figure.name) + "\"";
  appendMove(text, figure.at);
  text += ">\n<title>" + xmlText(figure.name) + "</title>\n";
  if (figure.scene)
    appendLayers(text, figure);
  else
    appendLines(text, *figure.drawing);
  text += "</g>\n";
}

}  // namespace

std::string svgSheet(const glm::vec2& sizeMm, std::span<const SvgFigure> figures,
                     std::span<const SvgWriting> writings, const ExportCredit& credit) {
  std::string text = svgStart(sheetNumber(sizeMm.x), sheetNumber(sizeMm.y), describedBy(credit));
  appendDescription(text, credit);
  appendCredit(text, credit);
  text += "<rect id=\"background\"" + sizeAttributes(sizeMm) + " fill=\"#ffffff\"/>\n";
  text +=
      "<g id=\"drawings\" inkscape:label=\"Drawings\" inkscape:groupmode=\"layer\" "
      "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const SvgFigure& figure : figures)
    appendFigure(text, figure);
  text += "</g>\n";
  for (const SvgWriting& writing : writings)
    appendLettering(text, writing, sheetDecimals);
  return text + "</svg>\n";
}

}  // namespace sline::render
