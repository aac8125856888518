// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/role_texts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/focus/context.h"
#include "model/lengths/measured_extent.h"
#include "widgets/session/length_texts.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

using model::ContextRole;
using model::RoleReason;

QString nameOf(Session& session, model::NodeId id) {
  const model::Node* node = session.scene().find(id);
  return node ? session.names().shown(node->name) : QString();
}

QString hidesText(const model::Relation& relation) {
  return tr("hides up to %1 % of it").arg(qRound(100.0f * relation.hides));
}

/// Returns how far the structure's surface and those in focus have been moved by import, at most.
float movedBetween(const model::Scene& scene, const model::Relation& relation) {
  const auto moved = [&](model::NodeId id) {
    const model::Node* node = scene.find(id);
    return node ? model::movedMm(node->provenance) : 0.0f;
  };
  float most = 0.0f;
  for (const model::NodeId id : scene.structuresBelow(scene.focus().targets))
    most = std::max(most, moved(id));
  return most + moved(relation.structure);
}

QString distanceText(Session& session, const model::Relation& relation) {
  if (!std::isfinite(relation.gapMm))
    return tr("Cut away");
  const model::DrawnLength gap{.mm = relation.gapMm,
                               .offMm = movedBetween(session.scene(), relation)};
  return tr("%1 away").arg(lengthText(session.scene(), gap));
}

QString firstClause(Session& session, const model::Relation& relation) {
  switch (relation.reason) {
    case RoleReason::chosen:
      return tr("Chosen");
    case RoleReason::reaches:
      return tr("Thin and long, comes to it");
    case RoleReason::feedsStem:
      return tr("Where %1 comes from").arg(nameOf(session, relation.through));
    case RoleReason::supplies:
      return tr("Serves %1").arg(nameOf(session, relation.through));
    case RoleReason::touches:
      return tr("Lies against it");
    case RoleReason::hides:
      return tr("Lies outside, %1").arg(distanceText(session, relation));
    case RoleReason::near:
    case RoleReason::far:
      break;
  }
  return distanceText(session, relation);
}

QString tissueName(model::Tissue tissue) {
  using model::Tissue;
  switch (tissue) {
    case Tissue::lesion:
      return tr("lesion");
    case Tissue::organ:
      return tr("organ");
    case Tissue::vessel:
      return tr("vessel");
    case Tissue::nerve:
      return tr("nerve");
    case Tissue::bone:
      return tr("bone");
    case Tissue::joint:
      return tr("joint");
    case Tissue::muscle:
      return tr("muscle");
    case Tissue::skin:
      return tr("skin");
    case Tissue::unknown:
      break;
  }
  return tr("structure");
}

QString roleOnly(ContextRole role) {
  switch (role) {
    case ContextRole::target:
      return tr("the subject");
    case ContextRole::feeder:
      return tr("it comes to the subject");
    case ContextRole::neighbour:
      return tr("it is near the subject");
    case ContextRole::shell:
      return tr("it lies outside and hides the subject");
    case ContextRole::backdrop:
      break;
  }
  return tr("it is away from the subject");
}

}  // namespace

QString mannerText(const model::Relation& relation, bool drawn) {
  using model::ContextManner;
  if (!drawn)
    return tr("not drawn: more context would show it");
  const QString tissue = tissueName(relation.tissue);
  switch (model::mannerOf(relation)) {
    case ContextManner::detail:
      return tr("in detail: it is the subject");
    case ContextManner::host:
      return tr("solid and pale: the subject lies in it");
    case ContextManner::outline:
      return tr("outline: %1 in front of the subject").arg(tissue);
    case ContextManner::feeder:
      return tr("modelled: %1 that comes to the subject").arg(tissue);
    case ContextManner::near:
      return tr("solid: %1 near the subject").arg(tissue);
    case ContextManner::far:
      return tr("solid and pale: %1 away from the subject").arg(tissue);
    case ContextManner::byRole:
      break;
  }
  return tr("lines: %1").arg(roleOnly(relation.role));
}

QString subjectText(Session& session, const std::string& title) {
  const std::array<std::pair<const char*, QString>, 9> known{
      {{"ligands", tr("Ligands")},
       {"lesions", tr("Lesions")},
       {"organs", tr("Organs")},
       {"joints", tr("Joints")},
       {"vessels and nerves", tr("Vessels and nerves")},
       {"bones", tr("Bones")},
       {"what lies in the organs", tr("What lies in the organs")},
       {"what lies inside", tr("What lies inside")},
       {"everything", tr("Everything")}}};
  for (const auto& [english, text] : known)
    if (title == english)
      return text;
  return session.names().shown(title);
}

std::vector<RoleRow> roleRows() {
  return {{ContextRole::target, tr("In focus"), tr("In focus")},
          {ContextRole::feeder, tr("Vessel, nerve or duct"), tr("Vessels, nerves and ducts")},
          {ContextRole::neighbour, tr("Neighbour"), tr("Neighbours")},
          {ContextRole::shell, tr("Shell"), tr("Shells around it")},
          {ContextRole::backdrop, tr("Backdrop"), tr("Backdrop")}};
}

QString reasonText(Session& session, const model::Relation& relation) {
  constexpr float worthSaying = 0.05f;
  const QString first = firstClause(session, relation);
  if (relation.role == ContextRole::target || relation.hides < worthSaying)
    return first;
  return tr("%1; %2").arg(first, hidesText(relation));
}

}  // namespace sline::widgets
