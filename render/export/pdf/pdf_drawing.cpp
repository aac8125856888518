// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_drawing.h"

#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace sline::render {

namespace {

constexpr int decimals = 3;  // of millimetres

class Operators {
 public:
  void number(double value, int digits = decimals) {
    std::array<char, 40> text{};
    const int length = std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    std::string_view digitsOnly(text.data(), std::size_t(std::max(length, 0)));
    if (digitsOnly.find('.') != std::string_view::npos) {
      while (digitsOnly.ends_with('0'))
        digitsOnly.remove_suffix(1);
      if (digitsOnly.ends_with('.'))
        digitsOnly.remove_suffix(1);
    }
    if (digitsOnly == "-0")
      digitsOnly = "0";
    m_text += digitsOnly;
    m_text += ' ';
  }
  void point(const glm::vec2& p) {
    number(double(p.x));
    number(double(p.y));
  }
  void word(const char* operation) {
    m_text += operation;
    m_text += '\n';
  }
  void text(std::string_view more) { m_text += more; }

  /// Sets the colour; black, white and grey are written as such, so that a printer mixes no inks
  /// for them.
  void colour(const Colour& colour, bool stroke) {
    const auto channel = [this](std::uint8_t value) { number(double(value) / 255.0, 4); };
    channel(colour.red);
    if (colour.red == colour.green && colour.green == colour.blue) {
      word(stroke ? "G" : "g");
      return;
    }
    channel(colour.green);
    channel(colour.blue);
    word(stroke ? "RG" : "rg");
  }

  /// Maps millimetres from the page's upper left corner, y downwards.
  void pageAxes(double pageHeight) {
    for (const double value : {pointsPerMillimetre, 0.0, 0.0, -pointsPerMillimetre, 0.0})
      number(value, 8);
    number(pageHeight, 4);
    word("cm");
  }
  void moveBy(const glm::vec2& by) {
    for (const double value : {1.0, 0.0, 0.0, 1.0})
      number(value);
    point(by);
    word("cm");
  }

  void path(const QPainterPath& path) {
    const auto at = [&path](int i) {
      return glm::vec2(float(path.elementAt(i).x), float(path.elementAt(i).y));
    };
    for (int i = 0; i < path.elementCount(); ++i) {
      const QPainterPath::ElementType type = path.elementAt(i).type;
      point(at(i));
      if (type == QPainterPath::CurveToElement) {
        point(at(++i));
        point(at(++i));
      }
      word(type == QPainterPath::MoveToElement   ? "m"
           : type == QPainterPath::LineToElement ? "l"
                                                 : "c");
    }
  }

  void path(const Path& path) {
    for (const Curve& curve : path) {
      point(curve.start);
      word("m");
      glm::vec2 last = curve.start;
      for (const Cubic& piece : curve.pieces) {
        if (piece.control1 == last && piece.control2 == piece.end) {
          point(piece.end);
          word("l");
        } else {
          point(piece.control1);
          point(piece.control2);
          point(piece.end);
          word("c");
        }
        last = piece.end;
      }
      if (curve.pieces.empty() && !curve.closed) {
        point(curve.start);  // a dot of the round pen
        word("l");
      }
      if (curve.closed)
        word("h");
    }
  }
  void box(const LabelBox& box) {
    point(box.low);
    point(box.size());
    word("re");
  }

  std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
};

class DrawingContent {
 public:
  DrawingContent(PdfContent& content, const VectorDrawing& drawing)
      : m_content(content), m_drawing(drawing) {}

  void append(const PdfPlacement& place, double pageHeight) {
    Operators out;
    out.word("q");
    out.pageAxes(pageHeight);
    out.box(place.clip);
    out.word("W n");
    if (m_drawing.background) {
      out.colour(*m_drawing.background, false);
      out.box(place.clip);
      out.word("f");
    }
    out.moveBy(place.at);
    out.word("1 J 1 j");
    for (const VectorStructure& structure : m_drawing.structures)
      fills(out, structure);
    for (const VeiledLines& veiled : veiledLines(m_drawing))
      group(out, veiled.shapes, veiled.lines->opacity, veiled.structure->grain);
    // The farthest first, as in other vector files.
    std::vector<const VectorStructure*> lined;
    for (const VectorStructure& structure : m_drawing.structures)
      lined.push_back(&structure);
    std::stable_sort(lined.begin(), lined.end(),
                     [](const auto* a, const auto* b) { return a->depth > b->depth; });
    for (const VectorStructure* structure : lined)
      for (const VectorLines& lines : structure->lines)
        group(out, plainShapes(lines), lines.opacity, structure->grain);
    out.word("Q");
    m_content.operators += out.take();
  }

 private:
  void fills(Operators& out, const VectorStructure& structure) {
    if (structure.tones) {
      const VectorTones& tones = *structure.tones;
      out.word("q");
      out.path(tones.edge);
      out.word("W* n");
      // An image fills the unit square, its first row above.
      for (const float value : {tones.sizeMm.x, 0.0f, 0.0f, -tones.sizeMm.y})
        out.number(double(value));
      out.point({tones.at.x, tones.at.y + tones.sizeMm.y});
      out.word("cm");
      out.text(pdfImageName(m_content.images.size()) + " Do\n");
      out.word("Q");
      m_content.images.push_back(tones.image);
    }
    if (!structure.fills.empty())
      group(out, structure.fills, structure.fillOpacity, {});
  }

  static bool opaque(float opacity) { return opacity >= 0.999f; }

  /// Returns the name of the state in which everything has that opacity, and records it in
  /// `opacities`.
  static std::string state(float opacity, std::set<int>& opacities) {
    const int percent = std::clamp(int(std::lround(100.0f * opacity)), 0, 100);
    opacities.insert(percent);
    return pdfStateName(percent);
  }

  static void shapes(Operators& out, std::span<const VectorShape> shapes, bool regions,
                     std::set<int>& opacities) {
    for (const VectorShape& shape : shapes) {
      const bool stroke = shape.penWidth > 0.0f;
      if (!opaque(shape.opacity)) {
        out.word("q");
        out.text(state(shape.opacity, opacities) + " gs\n");
      }
      out.colour(shape.colour, stroke);
      if (stroke) {
        out.number(double(shape.penWidth), decimals + 1);
        out.word("w");
      }
      out.path(shape.path);
      out.word(stroke ? "S" : regions ? "f*" : "f");
      if (!opaque(shape.opacity))
        out.word("Q");
    }
  }

  /// Draws lines with that grain, or regions, which have none, transparent as a whole.
  void group(Operators& out, std::span<const VectorShape> all, float opacity,
             std::optional<float> grain) {
    const bool regions = !grain;
    const int paper = paperPercent(grain.value_or(0.0f));
    if ((opaque(opacity) && paper == 0) || all.empty()) {
      shapes(out, all, regions, m_content.opacities);
      return;
    }
    constexpr float beyond = 20.0f;  // pens reach over the page's edge
    PdfForm form{.operators = {},
                 .box = {glm::vec2(-beyond), m_drawing.sizeMm + beyond},
                 .opacities = {},
                 .paper = paper};
    if (paper > 0 && !m_content.papers.contains(paper))
      m_content.papers[paper] = {paperTile(paper, m_drawing.sizeMm.y), m_drawing.sizeMm};
    Operators inner;
    // Forms begin with their page's state, so that transparency applies once.
    inner.word("1 J 1 j");
    if (paper > 0)
      inner.text(pdfPaperName(paper) + " gs\n");
    shapes(inner, all, regions, form.opacities);
    form.operators = inner.take();
    out.word("q");
    out.text(state(opacity, m_content.opacities) + " gs " + pdfFormName(m_content.forms.size()) +
             " Do\n");
    out.word("Q");
    m_content.forms.push_back(std::move(form));
  }

  PdfContent& m_content;
  const VectorDrawing& m_drawing;
};

}  // namespace

std::string pdfStateName(int percent) {
  return "/SlO" + std::to_string(percent);
}

std::string pdfFormName(std::size_t index) {
  return "/SlG" + std::to_string(index);
}

std::string pdfImageName(std::size_t index) {
  return "/SlI" + std::to_string(index);
}

std::string pdfPaperName(int percent) {
  return "/SlP" + std::to_string(percent);
}

void appendDrawing(PdfContent& content, const VectorDrawing& drawing, const PdfPlacement& place,
                   double pageHeight) {
  DrawingContent(content, drawing).append(place, pageHeight);
}

std::string gapsOf(const Lettering& lettering, const glm::vec2& at, double pageHeight) {
  Operators out;
  out.word("q");
  out.pageAxes(pageHeight);
  out.moveBy(at);
  out.word("1 J 1 j 0 G 0 g");
  for (const LetteringItem& item : lettering.items) {
    for (const LetteringShape& shape : item.shapes) {
      if (shape.ground) {
        out.path(shape.path);
        out.word("f");
      }
      if (shape.halo <= 0.0f)
        continue;
      out.number(double(shape.pen + 2.0f * shape.halo));
      out.word("w");
      out.path(shape.path);
      out.word(shape.fill ? "B" : "S");
    }
    if (!item.text)
      continue;
    out.number(double(2.0f * textHalo));
    out.word("w");
    out.path(haloOf(*item.text));
    out.word("S");
  }
  out.word("Q");
  return out.take();
}

}  // namespace sline::render
