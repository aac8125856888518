// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_sheet.h"

#include "render/export/encoding/xml_text.h"
#include "render/export/svg/svg_lettering.h"
#include "render/export/svg/svg_shapes.h"
#include "render/export/svg/svg_values.h"

namespace sline::render {

namespace {

constexpr int sheetDecimals = 3;

void appendFigure(std::string& text, const SvgFigure& figure) {
  text += "<g id=\"" + figure.id + "\" inkscape:label=\"" + xmlText(figure.name) +
          "\" transform=\"translate(" + number(double(figure.at.x), sheetDecimals) + " " +
          number(double(figure.at.y), sheetDecimals) + ")\">\n<title>" + xmlText(figure.name) +
          "</title>\n";
  for (const VectorStructure& structure : figure.drawing->structures)
    for (const VectorLines& lines : structure.lines) {
      text += "<g inkscape:label=\"" + std::string(lines.kind) + "\"" +
              opacityAttribute(lines.opacity) + ">\n";
      for (const VectorShape& shape : plainShapes(lines))
        appendShape(text, shape, {.decimals = sheetDecimals});
      text += "</g>\n";
    }
  text += "</g>\n";
}

}  // namespace

std::string svgSheet(const glm::vec2& sizeMm, std::span<const SvgFigure> figures,
                     const Lettering& lettering) {
  const std::string width = number(double(sizeMm.x), sheetDecimals);
  const std::string height = number(double(sizeMm.y), sheetDecimals);
  std::string text = svgStart(width, height);
  text += "<rect id=\"background\" width=\"" + width + "\" height=\"" + height +
          "\" fill=\"#ffffff\"/>\n";
  text +=
      "<g id=\"lines\" inkscape:label=\"Lines\" inkscape:groupmode=\"layer\" "
      "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const SvgFigure& figure : figures)
    appendFigure(text, figure);
  text += "</g>\n";
  appendLettering(text, {.id = "text", .name = "Text", .lettering = lettering, .halos = false},
                  sheetDecimals);
  return text + "</svg>\n";
}

}  // namespace sline::render
