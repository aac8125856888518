// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/figure_page.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "model/camera/camera_moves.h"
#include "render/export/description/alt_text.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/figure/figure_options.h"
#include "render/export/figure/line_weights.h"
#include "render/export/figure/panel_cameras.h"
#include "render/vectors/cropped.h"

namespace sline::render {

namespace {

constexpr float framePen = 0.2f;  // millimetres
constexpr float frameHalo = 0.25f;

/// Draws the panel on a page as high as pens are measured by, and cuts the panel out.
Result<VectorDrawing> drawnPanel(const ExportOrder& order, float penHeightMm,
                                 const VectorProgress& progress) {
  const glm::vec2 size = order.page.sizeMm;
  const float times = penHeightMm / size.y;
  VectorDrawing drawing = TRY(
      drawVectors(order.scene, model::withHeight(order.camera, times),
                  {.sizeMm = {size.x, penHeightMm}, .environment = order.environment}, progress));
  return cropped(std::move(drawing), {0.0f, 0.5f * (penHeightMm - size.y)}, size);
}

bool sameLook(const FigurePlan& a, const FigurePlan& b, std::size_t index) {
  if (index >= b.panels.size() || a.penHeightMm != b.penHeightMm ||
      a.figure.thinLines != b.figure.thinLines || a.figure.leastLine != b.figure.leastLine)
    return false;
  const ExportOrder& one = a.panels[index];
  const ExportOrder& other = b.panels[index];
  return one.camera == other.camera && one.page.sizeMm == other.page.sizeMm &&
         one.scene == other.scene;
}

class Frames {
 public:
  Frames(const FigurePlan& plan, const std::vector<ComposedPanel>& panels) : m_plan(plan) {
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const glm::vec2 at = plan.layout.panels[i].box.at;
      const auto add = [&](const LabelBox& box) {
        m_texts.push_back({at + box.low, at + box.high});
      };
      if (panels[i].plate.labels)
        for (const PlacedLabel& label : panels[i].plate.labels->layout.labels)
          add(label.box);
      for (const LabelBox& box : panels[i].plate.marks.boxes)
        add(box);
    }
  }

  Lettering make() {
    for (const InsetFrame& frame : m_plan.frames) {
      LetteringItem item{.name = "frame of " + nameOf(frame.panel), .shapes = {}, .text = {}};
      item.shapes.push_back(closed(frame.corners));
      const model::FigureBox& box = m_plan.layout.panels[frame.panel].box;
      const std::vector<glm::vec2> inset{
          box.at, {box.end().x, box.at.y}, box.end(), {box.at.x, box.end().y}};
      item.shapes.push_back(closed(inset));
      if (frame.lines)
        addLines(item, frame.corners, inset);
      m_lettering.items.push_back(std::move(item));
    }
    return std::move(m_lettering);
  }

 private:
  std::string nameOf(std::size_t panel) const { return model::panelName(m_plan.figure, panel); }

  static LetteringShape shapeOf(Path path) {
    return {.path = std::move(path),
            .pen = framePen,
            .ink = letteringColours().ink,
            .fill = {},
            .halo = frameHalo};
  }
  static LetteringShape closed(const std::vector<glm::vec2>& corners) {
    Path path = polyline(corners);
    path.front().closed = true;
    return shapeOf(std::move(path));
  }

  /// Tells whether the point lies within the convex outline, clockwise as seen, not on its edge.
  static bool within(const glm::vec2& p, const std::vector<glm::vec2>& outline) {
    constexpr float onEdge = 0.02f;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::vec2 side = outline[(i + 1) % outline.size()] - outline[i];
      const glm::vec2 to = p - outline[i];
      if (side.x * to.y - side.y * to.x < onEdge * glm::length(side))
        return false;
    }
    return true;
  }

  bool onText(const glm::vec2& p) const {
    return std::any_of(m_texts.begin(), m_texts.end(),
                       [&p](const LabelBox& box) { return box.contains(p); });
  }

  /// Adds the line, with gaps where it would run through a text.
  void addBesideTexts(LetteringItem& item, const glm::vec2& from, const glm::vec2& to) const {
    constexpr float stepMm = 0.2f;
    const int steps = std::max(1, int(glm::distance(from, to) / stepMm));
    std::optional<glm::vec2> start;
    for (int step = 0; step <= steps; ++step) {
      const glm::vec2 p = from + float(step) / float(steps) * (to - from);
      const bool free = !onText(p);
      if (free && !start)
        start = p;
      if (start && (!free || step == steps)) {
        item.shapes.push_back(shapeOf(polyline({*start, p})));
        start.reset();
      }
    }
  }

  /// Joins corners of the same name where the line enters neither outline: on the outside.
  void addLines(LetteringItem& item, const std::vector<glm::vec2>& frame,
                const std::vector<glm::vec2>& inset) const {
    constexpr int steps = 64;
    for (std::size_t i = 0; i < frame.size(); ++i) {
      bool outside = true;
      for (int step = 1; step < steps; ++step) {
        const glm::vec2 p = frame[i] + float(step) / float(steps) * (inset[i] - frame[i]);
        outside = outside && !within(p, frame) && !within(p, inset);
      }
      if (outside)
        addBesideTexts(item, frame[i], inset[i]);
    }
  }

  const FigurePlan& m_plan;
  std::vector<LabelBox> m_texts;  ///< on the page
  Lettering m_lettering;
};

Lettering lettersAndLegend(const FigurePlan& plan) {
  Lettering lettering;
  for (const model::PlacedPanel& panel : plan.layout.panels)
    if (!panel.letter.empty())
      lettering.items.push_back(drawnLetter(plan.figure, panel.letter, panel.box.at));
  const model::FigureBox& box = plan.layout.legend;
  const glm::vec2 below{0.0f, plan.legend.heightIn(box.size.x)};
  for (const auto& items :
       {plan.legend.drawnAt(box.at, box.size.x), plan.credits.drawnAt(box.at + below, box.size.x)})
    lettering.items.insert(lettering.items.end(), items.begin(), items.end());
  return lettering;
}

}  // namespace

Result<ComposedFigure> composeFigure(const FigurePlan& plan, const ExportProgress& progress,
                                     const ComposedFigure* before) {
  ComposedFigure figure{.plan = plan, .panels = {}, .frames = {}, .writing = {}};
  model::MeshTrees trees;
  const auto count = double(plan.panels.size());
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    const std::string name = model::panelName(plan.figure, i);
    bool wanted = true;
    const auto tell = [&](double share, std::string_view what) {
      wanted = wanted && (!progress ||
                          progress((double(i) + share) / count, name + ", " + std::string(what)));
    };
    ComposedPanel panel;
    if (before && sameLook(plan, before->plan, i)) {
      panel.drawing = before->panels[i].drawing;
    } else {
      Result<VectorDrawing> drawing = drawnPanel(plan.panels[i], plan.penHeightMm, tell);
      if (!drawing.ok()) {
        Error error = drawing.error();
        error.where = name;
        return error;
      }
      panel.drawing = std::move(*drawing);
      if (plan.figure.thinLines == model::ThinLines::raised)
        raiseLines(panel.drawing, plan.figure.leastLine * millimetresPerPoint);
    }
    if (!wanted)
      return givenUp({});
    panel.plate = figurePlate(plan.panels[i], trees);
    figure.panels.push_back(std::move(panel));
  }
  figure.frames = Frames(plan, figure.panels).make();
  figure.writing = lettersAndLegend(plan);
  return figure;
}

DrawnPage pageOf(const ComposedFigure& figure, const ExportCredit& credit) {
  const FigurePlan& plan = figure.plan;
  DrawnPage page{.sizeMm = plan.layout.sizeMm, .credit = credit};
  if (!plan.figure.language.empty())
    page.language = plan.panels.front().labels.language;
  // Insets lie on their panels.
  for (const std::size_t i : plan.layout.order)
    page.drawings.push_back({.id = "panel-" + std::to_string(i + 1),
                             .name = model::panelName(plan.figure, i),
                             .drawing = &figure.panels[i].drawing,
                             .at = plan.layout.panels[i].box.at,
                             .scene = &plan.panels[i].scene});
  page.writings.push_back({.id = "frames", .name = "Frames", .lettering = figure.frames});
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const FigurePlate& plate = figure.panels[i].plate;
    const std::string name = model::panelName(plan.figure, i);
    const std::string id = "panel-" + std::to_string(i + 1);
    const glm::vec2 at = plan.layout.panels[i].box.at;
    page.writings.push_back({.id = id + "-marks",
                             .name = "Marks of " + name,
                             .lettering = plate.marks.lettering,
                             .at = at});
    if (plate.labels)
      page.writings.push_back({.id = id + "-labels",
                               .name = "Labels of " + name,
                               .lettering = letteringOf(*plate.labels),
                               .at = at});
  }
  page.writings.push_back(
      {.id = "letters", .name = "Letters and legend", .lettering = figure.writing});
  return page;
}

ExportCredit creditOf(const ComposedFigure& figure, const ExportOrder& options) {
  const FigurePlan& plan = figure.plan;
  ExportCredit credit{.author = plainLine(options.credit.author),
                      .copyright = plainLine(options.credit.copyright)};
  if (const std::string sources = sourcesOf(plan.panels);
      options.sourcesInPicture() && !sources.empty())
    credit.copyright += (credit.copyright.empty() ? "" : "; ") + sources;
  if (!options.altText.empty()) {
    const AltText said = altTextOf(options);
    credit.description = said.text;
    return credit;
  }
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    if (plan.figure.panels[i].inset)
      continue;
    const AltText said = altTextOf(plan.panels[i]);
    const std::string& letter = plan.layout.panels[i].letter;
    if (said.text.empty())
      continue;
    credit.description +=
        (credit.description.empty() ? "" : " ") + (letter.empty() ? "" : letter + ": ") + said.text;
    credit.descriptionLanguage = said.language;
  }
  return credit;
}

Status writeFigure(const ComposedFigure& figure, const ExportOrder& options,
                   const std::filesystem::path& target, const ExportProgress& progress) {
  const bool ink = figure.plan.figure.blackAndWhite;
  TRY(checkFigureOptions(options, ink));
  return writePage(pageOf(figure, creditOf(figure, options)), target, pixelsOf(options, ink),
                   progress);
}

}  // namespace sline::render
