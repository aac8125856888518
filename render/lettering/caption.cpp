// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/caption.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float boxCorner = 0.6f;    // millimetres
constexpr float boxPen = 0.2f;       // millimetres
constexpr float tolerance = 0.001f;  // of a line
constexpr float wordShare = 0.999f;  // of the width, for a word without a place to divide it

bool blank(const LabelText& text) {
  return std::all_of(text.lines.begin(), text.lines.end(),
                     [](const TextLine& line) { return plainText(line).trimmed().isEmpty(); });
}

/// Leaves as many lines as fit into the height; an ellipsis tells of the rest.
bool shorten(LabelText& text, std::size_t most, const LabelStyle& style, float widest) {
  if (text.lines.size() <= most)
    return false;
  text.lines.resize(most);
  TextLine& last = text.lines.back();
  const TextLine whole = last;
  append(last, QStringLiteral("\u2026"), {});
  for (TextLine rest = whole; textWidthMm(last, style.points) > widest && !rest.runs.empty();) {
    rest.runs.back().text.chop(1);
    if (rest.runs.back().text.isEmpty())
      rest.runs.pop_back();
    last = rest;
    append(last, QStringLiteral("\u2026"), {});
  }
  return true;
}

}  // namespace

std::string captionMarkup(const std::string& title, const std::string& text) {
  const std::string line = QString::fromStdString(title).simplified().toStdString();
  if (line.empty())
    return text;
  std::string marked = "**";
  for (const char c : line) {
    if (model::escapableSigns.find(c) != std::string_view::npos)
      marked += '\\';
    marked += c;
  }
  return marked + "**" + (text.empty() ? "" : "\n" + text);
}

std::optional<Caption> captionOf(const std::string& markup, const LabelStyle& style,
                                 const CaptionPlace& place) {
  ShownLabel label;
  label.item.kind = model::AnnotationKind::callout;
  label.text = markup;
  LabelStyle written = style;
  written.mode = LabelMode::on;
  const glm::vec2 padding = paddingOf(label.item.kind, written);
  const float widest = place.width - 2.0f * padding.x;
  const float leading = lineHeightMm(written);
  const float lines = (place.height - 2.0f * padding.y) / leading + tolerance;
  if (widest <= 0.0f || lines < 1.0f)
    return std::nullopt;
  LabelText text = textOf(label, written, widest, {.whole = widest, .part = wordShare * widest});
  if (text.lines.empty() || blank(text))
    return std::nullopt;
  Caption caption;
  caption.shortened = shorten(text, std::size_t(lines), written, widest);
  float width = 0.0f;
  for (const TextLine& line : text.lines)
    width = std::max(width, textWidthMm(line, written.points));
  const glm::vec2 size{width + 2.0f * padding.x,
                       float(text.lines.size()) * leading + 2.0f * padding.y};
  caption.box.low = {place.middle - 0.5f * size.x, place.foot - size.y};
  caption.box.high = caption.box.low + size;
  const LetteringColours colours = letteringColours(written.ground);
  caption.item.name = "caption";
  caption.item.shapes.push_back({.path = roundedBox(caption.box.low, caption.box.high, boxCorner),
                                 .pen = boxPen,
                                 .ink = colours.ink,
                                 .fill = colours.ground,
                                 .dashed = false,
                                 .halo = 0.0f});
  caption.item.text = LetteringText{
      .lines = std::move(text.lines),
      .at = {caption.box.low.x + padding.x,
             caption.box.low.y + padding.y + 0.5f * leading + 0.5f * capHeightMm(written.points)},
      .leading = leading,
      .points = written.points,
      .anchor = TextAnchor::start,
      .ink = colours.ink};
  return caption;
}

}  // namespace sline::render
