// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/in_picture/label_sheet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <tuple>

#include "render/labels/seen/sight.h"

namespace sline::widgets {

namespace {

bool wanted(const model::Scene& scene, const LabelWish& wish) {
  return wish.style.mode != render::LabelMode::off && wish.size.x >= 1.0f && wish.size.y >= 1.0f &&
         std::any_of(scene.annotations().begin(), scene.annotations().end(),
                     [](const model::Annotation& annotation) { return annotation.visible; });
}

/// Returns the box of all that is painted, in millimetres, with a margin for halos and dots.
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

bool same(const LabelWish& a, const LabelWish& b) {
  const auto tied = [](const LabelWish& w) {
    return std::tie(w.style.mode, w.style.points, w.style.language, w.style.ground, w.size,
                    w.style.reserved, w.pixelsPerMm, w.ratio, w.document, w.arrivals);
  };
  return tied(a) == tied(b);
}

/// The space around a text's box for halos and frames, in millimetres.
constexpr float textMargin = 1.0f;

/// Returns the text alone with its frame, with the box's corner `textMargin` from the origin.
render::LabelPlate textAlone(const render::LabelPlate& plate, std::size_t i,
                             const render::PlacedLabel& placed) {
  constexpr float outside = 1e4f;
  render::LabelPlate alone{.style = plate.style,
                           .labels = {plate.labels[i]},
                           .texts = {plate.texts[i]},
                           .layout = {.labels = {placed}}};
  // The side on which its place lies decides how lines are aligned.
  const bool after = placed.box.high.x < plate.labels[i].item.places.front().x;
  alone.labels[0].item.places = {glm::vec2(after ? outside : -outside, -outside)};
  alone.layout.labels[0].leader.clear();
  alone.layout.labels[0].box = {glm::vec2(textMargin), glm::vec2(textMargin) + placed.box.size()};
  return alone;
}

/// Returns a key of everything that the lines' looks depend on.
QString keyOf(const std::vector<render::TextLine>& lines) {
  QString key;
  for (const render::TextLine& line : lines) {
    key += QLatin1Char('\n') + QString::number(double(line.indent));
    for (const render::TextRun& run : line.runs)
      key +=
          QStringLiteral(" %1%2 ").arg(int(run.style.bold)).arg(int(run.style.italic)) + run.text;
  }
  return key;
}

QString keyOf(const LabelWish& wish, const render::LabelPlate& alone) {
  const std::vector<render::TextLine>& lines = alone.texts[0].lines;
  const render::LabelPost post = alone.layout.labels[0].post;
  // A single line fills its box, whichever way it is aligned.
  const bool right = lines.size() > 1 &&
                     (post == render::LabelPost::left || (post == render::LabelPost::beside &&
                                                          alone.labels[0].item.places[0].x > 0.0f));
  const QStringList looks{QString::number(int(alone.style.mode)),
                          QString::number(double(alone.style.points)),
                          QString::number(int(alone.style.ground)),
                          QString::number(double(wish.pixelsPerMm) * wish.ratio),
                          QString::number(int(alone.labels[0].item.kind)),
                          QString::number(int(right))};
  return looks.join(QLatin1Char(' ')) + keyOf(lines);
}

/// Returns the leaders and places, without texts and their frames.
render::LabelPlate withoutTexts(render::LabelPlate plate) {
  plate.style.mode = render::LabelMode::on;
  for (render::ShownLabel& label : plate.labels)
    if (label.item.kind == model::AnnotationKind::callout)
      label.item.kind = model::AnnotationKind::label;
  for (render::LabelText& text : plate.texts)
    text.lines.clear();
  return plate;
}

}  // namespace

LabelSightsById sightsOf(const LabelSheet& sheet) {
  LabelSightsById sights;
  const auto add = [&sights](const std::vector<model::AnnotationId>& ids, LabelSight sight) {
    for (const model::AnnotationId id : ids)
      sights[id.value] = sight;
  };
  const render::UnseenLabels& unseen = sheet.plate.unseen;
  add(unseen.hidden, LabelSight::hidden);
  add(unseen.offPicture, LabelSight::offPicture);
  add(unseen.notDrawn, LabelSight::notDrawn);
  add(sheet.plate.layout.leftOut, LabelSight::withoutRoom);
  return sights;
}

bool outgrown(const model::Camera& settled, const model::Camera& camera) {
  constexpr double most = 1.25;
  const auto shown = [](const model::Camera& of) {  // millimetres, at the target
    return of.projection == model::Projection::orthographic
               ? double(of.heightMm)
               : 2.0 * double(glm::distance(of.eye, of.target)) * double(model::edgeSlope(of));
  };
  const double share = shown(camera) / std::max(shown(settled), 1e-9);
  return share > most || share * most < 1.0;
}

void LabelDrawer::paintTexts(QPainter& painter, const LabelSheet& sheet) {
  const double scale = double(sheet.wish.pixelsPerMm) * sheet.wish.ratio;
  // Labels come and go while a camera turns; when too many are kept, all are dropped, the unused
  // ones among them.
  constexpr std::size_t mostKept = 400;
  if (m_texts.size() > mostKept)
    m_texts.clear();
  for (std::size_t i = 0; i < sheet.plate.labels.size(); ++i) {
    const render::PlacedLabel* placed = sheet.plate.layout.find(sheet.plate.labels[i].item.id);
    if (!placed)
      continue;
    const render::LabelPlate alone = textAlone(sheet.plate, i, *placed);
    QImage& image = m_texts[keyOf(sheet.wish, alone)];
    if (image.isNull()) {
      const glm::vec2 size = alone.layout.labels[0].box.high + textMargin;
      image = QImage(int(std::ceil(scale * double(size.x))), int(std::ceil(scale * double(size.y))),
                     QImage::Format_ARGB32_Premultiplied);
      image.fill(Qt::transparent);
      QPainter letters(&image);
      letters.scale(scale, scale);
      render::paintLabels(letters, alone);
    }
    // The image is placed on whole pixels, so that it is as sharp as it was painted.
    const glm::vec2 corner = placed->box.low - textMargin;
    painter.drawImage(QPoint(int(std::lround(scale * double(corner.x))),
                             int(std::lround(scale * double(corner.y)))),
                      image);
  }
}

void LabelDrawer::paint(LabelSheet& sheet) {
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
  sheet.image.fill(Qt::transparent);
  const double scale = double(wish.pixelsPerMm) * wish.ratio;
  QPainter painter(&sheet.image);
  painter.translate(QPointF((wish.ratio * sheet.corner).toPoint()) * -1.0);
  // Blank lines to write on are not texts.
  const bool blank = wish.style.mode == render::LabelMode::blank;
  painter.save();
  painter.scale(scale, scale);
  render::paintLabels(painter, blank ? sheet.plate : withoutTexts(sheet.plate));
  painter.restore();
  if (!blank)
    paintTexts(painter, sheet);
  painter.end();
  sheet.image.setDevicePixelRatio(wish.ratio);
}

std::optional<render::LabelLayout> LabelDrawer::before(const model::Camera& camera,
                                                       const LabelWish& wish) const {
  constexpr float another = 0.85f;  // cosine of the largest angle of a turn that is followed
  if (!m_last || m_last->empty() || m_last->wish.document != wish.document ||
      m_last->wish.style.points != wish.style.points ||
      m_last->wish.style.mode != wish.style.mode || m_last->wish.arrivals != wish.arrivals ||
      (!wish.moving && outgrown(m_last->settled, camera)))
    return std::nullopt;
  const glm::vec3 was = model::cameraFrame(m_last->camera).back;
  if (glm::dot(was, model::cameraFrame(camera).back) < another)
    return std::nullopt;
  const glm::vec2 from = m_last->wish.size / m_last->wish.pixelsPerMm;
  const glm::vec2 to = wish.size / wish.pixelsPerMm;
  return from == to ? m_last->plate.layout : render::resized(m_last->plate.layout, from, to);
}

LabelSheetPtr LabelDrawer::draw(const model::Scene& scene, const model::Camera& camera,
                                const LabelWish& wish) {
  if (m_last && m_last->camera == camera && same(m_last->wish, wish) && m_lastScene == scene &&
      (wish.moving || !m_last->waits()))
    return m_last;
  auto sheet = std::make_shared<LabelSheet>();
  sheet->camera = camera;
  sheet->wish = wish;
  if (wanted(scene, wish)) {
    m_trees.keepOnly(model::meshesOf(scene));
    if (!render::Sights(scene, m_trees).withoutTree().empty())
      return nullptr;
    const render::Screen screen(camera, wish.size / wish.pixelsPerMm);
    const std::optional<render::LabelLayout> follows = before(camera, wish);
    sheet->plate = render::labelPlate(
        scene, screen, wish.style, m_trees,
        {.before = follows ? &*follows : nullptr, .moving = wish.moving, .hurried = wish.moving});
    sheet->settled = follows ? m_last->settled : camera;
    if (!sheet->empty())
      paint(*sheet);
  }
  m_last = sheet;
  m_lastScene = scene;
  return m_last;
}

bool LabelDrawer::prepare(const model::Scene& scene) {
  const std::vector<model::MeshPtr> missing = render::Sights(scene, m_trees).withoutTree();
  if (missing.empty())
    return false;
  m_trees.of(missing.front());
  return true;
}

}  // namespace sline::widgets
