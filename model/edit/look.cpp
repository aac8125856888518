// SPDX-License-Identifier: Apache-2.0
#include "model/edit/look.h"

#include "model/edit/styled_nodes.h"

namespace sline::model {

namespace {

template <class Body>
void forEachField(const Body& body) {
  body(&Style::colour);
  body(&Style::inkColour);
  body(&Style::gamma);
  body(&Style::opacity);
  body(&Style::fill);
  body(&Style::visible);
  body(&Style::penWeight);
  body(&Style::hatchDensity);
  body(&Style::hatchTone);
}

/// Clears what `which` answers.
void forget(Style& style, const Style& which) {
  forEachField([&](auto field) {
    if (which.*field)
      (style.*field).reset();
  });
}

}  // namespace

Edited withLook(const Scene& scene, std::span<const NodeId> ids, const Style& look) {
  return withStyles(scene, ids, [&look](Style& style, bool named) {
    if (named)
      patch(style, look);
    else
      forget(style, look);
  });
}

Edited withLookInherited(const Scene& scene, std::span<const NodeId> ids, const Style& which) {
  return withStyles(scene, ids, [&which](Style& style, bool) { forget(style, which); });
}

Style picked(const Style& style, const Style& which) {
  Style some;
  forEachField([&](auto field) {
    if (which.*field)
      some.*field = style.*field;
  });
  return some;
}

Style lookOf(const Scene& scene, NodeId id) {
  const ResolvedStyle seen = scene.resolve(id);
  return {.colour = seen.colour,
          .inkColour = seen.inkColour,
          .gamma = seen.gamma,
          .opacity = seen.opacity,
          .fill = seen.fill,
          .visible = seen.visible,
          .penWeight = seen.penWeight,
          .hatchDensity = seen.hatchDensity,
          .hatchTone = seen.hatchTone};
}

}  // namespace sline::model
