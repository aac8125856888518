// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/style_flags.h"

#include <array>
#include <type_traits>

#include "app/cli/flags/values.h"
#include "model/scene/style_fields.h"

namespace sline::cli {

namespace {

template <const auto& Field>
Result<model::Style> parseStyleField(std::string_view what, std::string_view text) {
  using Value = typename std::remove_cvref_t<decltype(Field)>::Value;
  const Result<float> number = parseWithin(what, text, Field.limits());
  if (!number)
    return number.error();
  model::Style style;
  if constexpr (std::is_same_v<Value, float>)
    style.*Field.own = *number;
  else
    style.*Field.own = Value::clamped(*number);
  return style;
}

constexpr std::array fieldFlags{
    StyleFlag{.flag = "--pen",
              .value = "[NAME=]W",
              .help = "How wide lines are, 0 to 10 times the usual, of all (--pen 1.5), of a "
                      "structure or of all in a group",
              .what = "pen",
              .parse = parseStyleField<model::style_fields::penWeight>},
    StyleFlag{.flag = "--hatch-density",
              .value = "[NAME=]D",
              .help = "How many strokes hatching has, 0 to 4 times the usual; they get thinner as "
                      "they become more, and its tone stays",
              .what = "hatch density",
              .parse = parseStyleField<model::style_fields::hatchDensity>},
    StyleFlag{.flag = "--hatch-tone",
              .value = "[NAME=]T",
              .help = "How dark hatching is, 0 to 4 times the usual, by the width of strokes",
              .what = "hatch tone",
              .parse = parseStyleField<model::style_fields::hatchTone>}};

}  // namespace

std::span<const StyleFlag> styleFlags() {
  return fieldFlags;
}

}  // namespace sline::cli
