// SPDX-License-Identifier: Apache-2.0
// Puts into words which rules a ramp breaks.
#include <array>
#include <cstdio>

#include "render/measures/ramp.h"

namespace sline::render {

namespace {

std::string number(double value, int decimals) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string percent(double share, int decimals = 0) {
  return number(100.0 * share, decimals) + " %";
}

/// Returns "3.10–3.35, 3.80–3.90": neighbouring stretches of 0.1 become one.
std::string stretches(const std::vector<double>& starts) {
  std::string text;
  for (std::size_t i = 0; i < starts.size();) {
    std::size_t last = i;
    while (last + 1 < starts.size() && starts[last + 1] - starts[last] < 0.075)
      ++last;
    text += (text.empty() ? "" : ", ") + number(starts[i], 2) + "–" + number(starts[last] + 0.1, 2);
    i = last + 1;
  }
  return text;
}

}  // namespace

std::vector<std::string> faults(const Ramp& ramp) {
  std::vector<std::string> found;
  for (std::size_t s = 0; s < ramp.stages.size(); ++s) {
    const RampStage& stage = ramp.stages[s];
    const std::string name = std::to_string(s) + "–" + std::to_string(s + 1) + ": ";
    if (stage.jumps())
      found.push_back(name + "jumps by " + number(stage.largest, 1) +
                      " times the mean at Γ = " + number(stage.largestAt, 2));
    if (stage.stalls())
      found.push_back(name + "nearly nothing changes in Γ = " + stretches(stage.dead) +
                      " (at worst " + percent(stage.weakest) + " of the mean rate)");
  }
  if (ramp.tone.tooDark())
    found.push_back("tone: " + percent(1.0 - ramp.tone.lowest, 1) +
                    " darker at Γ = " + number(ramp.tone.lowestAt, 2) + " than at Γ = 5");
  if (ramp.tone.turnsBack())
    found.push_back("tone: " + percent(ramp.tone.bump.height, 1) + " lighter at Γ = " +
                    number(rampGamma(ramp.tone.bump.at).value(), 2) + " than before and after");
  if (ramp.fill.falls())
    found.push_back("fill: opacity falls by " + number(ramp.fill.largestFall, 3) +
                    " at Γ = " + number(ramp.fill.fallAt, 2));
  if (ramp.fill.incomplete())
    found.push_back("fill: " + percent(ramp.fill.openAtEnd, 1) +
                    " of the structure is not filled at Γ = 5");
  return found;
}

}  // namespace sline::render
