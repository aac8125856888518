// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_shapes.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/colour_text.h"
#include "render/export/slides/slide_text.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float touching = 0.02f;  // millimetres of the figure's page

struct Extent {
  glm::vec2 low{std::numeric_limits<float>::max()};
  glm::vec2 high{std::numeric_limits<float>::lowest()};
  void add(const glm::vec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

/// Control points count as if they were on the path, which is so for lines and quarters of circles.
Extent extentOf(const Path& path) {
  Extent extent;
  for (const Curve& curve : path) {
    extent.add(curve.start);
    for (const Cubic& piece : curve.pieces)
      for (const glm::vec2& p : {piece.control1, piece.control2, piece.end})
        extent.add(p);
  }
  return extent;
}

bool isLine(const glm::vec2& from, const Cubic& piece) {
  return piece.control1 == from && piece.control2 == piece.end;
}

/// Returns the points of a path of straight lines that is not closed, without those on the way
/// between their neighbours; nothing for another path.
std::vector<glm::vec2> pointsOf(const LetteringShape& shape) {
  if (shape.fill || shape.path.size() != 1 || shape.path[0].closed)
    return {};
  std::vector<glm::vec2> points{shape.path[0].start};
  glm::vec2 from = points.front();
  for (const Cubic& piece : shape.path[0].pieces) {
    if (!isLine(from, piece))
      return {};
    if (points.size() > 1) {
      const glm::vec2 before = points[points.size() - 2];
      const glm::vec2 way = piece.end - before;
      const glm::vec2 off = points.back() - before;
      if (std::abs(way.x * off.y - way.y * off.x) < touching * glm::length(way))
        points.pop_back();
    }
    points.push_back(piece.end);
    from = piece.end;
  }
  return points;
}

/// Returns the radius of the corners if the path is what `roundedBox` makes; else nothing.
std::optional<float> cornersOf(const Path& path, const Extent& extent) {
  if (path.size() != 1 || !path[0].closed || path[0].pieces.empty())
    return std::nullopt;
  const float radius = path[0].start.x - extent.low.x;
  const Path box = roundedBox(extent.low, extent.high, radius);
  if (radius <= 0.0f || box[0].pieces.size() != path[0].pieces.size())
    return std::nullopt;
  for (std::size_t i = 0; i < box[0].pieces.size(); ++i)
    if (glm::distance(box[0].pieces[i].end, path[0].pieces[i].end) > touching)
      return std::nullopt;
  return radius;
}

std::string preset(const char* name, const std::string& guide = {}) {
  return std::string("<a:prstGeom prst=\"") + name + "\"><a:avLst>" + guide +
         "</a:avLst></a:prstGeom>";
}

std::string pathPoint(const glm::vec2& p) {
  return "<a:pt x=\"" + std::to_string(emu(double(p.x))) + "\" y=\"" +
         std::to_string(emu(double(p.y))) + "\"/>";
}

/// Returns a path of millimetres of the slide as geometry of a shape at `low`.
std::string freeform(const Path& path, const SlideBox& box, float scale, const glm::vec2& low) {
  const auto at = [&](const glm::vec2& p) { return pathPoint(scale * (p - low)); };
  std::string text =
      "<a:custGeom><a:avLst/><a:gdLst/><a:ahLst/><a:cxnLst/><a:rect l=\"0\" t=\"0\" r=\"r\" "
      "b=\"b\"/><a:pathLst><a:path w=\"" +
      std::to_string(emu(double(box.size.x))) + "\" h=\"" +
      std::to_string(emu(double(box.size.y))) + "\">";
  for (const Curve& curve : path) {
    text += "<a:moveTo>" + at(curve.start) + "</a:moveTo>";
    glm::vec2 from = curve.start;
    for (const Cubic& piece : curve.pieces) {
      text += isLine(from, piece) ? "<a:lnTo>" + at(piece.end) + "</a:lnTo>"
                                  : "<a:cubicBezTo>" + at(piece.control1) + at(piece.control2) +
                                        at(piece.end) + "</a:cubicBezTo>";
      from = piece.end;
    }
    text += curve.closed ? "<a:close/>" : "";
  }
  return text + "</a:path></a:pathLst></a:custGeom>";
}

}  // namespace

/// A label's text with its box, in millimetres of the figure's page.
struct SlideShapes::Text {
  const LetteringText& text;
  std::string language;
  int id = 0;
  SlideBox box;
  float left = 0.0f;  ///< from the box's side to the text's
  float right = 0.0f;
  bool drawn = false;  ///< a shape around it holds it

  Text(const LetteringText& given, std::string tag, int number)
      : text(given), language(std::move(tag)), id(number) {
    float width = 0.0f;
    for (const TextLine& line : text.lines)
      width = std::max(width, textWidthMm(line, text.points));
    const float x = text.anchor == TextAnchor::end      ? text.at.x - width
                    : text.anchor == TextAnchor::middle ? text.at.x - 0.5f * width
                                                        : text.at.x;
    const auto lines = float(text.lines.size());
    const float line =
        text.leading > 0.0f ? text.leading : 1.2f * text.points * millimetresPerPoint;
    // Capitals stand in the middle of their line.
    const float middle = text.at.y - 0.5f * capHeightMm(text.points) + 0.5f * line * (lines - 1.0f);
    box = {{x, middle - 0.5f * line * lines}, {width, line * lines}};
  }

  /// Makes the shape the text's box if it lies around the text.
  void takeBox(const LetteringShape& shape) {
    const Extent extent = extentOf(shape.path);
    const glm::vec2 high = box.at + box.size;
    if (!shape.fill || glm::any(glm::greaterThan(extent.low, box.at + touching)) ||
        glm::any(glm::lessThan(extent.high, high - touching)))
      return;
    drawn = true;
    left = box.at.x - extent.low.x;
    right = extent.high.x - high.x;
    box = {extent.low, extent.high - extent.low};
  }

  /// Makes the box reach to the end of a leader beside it.
  void reach(const glm::vec2& end) {
    constexpr float most = 3.0f;  // millimetres between a text and its leader
    if (drawn || end.y < box.at.y || end.y > box.at.y + box.size.y)
      return;
    const float before = box.at.x - end.x;
    const float behind = end.x - box.at.x - box.size.x;
    if (before > 0.0f && before < most) {
      box.at.x = end.x;
      box.size.x += before;
      left = before;
    } else if (behind > 0.0f && behind < most) {
      box.size.x += behind;
      right = behind;
    }
  }

  /// Returns the connection site at the place: left or right in the middle; none elsewhere.
  std::optional<int> siteAt(const glm::vec2& end) const {
    constexpr int leftSite = 1;
    constexpr int rightSite = 3;
    if (std::abs(end.y - box.at.y - 0.5f * box.size.y) > touching)
      return std::nullopt;
    if (std::abs(end.x - box.at.x) < touching)
      return leftSite;
    if (std::abs(end.x - box.at.x - box.size.x) < touching)
      return rightSite;
    return std::nullopt;
  }
};

std::string slidePlace(const SlideBox& box) {
  return "<a:off x=\"" + std::to_string(emu(double(box.at.x))) + "\" y=\"" +
         std::to_string(emu(double(box.at.y))) + "\"/><a:ext cx=\"" +
         std::to_string(emu(double(box.size.x))) + "\" cy=\"" +
         std::to_string(emu(double(box.size.y))) + "\"/>";
}

std::string SlideShapes::named(int id, const std::string& name) {
  constexpr qsizetype longest = 200;  // characters
  const std::string some = QString::fromStdString(name).left(longest).toStdString();
  return "id=\"" + std::to_string(id) + "\" name=\"" + slideXmlText(some) + "\"";
}

std::string SlideShapes::colour(const Colour& colour) const {
  // What has the deck's own ink follows another theme that is chosen for the slides.
  return "<a:solidFill>" +
         (colour == m_deck.ink ? std::string("<a:schemeClr val=\"tx1\"/>")
                               : "<a:srgbClr val=\"" + colourText(colour).substr(1) + "\"/>") +
         "</a:solidFill>";
}

std::string SlideShapes::glow(float haloMm) const {
  return haloMm > 0.0f
             ? "<a:effectLst><a:glow rad=\"" + std::to_string(emu(double(slideScale * haloMm))) +
                   "\"><a:srgbClr val=\"" + colourText(m_deck.halo).substr(1) +
                   "\"/></a:glow></a:effectLst>"
             : std::string();
}

std::string SlideShapes::outline(const LetteringShape& shape) const {
  if (shape.pen <= 0.0f)
    return "<a:ln><a:noFill/></a:ln>";
  std::string text = "<a:ln w=\"" + std::to_string(emu(double(slideScale * shape.pen))) +
                     "\" cap=\"flat\">" + colour(shape.ink);
  if (shape.dashed)
    // In thousandths of a percent of the pen.
    text += "<a:custDash><a:ds d=\"" + std::to_string(std::lround(100'000.0f * dashPens)) +
            "\" sp=\"" + std::to_string(std::lround(100'000.0f * gapPens)) + "\"/></a:custDash>";
  return text + "<a:round/></a:ln>";
}

void SlideShapes::extend(const SlideBox& box) {
  m_low = glm::min(m_low, box.at);
  m_high = glm::max(m_high, box.at + box.size);
}

/// A line with a bend is two connectors, of which the one at the text is glued to it. That one has
/// no halo, which would lie over the other's end.
std::string SlideShapes::connectors(const LetteringShape& shape,
                                    const std::vector<glm::vec2>& points, const Text* text) {
  std::string all;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::vec2 from = onSlide(points[i - 1]);
    const glm::vec2 to = onSlide(points[i]);
    const SlideBox box{glm::min(from, to), glm::abs(to - from)};
    extend(box);
    const std::optional<int> site =
        text && i + 1 == points.size() ? text->siteAt(points[i]) : std::nullopt;
    const std::string glued = site ? "<a:endCxn id=\"" + std::to_string(text->id) + "\" idx=\"" +
                                         std::to_string(*site) + "\"/>"
                                   : std::string();
    all += "<p:cxnSp><p:nvCxnSpPr><p:cNvPr " + named("Line") + "/><p:cNvCxnSpPr>" + glued +
           "</p:cNvCxnSpPr><p:nvPr/></p:nvCxnSpPr><p:spPr><a:xfrm" +
           (to.x < from.x ? " flipH=\"1\"" : "") + (to.y < from.y ? " flipV=\"1\"" : "") + ">" +
           slidePlace(box) + "</a:xfrm>" + preset("line") + outline(shape) +
           glow(i == 1 ? shape.halo : 0.0f) + "</p:spPr></p:cxnSp>\n";
  }
  return all;
}

std::string SlideShapes::drawn(const LetteringShape& shape, const Text* text) {
  const Extent extent = extentOf(shape.path);
  const SlideBox box{onSlide(extent.low), slideScale * (extent.high - extent.low)};
  extend(box);
  const glm::vec2 size = extent.high - extent.low;
  const std::optional<float> corners = cornersOf(shape.path, extent);
  const float shorter = std::min(size.x, size.y);
  const bool round = corners && std::abs(size.x - size.y) < touching &&
                     2.0f * *corners > shorter - 2.0f * touching;
  std::string geometry;
  if (round)
    geometry = preset("ellipse");
  else if (corners)
    geometry = preset("roundRect",
                      "<a:gd name=\"adj\" fmla=\"val " +
                          std::to_string(std::lround(100'000.0f * *corners / shorter)) + "\"/>");
  else
    geometry = freeform(shape.path, box, slideScale, extent.low);
  const std::string fill = shape.fill ? colour(*shape.fill) : "<a:noFill/>";
  return "<p:sp><p:nvSpPr><p:cNvPr " +
         (text ? named(text->id, "Text")
               : named(round        ? "Dot"
                       : shape.fill ? "Shape"
                                    : "Line")) +
         "/><p:cNvSpPr/>" + "<p:nvPr/></p:nvSpPr><p:spPr><a:xfrm>" + slidePlace(box) + "</a:xfrm>" +
         geometry + fill + outline(shape) + glow(shape.halo) + "</p:spPr>" +
         (text ? body(*text) : std::string()) + "</p:sp>\n";
}

std::string SlideShapes::body(const Text& text) const {
  const auto inset = [](float mm) { return std::to_string(emu(double(slideScale * mm))); };
  return "<p:txBody><a:bodyPr wrap=\"none\" lIns=\"" + inset(text.left) + "\" tIns=\"0\" rIns=\"" +
         inset(text.right) + "\" bIns=\"0\" anchor=\"ctr\"><a:noAutofit/></a:bodyPr><a:lstStyle/>" +
         lines(text) + "</p:txBody>";
}

/// Lines end where the layout ends them; those of an item of a list make one paragraph.
std::string SlideShapes::lines(const Text& text) const {
  const LetteringText& set = text.text;
  const QString bullet = QString::fromUtf8(model::bulletSign.data(), model::bulletSign.size());
  const bool right = plainText(set.lines).isRightToLeft();
  const auto isItem = [&bullet](const TextLine& line) {
    return !line.runs.empty() && line.runs.front().text.startsWith(bullet);
  };
  const bool list = std::any_of(set.lines.begin(), set.lines.end(), isItem);
  // A list begins at the side where its lines do.
  const char* side = set.anchor == TextAnchor::end || (list && right) ? "r"
                     : set.anchor == TextAnchor::middle               ? "ctr"
                                                                      : "l";
  std::string leading;
  if (set.lines.size() > 1)
    leading = "<a:lnSpc><a:spcPts val=\"" +
              std::to_string(std::lround(100.0f * slideScale * set.leading / millimetresPerPoint)) +
              "\"/></a:lnSpc>";
  const std::string plain = std::string("<a:pPr marL=\"0\" indent=\"0\" algn=\"") + side +
                            "\" rtl=\"" + (right ? "1" : "0") + "\">" + leading +
                            "<a:buNone/></a:pPr>";
  const std::string item =
      slideBullet(slideScale * textWidthMm(TextLine(bullet), set.points), side, right, leading);
  const RunLook look{.language = text.language,
                     .inside = colour(set.ink) + (text.drawn ? std::string() : glow(textHalo)),
                     .points = slideScale * set.points};
  std::string all;
  for (const TextLine& line : set.lines) {
    const bool begins = all.empty() || isItem(line) || (list && line.indent <= 0.0f);
    all += begins ? (all.empty() ? "<a:p>" : "</a:p><a:p>") + (isItem(line) ? item : plain)
                  : "<a:br/>";
    for (std::size_t i = 0; i < line.runs.size(); ++i)
      all +=
          slideRun(line.runs[i].text.mid(i == 0 && isItem(line) ? bullet.size() : 0).toStdString(),
                   line.runs[i].style, look);
  }
  return all + (all.empty() ? "<a:p/>" : "</a:p>");
}

std::string SlideShapes::textBox(const Text& text, const std::string& name) {
  const SlideBox box{onSlide(text.box.at), slideScale * text.box.size};
  extend(box);
  return "<p:sp><p:nvSpPr><p:cNvPr " + named(text.id, name) +
         "/><p:cNvSpPr txBox=\"1\"/><p:nvPr/></p:nvSpPr><p:spPr><a:xfrm>" + slidePlace(box) +
         "</a:xfrm>" + preset("rect") + "<a:noFill/></p:spPr>" + body(text) + "</p:sp>\n";
}

std::string SlideShapes::label(const SlideLabel& label, int* id) {
  m_low = glm::vec2(std::numeric_limits<float>::max());
  m_high = glm::vec2(std::numeric_limits<float>::lowest());
  const LetteringItem& item = label.item;
  const int group = nextId();
  if (id)
    *id = group;
  std::optional<Text> text;
  if (item.text)
    text.emplace(*item.text, label.language, item.shapes.empty() ? group : nextId());
  if (item.shapes.empty())
    return text ? textBox(*text, item.name) : std::string();
  if (text)
    text->takeBox(item.shapes.back());
  std::string inside;
  for (const LetteringShape& each : item.shapes) {
    const Text* const own = text ? &*text : nullptr;
    const std::vector<glm::vec2> points = pointsOf(each);
    if (text && points.size() > 1)
      text->reach(points.back());
    if (points.size() == 2 || points.size() == 3)
      inside += connectors(each, points, own);
    else
      inside += drawn(each, text && text->drawn && &each == &item.shapes.back() ? own : nullptr);
  }
  if (text && !text->drawn)
    inside += textBox(*text, "Text");
  const std::string place = slidePlace({m_low, m_high - m_low});
  const std::string child = [&] {
    std::string copy = place;
    copy.replace(copy.find("<a:off"), 6, "<a:chOff");
    return copy.replace(copy.find("<a:ext"), 6, "<a:chExt");
  }();
  return "<p:grpSp><p:nvGrpSpPr><p:cNvPr " + named(group, item.name) +
         "/><p:cNvGrpSpPr/><p:nvPr/></p:nvGrpSpPr><p:grpSpPr><a:xfrm>" + place + child +
         "</a:xfrm></p:grpSpPr>\n" + inside + "</p:grpSp>\n";
}

}  // namespace sline::render
