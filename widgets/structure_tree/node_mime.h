// SPDX-License-Identifier: Apache-2.0
// Packs nodes that move within the tree into the form that Qt's drag and drop carries.
#pragma once

#include <optional>

#include "widgets/session/session.h"

class QMimeData;

namespace sline::widgets {

inline constexpr const char* nodeMimeType = "application/x-sline-nodes";

/// Returns the nodes' data, which the caller owns.
QMimeData* nodesAsMime(const Session& session, const NodeIds& ids);
/// Returns the nodes; none where the data are of another kind, or of another session's scene.
std::optional<NodeIds> nodesFromMime(const Session& session, const QMimeData& data);

}  // namespace sline::widgets
