// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_lettering.h"

#include <algorithm>

#include "model/base/colour_text.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/svg/svg_path.h"
#include "render/export/svg/svg_values.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

/// The font in which positions are exact comes first, then those of the same widths.
constexpr const char* families = "DejaVu Sans, Bitstream Vera Sans, Verdana, sans-serif";

Path pathOf(const QPainterPath& outline) {
  Path path;
  const auto at = [&outline](int i) {
    const QPainterPath::Element e = outline.elementAt(i);
    return glm::vec2(float(e.x), float(e.y));
  };
  glm::vec2 last(0.0f);
  for (int i = 0; i < outline.elementCount(); ++i) {
    switch (outline.elementAt(i).type) {
      case QPainterPath::MoveToElement:
        path.push_back({.start = at(i), .pieces = {}, .closed = true});
        break;
      case QPainterPath::LineToElement:
        path.back().pieces.push_back({last, at(i), at(i)});
        break;
      case QPainterPath::CurveToElement:
        path.back().pieces.push_back({at(i), at(i + 1), at(i + 2)});
        i += 2;
        break;
      case QPainterPath::CurveToDataElement:
        break;
    }
    last = at(i);
  }
  return path;
}

class Layer {
 public:
  Layer(std::string& text, int decimals) : m_text(text), m_decimals(decimals) {}

  void add(const SvgWriting& writing) {
    m_text += "<g id=\"" + writing.id + "\" inkscape:label=\"" + xmlText(writing.name) +
              "\" inkscape:groupmode=\"layer\" stroke-linejoin=\"round\" font-family=\"" +
              std::string(families) + "\"";
    appendMove(m_text, writing.at);
    m_text += ">\n";
    if (writing.halos && !writing.lettering.clear)
      addHalos("inkscape:label=\"Halos\" ", writing.lettering, writing.lettering.ground);
    for (const LetteringItem& item : writing.lettering.items)
      if (!writing.halos || !isGround(item))
        addItem(item);
    m_text += "</g>\n";
  }

  void addHalos(const std::string& attributes, const Lettering& lettering, const Colour& colour) {
    m_text += "<g " + attributes + "fill=\"none\" stroke-linecap=\"round\" stroke=\"" +
              colourText(colour) + "\">\n";
    for (const LetteringItem& item : lettering.items)
      addHalo(item, colour);
    m_text += "</g>\n";
  }

 private:
  static bool isGround(const LetteringItem& item) {
    return !item.text && std::all_of(item.shapes.begin(), item.shapes.end(),
                                     [](const LetteringShape& shape) { return shape.ground; });
  }

  void addHalo(const LetteringItem& item, const Colour& ground) {
    for (const LetteringShape& shape : item.shapes)
      if (shape.ground)
        addPath(shape.path, 0.0f, " stroke=\"none\" fill=\"" + colourText(ground) + "\"");
      else if (shape.halo > 0.0f)
        addPath(shape.path, shape.pen + 2.0f * shape.halo,
                shape.fill ? " fill=\"" + colourText(ground) + "\"" : std::string());
    if (item.text)
      addPath(pathOf(haloOf(*item.text)), 2.0f * textHalo, {});
  }

  void addItem(const LetteringItem& item) {
    m_text += "<g inkscape:label=\"" + xmlText(item.name) + "\">\n";
    for (const LetteringShape& shape : item.shapes)
      addShape(shape);
    if (item.text)
      addText(*item.text);
    m_text += "</g>\n";
  }

  void addPath(const Path& path, float pen, const std::string& more) {
    const std::string d = svgPath(path, m_decimals);
    if (d.empty())
      return;
    m_text += "<path";
    if (pen > 0.0f)
      m_text += " stroke-width=\"" + number(double(pen), m_decimals + 1) + "\"";
    m_text += more + " d=\"" + d + "\"/>\n";
  }

  void addShape(const LetteringShape& shape) {
    std::string more = " fill=\"" + (shape.fill ? colourText(*shape.fill) : "none") + "\"";
    if (shape.pen > 0.0f)
      more += " stroke=\"" + colourText(shape.ink) + "\"";
    if (shape.pen > 0.0f && shape.dashed)
      more += " stroke-dasharray=\"" + number(double(dashPens * shape.pen), m_decimals) + " " +
              number(double(gapPens * shape.pen), m_decimals) + "\"";
    addPath(shape.path, shape.pen, more);
  }

  static std::string runText(const TextRun& run) {
    std::string text = xmlText(run.text.toStdString());
    if (run.style == model::LetterStyle{})
      return text;
    return std::string("<tspan") + (run.style.bold ? " font-weight=\"bold\"" : "") +
           (run.style.italic ? " font-style=\"italic\"" : "") + ">" + text + "</tspan>";
  }

  void addText(const LetteringText& text) {
    constexpr std::array<const char*, 3> anchors{"start", "middle", "end"};
    const float em = text.points * millimetresPerPoint;
    const auto place = [&](std::size_t line) {
      return " x=\"" + number(double(text.at.x + text.lines[line].indent * em), m_decimals) +
             "\" y=\"" + number(double(text.at.y + float(line) * text.leading), m_decimals) + "\">";
    };
    const auto words = [&](std::size_t line) {
      std::string all;
      for (const TextRun& run : text.lines[line].runs)
        all += runText(run);
      return all;
    };
    m_text += "<text font-size=\"" + number(double(em), 4) + "\" text-anchor=\"" +
              anchors[std::size_t(text.anchor)] + "\" fill=\"" + colourText(text.ink) + "\"";
    if (text.lines.size() == 1) {
      m_text += place(0) + words(0) + "</text>\n";
      return;
    }
    m_text += ">";
    for (std::size_t i = 0; i < text.lines.size(); ++i)
      m_text += "<tspan" + place(i) + words(i) + "</tspan>";
    m_text += "</text>\n";
  }

  std::string& m_text;
  int m_decimals;
};

}  // namespace

void appendMove(std::string& text, const glm::vec2& by) {
  constexpr int decimals = 3;
  if (by != glm::vec2(0.0f))
    text += " transform=\"translate(" + number(double(by.x), decimals) + " " +
            number(double(by.y), decimals) + ")\"";
}

bool appendGaps(std::string& text, std::span<const SvgWriting> writings, const std::string& id,
                const glm::vec2& sizeMm, int decimals) {
  const auto leavesGaps = [](const SvgWriting& writing) {
    return writing.halos && writing.lettering.clear && !writing.lettering.items.empty();
  };
  if (std::none_of(writings.begin(), writings.end(), leavesGaps))
    return false;
  const std::string width = number(double(sizeMm.x), decimals);
  const std::string height = number(double(sizeMm.y), decimals);
  text += "<mask id=\"" + id + "\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\" width=\"" + width +
          "\" height=\"" + height + "\">\n<path fill=\"#ffffff\" d=\"M0 0h" + width + "v" + height +
          "h-" + width + "z\"/>\n";
  for (const SvgWriting& writing : writings)
    if (leavesGaps(writing))
      Layer(text, decimals).addHalos("stroke-linejoin=\"round\" ", writing.lettering, {0, 0, 0});
  text += "</mask>\n";
  return true;
}

void appendLettering(std::string& text, const SvgWriting& writing, int decimals) {
  if (!writing.lettering.items.empty())
    Layer(text, decimals).add(writing);
}

}  // namespace sline::render
