// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_shapes.h"

#include "model/base/colour_text.h"
#include "render/export/svg/svg_path.h"
#include "render/export/svg/svg_values.h"

namespace sline::render {

std::string svgStart(const std::string& width, const std::string& height, const std::string& more) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"" +
         width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\"" +
         more + ">\n";
}

void appendShape(std::string& text, const VectorShape& shape, const SvgPrecision& precision) {
  const std::string d = svgPath(shape.path, precision.decimals);
  if (d.empty())
    return;
  text += "<path";
  if (shape.penWidth > 0.0f)
    text += " fill=\"none\" stroke=\"" + colourText(shape.colour) + "\" stroke-width=\"" +
            number(double(shape.penWidth), precision.decimals + 1) + "\"";
  else
    text += " fill=\"" + colourText(shape.colour) + "\"";
  if (precision.regions)
    text += " fill-rule=\"evenodd\"";
  text += opacityAttribute(shape.opacity) + " d=\"" + d + "\"/>\n";
}

}  // namespace sline::render
