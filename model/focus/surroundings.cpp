// SPDX-License-Identifier: Apache-2.0
#include "model/focus/surroundings.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "model/geometry/sight.h"

namespace sline::model {

namespace {

constexpr std::size_t targetSamples = 256;
/// Surfaces lie against each other where they are nearer than this factor times the targets' size:
/// segmentations leave a voxel between neighbours.
constexpr float againstShare = 0.1f;
constexpr float endless = std::numeric_limits<float>::infinity();

/// Returns the directions to the points of a lattice on a cube's surface with 2n + 1 points along
/// an edge; each mirror image of the set is the set itself.
std::vector<glm::vec3> directionsAround(int n) {
  std::vector<glm::vec3> directions;
  for (int x = -n; x <= n; ++x)
    for (int y = -n; y <= n; ++y)
      for (int z = -n; z <= n; ++z)
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == n)
          directions.push_back(glm::normalize(glm::vec3(x, y, z)));
  return directions;
}

/// Returns the directions from which the targets are looked at: a cube's sides, edges and corners.
const std::vector<glm::vec3>& sides() {
  static const std::vector<glm::vec3> directions = directionsAround(1);
  return directions;
}

/// Returns the directions along which the extents are measured.
const std::vector<glm::vec3>& sectors() {
  static const std::vector<glm::vec3> directions = directionsAround(3);
  return directions;
}

std::size_t sectorOf(const glm::vec3& direction) {
  const auto& all = sectors();
  std::size_t best = 0;
  float most = glm::dot(all.front(), direction);
  for (std::size_t i = 1; i < all.size(); ++i)
    if (const float along = glm::dot(all[i], direction); along > most) {
      most = along;
      best = i;
    }
  return best;
}

bool blocks(const Party& party, const Ray& ray) {
  const Ray rest = keptPart(ray, party.planes);
  return rest.nearest <= rest.farthest && party.form->tree->blocked(rest);
}

float boxDistance(const Box& box, const glm::vec3& place) {
  return glm::length(glm::max(glm::max(box.low - place, place - box.high), 0.0f));
}

float boxDistance(const Box& a, const Box& b) {
  return glm::length(glm::max(glm::max(a.low - b.high, b.low - a.high), 0.0f));
}

}  // namespace

Surroundings::Surroundings(std::span<const Party> parties, std::span<const Camera> cameras)
    : m_parties(parties) {
  double area = 0.0;
  double thickness = 0.0;
  for (const Party& party : parties)
    if (party.target && party.form->area > 0.0) {
      m_targets.push_back(&party);
      area += party.form->area;
      thickness += party.form->area * double(party.form->thickness);
    }
  if (!(area > 0.0))
    return;
  m_radius = float(std::sqrt(area / (4.0 * M_PI)));
  m_thickness = float(thickness / area);
  for (const Party* target : m_targets) {
    // Each target gets samples by its share of the surface, so that the order of targets does not
    // matter.
    const double share = target->form->area / area;
    const auto count = std::size_t(std::ceil(double(targetSamples) * share));
    for (const SurfaceSample& sample : surfaceSamples(*target->mesh, count))
      if (keptByAll(target->planes, sample.place))
        m_samples.push_back(sample);
    m_box.add(target->mesh->bounds());
  }
  if (m_samples.empty())
    return;
  glm::dvec3 sum(0.0);
  for (const SurfaceSample& sample : m_samples)
    sum += glm::dvec3(sample.place);
  m_centre = glm::vec3(sum / double(m_samples.size()));
  measureExtents();
  if (cameras.empty())
    castFromAllSides();
  else
    castFromCameras(cameras);
}

void Surroundings::castSight(std::size_t side, const SurfaceSample& sample,
                             const glm::vec3& direction, float farthest) {
  const float facing = glm::dot(sample.normal, direction);
  if (!(facing > 0.0f))
    return;
  const Ray ray{sample.place, direction, 1e-3f * m_radius, farthest};
  if (std::any_of(m_targets.begin(), m_targets.end(),
                  [&](const Party* target) { return blocks(*target, ray); }))
    return;
  m_sights.push_back({ray, facing, side});
  m_shown[side] += double(facing);
}

void Surroundings::castFromAllSides() {
  m_shown.assign(sides().size(), 0.0);
  for (std::size_t side = 0; side < sides().size(); ++side)
    for (const SurfaceSample& sample : m_samples)
      castSight(side, sample, sides()[side], endless);
}

void Surroundings::castFromCameras(std::span<const Camera> cameras) {
  m_shown.assign(cameras.size(), 0.0);
  for (std::size_t side = 0; side < cameras.size(); ++side) {
    const Camera& camera = cameras[side];
    const bool eye = camera.projection == Projection::perspective;
    for (const SurfaceSample& sample : m_samples)
      castSight(side, sample, towardsEye(camera, sample.place),
                eye ? glm::length(camera.eye - sample.place) : endless);
  }
}

void Surroundings::measureExtents() {
  m_extents.assign(sectors().size(), {});
  const auto reach = [this](const glm::vec3& place) {
    const glm::vec3 away = place - m_centre;
    return std::pair(sectorOf(away), glm::length(away));
  };
  for (const Party& party : m_parties)
    for (const SurfaceSample& sample : party.form->samples)
      if (keptByAll(party.planes, sample.place)) {
        const auto [sector, length] = reach(sample.place);
        m_extents[sector].scene = std::max(m_extents[sector].scene, length);
      }
  for (const SurfaceSample& sample : m_samples) {
    const auto [sector, length] = reach(sample.place);
    m_extents[sector].targets = std::max(m_extents[sector].targets, length);
  }
}

float Surroundings::distanceTo(const glm::vec3& place, float farthest) const {
  float nearest = endless;
  for (const Party* target : m_targets) {
    const float within = std::min(nearest, farthest);
    if (boxDistance(target->mesh->bounds(), place) < within)
      nearest = std::min(nearest, target->form->tree->closest(place, 0.0f, within).distance);
  }
  return nearest;
}

bool Surroundings::isWithin(const glm::vec3& place, float distance) const {
  return std::any_of(m_targets.begin(), m_targets.end(), [&](const Party* target) {
    return boxDistance(target->mesh->bounds(), place) < distance &&
           target->form->tree->isWithin(place, distance);
  });
}

float Surroundings::hiding(const Party& party) const {
  std::vector<double> hidden(m_shown.size(), 0.0);
  for (const Sight& sight : m_sights)
    if (blocks(party, sight.ray))
      hidden[sight.side] += double(sight.weight);
  double most = 0.0;
  for (std::size_t i = 0; i < hidden.size(); ++i)
    if (m_shown[i] > 0.0)
      most = std::max(most, hidden[i] / m_shown[i]);
  return float(most);
}

float Surroundings::outsideness(const Party& party) const {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SurfaceSample& sample : party.form->samples) {
    if (!keptByAll(party.planes, sample.place))
      continue;
    const glm::vec3 away = sample.place - m_centre;
    const Extent& extent = m_extents[sectorOf(away)];
    const float room = extent.scene - extent.targets;
    ++count;
    if (room > 0.0f)
      sum += double(std::clamp((glm::length(away) - extent.targets) / room, 0.0f, 1.0f));
  }
  return count > 0 ? float(sum / double(count)) : 0.0f;
}

float Surroundings::roomBeyond(const Party& party, float within) const {
  std::vector<float> rooms;
  for (const SurfaceSample& sample : party.form->samples)
    if (keptByAll(party.planes, sample.place) && isWithin(sample.place, within)) {
      const glm::vec3 away = sample.place - m_centre;
      rooms.push_back((m_extents[sectorOf(away)].scene - glm::length(away)) / m_radius);
    }
  if (rooms.empty())
    return 0.0f;
  const auto middle = rooms.begin() + std::ptrdiff_t(rooms.size() / 2);
  std::nth_element(rooms.begin(), middle, rooms.end());
  return *middle;
}

Facts Surroundings::factsOf(const Party& party) const {
  Facts facts{.gap = endless};
  // The likeliest to be nearest come first, so that most of the others need not be asked.
  std::vector<std::pair<float, std::size_t>> places;
  for (std::size_t i = 0; i < party.form->samples.size(); ++i)
    if (const glm::vec3& place = party.form->samples[i].place; keptByAll(party.planes, place))
      places.emplace_back(boxDistance(m_box, place), i);
  if (places.empty())
    return facts;
  std::sort(places.begin(), places.end());
  for (const auto& [least, i] : places) {
    if (least >= facts.gap)
      break;
    facts.gap = std::min(facts.gap, distanceTo(party.form->samples[i].place, facts.gap));
  }
  const float against = againstShare * m_radius;
  std::size_t touched = 0;
  for (const SurfaceSample& sample : m_samples) {
    touched += party.form->tree->isWithin(sample.place, against);
    if (boxDistance(party.mesh->bounds(), sample.place) < facts.gap)
      facts.gap =
          std::min(facts.gap, party.form->tree->closest(sample.place, 0.0f, facts.gap).distance);
  }
  facts.contact = float(touched) / float(m_samples.size());
  facts.hides = hiding(party);
  facts.outside = outsideness(party);
  return facts;
}

float gapBetween(const Form& a, const Form& b, float enough) {
  float gap = endless;
  const auto measure = [&](const Form& from, const Form& to) {
    for (const SurfaceSample& sample : from.samples) {
      const float within = std::min(gap, enough);
      if (boxDistance(to.mesh->bounds(), sample.place) < within)
        gap = std::min(gap, to.tree->closest(sample.place, 0.0f, within).distance);
    }
  };
  if (boxDistance(a.mesh->bounds(), b.mesh->bounds()) >= enough)
    return gap;
  measure(a, b);
  measure(b, a);
  return gap;
}

}  // namespace sline::model
