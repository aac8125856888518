// SPDX-License-Identifier: Apache-2.0
#include "tests/support/plate_products.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>

#include "model/edit/look.h"
#include "model/figure/figure.h"
#include "model/look/opening_look.h"
#include "model/scene/visible_structures.h"
#include "render/export/figure/figure_plan.h"
#include "render/export/order/ink_alone.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/plate/plate_image.h"
#include "render/export/slides/slide_page.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/typesetting.h"

namespace sline::test {

using namespace render;

namespace {

struct Side {
  const char* name;
  std::optional<model::AnatomicalView> view;  ///< absent: oblique
};
constexpr std::array<Side, 5> sides{{{"anterior", model::AnatomicalView::anterior},
                                     {"left", model::AnatomicalView::left},
                                     {"superior", model::AnatomicalView::superior},
                                     {"oblique", std::nullopt},
                                     {"posterior", model::AnatomicalView::posterior}}};
constexpr std::array<const char*, 6> kinds{"picture", "sheet", "figure",
                                           "slide",   "still", "self-test"};
struct Size {
  int width;
  int height;
};
constexpr std::array<Size, 4> sizes{{{1600, 1200}, {800, 600}, {1920, 1080}, {1000, 1000}}};
constexpr Size largest{3000, 2000};
constexpr std::size_t mostLabels = 24;

model::Camera obliqueCamera(const model::Scene& scene, float aspect) {
  const model::Box bounds = scene.visibleBounds();
  model::Camera camera = model::anatomicalCamera(model::AnatomicalView::anterior, bounds, aspect);
  const float far = glm::distance(camera.eye, camera.target);
  camera.eye = camera.target + far * glm::normalize(glm::vec3(0.7f, -0.8f, 0.45f));
  return model::fitted(camera, bounds.corners(), aspect);
}

/// Labels the largest structures that are seen.
model::Scene labelled(const model::Scene& scene, const Screen& screen, model::MeshTrees& trees) {
  std::vector<std::pair<float, model::NodeId>> largest;
  for (const model::VisibleStructure& one : model::visibleStructures(scene))
    largest.emplace_back(-glm::length(one.node->mesh->bounds().size()), one.node->id);
  std::sort(largest.begin(), largest.end());
  model::Scene result = scene;
  result.setAnnotations({});
  const SeenMap map(scene, screen, &trees);
  for (std::size_t i = 0; i < std::min(largest.size(), mostLabels); ++i)
    if (auto label = map.labelFor(largest[i].second)) {
      label->text = scene.find(largest[i].second)->name;
      result.appendAnnotation(*std::move(label));
    }
  return result;
}

/// Sees to it that every product has a credit.
model::Scene credited(const model::Scene& scene) {
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (!node.isGroup() && node.provenance.credit.empty())
      node.provenance.credit = {.authors = "The authors of the surfaces",
                                .source = "A collection of anatomy",
                                .licence = "CC BY 4.0"};
  model::Scene result = scene;
  result.setNodes(std::move(nodes));
  return result;
}

class Making {
 public:
  Making(const model::Scene& scene, int index, ProductTools& tools)
      : m_scene(scene),
        m_tools(tools),
        m_index(index),
        m_kind(kinds[std::size_t(index) % kinds.size()]),
        m_side(sides[std::size_t(index / int(kinds.size())) % sides.size()]),
        m_size(index % 20 == 7 ? largest : sizes[std::size_t(index) % sizes.size()]),
        m_near(isNear(index)),
        m_cut(index % 7 == 4) {}

  Result<Product> make() {
    const float aspect = float(m_size.width) / float(m_size.height);
    model::Scene scene = credited(m_scene);
    scene.setAnnotations({});
    model::OpeningWishes wishes{.view = m_side.view, .aspect = aspect};
    if (!m_side.view)
      wishes.camera = obliqueCamera(scene, aspect);
    const model::Scene whole = scene;
    if (m_cut)
      scene.appendSection({.plane = model::anatomicalPlane(model::AnatomicalView::anterior,
                                                           scene.visibleBounds().centre().y)});
    auto look = model::openingLook(scene, m_tools.forms, wishes);
    if (!look) {
      // The cut leaves nothing of what the scene is about.
      look = model::openingLook(whole, m_tools.forms, wishes);
      m_cut = false;
    }
    if (!look)
      return Error{.reason = "the scene shows nothing", .remedy = "Choose another"};
    m_camera = look->camera;
    if (m_near) {
      const glm::vec3 way = m_camera.eye - m_camera.target;
      m_camera.eye = m_camera.target + 0.7f * way;
      m_camera.heightMm *= 0.7f;
    }
    Product product{.kind = m_kind,
                    .name = std::string(m_kind) + ", " + m_side.name + (m_near ? ", near" : "") +
                            (m_cut ? ", section" : ""),
                    .height = std::clamp(m_size.height, 600, 1200),
                    .colour = {},
                    .ink = {}};
    for (const bool ink : {false, true}) {
      auto parts = partsOf(look->scene, ink);
      if (!parts)
        return parts.error();
      (ink ? product.ink : product.colour) = std::move(*parts);
    }
    return product;
  }

 private:
  ExportOrder orderOf(const model::Scene& scene) const {
    const float aspect = float(m_size.width) / float(m_size.height);
    ExportOrder order;
    order.scene = scene;
    order.camera = m_camera;
    order.viewName = m_side.view ? m_side.name : "";
    order.words.title.text = m_side.view ? "" : "A view";
    order.words.text.text = "What is said of this view, in *two* sentences. They are read with it.";
    order.page.sizeMm = {aspect * usualHeightMm, usualHeightMm};
    order.labels.mode = LabelMode::on;
    order.legend = LegendList::labelled;
    order.sources = SourceCredits::line;
    return order;
  }

  void fit(ExportOrder& order, const ExportOrder& figure) const {
    if (!m_near)
      order.camera = model::fittedToVisible(figure.scene, order.camera,
                                            order.page.sizeMm.x / order.page.sizeMm.y,
                                            sidesOfPlate(figure, **Typesetting::create()));
  }

  static void inked(ExportOrder& order, bool ink) {
    if (ink)
      leaveInkAlone(order);
  }

  Result<std::vector<PrintedPart>> partsOf(const model::Scene& scene, bool ink) const {
    ExportOrder order = orderOf(scene);
    const std::string kind = m_kind;
    if (kind == "sheet" || kind == "self-test") {
      order.labels.mode = LabelMode::off;
      order.of<SheetOptions>().kind = kind == "sheet" ? SheetKind::figure : SheetKind::teaching;
      if (kind == "sheet") {
        order.labels.mode = LabelMode::on;
      }
      inked(order, ink);
      order.page.sizeMm = sheetFigureMm(order);
      fit(order, sheetFigure(order));
      return std::vector<PrintedPart>{{sheetFigure(order), {}}};
    }
    if (kind == "figure")
      return panelsOf(scene, ink);
    if (kind == "slide")
      order = slideFigure(order, nullptr);
    if (kind == "still") {
      order.page.sizeMm = {160.0f, 120.0f};
      order.labels.mode = LabelMode::numbers;
      order.marks = ExportMarks::none();
      order.marks.sides = true;
      order.legend = LegendList::none;
      order.sources = SourceCredits::off;
    }
    order.scene = labelled(order.scene, Screen(order.camera, order.page.sizeMm), m_tools.trees);
    inked(order, ink);
    fit(order, order);
    return std::vector<PrintedPart>{{std::move(order), {}}};
  }

  Result<std::vector<PrintedPart>> panelsOf(const model::Scene& scene, bool ink) const {
    const Screen screen(m_camera, {120.0f, 90.0f});
    const auto shown = std::make_shared<const model::Scene>(labelled(scene, screen, m_tools.trees));
    model::Figure figure;
    figure.scene = "scene.sline";
    figure.blackAndWhite = ink;
    // A legend of colours is refused in black and white.
    figure.legend = ink ? model::FigureLegend::none : model::FigureLegend::labelled;
    for (const int more : {0, 1}) {
      model::FigurePanel panel;
      const Side& side = sides[std::size_t(m_index / int(kinds.size()) + more) % sides.size()];
      panel.view = side.view ? side.name : "right";
      figure.panels.push_back(panel);
    }
    const Result<FigurePlan> plan = planFigure(figure, {{"scene.sline", shown}});
    if (!plan.ok())
      return plan.error();
    std::vector<PrintedPart> parts;
    for (std::size_t i = 0; i < plan->panels.size(); ++i) {
      PrintedPart& part = parts.emplace_back(PrintedPart{plan->panels[i], {}});
      if (const std::string& letter = plan->layout.panels[i].letter; !letter.empty())
        part.besides.items.push_back(drawnLetter(plan->figure, letter, glm::vec2(0.0f)));
    }
    return parts;
  }

  const model::Scene& m_scene;
  ProductTools& m_tools;
  int m_index;
  const char* m_kind;
  const Side& m_side;
  Size m_size;
  bool m_near;
  bool m_cut;
  model::Camera m_camera;
};

std::vector<LeaderEnd> endsOf(const ExportOrder& order, const LabelPlate& plate, float scale) {
  std::vector<LeaderEnd> ends;
  for (const ShownLabel& label : plate.labels)
    if (const PlacedLabel* placed = plate.layout.find(label.item.id))
      for (const model::Annotation& annotation : order.scene.annotations())
        if (annotation.id == label.item.id)
          if (const auto* on = std::get_if<model::SurfacePoint>(&annotation.anchors.front()))
            ends.push_back({on->structure, scale * label.item.places.front(), placed->hidden});
  return ends;
}

std::string inWords(const WritingFault& fault) {
  switch (fault.kind) {
    case WritingFault::Kind::overAnatomy:
    case WritingFault::Kind::labelOver:
      return fault.item + " lies over " + std::to_string(fault.pixels) + " pixels of anatomy";
    case WritingFault::Kind::throughDot:
      return "the leader of " + fault.item + " touches the dot of " + fault.other;
    case WritingFault::Kind::throughText:
      return "the leader of " + fault.item + " runs through " + fault.other;
    case WritingFault::Kind::crossing:
      break;
  }
  return "the leaders of " + fault.item + " and " + fault.other + " cross";
}

class Proof {
 public:
  Proof(const Product& product, const DrawPicture& draw, const ProofWishes& wishes,
        ProductTools& tools)
      : m_product(product), m_draw(draw), m_wishes(wishes), m_tools(tools) {}

  Result<ProductProof> make() {
    std::array<std::vector<FigurePlate>, 2> plates;
    for (const bool ink : {false, true})
      for (const PrintedPart& part : ink ? m_product.ink : m_product.colour) {
        m_inks = ink ? " (ink): " : ": ";
        FigurePlate plate = figurePlate(part.order, m_tools.trees);
        plate.marks.lettering.items.insert(plate.marks.lettering.items.end(),
                                           part.besides.items.begin(), part.besides.items.end());
        if (const Status done = prove(part, plate); !done.ok())
          return done.error();
        if (ink && m_wishes.unruled && !plates[0].empty()) {
          ExportOrder alone = part.order;
          alone.labels.inColour.reset();
          m_proof.elsewhereAlone +=
              int(writtenElsewhere(plates[0][plates[1].size()], figurePlate(alone, m_tools.trees))
                      .size());
        }
        plates[ink ? 1 : 0].push_back(std::move(plate));
      }
    m_inks = ": ";
    for (std::size_t i = 0; i < std::min(plates[0].size(), plates[1].size()); ++i)
      for (const std::string& other : writtenElsewhere(plates[0][i], plates[1][i])) {
        ++m_proof.elsewhere;
        tell("in ink, " + other);
      }
    return std::move(m_proof);
  }

 private:
  void tell(const std::string& what) { m_proof.lines.push_back(m_product.name + m_inks + what); }

  Status prove(const PrintedPart& part, const FigurePlate& plate) {
    const glm::vec2 size = part.order.page.sizeMm;
    PictureSettings settings{
        .width = std::max(16, int(std::lround(float(m_product.height) * size.x / size.y))),
        .height = m_product.height,
        .environment = part.order.environment};
    settings.environment.background = Background::transparent;
    const Result<Image> bare = m_draw(part.order.scene, part.order.camera, settings);
    if (!bare.ok())
      return bare.error();
    const WritingProof proof = provedWriting(plate, size, *bare);
    m_proof.marks += proof.marks;
    m_proof.labels += proof.labels;
    m_proof.leftOut += plate.labels ? plate.labels->layout.leftOut.size() : 0;
    m_proof.pixels += proof.pixels();
    if (m_wishes.unruled) {
      FigurePlate whole = plate;
      whole.marks.cutOff.reset();
      std::erase_if(whole.marks.lettering.items,
                    [](const LetteringItem& item) { return item.name == groundName; });
      const WritingProof uncut = provedWriting(whole, size, *bare);
      m_proof.overUncut += uncut.count(WritingFault::Kind::overAnatomy);
      m_proof.pixelsUncut += uncut.pixels();
    }
    m_proof.overAnatomy += proof.count(WritingFault::Kind::overAnatomy);
    m_proof.labelsOver += proof.count(WritingFault::Kind::labelOver);
    m_proof.throughDots += proof.count(WritingFault::Kind::throughDot);
    m_proof.throughTexts += proof.count(WritingFault::Kind::throughText);
    m_proof.crossings += proof.count(WritingFault::Kind::crossing);
    for (const WritingFault& fault : proof.faults)
      tell(inWords(fault));
    return m_wishes.judge && plate.labels ? judge(part, *plate.labels) : Status(Unit{});
  }

  Status judge(const PrintedPart& part, const LabelPlate& plate) {
    constexpr int height = 600;
    const glm::vec2 size = part.order.page.sizeMm;
    const float scale = float(height) / size.y;
    const std::vector<LeaderEnd> ends = endsOf(part.order, plate, scale);
    const Result<std::vector<LeaderVerdict>> verdicts =
        judgeLeaders(m_draw,
                     {.scene = part.order.scene,
                      .camera = part.order.camera,
                      .settings = {.width = int(std::lround(scale * size.x)), .height = height},
                      .dotRadius = 0.5f * scale},
                     ends);
    if (!verdicts.ok())
      return verdicts.error();
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const LeaderFault fault = (*verdicts)[i].fault;
      if (fault != LeaderFault::onAnother && fault != LeaderFault::besideIt)
        continue;
      ++m_proof.astray;
      tell("the leader of " + part.order.scene.find(ends[i].structure)->name + " ends " +
           (fault == LeaderFault::onAnother ? "on another" : "beside it"));
    }
    return Unit{};
  }

  const Product& m_product;
  const DrawPicture& m_draw;
  ProofWishes m_wishes;
  ProductTools& m_tools;
  std::string m_inks;
  ProductProof m_proof;
};

}  // namespace

Result<Product> productOf(const model::Scene& scene, int index, ProductTools& tools) {
  return Making(scene, index, tools).make();
}

void ProductProof::add(const ProductProof& other) {
  lines.insert(lines.end(), other.lines.begin(), other.lines.end());
  marks += other.marks;
  labels += other.labels;
  leftOut += other.leftOut;
  overAnatomy += other.overAnatomy;
  labelsOver += other.labelsOver;
  pixels += other.pixels;
  throughDots += other.throughDots;
  throughTexts += other.throughTexts;
  crossings += other.crossings;
  astray += other.astray;
  elsewhere += other.elsewhere;
  elsewhereAlone += other.elsewhereAlone;
  overUncut += other.overUncut;
  pixelsUncut += other.pixelsUncut;
}

Result<ProductProof> proved(const Product& product, const DrawPicture& draw,
                            const ProofWishes& wishes, ProductTools& tools) {
  return Proof(product, draw, wishes, tools).make();
}

}  // namespace sline::test
