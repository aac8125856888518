// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/atoms_json.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "model/scene/scene_limits.h"

namespace sline::model {

namespace {

void appendDecimal(std::string& text, float number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text += ' ';
  text.append(digits.data(), end);
}

/// Takes a number and the blanks before it off the text.
std::optional<float> takenNumber(std::string_view& text) {
  while (text.starts_with(' '))
    text.remove_prefix(1);
  float number = 0.0f;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || !std::isfinite(number))
    return std::nullopt;
  text.remove_prefix(std::size_t(end - text.data()));
  return number;
}

/// Takes the next atom off the text; nothing where its numbers are none of an atom.
std::optional<AtomBall> takenAtom(std::string_view& text) {
  std::array<float, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::optional<float> number = takenNumber(text);
    if (!number || std::abs(*number) > (i < 3 ? farthestAtom : largestAtom))
      return std::nullopt;
    numbers[i] = *number;
  }
  if (!(numbers[3] > 0.0f))
    return std::nullopt;
  return AtomBall{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

}  // namespace

nlohmann::ordered_json atomsJson(const AtomSet& atoms) {
  std::vector<std::string> texts;
  texts.reserve(atoms.residues.size());
  for (const std::string& residue : atoms.residues)
    texts.push_back(residue + " |");
  for (const AtomBall& atom : atoms.atoms) {
    std::string& text = texts[atom.residue];
    for (int axis = 0; axis < 3; ++axis)
      appendDecimal(text, atom.place[axis]);
    appendDecimal(text, atom.radius);
  }
  return texts;
}

KeptAtoms atomsFrom(const JsonValue& value) {
  auto set = std::make_shared<AtomSet>();
  value.forEach([&set](const JsonValue& residue) {
    const std::string text = residue.text();
    // A name may have a bar in it, numbers have none.
    const std::size_t bar = text.rfind(" |");
    if (bar == std::string::npos)
      return residue.fail("a residue's name, a bar and numbers are expected here");
    std::string_view numbers = std::string_view(text).substr(bar + 2);
    while (numbers.find_first_not_of(' ') != std::string_view::npos) {
      std::optional<AtomBall> atom = takenAtom(numbers);
      if (!atom)
        return residue.fail("an atom has x, y, z in millimetres and a radius above 0");
      if (set->atoms.size() >= mostKeptAtoms)
        return residue.fail("there are more than " + std::to_string(mostKeptAtoms) + " atoms");
      atom->residue = std::uint32_t(set->residues.size());
      set->atoms.push_back(*atom);
    }
    set->residues.push_back(text.substr(0, bar));
  });
  return {std::move(set)};
}

}  // namespace sline::model
