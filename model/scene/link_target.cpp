// SPDX-License-Identifier: Apache-2.0
#include "model/scene/link_target.h"

#include <algorithm>
#include <charconv>

namespace sline::model {

namespace {

std::optional<LinkTarget> namedStructure(const std::string& name, const Scene& scene,
                                         const OtherNames& others) {
  if (const std::vector<NodeId> named = scene.named(name); !named.empty())
    return named.front();
  if (!others)
    return std::nullopt;
  const std::string wanted = normalisedName(name);
  if (wanted.empty())
    return std::nullopt;
  for (const Node& node : scene.nodes())
    for (const std::string& other : others(node.name))
      if (normalisedName(other) == wanted)
        return node.id;
  return std::nullopt;
}

bool hasTitle(const View& view, const std::string& wanted) {
  const Wording& title = view.words.title;
  return normalisedName(view.name) == wanted || normalisedName(title.text) == wanted ||
         std::any_of(title.texts.begin(), title.texts.end(),
                     [&](const auto& text) { return normalisedName(text.second) == wanted; });
}

std::optional<LinkTarget> namedView(const std::string& name, const Scene& scene) {
  const std::vector<View>& views = scene.views();
  std::size_t number = 0;
  const char* last = name.data() + name.size();
  const auto [end, fault] = std::from_chars(name.data(), last, number);
  if (fault == std::errc() && end == last)
    return number >= 1 && number <= views.size() ? std::optional<LinkTarget>(number - 1)
                                                 : std::nullopt;
  const std::string wanted = normalisedName(name);
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!wanted.empty() && hasTitle(views[i], wanted))
      return i;
  return std::nullopt;
}

}  // namespace

std::optional<LinkTarget> linkTarget(const MarkupLink& link, const Scene& scene,
                                     const OtherNames& others) {
  return link.to == MarkupLink::To::view ? namedView(link.name, scene)
                                         : namedStructure(link.name, scene, others);
}

}  // namespace sline::model
