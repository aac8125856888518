// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/role_texts.h"

#include <QLocale>
#include <cmath>

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

QString distanceText(const model::Relation& relation) {
  if (!std::isfinite(relation.gapMm))
    return tr("Cut away");
  const double mm = double(relation.gapMm);
  return tr("%1 mm away").arg(QLocale().toString(mm, 'f', mm < 10.0 ? 1 : 0));
}

QString firstClause(Session& session, const model::Relation& relation) {
  switch (relation.reason) {
    case RoleReason::chosen:
      return tr("Chosen");
    case RoleReason::reaches:
      return tr("Thin and long, comes to it");
    case RoleReason::feedsStem:
      return tr("Where %1 comes from").arg(nameOf(session, relation.through));
    case RoleReason::touches:
      return tr("Lies against it");
    case RoleReason::hides:
      return tr("Lies outside, %1").arg(distanceText(relation));
    case RoleReason::near:
    case RoleReason::far:
      break;
  }
  return distanceText(relation);
}

}  // namespace

std::vector<RoleRow> roleRows() {
  return {{ContextRole::target, tr("In focus"), tr("In focus")},
          {ContextRole::feeder, tr("Vessel or duct"), tr("Vessels and ducts")},
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
