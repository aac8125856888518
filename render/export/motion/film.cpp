// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film.h"
#include "render/export/motion/film_options.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "model/edit/views.h"
#include "model/focus/turned_focus.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace {

Error tooLongRests(double rests, double seconds) {
  const auto tenths = [](double value) {
    std::string text = std::to_string(std::lround(10.0 * value));
    return text.insert(text.size() > 1 ? text.size() - 1 : 0, text.size() > 1 ? "." : "0.");
  };
  return {.reason = "rests of " + tenths(rests) + " seconds leave no time to move in a film of " +
                    tenths(seconds),
          .remedy = "Make the rests shorter or the film longer"};
}

/// Returns how long the film rests at each view, seconds: as the view says, else as all others.
std::vector<double> restsOf(const std::vector<model::View>& views, const FilmOptions& options) {
  const double usual = options.hold.value_or(0.4 * options.seconds / double(views.size()));
  std::vector<double> rests;
  rests.reserve(views.size());
  for (const model::View& view : views)
    rests.push_back(view.words.seconds ? double(*view.words.seconds) : usual);
  return rests;
}

/// Returns the scene as it turns: nothing that comes to lie before what is in focus hides it.
model::Scene turnedScene(const model::Scene& scene, const Turntable& table) {
  constexpr int some = 24;
  std::vector<model::Camera> cameras;
  cameras.reserve(some);
  for (int i = 0; i < some; ++i)
    cameras.push_back(table.at(double(i) / double(some)));
  return model::withFocusSeenFrom(scene, cameras);
}

Status checked(const FilmOptions& options, const glm::ivec2& size) {
  if (!filmSecondsLimits.contain(options.seconds))
    return Error{.reason = "a film takes 0.1 to 600 seconds", .remedy = "Choose another length"};
  if (!framesPerSecondLimits.contain(options.framesPerSecond))
    return Error{.reason = "a film has 1 to 60 frames per second", .remedy = "Choose another rate"};
  if (!filmHeightLimits.contain(size.x) || !filmHeightLimits.contain(size.y))
    return Error{.reason = "frames of " + std::to_string(size.x) + " × " + std::to_string(size.y) +
                           " pixels are none for a film",
                 .remedy = "Choose a size of which both sides have 16 to 4320 pixels"};
  return Unit{};
}

}  // namespace

int filmFrames(const FilmOptions& options) {
  return std::max(int(std::lround(options.seconds * double(options.framesPerSecond))), 1);
}

Result<Film> Film::create(const ExportOrder& order, const glm::vec2& share) {
  const FilmOptions& options = order.of<FilmOptions>();
  Film film;
  film.m_size = filmSize(order);
  TRY(checked(options, film.m_size));
  film.m_framesPerSecond = options.framesPerSecond;
  film.m_frames = filmFrames(options);
  switch (options.motion) {
    case Motion::turntable: {
      const Turntable table(order.scene, order.camera, float(film.m_size.x) / float(film.m_size.y),
                            share);
      film.m_motion = Turn{turnedScene(order.scene, table), table};
      return film;
    }
    case Motion::tour: {
      film.m_motion = TRY(tourOf(order));
      return film;
    }
    case Motion::gammaSweep: {
      film.m_motion = TRY(sweepOf(order));
      return film;
    }
  }
  return film;
}

Result<Film::Tour> Film::tourOf(const ExportOrder& order) {
  const std::vector<model::View>& views = order.scene.views();
  if (views.size() < 2)
    return Error{.reason = views.empty()
                               ? "the scene has no saved views to tour"
                               : "the scene has one saved view alone: there is no way to go",
                 .remedy = "Save views, or make a turntable"};
  const FilmOptions& options = order.of<FilmOptions>();
  const std::vector<double> rests = restsOf(views, options);
  const double resting = std::accumulate(rests.begin(), rests.end(), 0.0);
  Tour tour;
  tour.way = (options.seconds - resting) / (double(views.size()) - 1.0);
  if (tour.way <= 0.0 || options.hold.value_or(0.0) < 0.0)
    return tooLongRests(options.hold.value_or(resting), options.seconds);
  const glm::vec2 size(filmSize(order));
  const auto cameraOf = [aspect = size.x / size.y](const model::Scene& scene,
                                                   const model::View& view) {
    return fittedToPage(scene, view.camera, aspect);
  };
  model::Scene before = model::withViewApplied(order.scene, views.front()).scene;
  model::Camera from = cameraOf(before, views.front());
  for (const model::View& view : views)
    tour.said.push_back({view.name, view.words});
  tour.rests = rests;
  tour.first = {before, from, views.front().name, false, tour.restAt(0), views.front().words, 0};
  double leaves = 0.0;
  for (std::size_t i = 1; i < views.size(); ++i) {
    leaves += rests[i - 1];
    tour.leaves.push_back(leaves);
    leaves += tour.way;
    model::Scene next = model::withViewApplied(order.scene, views[i]).scene;
    const model::Camera to = cameraOf(next, views[i]);
    tour.legs.push_back({model::SceneBlend(before, next), model::CameraFlight(from, to)});
    before = std::move(next);
    from = to;
  }
  return tour;
}

Result<Film::Sweep> Film::sweepOf(const ExportOrder& order) {
  const FilmOptions& options = order.of<FilmOptions>();
  Sweep sweep{order.scene, order.camera, order.viewName, order.words, {}, 1.0 / 12.0};
  if (options.hold)
    sweep.hold = *options.hold / options.seconds;
  if (sweep.hold < 0.0 || sweep.hold >= 0.5)
    return tooLongRests(*options.hold, options.seconds);
  std::set<model::NodeId> swept;
  for (const model::NodeId id : options.swept)
    swept.merge([&] {
      const auto below = order.scene.structuresBelow(id);
      return std::set<model::NodeId>(below.begin(), below.end());
    }());
  if (options.swept.empty())
    for (const model::NodeId id : order.scene.structuresBelow(model::rootId))
      swept.insert(id);
  sweep.swept.assign(swept.begin(), swept.end());
  return sweep;
}

std::optional<std::size_t> Film::Tour::restAt(std::size_t view) const {
  return rests[view] > 0.0 ? std::optional(view) : std::nullopt;
}

FilmFrame Film::at(int frame) const {
  if (const auto* turn = std::get_if<Turn>(&m_motion))
    // The view's name would be true only where the turn begins.
    return {turn->scene, turn->table.at(double(frame) / double(m_frames)), {}, true, {}};
  if (const auto* tour = std::get_if<Tour>(&m_motion))
    return atTime(*tour, double(frame) / double(m_framesPerSecond));
  const double last = std::max(double(m_frames - 1), 1.0);
  return atPart(std::get<Sweep>(m_motion), double(frame) / last);
}

FilmFrame Film::atTime(const Tour& tour, double seconds) const {
  if (seconds <= tour.leaves.front())
    return tour.first;
  const auto after = std::upper_bound(tour.leaves.begin(), tour.leaves.end(), seconds);
  const auto leg = std::size_t(after - tour.leaves.begin()) - 1;
  const double part = std::clamp((seconds - tour.leaves[leg]) / tour.way, 0.0, 1.0);
  // Where a way begins, the one before has ended, exactly at its view.
  const bool arrived = part <= 0.0 && leg > 0;
  const std::size_t now = arrived ? leg - 1 : leg;
  const double way = arrived ? 1.0 : part;
  const std::size_t view = way < 0.5 ? now : now + 1;
  const Said& said = tour.said[view];
  const bool moving = way > 0.0 && way < 1.0;
  return {tour.legs[now].blend.at(way),
          tour.legs[now].flight.at(way),
          said.name,
          moving,
          moving ? std::nullopt : tour.restAt(now + 1),
          said.words,
          view};
}

std::vector<FilmCue> Film::cues() const {
  const double end = double(m_frames) / double(m_framesPerSecond);
  if (const auto* sweep = std::get_if<Sweep>(&m_motion))
    return {{0.0, end, sweep->words}};
  std::vector<FilmCue> cues;
  if (const auto* tour = std::get_if<Tour>(&m_motion))
    for (std::size_t i = 0; i < tour->said.size(); ++i)
      cues.push_back({i == 0 ? 0.0 : cues.back().end,
                      i < tour->leaves.size() ? tour->leaves[i] + 0.5 * tour->way : end,
                      tour->said[i].words});
  return cues;
}

FilmFrame Film::atPart(const Sweep& sweep, double part) const {
  const double moving =
      std::clamp((part - sweep.hold) / std::max(1.0 - 2.0 * sweep.hold, 1e-9), 0.0, 1.0);
  FilmFrame frame{sweep.scene, sweep.camera, sweep.viewName, false, {}, sweep.words};
  // Locks protect from edits, not from being looked at, so the nodes are set directly.
  std::vector<model::Node> nodes = sweep.scene.nodes();
  for (model::Node& node : nodes)
    if (std::binary_search(sweep.swept.begin(), sweep.swept.end(), node.id))
      node.style.gamma = Gamma::clamped(float(5.0 * moving));
  frame.scene.setNodes(std::move(nodes));
  return frame;
}

}  // namespace sline::render
