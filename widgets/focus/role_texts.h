// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "model/focus/analysis.h"
#include "widgets/session/session.h"

namespace sline::widgets {

struct RoleRow {
  model::ContextRole role;
  QString text;    ///< for one structure of the role
  QString plural;  ///< a heading over several
};

/// Returns the roles in the order in which they are listed.
std::vector<RoleRow> roleRows();

/// Returns a sentence on why the structure has its role.
QString reasonText(Session& session, const model::Relation& relation);

/// Returns how the structure is drawn and why: "solid: bone near the subject".
QString mannerText(const model::Relation& relation, bool drawn);

/// Returns the subject of a plate by its English title.
QString subjectText(Session& session, const std::string& title);

}  // namespace sline::widgets
