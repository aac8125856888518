// SPDX-License-Identifier: Apache-2.0
#include "model/focus/kin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "model/anatomy/kin_names.h"

namespace sline::model {

namespace {

/// Tells whether structures of that tissue whose names differ by a number alone are one family.
/// Branches of vessels are not: each goes its own way.
bool comesInFamilies(Tissue tissue) {
  return tissue == Tissue::bone || tissue == Tissue::joint || tissue == Tissue::organ ||
         tissue == Tissue::muscle;
}

/// Returns the larger of two roles in the order in which they decide how kin is drawn: kin of which
/// one member hides the targets is a shell.
ContextRole stronger(ContextRole a, ContextRole b) {
  constexpr std::array order{ContextRole::target, ContextRole::shell, ContextRole::feeder,
                             ContextRole::neighbour, ContextRole::backdrop};
  return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b) ? a
                                                                                             : b;
}

void unite(std::span<Relation* const> kin) {
  Relation most = *kin.front();
  for (const Relation* each : kin) {
    if (stronger(each->role, most.role) == each->role && each->role != most.role) {
      most.role = each->role;
      most.reason = each->reason;
      most.through = each->through;
    }
    most.gapMm = std::min(most.gapMm, each->gapMm);
    most.gap = std::min(most.gap, each->gap);
    most.contact = std::max(most.contact, each->contact);
    most.feeding = std::max(most.feeding, each->feeding);
    most.nearness = std::max(most.nearness, each->nearness);
    most.hides = std::max(most.hides, each->hides);
    most.outside = std::min(most.outside, each->outside);
    most.size = std::max(most.size, each->size);
    if (most.tissue == Tissue::unknown)
      most.tissue = each->tissue;
  }
  for (Relation* each : kin) {
    most.structure = each->structure;
    *each = most;
  }
}

using Pairs = std::map<std::string, std::array<const Node*, 2>>;

/// The plane that mirrors left to right: normal · place = offset for the places on it.
struct Middle {
  glm::vec3 normal{1.0f, 0.0f, 0.0f};
  float offset = 0.0f;
};

float medianOf(std::vector<float> values) {
  const auto half = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), half, values.end());
  return *half;
}

/// Holds a plane across that direction, and how far from it the middles of pairs are.
struct Candidate {
  Middle middle;
  float residual = 0.0f;
};

Candidate across(const glm::vec3& normal, const std::vector<glm::vec3>& centres) {
  Candidate plane{.middle = {.normal = normal}};
  std::vector<float> values;
  values.reserve(centres.size());
  for (const glm::vec3& centre : centres)
    values.push_back(glm::dot(normal, centre));
  plane.middle.offset = medianOf(values);
  for (float& value : values)
    value = std::abs(value - plane.middle.offset);
  plane.residual = medianOf(std::move(values));
  return plane;
}

/// Returns the plane halfway between the members of the pairs: the sagittal one or, where a body
/// lies askew so that it fits better, the one across their mean direction. Absent where there are
/// no pairs.
std::optional<Middle> middleOf(const Pairs& pairs) {
  glm::vec3 ways(0.0f);
  std::vector<glm::vec3> centres;
  for (const auto& [name, pair] : pairs)
    if (pair[0] && pair[1]) {
      const glm::vec3 left = pair[0]->mesh->bounds().centre();
      const glm::vec3 right = pair[1]->mesh->bounds().centre();
      ways += left - right;
      centres.push_back(0.5f * (left + right));
    }
  if (centres.empty())
    return std::nullopt;
  const Candidate sagittal = across(Middle().normal, centres);
  if (!(glm::length(ways) > 0.0f))
    return sagittal.middle;
  const Candidate askew = across(glm::normalize(ways), centres);
  return askew.residual < sagittal.residual ? askew.middle : sagittal.middle;
}

/// Tells whether the targets lie on the body's middle, which they do where no pair tells it.
bool onTheMiddle(const Scene& scene, std::span<const Relation> relations, const Pairs& pairs) {
  const std::optional<Middle> middle = middleOf(pairs);
  if (!middle)
    return true;
  bool left = false;
  bool right = false;
  bool any = false;
  for (const Relation& relation : relations)
    if (relation.role == ContextRole::target)
      for (const glm::vec3& place : scene.find(relation.structure)->mesh->positions()) {
        const bool beyond = glm::dot(middle->normal, place) > middle->offset;
        left = left || beyond;
        right = right || !beyond;
        any = true;
      }
  return !any || (left && right);
}

}  // namespace

void treatKinAlike(const Scene& scene, std::span<Relation> relations) {
  std::vector<KinName> names;
  Pairs pairs;
  for (const Relation& relation : relations) {
    const Node* node = scene.find(relation.structure);
    names.push_back(kinName(node->name));
    if (names.back().side != Side::none)
      pairs[names.back().pair][names.back().side == Side::left ? 0 : 1] = node;
  }
  const bool middle = onTheMiddle(scene, relations, pairs);
  std::map<std::string, std::vector<Relation*>> kin;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    Relation& relation = relations[i];
    if (relation.role == ContextRole::target)
      continue;
    const bool family = comesInFamilies(relation.tissue) && !names[i].family.empty();
    if (!family && names[i].side == Side::none)
      continue;
    const std::string side = middle || names[i].side == Side::none ? ""
                             : names[i].side == Side::left         ? "l "
                                                                   : "r ";
    kin[side + (family ? names[i].family : names[i].pair)].push_back(&relation);
  }
  for (const auto& [name, members] : kin)
    unite(members);
}

}  // namespace sline::model
