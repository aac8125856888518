// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_labels.h"

#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <utility>

#include "render/export/motion/label_sides.h"

namespace sline::render {

namespace {

/// Returns the places of those labels as a layout that the next picture's follow.
LabelLayout placesOf(const LabelsInPicture& labels) {
  LabelLayout layout;
  for (const ShownLabel& label : labels.shown)
    layout.labels.push_back(
        {.id = label.item.id, .hidden = label.item.hidden, .found = label.item.found});
  return layout;
}

LabelBox around(const std::optional<LabelBox>& all, const LabelBox& one) {
  return all ? LabelBox{glm::min(all->low, one.low), glm::max(all->high, one.high)} : one;
}

/// Makes the anatomy's extent the same in all frames, so that columns stay where they are.
void shareExtent(std::vector<LabelSights>& sights) {
  std::optional<LabelBox> all;
  for (const LabelSights& one : sights)
    if (const auto& extent = one.obstacles.extent)
      all = around(all, *extent);
  for (LabelSights& one : sights)
    if (one.obstacles.extent)
      one.obstacles.extent = all;
}

}  // namespace

ExportOrder FilmLabels::orderOf(const FilmFrame& frame) const {
  ExportOrder now;
  now.scene = frame.scene;
  now.camera = frame.camera;
  now.viewName = frame.viewName;
  now.page = m_order.page;
  now.environment = m_order.environment;
  now.labels = m_order.labels;
  now.marks = m_order.marks;
  now.legend = m_order.legend;
  return now;
}

LabelStyle FilmLabels::style() const {
  LabelStyle style = m_order.labels;
  style.onDark = m_order.environment.background == Background::dark;
  style.edges = m_edges;
  if (m_legend)
    style.reserved = {*m_legend};
  return style;
}

FigurePlate FilmLabels::plateOf(const Film& film, int frame) const {
  FigurePlate plate{.labels = {}, .marks = marksOf(orderOf(film.at(frame))), .notes = {}};
  if (m_order.labels.mode != LabelMode::off)
    plate.labels = m_plates[std::size_t(frame)];
  return plate;
}

FigurePlate FilmLabels::alone(const FilmFrame& frame) {
  FigurePlate plate{.labels = {}, .marks = marksOf(orderOf(frame)), .notes = {}};
  if (m_order.labels.mode == LabelMode::off)
    return plate;
  LabelStyle free = style();
  if (plate.marks.legend)
    free.reserved = {*plate.marks.legend};
  plate.labels = labelPlate(frame.scene, Screen(frame.camera, m_order.page.sizeMm), free, m_trees);
  return plate;
}

bool FilmLabels::settle(const Film& film, const std::function<bool(double)>& go) {
  if (m_order.labels.mode == LabelMode::off)
    return true;
  keepMarksFree(film);
  if (!lookAt(film, go))
    return false;
  if (film.loops())
    shareExtent(m_sights);
  // Half of the labels may have a second line.
  constexpr float lines = 1.5f;
  const float height = m_order.page.sizeMm.y - m_edges.top - m_edges.bottom;
  keepSides(m_sights, film, std::size_t(height / (lines * lineHeightMm(style()))));
  layOut(film);
  return true;
}

void FilmLabels::keepMarksFree(const Film& film) {
  // Marks come and go; labels should not give way each time.
  const int step = std::max(film.frames() / 48, 1);
  for (int i = 0; i < film.frames(); i += step) {
    const Marks marks = marksOf(orderOf(film.at(i)));
    const EdgeRoom& now = marks.edges;
    m_edges = {.left = std::max(m_edges.left, now.left),
               .top = std::max(m_edges.top, now.top),
               .right = std::max(m_edges.right, now.right),
               .bottom = std::max(m_edges.bottom, now.bottom)};
    if (marks.legend)
      m_legend = around(m_legend, *marks.legend);
  }
}

bool FilmLabels::lookAt(const Film& film, const std::function<bool(double)>& go) {
  LabelLayout before;
  for (int i = 0; i < film.frames(); ++i) {
    if (go && !go(double(i) / double(film.frames())))
      return false;
    const FilmFrame frame = film.at(i);
    m_sights.push_back(labelSights(frame.scene, Screen(frame.camera, m_order.page.sizeMm),
                                   m_order.labels.language, m_trees,
                                   {.layout = i > 0 ? &before : nullptr, .steady = true}));
    before = placesOf(m_sights.back().labels);
  }
  return true;
}

void FilmLabels::layOut(const Film& film) {
  std::optional<LabelLayout> before;
  // A label that finds no room is gone for a second, and is in nobody's way.
  std::map<model::AnnotationId, int> gone;
  const auto plateAt = [&](std::size_t i) {
    LabelSights sights = m_sights[i];
    std::vector<model::AnnotationId> waiting;
    std::erase_if(sights.labels.shown, [&](const ShownLabel& label) {
      if (gone[label.item.id]-- <= 0)
        return false;
      waiting.push_back(label.item.id);
      return true;
    });
    LabelPlate plate = labelPlate(std::move(sights), style(),
                                  {.before = before ? &*before : nullptr, .still = true});
    LabelLayout now = plate.layout;
    // A number that comes back is the same.
    if (before && m_order.labels.mode == LabelMode::numbers)
      for (const PlacedLabel& was : before->labels)
        if (!now.find(was.id))
          now.labels.push_back(was);
    before = std::move(now);
    for (const model::AnnotationId id : plate.layout.leftOut)
      gone[id] = film.framesPerSecond() - 1;
    std::vector<model::AnnotationId>& without = plate.layout.leftOut;
    without.insert(without.end(), waiting.begin(), waiting.end());
    return plate;
  };
  // In a film that loops the first frame follows the last like any other.
  if (film.loops())
    for (std::size_t i = 0; i < m_sights.size(); ++i)
      plateAt(i);
  for (std::size_t i = 0; i < m_sights.size(); ++i)
    m_plates.push_back(plateAt(i));
  m_sights.clear();
  stayForASecond(m_plates, film);
}

}  // namespace sline::render
