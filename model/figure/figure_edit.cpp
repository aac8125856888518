// SPDX-License-Identifier: Apache-2.0
#include "model/figure/figure_edit.h"

#include <algorithm>

namespace sline::model {

namespace {

/// The panel that each panel refers to.
using Links = std::vector<std::optional<std::size_t>>;

std::string* linkOf(FigurePanel& panel) {
  if (panel.inset)
    return &panel.inset->of;
  return panel.camera && !panel.camera->like.empty() ? &panel.camera->like : nullptr;
}

Links linksOf(const Figure& figure) {
  Links links;
  for (FigurePanel panel : figure.panels) {
    const std::string* letter = linkOf(panel);
    links.push_back(letter ? panelOfLetter(figure, *letter) : std::nullopt);
  }
  return links;
}

/// Returns the figure with those of its panels in that order, their links kept.
Figure inOrder(const Figure& figure, const std::vector<std::size_t>& order) {
  const Links links = linksOf(figure);
  Figure ordered = figure;
  ordered.panels.clear();
  for (const std::size_t from : order)
    ordered.panels.push_back(figure.panels[from]);
  const std::vector<std::string> letters = lettersOf(ordered);
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::string* link = linkOf(ordered.panels[i]);
    if (!link || !links[order[i]])
      continue;
    const auto now = std::find(order.begin(), order.end(), *links[order[i]]);
    if (now != order.end())
      *link = letters[std::size_t(now - order.begin())];
    else
      ordered.panels[i].camera.reset();
  }
  return ordered;
}

std::vector<std::size_t> allOf(const Figure& figure) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    order.push_back(i);
  return order;
}

}  // namespace

Figure figureOf(const Scene& scene, const std::string& file) {
  Figure figure{.scene = file};
  for (const View& view : scene.views())
    if (figure.panels.size() < mostPanels)
      figure.panels.push_back({.view = view.name});
  if (figure.panels.empty())
    figure.panels = {{.view = "anterior"}, {.view = "left"}};
  if (figure.panels.size() == 1)
    figure.columns = {1.0f};
  return figure;
}

Figure withPanel(const Figure& figure, const FigurePanel& panel) {
  Figure more = figure;
  if (more.panels.size() < mostPanels)
    more.panels.push_back(panel);
  return more;
}

Figure withoutPanel(const Figure& figure, std::size_t index) {
  const Links links = linksOf(figure);
  std::vector<bool> gone(figure.panels.size());
  gone[index] = true;
  // Insets of insets go as well.
  for (std::size_t round = 0; round < gone.size(); ++round)
    for (std::size_t i = 0; i < gone.size(); ++i)
      gone[i] = gone[i] || (figure.panels[i].inset && links[i] && gone[*links[i]]);
  std::vector<std::size_t> order = allOf(figure);
  std::erase_if(order, [&gone](std::size_t i) { return gone[i]; });
  return inOrder(figure, order);
}

Figure withPanelMoved(const Figure& figure, std::size_t index, std::size_t to) {
  std::vector<std::size_t> order = allOf(figure);
  order.erase(order.begin() + std::ptrdiff_t(index));
  order.insert(order.begin() + std::ptrdiff_t(std::min(to, order.size())), index);
  return inOrder(figure, order);
}

Figure withInset(const Figure& figure, std::size_t of, const FigureBox& part) {
  return withPanel(figure, {.inset = PanelInset{.of = lettersOf(figure)[of], .part = part}});
}

std::optional<FigureBox> insetPlace(const FigureBox& part, const glm::vec2& panelMm) {
  constexpr float share = 0.36f;
  constexpr float margin = 1.0f;
  const float times = share * std::min(panelMm.x / part.size.x, panelMm.y / part.size.y);
  const glm::vec2 size = times * part.size;
  if (std::min(size.x, size.y) < leastPanelMm)
    return std::nullopt;
  return FigureBox{{panelMm.x - size.x - margin, margin}, size};
}

std::vector<std::size_t> camerasFor(const Figure& figure, std::size_t index) {
  const Links links = linksOf(figure);
  const std::vector<std::string> letters = lettersOf(figure);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < links.size(); ++i) {
    std::optional<std::size_t> at = i;
    for (std::size_t step = 0; at && at != index && step < links.size(); ++step)
      at = links[*at];
    if (!at && !letters[i].empty())
      free.push_back(i);
  }
  return free;
}

}  // namespace sline::model
