// SPDX-License-Identifier: Apache-2.0
// Finds where links in texts lead.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/scene/markup.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Tells which structure or group a link lights up, or to which view it goes: a place among the
/// scene's views, from 0.
using LinkTarget = std::variant<NodeId, std::size_t>;

/// Returns what else is called so, as in other languages.
using OtherNames = std::function<std::vector<std::string>(const std::string& name)>;

/// Returns where a link leads; nothing where the scene has no such thing, and its words are plain.
/// Structures and groups are found by their name, as `Scene::named` compares, or by other names of
/// theirs; views by their number from 1, their name, or their title in any language.
std::optional<LinkTarget> linkTarget(const MarkupLink& link, const Scene& scene,
                                     const OtherNames& others = {});

}  // namespace sline::model
