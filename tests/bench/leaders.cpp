// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/leaders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <ostream>
#include <sstream>

#include "model/edit/look.h"
#include "model/geometry/plane.h"
#include "model/look/opening_look.h"
#include "model/scene/resolved_styles.h"
#include "render/export/pdf/sheet_figure.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/plate/figure_plate.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/typesetting.h"
#include "render/measures/leader_truth.h"
#include "tests/bench/kept_plate.h"
#include "tests/bench/measure.h"

namespace sline::bench {

namespace {

constexpr float aspect = 4.0f / 3.0f;

/// One picture of the course.
struct Exhibit {
  std::string name;
  model::Scene scene;
  model::Camera camera;
};

struct Angle {
  model::AnatomicalView view;
  float turn;  ///< degrees about the body's long axis, then towards its head
  float lift;
};

constexpr std::array<Angle, 9> angles{{{model::AnatomicalView::anterior, 0, 0},
                                       {model::AnatomicalView::superior, 0, 0},
                                       {model::AnatomicalView::posterior, 0, 0},
                                       {model::AnatomicalView::left, 0, 0},
                                       {model::AnatomicalView::right, 0, 0},
                                       {model::AnatomicalView::inferior, 0, 0},
                                       {model::AnatomicalView::anterior, 35, 25},
                                       {model::AnatomicalView::anterior, -50, -20},
                                       {model::AnatomicalView::posterior, 25, 40}}};

model::Camera cameraAt(const model::Scene& scene, const Angle& angle) {
  const model::Box bounds = scene.visibleBounds();
  model::Camera camera = model::anatomicalCamera(angle.view, bounds, aspect);
  const float turn = glm::radians(angle.turn);
  const float lift = glm::radians(angle.lift);
  if (angle.turn != 0.0f || angle.lift != 0.0f) {
    const glm::vec3 d = camera.eye - camera.target;
    const glm::vec3 turned(std::cos(turn) * d.x - std::sin(turn) * d.y,
                           std::sin(turn) * d.x + std::cos(turn) * d.y, d.z);
    camera.eye = camera.target + std::cos(lift) * turned +
                 std::sin(lift) * glm::length(d) * glm::vec3(0.0f, 0.0f, 1.0f);
  }
  const auto corners = bounds.corners();
  return model::fitted(camera, corners, aspect,
                       {.left = 0.22, .right = 0.22, .top = 0.05, .bottom = 0.05});
}

std::vector<model::NodeId> named(const model::Scene& scene, const std::string& names) {
  std::vector<model::NodeId> ids;
  std::stringstream all(names);
  for (std::string name; std::getline(all, name, ',');)
    for (const model::NodeId id : scene.named(name))
      ids.push_back(id);
  return ids;
}

model::Scene withFill(const model::Scene& scene, std::optional<model::Fill> fill) {
  if (!fill)
    return scene;
  const std::vector<model::NodeId> all = scene.structuresBelow(model::rootId);
  return model::withLook(scene, all, {.fill = *fill}).scene;
}

/// Labels the structures in focus and the largest of the others, in the order of the scene.
model::Scene labelled(const Exhibit& exhibit, std::span<const model::NodeId> focus, int most,
                      const render::Screen& screen) {
  struct Candidate {
    model::NodeId id;
    float size;
  };
  std::vector<Candidate> candidates;
  const std::array<model::NodeId, 1> all{model::rootId};
  for (const model::ResolvedStructure& one : model::resolvedBelow(exhibit.scene, all)) {
    if (!one.style.visible || one.style.opacity.value() <= 0.0f)
      continue;
    const bool target = std::any_of(focus.begin(), focus.end(), [&](model::NodeId id) {
      return id == one.node->id || exhibit.scene.isBelow(one.node->id, id);
    });
    candidates.push_back(
        {one.node->id, (target ? 1e6f : 0.0f) + glm::length(one.node->mesh->bounds().size())});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.size > b.size; });
  candidates.resize(std::min(candidates.size(), std::size_t(most)));
  model::Scene scene = exhibit.scene;
  scene.setAnnotations({});
  const render::SeenMap map(scene, screen);
  for (const Candidate& one : candidates)
    if (auto label = map.labelFor(one.id)) {
      label->text = scene.find(one.id)->name;
      scene.appendAnnotation(*std::move(label));
    }
  return scene;
}

std::vector<Exhibit> exhibitsOf(const model::Scene& imported, const LeaderCourse& course) {
  std::vector<Exhibit> exhibits;
  constexpr std::array<std::optional<model::Fill>, 5> fills{
      std::nullopt, model::Fill::none, model::Fill::paper, model::Fill::veil, model::Fill::tint};
  model::FormIndex forms;
  std::size_t number = 0;
  for (const std::string& focus : course.foci) {
    const std::vector<model::NodeId> about = named(imported, focus);
    for (const Angle& angle : angles) {
      const std::size_t fill = number % fills.size();
      const bool cut = number % 4 == 3;
      ++number;
      if (number % std::size_t(course.every) != 0)
        continue;
      model::Scene scene = imported;
      if (cut)
        scene.appendSection(
            {.plane = model::anatomicalPlane(
                 number % 8 == 4 ? model::AnatomicalView::left : model::AnatomicalView::anterior,
                 number % 8 == 4 ? scene.visibleBounds().centre().x
                                 : scene.visibleBounds().centre().y)});
      const model::Camera camera = cameraAt(scene, angle);
      const auto look =
          model::openingLook(scene, forms, {.about = about, .camera = camera, .aspect = aspect});
      exhibits.push_back(
          {focus + ", view " + std::to_string(&angle - angles.data()) + ", fill " +
               (fill == 0 ? std::string("as looked") : std::string(model::fillNames[fill - 1])) +
               (cut ? ", section" : ""),
           withFill(look ? look->scene : scene, fills[fill]), camera});
    }
  }
  return exhibits;
}

render::ExportOrder orderOf(const Exhibit& exhibit, const LeaderCourse& course) {
  render::ExportOrder order;
  order.camera = exhibit.camera;
  order.scene = exhibit.scene;
  order.page = {.sizeMm = {aspect * render::usualHeightMm, render::usualHeightMm},
                .dpi = float(course.height) / render::usualHeightMm * render::millimetresPerInch};
  order.labels.mode = render::LabelMode::on;
  if (!course.selfTest)
    return order;
  // The sheet labels by itself what has no labels yet.
  order.labels.mode = render::LabelMode::off;
  order.of<render::SheetOptions>().kind = render::SheetKind::teaching;
  return render::sheetFigure(order);
}

/// Counts what is judged.
struct Tally {
  std::array<int, 6> faults{};
  int dashed = 0;
  int pictures = 0;
  double layoutMs = 0.0;
  std::ostream& out;  ///< where faults go
};

constexpr std::array<const char*, 6> faultNames{"right",
                                                "ends on another",
                                                "ends beside it",
                                                "dashed though seen there",
                                                "dashed though seen elsewhere",
                                                "covers what shows of it"};

/// The ends of a plate's leaders, and the labels' texts.
struct Ends {
  std::vector<render::LeaderEnd> ends;
  std::vector<std::string> names;
};

Ends endsOf(const render::ExportOrder& order, const render::LabelPlate& plate, float scale) {
  Ends all;
  for (const render::ShownLabel& label : plate.labels)
    if (const render::PlacedLabel* placed = plate.layout.find(label.item.id)) {
      const auto& annotations = order.scene.annotations();
      const auto annotation =
          std::find_if(annotations.begin(), annotations.end(),
                       [&](const model::Annotation& one) { return one.id == label.item.id; });
      all.ends.push_back(
          {std::get<model::SurfacePoint>(annotation->anchors.front()).structure,
           scale * (placed->leader.empty() ? label.item.places.front() : placed->leader.front()),
           placed->hidden});
      all.names.push_back(label.text);
    }
  return all;
}

/// Judges one picture; returns whether it has faults.
Result<bool> judgeOne(const render::DrawPicture& draw, const render::ExportOrder& order,
                      const std::string& name, int height, Tally& tally) {
  model::MeshTrees trees;
  render::figurePlate(order, trees);
  const Stopwatch watch;
  const render::FigurePlate plate = render::figurePlate(order, trees);
  tally.layoutMs += watch.milliseconds();
  const float scale = float(height) / order.page.sizeMm.y;
  const Ends all = endsOf(order, *plate.labels, scale);
  model::Scene bare = order.scene;
  bare.setAnnotations({});
  const auto verdicts =
      render::judgeLeaders(draw,
                           {.scene = bare,
                            .camera = order.camera,
                            .settings = {.width = int(aspect * float(height)), .height = height},
                            .dotRadius = 0.5f * scale},
                           all.ends);
  if (!verdicts)
    return verdicts.error();
  bool faulty = false;
  ++tally.pictures;
  for (std::size_t i = 0; i < all.ends.size(); ++i) {
    const render::LeaderVerdict& verdict = (*verdicts)[i];
    ++tally.faults[std::size_t(verdict.fault)];
    tally.dashed += all.ends[i].dashed ? 1 : 0;
    if (verdict.fault == render::LeaderFault::none)
      continue;
    faulty = true;
    tally.out << tally.pictures << " [" << name << "] " << all.names[i] << ": "
              << faultNames[std::size_t(verdict.fault)] << " at " << int(all.ends[i].place.x) << ','
              << int(all.ends[i].place.y) << " own " << verdict.own << " another "
              << verdict.another << ' '
              << (verdict.seen ? bare.find(*verdict.seen)->name : std::string("ground")) << '\n';
  }
  return faulty;
}

}  // namespace

Result<int> judgeScene(render::Picture& picture, const model::Scene& imported,
                       const LeaderCourse& course, std::ostream& out) {
  const auto typesetting = render::Typesetting::create();
  if (!typesetting)
    return typesetting.error();
  Tally tally{.out = out};
  const render::DrawPicture draw = picture.drawing();
  for (Exhibit& exhibit : exhibitsOf(imported, course)) {
    render::ExportOrder order = orderOf(exhibit, course);
    if (!course.selfTest)
      order.scene =
          labelled(exhibit, named(imported, exhibit.name.substr(0, exhibit.name.find(", "))),
                   course.labels, render::Screen(order.camera, order.page.sizeMm));
    const auto faulty = judgeOne(draw, order, exhibit.name, course.height, tally);
    if (!faulty)
      return faulty.error();
    if (!*faulty || course.folder.empty())
      continue;
    const std::string path = course.folder + '/' + std::to_string(tally.pictures) + ".png";
    if (const Status kept =
            keepPlate(picture, order, **typesetting, {.path = path, .height = 2 * course.height});
        !kept)
      return kept.error();
  }
  int all = 0;
  for (std::size_t i = 0; i < faultNames.size(); ++i) {
    all += tally.faults[i];
    out << faultNames[i] << ' ' << tally.faults[i] << '\n';
  }
  out << all << " leaders in " << tally.pictures << " pictures, " << tally.dashed
      << " dashed; a layout takes " << tally.layoutMs / std::max(tally.pictures, 1) << " ms\n";
  return all - tally.faults[0];
}

}  // namespace sline::bench
