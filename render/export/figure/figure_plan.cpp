// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/figure_plan.h"

#include <algorithm>
#include <cmath>

#include "model/camera/camera_moves.h"
#include "model/edit/views.h"
#include "model/scene/known_frame.h"
#include "model/scene/near_names.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/visible_structures.h"
#include "render/export/figure/panel_cameras.h"
#include "render/export/order/ink_alone.h"
#include "render/export/plate/marks.h"
#include "render/export/plate/plate_image.h"
#include "render/lettering/scale_length.h"
#include "render/lettering/typesetting.h"

namespace sline::render {

namespace {

// Millimetres.
constexpr float letterIndent = 0.4f;
constexpr float letterAir = 1.0f;
constexpr float insetAir = 1.0f;
constexpr float linesOfHeight = 720.0f;  // λ (METHOD §1)
constexpr float contourPen = 2.0f;       // λ
constexpr float creditShare = 0.65f;     // of the labels' size

LegendList listOf(model::FigureLegend legend) {
  switch (legend) {
    case model::FigureLegend::all:
      return LegendList::all;
    case model::FigureLegend::labelled:
      return LegendList::labelled;
    case model::FigureLegend::focus:
      return LegendList::focus;
    case model::FigureLegend::none:
      break;
  }
  return LegendList::none;
}

LetteringText letterText(const model::Figure& figure, const std::string& letter,
                         const glm::vec2& corner) {
  TextLine line;
  append(line, QString::fromStdString(letter), {.bold = true});
  return {.lines = {line},
          .at = corner + glm::vec2(letterIndent, letterIndent + capHeightMm(figure.letterPoints)),
          .points = figure.letterPoints,
          .ink = letteringColours().ink};
}

class Planning {
 public:
  Planning(const model::Figure& figure, const FigureScenes& scenes, const ExportOrder& options)
      : m_scenes(scenes), m_options(options) {
    m_plan.figure = figure;
  }

  Result<FigurePlan> make() {
    TRY(model::checkFigure(figure()));
    m_typesetting = TRY(Typesetting::create());
    m_plan.legend = {listOf(figure().legend), legendShare * figure().points};
    const model::FigureLayout layout = TRY(model::layOut(figure()));
    m_plan.panels.resize(figure().panels.size());
    for (const std::size_t i : layout.order)
      TRY(showScene(i, layout.panels[i].from));
    for (const ExportOrder& panel : m_plan.panels)
      m_plan.legend.add(panel.scene, figure().language);
    if (m_options.sourcesInPicture())
      m_plan.credits = {sourcesOf(m_plan.panels),
                        std::max(creditShare * figure().points, figure().leastPoints)};
    m_plan.layout = TRY(model::layOut(figure(), m_plan.legend.heightIn(figure().widthMm) +
                                                    m_plan.credits.heightIn(figure().widthMm)));
    reserve();
    for (const std::size_t i : m_plan.layout.order)
      aim(i);
    if (figure().sameScale)
      level();
    measurePens();
    return std::move(m_plan);
  }

 private:
  const model::Figure& figure() const { return m_plan.figure; }
  const model::FigurePanel& wish(std::size_t index) const { return figure().panels[index]; }

  Error fault(std::size_t index, std::string reason, std::string remedy) const {
    return {.where = model::panelName(figure(), index),
            .reason = std::move(reason),
            .remedy = std::move(remedy)};
  }

  /// Gives the panel its scene as its view shows it; an inset's is that of its panel.
  Status showScene(std::size_t index, const std::optional<std::size_t>& from) {
    const model::FigurePanel& panel = wish(index);
    ExportOrder& order = m_plan.panels[index];
    const bool inset = panel.inset.has_value();
    const std::string& file = inset ? m_files[*from] : model::sceneOf(figure(), panel);
    m_files[index] = file;
    const auto found = m_scenes.find(file);
    if (found == m_scenes.end() || !found->second)
      return fault(index, file.empty() ? "it shows no scene" : "there is no scene " + file,
                   "Name a scene file with \"scene\"");
    const model::Scene& scene = *found->second;
    if (inset && panel.view.empty()) {
      order.scene = m_plan.panels[*from].scene;
      return Unit{};
    }
    order.scene = scene;
    const model::View* saved = viewNamed(scene, panel.view);
    if (saved) {
      order.scene = model::withViewApplied(scene, *saved).scene;
      order.camera = saved->camera;
      order.viewName = saved->name;
      order.words = saved->words;
      m_saved.insert({index, true});
    } else if (!panel.view.empty() &&
               !model::anatomicalViewNamed(model::normalisedName(panel.view))) {
      return unknownView(index, scene);
    }
    return Unit{};
  }

  static const model::View* viewNamed(const model::Scene& scene, const std::string& name) {
    const std::string wanted = model::normalisedName(name);
    for (const model::View& view : scene.views())
      if (!wanted.empty() && model::normalisedName(view.name) == wanted)
        return &view;
    return nullptr;
  }

  Status unknownView(std::size_t index, const model::Scene& scene) const {
    std::vector<std::string> names;
    for (const model::View& view : scene.views())
      names.push_back(view.name);
    names.insert(names.end(), model::anatomicalViewNames.begin(), model::anatomicalViewNames.end());
    std::string near = model::nearNamesText(wish(index).view, names);
    return fault(index, "its scene has no view \"" + wish(index).view + "\"",
                 near.empty() ? "Name one of the scene's saved views" : near);
  }

  /// Gives each panel its page and says where nothing may stand in it.
  void reserve() {
    for (std::size_t i = 0; i < m_plan.panels.size(); ++i) {
      const model::FigurePanel& panel = wish(i);
      const model::PlacedPanel& placed = m_plan.layout.panels[i];
      ExportOrder& order = m_plan.panels[i];
      order.page.sizeMm = placed.box.size;
      order.legend = LegendList::none;
      order.labels = {.mode = panel.labels.value_or(model::usualLabels(figure(), i))
                                  ? LabelMode::on
                                  : LabelMode::off,
                      .points = figure().points,
                      .language = figure().language,
                      .seenOnly = panel.inset.has_value()};  // it shows a part of a panel closer
      order.marks = ExportMarks::none();
      order.marks.scaleBar = panel.scaleBar.value_or(model::usualScaleBar(figure(), i));
      order.marks.sides = panel.sides.value_or(model::usualSides(figure(), i));
      order.marks.gammaKey = true;
      if (figure().blackAndWhite)
        leaveInkAlone(order);
      if (!placed.letter.empty())
        order.labels.reserved.push_back(letterBox(figure(), placed.letter));
    }
    for (std::size_t i = 0; i < m_plan.panels.size(); ++i)
      if (wish(i).inset && wish(i).inset->inside) {
        const model::FigureBox& box = *wish(i).inset->inside;
        m_plan.panels[*m_plan.layout.panels[i].from].labels.reserved.push_back(
            LabelBox{box.at, box.end()}.grown(insetAir));
      }
  }

  /// Gives the panel its camera.
  void aim(std::size_t index) {
    const model::FigurePanel& panel = wish(index);
    ExportOrder& order = m_plan.panels[index];
    const auto& from = m_plan.layout.panels[index].from;
    if (panel.inset)
      return aimInset(index, *from);
    if (from) {
      const ExportOrder& other = m_plan.panels[*from];
      order.camera = model::withHeight(other.camera, order.page.sizeMm.y / other.page.sizeMm.y);
      if (panel.camera->centred)
        centre(order, other);
      return;
    }
    const float aspect = order.page.sizeMm.x / order.page.sizeMm.y;
    const bool saved = m_saved.contains(index);
    if (!saved)
      order.camera =
          model::anatomicalCamera(model::anatomicalViewNamed(model::normalisedName(panel.view))
                                      .value_or(model::AnatomicalView::anterior),
                                  order.scene.visibleBounds(), aspect);
    if (figure().projection == model::FigureProjection::parallel)
      order.camera = inParallel(order.camera);
    if (!saved || (panel.camera && panel.camera->fit))
      order.camera =
          model::fittedToVisible(order.scene, order.camera, aspect, sidesOf(index, order));
  }

  /// Returns what labels, marks and the panel's letter take of its sides.
  model::FreeSides sidesOf(std::size_t index, const ExportOrder& order) const {
    model::FreeSides sides = sidesOfPlate(order, *m_typesetting);
    if (const std::string& letter = m_plan.layout.panels[index].letter; !letter.empty())
      sides.top =
          std::max(sides.top, double(letterBox(figure(), letter).high.y / order.page.sizeMm.y));
    return sides;
  }

  /// Moves the camera aside so that it looks at the middle of what its own panel shows.
  static void centre(ExportOrder& order, const ExportOrder& other) {
    const glm::vec3 by =
        order.scene.visibleBounds().centre() - other.scene.visibleBounds().centre();
    order.camera.eye += by;
    order.camera.target += by;
  }

  /// Returns how many millimetres of the body one of paper shows, where scale bars are true; absent
  /// where the panel shows nothing.
  static std::optional<float> scaleOf(const ExportOrder& order) {
    const std::optional<ScalePlace> place = scalePlaces(order.scene).in(order.camera);
    if (!place)
      return std::nullopt;
    const float scale = model::millimetresPerPixel(order.camera, place->at, order.page.sizeMm.y);
    return scale > 0.0f && std::isfinite(scale) ? std::optional(scale) : std::nullopt;
  }

  /// Gives all panels but insets the scale of the one that shows most, so that none shows less.
  void level() {
    float widest = 0.0f;
    for (std::size_t i = 0; i < m_plan.panels.size(); ++i)
      if (!wish(i).inset)
        widest = std::max(widest, scaleOf(m_plan.panels[i]).value_or(0.0f));
    for (std::size_t i = 0; i < m_plan.panels.size(); ++i)
      if (const auto scale = scaleOf(m_plan.panels[i]); scale && !wish(i).inset)
        m_plan.panels[i].camera = model::withHeight(m_plan.panels[i].camera, widest / *scale);
    // One bar speaks for all of them.
    const bool doubted =
        std::any_of(m_plan.panels.begin(), m_plan.panels.end(), [](const auto& one) {
          return drawnUnit(one.scene) == model::DrawnUnit::doubtedMillimetre;
        });
    for (ExportOrder& order : m_plan.panels)
      order.of<SharedScale>().doubted = doubted;
    m_plan.frames.clear();
    for (const std::size_t i : m_plan.layout.order)
      if (wish(i).inset)
        aimInset(i, *m_plan.layout.panels[i].from);
  }

  void aimInset(std::size_t index, std::size_t of) {
    const model::PanelInset& inset = *wish(index).inset;
    ExportOrder& order = m_plan.panels[index];
    const ExportOrder& parent = m_plan.panels[of];
    order.camera = insetCamera(parent.camera, parent.page.sizeMm, inset.part, order.page.sizeMm);
    InsetFrame frame{.panel = index, .of = of, .corners = {}, .lines = inset.lines};
    for (const glm::vec2& corner :
         cornersIn(parent.camera, parent.page.sizeMm, order.camera, order.page.sizeMm))
      frame.corners.push_back(m_plan.layout.panels[of].box.at + corner);
    m_plan.frames.push_back(std::move(frame));
  }

  /// Chooses the height that all panels' pens are measured by. Where the tallest panel is higher
  /// than the one at which contours are as wide as asked for, pens are made finer.
  void measurePens() {
    const float wanted = figure().penPoints * millimetresPerPoint * linesOfHeight / contourPen;
    m_plan.penHeightMm = wanted;
    for (const ExportOrder& order : m_plan.panels)
      m_plan.penHeightMm = std::max(m_plan.penHeightMm, order.page.sizeMm.y);
    const float finer = wanted / m_plan.penHeightMm;
    if (finer == 1.0f)
      return;
    for (ExportOrder& order : m_plan.panels) {
      const std::vector<model::ResolvedStyle> styles = model::resolveAll(order.scene);
      std::vector<model::Node> nodes = order.scene.nodes();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!nodes[i].isGroup())
          nodes[i].style.penWeight = finer * styles[i].penWeight;
      order.scene.setNodes(std::move(nodes));
    }
  }

  const FigureScenes& m_scenes;
  const ExportOrder& m_options;
  std::unique_ptr<Typesetting> m_typesetting;
  FigurePlan m_plan;
  std::map<std::size_t, std::string> m_files;  ///< of the panels' scenes
  std::map<std::size_t, bool> m_saved;         ///< panels with a saved view
};

}  // namespace

LabelBox letterBox(const model::Figure& figure, const std::string& letter) {
  const LetteringText text = letterText(figure, letter, {});
  return {glm::vec2(0.0f),
          {text.at.x + textWidthMm(text.lines.front(), text.points) + letterAir,
           text.at.y + letterAir}};
}

LetteringItem drawnLetter(const model::Figure& figure, const std::string& letter,
                          const glm::vec2& corner) {
  return {.name = "letter " + letter, .shapes = {}, .text = letterText(figure, letter, corner)};
}

Result<FigurePlan> planFigure(const model::Figure& figure, const FigureScenes& scenes,
                              const ExportOrder& options) {
  return Planning(figure, scenes, options).make();
}

}  // namespace sline::render
