// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "model/focus/analysis.h"
#include "widgets/session/session.h"

namespace sline::widgets {

struct RoleRow {
  model::ContextRole role;
  QString text;    ///< one of the kind
  QString plural;  ///< a heading over several
};

/// In the order in which they are listed.
std::vector<RoleRow> roleRows();

/// Why the structure has its role, as a sentence.
QString reasonText(Session& session, const model::Relation& relation);

}  // namespace sline::widgets
