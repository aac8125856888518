// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/scene/node_id.h"
#include "model/scene/style.h"

namespace sline::model {

/// Says how a node is shown: the style's answers replace the node's own, all others stay.
struct Look {
  NodeId node;
  Style style;
  std::string unread;  ///< like Node::unread
  bool operator==(const Look&) const = default;
};

}  // namespace sline::model
