// SPDX-License-Identifier: Apache-2.0
#include "model/figure/figure.h"

#include <algorithm>

#include "model/base/letters.h"

namespace sline::model {

std::vector<std::string> lettersOf(const Figure& figure) {
  std::vector<std::string> letters;
  char next = 'a';
  for (const FigurePanel& panel : figure.panels) {
    std::string letter = panel.letter.value_or("");
    if (!panel.letter && !(panel.inset && panel.inset->inside) && next <= 'z')
      letter = std::string(1, next++);
    if (figure.letters == PanelLetters::upper && !panel.letter && !letter.empty())
      letter.front() = char(letter.front() - 'a' + 'A');
    letters.push_back(letter);
  }
  return letters;
}

std::optional<std::size_t> panelOfLetter(const Figure& figure, std::string_view letter) {
  const std::vector<std::string> letters = lettersOf(figure);
  const std::string wanted = lowerCase(letter);
  if (!wanted.empty())
    for (std::size_t i = 0; i < letters.size(); ++i)
      if (lowerCase(letters[i]) == wanted)
        return i;
  return std::nullopt;
}

const std::string& sceneOf(const Figure& figure, const FigurePanel& panel) {
  return panel.scene.empty() ? figure.scene : panel.scene;
}

bool usualLabels(const Figure& figure, std::size_t) {
  return figure.labels;
}

bool usualScaleBar(const Figure& figure, std::size_t index) {
  const auto first = std::find_if(figure.panels.begin(), figure.panels.end(),
                                  [](const FigurePanel& each) { return !each.inset; });
  return figure.scaleBars && (!figure.sameScale || figure.panels[index].inset ||
                              index == std::size_t(first - figure.panels.begin()));
}

bool usualSides(const Figure& figure, std::size_t index) {
  return figure.sides && !figure.panels[index].inset;
}

std::string panelName(const Figure& figure, std::size_t index) {
  const std::string letter = lettersOf(figure).at(index);
  if (!letter.empty())
    return "panel " + letter;
  const auto& inset = figure.panels[index].inset;
  return "panel " + std::to_string(index + 1) + (inset ? ", an inset of " + inset->of : "");
}

}  // namespace sline::model
