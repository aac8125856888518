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
  const float number = TRY(parseWithin(what, text, Field.limits()));
  model::Style style;
  if constexpr (std::is_same_v<Value, float>)
    style.*Field.own = number;
  else
    style.*Field.own = Value::clamped(number);
  return style;
}

template <const auto& Field>
Result<model::Style> parseStyleChoice(std::string_view what, std::string_view text) {
  using Value = typename std::remove_cvref_t<decltype(Field)>::Value;
  const std::size_t place = TRY(parseName(model::namesOf(Value()), what, text));
  model::Style style;
  style.*Field.own = Value(place);
  return style;
}

constexpr std::array fieldFlags{
    StyleFlag{.flag = "--pen",
              .value = "[NAME=]W",
              .help = "How wide lines are, 0 to 10 times the usual, of all (--pen 1.5), of a "
                      "structure or of all in a group",
              .what = "pen",
              .parse = parseStyleField<model::style_fields::penWeight>},
    StyleFlag{.flag = "--line-variation",
              .value = "[NAME=]V",
              .help = "How much the pen's width tells light, depth and form, 0 (an even pen) to 1",
              .what = "line variation",
              .parse = parseStyleField<model::style_fields::lineVariation>},
    StyleFlag{.flag = "--line-smoothing",
              .value = "[NAME=]S",
              .help = "How far lines leave what turns back and forth, 0 to 2 times the usual",
              .what = "line smoothing",
              .parse = parseStyleField<model::style_fields::lineSmoothing>},
    StyleFlag{.flag = "--shortest-line",
              .value = "[NAME=]L",
              .help = "The shortest piece of a line that is drawn, in 1/720 of the picture's "
                      "height, 0 to 40 (usually 8)",
              .what = "shortest line",
              .parse = parseStyleField<model::style_fields::shortestLine>},
    StyleFlag{.flag = "--line-scale",
              .value = "[NAME=]S",
              .help = "How large a form must be in the picture to get suggestive contours, 0 (as "
                      "measured) to 2 times the usual",
              .what = "line scale",
              .parse = parseStyleField<model::style_fields::lineScale>},
    StyleFlag{.flag = "--hidden-lines",
              .value = "[NAME=]none|thin|dashed",
              .help = "How outlines are drawn where other structures hide them",
              .what = "hidden lines",
              .parse = parseStyleChoice<model::style_fields::hiddenLines>},
    StyleFlag{.flag = "--technique",
              .value = "[NAME=]sline|confis|apparent_ridges|ridges|photic|laplacian|demarcating|"
                       "highlights|streamline_hatching|noise_lic",
              .help = "What draws the form within contours: suggestive contours and hatching "
                      "(sline, the usual), short streamlines along contours and where the "
                      "curvature has an extremum (confis), long ones that tell light and shade "
                      "(streamline_hatching) or noise drawn out along them, in pixels alone "
                      "(noise_lic), from Γ = 1 to 3, or lines that these "
                      "are compared with, from Γ = 1 to 2: apparent ridges, ridges and valleys, "
                      "photic extremum lines, Laplacian lines, demarcating curves, suggestive and "
                      "principal highlights",
              .what = "technique",
              .parse = parseStyleChoice<model::style_fields::technique>},
    StyleFlag{.flag = "--halo",
              .value = "[NAME=]H",
              .help = "How many pens before its outline lines behind a structure stop, 0 to 4",
              .what = "halo",
              .parse = parseStyleField<model::style_fields::halo>},
    StyleFlag{.flag = "--grain",
              .value = "[NAME=]G",
              .help = "How much the pen is a pencil on rough paper, 0 to 1",
              .what = "grain",
              .parse = parseStyleField<model::style_fields::grain>},
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
