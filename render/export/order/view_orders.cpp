// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/view_orders.h"

#include <QString>
#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/edit/views.h"
#include "model/scene/visible_structures.h"
#include "render/export/order/ink_alone.h"
#include "render/lettering/looks_in_colour.h"
#include "render/lettering/mark_words.h"

namespace sline::render {

namespace {

constexpr float wideAspect = 16.0f / 9.0f;

constexpr std::array viewSubjects{OptionChoice{.id = "auto", .value = int(ViewSubject::asKind)},
                                  OptionChoice{.id = "all", .value = int(ViewSubject::all)},
                                  OptionChoice{.id = "shown", .value = int(ViewSubject::shown)}};

/// Returns how many times wider than high the page must be to show the corners of the box, as far
/// as a wide page shows them.
float aspectFor(const model::Camera& camera, const model::Box& box) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
  float aspect = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p{corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                      corner & 4 ? box.high.z : box.low.z};
    const glm::vec3 way = p - camera.eye;
    const float depth = glm::dot(way, forward);
    const float half = camera.projection == model::Projection::perspective
                           ? depth * model::edgeSlope(camera)
                           : 0.5f * camera.heightMm;
    if (half > 0.0f)
      aspect = std::max(aspect, std::abs(glm::dot(way, right)) / half);
  }
  return std::min(aspect, wideAspect);
}

}  // namespace

constinit const ExportOption viewsOption{
    .id = "views",
    .flag = "--views",
    .help =
        "Which views are in the file: all saved ones, each with a page, a slide or a deck of its "
        "own, or, for kinds that hold one picture, each in a numbered file; or what is shown "
        "alone, which is also what --view and --camera ask for. auto is all for slides and shown "
        "for others",
    .kind = ChoiceOption{viewSubjects},
    .field = boundTo([](auto& o) -> auto& { return o.template of<ViewsOptions>().subject; }),
    .kept = false};

bool wantsAllViews(const ExportOrder& order) {
  return order.of<ViewsOptions>().subject == ViewSubject::all && !order.scene.views().empty();
}

ExportOrder orderOfView(const ExportOrder& order, const model::View& view) {
  ExportOrder one = order;
  const model::Scene scene = withLooksInColour(order.scene, order.labels.inColour);
  one.scene = model::withViewApplied(scene, view).scene;
  if (order.pureInk)
    leaveInkAlone(one);
  one.camera = view.camera;
  one.viewName = view.name;
  one.words = view.words;
  return one;
}

ExportOrder pictureOfView(const ExportOrder& order, const model::View& view) {
  ExportOrder one = orderOfView(order, view);
  one.camera = fittedToPage(one.scene, one.camera, one.page.sizeMm.x / one.page.sizeMm.y);
  return one;
}

std::string titleOfView(const model::View& view, const std::string& language,
                        const model::KnownSides& sides) {
  const std::string& own = view.words.title.in(language);
  if (!own.empty())
    return own;
  const QString name = sides.any ? MarkWords(language, sides).view(view.name, view.camera)
                                 : QString::fromStdString(view.name).simplified();
  return name.toStdString();
}

model::Camera widened(model::Camera camera, float times) {
  if (!(times > 1.0f) || !std::isfinite(times))
    return camera;
  constexpr float widest = 150.0f;  // degrees
  const float half = model::edgeSlope(camera);
  camera.fovyDegrees = std::min(widest, 2.0f * glm::degrees(std::atan(times * half)));
  camera.heightMm *= times;
  return camera;
}

model::Camera fittedToPage(const model::Scene& scene, model::Camera camera, float aspect) {
  if (!(aspect > 0.0f) || aspect >= wideAspect || model::cameraFault(camera))
    return camera;
  float wanted = 0.0f;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    wanted = std::max(wanted, aspectFor(camera, structure.node->mesh->bounds()));
  return widened(camera, wanted / aspect);
}

std::string safeFileName(const std::string& text) {
  constexpr int longestBytes = 120;  // file systems take 255; the target's own name comes before
  static const QString separating = QStringLiteral("/\\:*?\"<>|");
  QString name;
  for (const QChar each : QString::fromStdString(text))
    if (separating.contains(each))
      name += QLatin1Char('-');
    else
      name += each.isSurrogate() || each.isPrint() ? each : QChar(u' ');
  name = name.simplified();
  while (name.toUtf8().size() > longestBytes)
    name.chop(name.size() > 1 && name.back().isLowSurrogate() ? 2 : 1);
  // Windows drops these characters at the end, and hides files that begin with a dot.
  while (name.endsWith(QLatin1Char('.')) || name.endsWith(QLatin1Char(' ')))
    name.chop(1);
  while (name.startsWith(QLatin1Char('.')))
    name.remove(0, 1);
  return name.isEmpty() ? "picture" : name.toStdString();
}

std::vector<std::filesystem::path> viewTargets(const std::filesystem::path& target,
                                               const std::vector<model::View>& views,
                                               const std::string& extension) {
  std::error_code unknown;
  const bool folder = !target.has_filename() || std::filesystem::is_directory(target, unknown);
  const std::string ending = "." + extension;
  std::string stem = target.string();
  if (stem.size() > ending.size() &&
      QString::fromStdString(stem).endsWith(QString::fromStdString(ending), Qt::CaseInsensitive))
    stem.resize(stem.size() - ending.size());
  const int digits = int(std::to_string(views.size()).size());
  std::vector<std::filesystem::path> targets;
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::string name = QStringLiteral("%1 ").arg(i + 1, digits, 10, QLatin1Char('0')).toStdString();
    name += safeFileName(views[i].name) += ending;
    if (folder)
      targets.push_back(target / name);
    else
      targets.emplace_back(std::string(stem).append(" - ").append(name));
  }
  return targets;
}

}  // namespace sline::render
