// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/technique_list.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

namespace {

struct Publication {
  const char* name;
  const char* authors;
  int year;
};

/// In the order of `model::Technique`; full titles stand at the techniques' own headers.
constexpr std::array<Publication, model::techniqueNames.size()> publications{
    {{"Suggestive contours", "DeCarlo et al.", 2003},
     {"ConFIS", "Lawonn et al.", 2013},
     {"Apparent ridges", "Judd et al.", 2007},
     {"Ridges and valleys", "Ohtake et al.", 2004},
     {"Photic extremum lines", "Xie et al.", 2007},
     {"Laplacian lines", "Zhang et al.", 2011},
     {"Demarcating curves", "Kolomenkin et al.", 2008},
     {"Highlight lines", "DeCarlo, Rusinkiewicz", 2007},
     {"Streamline hatching", "Zander et al.", 2004},
     {"Noise LIC", "Lawonn et al.", 2014}}};

std::string shortNumber(float value) {
  std::array<char, 32> text{};
  const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

/// Adds the thresholds of lines; those of two kinds that have one name are one.
void addThresholds(const LineTechnique& lines, TechniqueFacts& facts) {
  for (std::size_t i = 0; i < lines.thresholds.size(); ++i) {
    const LineThreshold& own = lines.thresholds[i];
    const std::string name = std::string(facts.id) + "." + own.id;
    const auto known =
        std::find_if(facts.thresholds.begin(), facts.thresholds.end(),
                     [&](const TechniqueThreshold& other) { return other.name == name; });
    if (known != facts.thresholds.end())
      known->kinds.add(lines.kind);
    else
      facts.thresholds.push_back({.name = name,
                                  .id = own.id,
                                  .meaning = own.meaning,
                                  .usual = own.usual,
                                  .limits = own.limits,
                                  .kinds = {lines.kind},
                                  .which = i});
  }
}

std::vector<TechniqueFacts> makeList() {
  std::vector<TechniqueFacts> list;
  for (std::size_t i = 0; i < publications.size(); ++i) {
    TechniqueFacts facts{.technique = model::Technique(i),
                         .id = model::techniqueNames[i],
                         .name = publications[i].name,
                         .authors = publications[i].authors,
                         .year = publications[i].year,
                         .whole = {},
                         .thresholds = {}};
    float whole = 2.0f;
    for (const LineTechnique& lines : lineTechniques())
      if (lines.drawnBy == facts.technique) {
        addThresholds(lines, facts);
        while (lines.entered(Gamma::clamped(whole)) < 1.0f && whole < Gamma::high)
          whole += 1.0f;
      }
    facts.whole = Gamma::clamped(whole);
    list.push_back(std::move(facts));
  }
  return list;
}

const TechniqueThreshold* thresholdNamed(std::string_view name) {
  for (const TechniqueFacts& facts : techniqueList())
    for (const TechniqueThreshold& threshold : facts.thresholds)
      if (threshold.name == name || facts.id == name)
        return &threshold;
  return nullptr;
}

std::string allNames() {
  std::string names;
  for (const TechniqueFacts& facts : techniqueList())
    for (const TechniqueThreshold& threshold : facts.thresholds)
      names += (names.empty() ? "" : ", ") + threshold.name;
  return names;
}

}  // namespace

std::string TechniqueFacts::citation() const {
  return std::string(authors) + " " + std::to_string(year);
}

std::span<const TechniqueFacts> techniqueList() {
  static const std::vector<TechniqueFacts> list = makeList();
  return list;
}

LineKinds kindsOf(model::Technique technique) {
  LineKinds kinds{};
  for (const LineTechnique& lines : lineTechniques())
    if (lines.drawnBy == technique)
      kinds.add(lines.kind);
  return kinds;
}

float valueOf(const TechniqueThreshold& threshold, const model::ThresholdValues& values) {
  const float value = values.of(threshold.name).value_or(threshold.usual);
  return std::clamp(value, threshold.limits.low, threshold.limits.high);
}

LineThresholds lineThresholds(const model::ThresholdValues& values) {
  LineThresholds thresholds;
  if (values.empty())
    return thresholds;
  for (const TechniqueFacts& facts : techniqueList())
    for (const TechniqueThreshold& threshold : facts.thresholds)
      for (const LineTechnique& lines : lineTechniques())
        if (threshold.kinds.has(lines.kind))
          thresholds.set(lines.kind, threshold.which, valueOf(threshold, values));
  return thresholds;
}

Result<model::ThresholdValue> parseThresholdValue(std::string_view text) {
  const std::size_t sign = text.find('=');
  const std::string name(text.substr(0, sign));
  const TechniqueThreshold* threshold = thresholdNamed(name);
  if (!threshold)
    return Error{.reason = "\"" + name + "\" is no threshold of lines",
                 .remedy = "There are: " + allNames()};
  const std::string_view number =
      sign == std::string_view::npos ? std::string_view() : text.substr(sign + 1);
  float value = 0.0f;
  const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (number.empty() || failure != std::errc{} || end != number.data() + number.size() ||
      !threshold->limits.contain(value))
    return Error{.reason = "\"" + std::string(text) + "\" is no value of " + threshold->name,
                 .remedy = "Write " + threshold->name + "=" + shortNumber(threshold->usual) +
                           ", or another number from " + shortNumber(threshold->limits.low) +
                           " to " + shortNumber(threshold->limits.high)};
  return model::ThresholdValue{threshold->name, value};
}

std::string thresholdHelp() {
  std::string text;
  for (const TechniqueFacts& facts : techniqueList())
    for (const TechniqueThreshold& threshold : facts.thresholds)
      text += (text.empty() ? "" : "; ") + threshold.name + " (" + threshold.meaning +
              "; usually " + shortNumber(threshold.usual) + ")";
  return text;
}

}  // namespace sline::render
