// SPDX-License-Identifier: Apache-2.0
#include "model/focus/roles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "model/base/parallel.h"
#include "model/focus/vessel_ends.h"

namespace sline::model {

namespace {

/// Falls from 1 at `low` to 0 at `high`.
float falling(float low, float high, float x) {
  return 1.0f - glm::smoothstep(low, high, x);
}

/// Returns how tubular a form is; the share of sheets is subtracted because sheets have tubes along
/// their rims.
float tubular(const Form& form) {
  return form.tube - form.sheet;
}

/// Returns how much a form is like a branch that may come to a target: a tube far thinner than the
/// target, with less surface.
float branchLike(const Surroundings& surroundings, const Form& form) {
  const float unit = surroundings.radius();
  const auto surface = float(form.area / (4.0 * M_PI)) / (unit * unit);
  return glm::smoothstep(0.2f, 0.35f, tubular(form)) * falling(0.2f, 0.4f, form.thickness / unit) *
         falling(1.0f, 2.0f, surface);
}

/// Returns how much a form is like a stem from which such a branch may come: also a tube, away from
/// the targets and not too thick.
float stemLike(const Surroundings& surroundings, const Form& form, float gap) {
  const float unit = surroundings.radius();
  return glm::smoothstep(0.45f, 0.6f, tubular(form)) * glm::smoothstep(0.05f, 0.15f, gap / unit) *
         falling(0.55f, 0.8f, form.thickness / unit);
}

/// Returns how far from its end a vessel is cut: its gap and right through its thickness, also
/// where it is flat.
float cutWidth(const Form& vessel, float gap) {
  return gap + 2.0f * vessel.thickness;
}

float comingToTargets(const Surroundings& surroundings, const Party& party, const Facts& facts) {
  const Form& form = *party.form;
  const float unit = surroundings.radius();
  float share = branchLike(surroundings, form) * falling(0.04f, 0.1f, facts.gap / unit);
  if (share < 0.5f)
    return share;
  // A rib between an organ and the skin touches the organ as a vessel does, but there is no room
  // behind it.
  share *= glm::smoothstep(0.2f, 0.5f, surroundings.roomBeyond(party, facts.gap + 0.05f * unit));
  if (share < 0.5f)
    return share;
  const float near = cutWidth(form, facts.gap);
  const Cut cut = cutNear(*party.mesh, near, [&](const glm::vec3& place, float distance) {
    return surroundings.isWithin(place, distance);
  });
  // A vessel that passes by serves the targets less.
  return cut.ends ? share : 0.4f * share;
}

/// Returns how surely `branch`, which comes to a target, comes from `stem`.
float comingFrom(const Surroundings& surroundings, float likely, const Party& stem,
                 const Party& branch) {
  // Blood comes to a vessel from a thicker one.
  constexpr float thicker = 1.5f;
  if (stem.form->thickness < thicker * branch.form->thickness)
    return 0.0f;
  const float touch = std::max(0.05f * surroundings.radius(), 0.5f * branch.form->thickness);
  const float gap = gapBetween(*stem.form, *branch.form, 3.0f * touch);
  const float share = likely * falling(1.0f, 3.0f, gap / touch);
  if (share < 0.5f)
    return share;
  const float near = cutWidth(*branch.form, gap);
  const Cut cut = cutNear(*branch.mesh, near, [&](const glm::vec3& place, float distance) {
    return stem.form->tree->isWithin(place, distance);
  });
  // A vessel that lies along another does not spring from it.
  constexpr double most = 0.6;
  return cut.ends && cut.share <= most ? share : 0.0f;
}

}  // namespace

std::vector<Feeding> feedings(const Surroundings& surroundings, std::span<const Party> parties,
                              std::span<const Facts> facts, const std::stop_token& stop) {
  std::vector<Feeding> found(parties.size());
  parallelFor(parties.size(), 1, [&](std::size_t i) {
    if (!parties[i].target && parties[i].mayFeed && !stop.stop_requested())
      found[i].direct = comingToTargets(surroundings, parties[i], facts[i]);
  });
  parallelFor(parties.size(), 1, [&](std::size_t i) {
    const float likely = stemLike(surroundings, *parties[i].form, facts[i].gap);
    if (parties[i].target || !parties[i].mayFeed || found[i].direct >= 0.5f || likely < 0.5f)
      return;
    for (std::size_t k = 0; k < parties.size() && !stop.stop_requested(); ++k) {
      if (k == i || found[k].direct < 0.5f)
        continue;
      const float share = comingFrom(surroundings, likely, parties[i], parties[k]);
      if (share > found[i].stem) {
        found[i].stem = share;
        found[i].through = parties[k].id;
      }
    }
  });
  return found;
}

namespace {

/// Tells whether a structure is a shell: it is wide, hides part of the targets, and the scene ends
/// behind it. A structure with much of itself against the targets is beside them rather than around
/// them.
bool isShell(const Relation& r) {
  constexpr float something = 0.1f;
  return r.hides >= something &&
         glm::smoothstep(1.2f, 1.8f, r.size) * glm::smoothstep(0.5f, 0.7f, r.outside - r.contact) >=
             0.5f;
}

void decide(Relation& relation, const Feeding& feeding) {
  constexpr float against = 0.05f;
  if (feeding.direct >= 0.5f) {
    relation.role = ContextRole::feeder;
    relation.reason = RoleReason::reaches;
  } else if (feeding.stem >= 0.5f) {
    relation.role = ContextRole::feeder;
    relation.reason = RoleReason::feedsStem;
    relation.through = feeding.through;
  } else if (isShell(relation)) {
    relation.role = ContextRole::shell;
    relation.reason = RoleReason::hides;
  } else if (relation.nearness >= 0.5f) {
    relation.role = ContextRole::neighbour;
    relation.reason = relation.gap <= against ? RoleReason::touches : RoleReason::near;
  }
}

}  // namespace

Relation relationOf(const Surroundings& surroundings, const Party& party, const Facts& facts,
                    const Feeding& feeding) {
  const float unit = surroundings.radius();
  Relation relation{.structure = party.id,
                    .gapMm = facts.gap,
                    .gap = facts.gap / unit,
                    .contact = facts.contact,
                    .feeding = std::max(feeding.direct, 0.7f * feeding.stem),
                    .nearness = falling(0.15f, 0.6f, facts.gap / unit),
                    .hides = facts.hides,
                    .outside = facts.outside,
                    .size = party.form->radius / unit};
  if (party.target) {
    relation.role = ContextRole::target;
    relation.reason = RoleReason::chosen;
  } else {
    decide(relation, feeding);
  }
  return relation;
}

}  // namespace sline::model
