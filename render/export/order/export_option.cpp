// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/export_option.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "model/base/letters.h"

namespace sline::render {

namespace {

std::string numberText(double number) {
  std::array<char, 32> text{};
  const auto [end, fault] = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), end};
}

Status parseAs(const SwitchOption&, std::string_view text, OptionValue& value) {
  if (text == "true" || text == "false") {
    value = text == "true";
    return Unit{};
  }
  return Error{.reason = "is unknown", .remedy = "Give true or false"};
}

Status parseAs(const ChoiceOption& kind, std::string_view text, OptionValue& value) {
  const auto found =
      std::find_if(kind.choices.begin(), kind.choices.end(),
                   [text](const OptionChoice& each) { return equalsIgnoringCase(text, each.id); });
  if (found != kind.choices.end()) {
    value = found->value;
    return Unit{};
  }
  return Error{.reason = "is unknown", .remedy = "Give " + choiceList(kind.choices)};
}

Status parseAs(const NumberOption& kind, std::string_view text, OptionValue& value) {
  double number = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = kind.decimals > 0 || number == std::round(number);
  if (fault == std::errc() && end == text.data() + text.size() && number >= kind.low &&
      number <= kind.high && whole) {
    if (kind.decimals > 0)
      value = number;
    else
      value = int(number);
    return Unit{};
  }
  return Error{
      .reason = whole ? "is out of range" : "is no whole number",
      .remedy = "Give a number from " + numberText(kind.low) + " to " + numberText(kind.high)};
}

Status parseAs(const TextOption& kind, std::string_view text, OptionValue& value) {
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; };
  const auto characters =
      std::ptrdiff_t(text.size()) - std::count_if(text.begin(), text.end(), continues);
  if (characters > kind.longest)
    return Error{.reason = "is too long",
                 .remedy = "Write at most " + std::to_string(kind.longest) + " characters"};
  value = std::string(text);
  return Unit{};
}

}  // namespace

Result<OptionValue> parseOption(const ExportOption& option, std::string_view text) {
  OptionValue value;
  TRY(std::visit([&](const auto& kind) { return parseAs(kind, text, value); }, option.kind));
  return value;
}

std::string optionText(const ExportOption& option, const OptionValue& value) {
  if (const auto* several = std::get_if<ChoiceOption>(&option.kind))
    for (const OptionChoice& each : several->choices)
      if (value == OptionValue(each.value))
        return each.id;
  if (const bool* on = std::get_if<bool>(&value))
    return *on ? "true" : "false";
  if (const int* number = std::get_if<int>(&value))
    return std::to_string(*number);
  if (const double* number = std::get_if<double>(&value))
    return numberText(*number);
  return std::get<std::string>(value);
}

std::string choiceList(std::span<const OptionChoice> choices) {
  std::string list;
  for (std::size_t i = 0; i < choices.size(); ++i)
    list += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + std::string(choices[i].id);
  return list;
}

}  // namespace sline::render
