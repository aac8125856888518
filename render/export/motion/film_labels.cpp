// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_labels.h"

#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <utility>

#include "render/export/motion/film_places.h"
#include "render/export/motion/label_heights.h"
#include "render/export/motion/label_presence.h"
#include "render/export/motion/label_sides.h"

namespace sline::render {

namespace {

LabelBox around(const std::optional<LabelBox>& all, const LabelBox& one) {
  return all ? LabelBox{glm::min(all->low, one.low), glm::max(all->high, one.high)} : one;
}

FilmLabel& labelOf(std::vector<FilmLabel>& labels, model::AnnotationId id) {
  return *std::find_if(labels.begin(), labels.end(),
                       [id](const FilmLabel& label) { return label.id == id; });
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

Screen FilmLabels::screenOf(const FilmFrame& frame) const {
  return Screen(frame.camera, m_order.page.sizeMm)
      .onDark(m_order.environment.background == Background::dark);
}

ExportOrder FilmLabels::orderOf(const FilmFrame& frame) const {
  ExportOrder now;
  now.scene = frame.scene;
  now.camera = frame.camera;
  now.viewName = frame.viewName;
  now.words = frame.words;
  now.page = m_order.page;
  now.environment = m_order.environment;
  now.labels = m_order.labels;
  now.marks = m_order.marks;
  now.legend = m_order.legend;
  now.sources = m_order.sources;
  return now;
}

LabelStyle FilmLabels::style() const {
  LabelStyle style = m_order.labels;
  style.ground = m_order.environment.background;
  style.edges = m_edges;
  style.reserved.insert(style.reserved.end(), m_boxes.begin(), m_boxes.end());
  return style;
}

Marks FilmLabels::marksOfFrame(const Film& film, const FilmFrame& frame) const {
  ExportOrder order = orderOf(frame);
  if (film.tours()) {
    const bool words = order.marks.words;
    order.marks = ExportMarks::none();
    order.marks.words = words;
    order.legend = LegendList::none;
    if (const auto rest = frame.view ? m_rests.find(*frame.view) : m_rests.end();
        rest != m_rests.end()) {
      Marks marks = rest->second.marks;
      std::erase_if(marks.lettering.items, [](const LetteringItem& item) {
        return item.name != "caption" && item.name != "sources" && item.name != groundName;
      });
      marks.notes.clear();
      return marks;
    }
  }
  return marksOf(order, m_drawn ? &*m_drawn : nullptr);
}

FigurePlate FilmLabels::plateOf(const Film& film, int frame) const {
  const FilmFrame shown = film.at(frame);
  if (film.tours() && shown.rest)
    return m_rests.at(*shown.rest);
  FigurePlate plate{.labels = {}, .marks = marksOfFrame(film, shown), .frame = {}, .notes = {}};
  if (m_order.labels.mode != LabelMode::off && !film.tours())
    plate.labels = m_plates[std::size_t(frame)];
  return plate;
}

FigurePlate FilmLabels::alone(const Film& film, int shown) {
  const FilmFrame frame = film.at(shown);
  if (!film.tours() || frame.rest)
    return figurePlate(orderOf(frame), m_trees, {.whole = true});
  return {.labels = {}, .marks = marksOfFrame(film, frame), .frame = {}, .notes = {}};
}

bool FilmLabels::settle(const Film& film, const std::function<bool(double)>& go) {
  if (m_order.bare())
    return true;
  const double looking = m_order.labels.mode == LabelMode::off ? 1.0 : 0.3;
  if (!lookAtAnatomy(film, [&](double share) { return !go || go(looking * share); }))
    return false;
  const auto rest = [&](double share) { return !go || go(looking + (1.0 - looking) * share); };
  if (film.tours())
    return settleRests(film, rest);
  keepMarksFree(film);
  if (m_order.labels.mode == LabelMode::off)
    return true;
  if (!lookAt(film, rest))
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

bool FilmLabels::lookAtAnatomy(const Film& film, const std::function<bool(double)>& go) {
  // What passes between two of them reaches no farther than marks keep away.
  constexpr int some = 24;
  const int step = std::max(film.frames() / some, 1);
  m_drawn.reset();
  const bool marks = m_order.marks != ExportMarks::none() || m_order.legendInPicture();
  if (!m_order.sourcesInPicture() && (film.tours() || !marks))
    return true;
  for (int i = 0; i < film.frames(); i += step) {
    if (!go(double(i) / double(film.frames())))
      return false;
    const FilmFrame frame = film.at(i);
    const SeenArea now = SeenMap(frame.scene, screenOf(frame), &m_trees).drawnArea();
    if (!m_drawn)
      m_drawn = now;
    for (std::size_t k = 0; k < now.cells.size(); ++k)
      m_drawn->cells[k] = m_drawn->cells[k] || now.cells[k];
  }
  return true;
}

bool FilmLabels::settleRests(const Film& film, const std::function<bool(double)>& go) {
  m_rests.clear();
  // Whose work it is stands in the same place all the time, on the same ground.
  ExportOrder credit = orderOf(film.at(0));
  credit.marks = ExportMarks::none();
  credit.legend = LegendList::none;
  const std::optional<LabelBox> foot = marksOf(credit, m_drawn ? &*m_drawn : nullptr).cutOff;
  for (int i = 0; i < film.frames(); ++i) {
    const FilmFrame frame = film.at(i);
    if (!frame.rest || m_rests.contains(*frame.rest))
      continue;
    if (!go(double(i) / double(film.frames())))
      return false;
    ExportOrder order = orderOf(frame);
    if (foot)
      order.labels.reserved.push_back(*foot);
    FigurePlate plate = figurePlate(order, m_trees, {.whole = true});
    if (foot && !plate.marks.cutOff)
      cutOffAt(plate.marks, *foot);
    m_rests.emplace(*frame.rest, std::move(plate));
  }
  return true;
}

void FilmLabels::keepMarksFree(const Film& film) {
  // Marks come and go; labels should not give way each time.
  const int step = std::max(film.frames() / 48, 1);
  for (int i = 0; i < film.frames(); i += step) {
    const Marks marks = marksOfFrame(film, film.at(i));
    const EdgeRoom& now = marks.edges;
    m_edges = {.left = std::max(m_edges.left, now.left),
               .top = std::max(m_edges.top, now.top),
               .right = std::max(m_edges.right, now.right),
               .bottom = std::max(m_edges.bottom, now.bottom)};
    for (const LabelBox& box : marks.boxes)
      if (std::find(m_boxes.begin(), m_boxes.end(), box) == m_boxes.end())
        m_boxes.push_back(box);
  }
}

bool FilmLabels::lookAt(const Film& film, const std::function<bool(double)>& go) {
  // Places of some frames may also do in others.
  constexpr int some = 24;
  const int step = std::max(film.frames() / some, 1);
  m_pool.clear();
  const int looks = film.frames() + (film.frames() + step - 1) / step;
  int done = 0;
  const auto next = [&] { return go(double(done++) / double(looks)); };
  for (int i = 0; i < film.frames() && next(); i += step) {
    const FilmFrame frame = film.at(i);
    addPlaces(m_pool, frame.scene, screenOf(frame), m_trees);
  }
  for (int i = 0; i < film.frames(); ++i) {
    if (!next())
      return false;
    const FilmFrame frame = film.at(i);
    m_sights.push_back(labelSights(frame.scene, screenOf(frame), m_order.labels.language, m_trees,
                                   {.pool = &m_pool}));
  }
  choosePlaces(m_sights, m_pool, film);
  return true;
}

void FilmLabels::layOut(const Film& film) {
  // Lines are broken for the frame with the most labels.
  const auto fullest = std::max_element(m_sights.begin(), m_sights.end(),
                                        [](const LabelSights& a, const LabelSights& b) {
                                          return a.labels.shown.size() < b.labels.shown.size();
                                        });
  const float textWidth = textWidthOf(*fullest, style());
  std::vector<LabelRequest> frames;
  frames.reserve(m_sights.size());
  for (const LabelSights& sights : m_sights)
    frames.push_back(filmRequest(sights, style(), textWidth));
  std::vector<FilmLabel> labels = filmLabels(frames);
  planHeights(labels, frames, film);
  uncrossPlaces(frames, m_sights, m_pool, film);
  labels = filmLabels(frames);
  planHeights(labels, frames, film);
  keepApart(labels, frames, film);
  // What finds no way in spite of the plan is gone for a second, too.
  while (!layOutAll(labels, frames, textWidth))
    for (FilmLabel& label : labels)
      stayForASecond(label.there, film);
  m_sights.clear();
}

bool FilmLabels::layOutAll(std::vector<FilmLabel>& labels, const std::vector<LabelRequest>& frames,
                           float textWidth) {
  m_plates.clear();
  bool all = true;
  LabelLayout before{.textWidth = textWidth};
  for (std::size_t t = 0; t < frames.size(); ++t) {
    LabelSights sights = m_sights[t];
    for (std::size_t k = 0; k < frames[t].items.size(); ++k) {
      LabelItem& item = sights.labels.shown[k].item;
      item = frames[t].items[k];
      item.absent = !labelOf(labels, item.id).there[t];
    }
    LabelPlate plate =
        labelPlate(sights, style(), {.before = &before, .still = true, .widths = frames[t].widths});
    for (const model::AnnotationId id : plate.layout.leftOut) {
      FilmLabel& label = labelOf(labels, id);
      all = all && !label.there[t];
      label.there[t] = false;
    }
    LabelLayout now = plate.layout;
    // A number that comes back is the same.
    if (m_order.labels.mode == LabelMode::numbers)
      for (const PlacedLabel& was : before.labels)
        if (!now.find(was.id))
          now.labels.push_back(was);
    before = std::move(now);
    m_plates.push_back(std::move(plate));
  }
  return all;
}

}  // namespace sline::render
