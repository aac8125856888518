// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/label_sheet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/labels/sight.h"

namespace sline::widgets {

namespace {

bool wanted(const model::Scene& scene, const LabelWish& wish) {
  return wish.style.mode != render::LabelMode::off && wish.size.x >= 1.0f && wish.size.y >= 1.0f &&
         std::any_of(scene.annotations().begin(), scene.annotations().end(),
                     [](const model::Annotation& annotation) { return annotation.visible; });
}

/// All that is painted, in millimetres; halos and dots lie that far beyond.
render::LabelBox extentOf(const render::LabelPlate& plate) {
  constexpr float beyond = 1.6f;
  render::LabelBox all{glm::vec2(std::numeric_limits<float>::infinity()),
                       glm::vec2(-std::numeric_limits<float>::infinity())};
  const auto add = [&all](const glm::vec2& p) {
    all = {glm::min(all.low, p), glm::max(all.high, p)};
  };
  for (const render::PlacedLabel& label : plate.layout.labels) {
    add(label.box.low);
    add(label.box.high);
  }
  for (const render::ShownLabel& label : plate.labels)
    for (const glm::vec2& place : label.item.places)
      add(place);
  return all.grown(beyond);
}

void paint(LabelSheet& sheet) {
  const LabelWish& wish = sheet.wish;
  const render::LabelBox extent = extentOf(sheet.plate);
  const glm::vec2 low = glm::max(glm::floor(extent.low * wish.pixelsPerMm), glm::vec2(0.0f));
  const glm::vec2 high = glm::min(glm::ceil(extent.high * wish.pixelsPerMm), wish.size);
  if (high.x <= low.x || high.y <= low.y)
    return;
  sheet.corner = QPointF(qreal(low.x), qreal(low.y));
  const QSizeF size = wish.ratio * QSizeF(qreal(high.x - low.x), qreal(high.y - low.y));
  sheet.image = QImage(int(std::ceil(size.width())), int(std::ceil(size.height())),
                       QImage::Format_ARGB32_Premultiplied);
  sheet.image.setDevicePixelRatio(wish.ratio);
  sheet.image.fill(Qt::transparent);
  QPainter painter(&sheet.image);
  painter.translate(-sheet.corner);
  painter.scale(qreal(wish.pixelsPerMm), qreal(wish.pixelsPerMm));
  render::paintLabels(painter, sheet.plate);
}

}  // namespace

const render::LabelLayout* LabelDrawer::before(const model::Camera& camera,
                                               const LabelWish& wish) const {
  constexpr float another = 0.85f;  // cosine of the angle beyond which nobody follows a turn
  if (!m_last || m_last->empty() || m_last->wish.document != wish.document ||
      m_last->wish.size != wish.size || m_last->wish.style.points != wish.style.points ||
      m_last->wish.style.mode != wish.style.mode)
    return nullptr;
  const glm::vec3 was = model::cameraFrame(m_last->camera).back;
  return glm::dot(was, model::cameraFrame(camera).back) < another ? nullptr : &m_last->plate.layout;
}

LabelSheetPtr LabelDrawer::draw(const model::Scene& scene, const model::Camera& camera,
                                const LabelWish& wish) {
  auto sheet = std::make_shared<LabelSheet>();
  sheet->camera = camera;
  sheet->wish = wish;
  if (wanted(scene, wish)) {
    m_trees.keepThoseOf(scene);
    if (!render::Sights(scene, m_trees).withoutTree().empty())
      return nullptr;
    const render::Screen screen(camera, wish.size / wish.pixelsPerMm);
    sheet->plate = render::labelPlate(scene, screen, wish.style, m_trees, before(camera, wish));
    if (!sheet->empty())
      paint(*sheet);
  }
  m_last = sheet;
  return m_last;
}

bool LabelDrawer::prepare(const model::Scene& scene) {
  const std::vector<model::MeshPtr> missing = render::Sights(scene, m_trees).withoutTree();
  if (missing.empty())
    return false;
  m_trees.treeOf(missing.front());
  return true;
}

}  // namespace sline::widgets
