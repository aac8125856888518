// SPDX-License-Identifier: Apache-2.0
// Nodes on their way from one place of the tree to another, as Qt's drag and drop carries them.
#pragma once

#include <optional>

#include "widgets/session/session.h"

class QMimeData;

namespace sline::widgets {

inline constexpr const char* nodeMimeType = "application/x-sline-nodes";

/// The caller's to keep.
QMimeData* nodesAsMime(const Session& session, const NodeIds& ids);
/// Nothing where the data are of another kind, or of another session's scene.
std::optional<NodeIds> nodesFromMime(const Session& session, const QMimeData& data);

}  // namespace sline::widgets
