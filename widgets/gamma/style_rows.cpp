// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/style_rows.h"

#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

float number(float value) {
  return value;
}
template <class T>
float number(const T& value) {
  return value.value();
}

template <class T>
T made(float value) {
  if constexpr (std::is_same_v<T, float>)
    return value;
  else
    return T::clamped(value);
}

template <auto Seen>
float seen(const model::ResolvedStyle& style) {
  return number(style.*Seen);
}

template <auto Own>
std::optional<float> own(const model::Style& style) {
  const auto& field = style.*Own;
  return field ? std::optional<float>(number(*field)) : std::nullopt;
}

template <auto Own>
model::Style look(float value) {
  model::Style style;
  using Field = std::remove_reference_t<decltype(style.*Own)>;
  style.*Own = made<typename Field::value_type>(value);
  return style;
}

/// Own and Seen are the field of a style and of one with all answered.
template <auto Own, auto Seen>
StyleNumber with(StyleNumber row) {
  row.value = seen<Seen>;
  row.own = own<Own>;
  row.look = look<Own>;
  return row;
}

}  // namespace

std::vector<StyleNumber> styleNumbers() {
  using model::ResolvedStyle;
  using model::Style;
  // A square gives the usual, 1 of 4, the slider's middle.
  return {with<&Style::penWeight, &ResolvedStyle::penWeight>(
              {.id = QStringLiteral("penWeight"),
               .text = tr("Line width"),
               .tip = tr("How wide lines are, times the usual; 0 draws none"),
               .high = 4.0,
               .power = 2.0}),
          with<&Style::hatchDensity, &ResolvedStyle::hatchDensity>(
              {.id = QStringLiteral("hatchDensity"),
               .text = tr("Hatching: strokes"),
               .tip = tr("How many strokes hatching has, times the usual; its tone stays"),
               .high = 4.0,
               .power = 2.0}),
          with<&Style::hatchTone, &ResolvedStyle::hatchTone>(
              {.id = QStringLiteral("hatchTone"),
               .text = tr("Hatching: tone"),
               .tip = tr("How dark hatching is, times the usual, by the width of its strokes"),
               .high = 4.0,
               .power = 2.0}),
          with<&Style::opacity, &ResolvedStyle::opacity>(
              {.id = QStringLiteral("opacity"),
               .text = tr("Opacity"),
               .tip = tr("How much of what lies behind the colour is hidden; lines stay"),
               .unit = tr(" %"),
               .shown = 100.0,
               .high = 100.0,
               .step = 5.0,
               .decimals = 0})};
}

std::vector<StyleColour> styleColours() {
  return {{QStringLiteral("colour"), tr("Colour"), tr("Of the shaded surface and of washes"),
           &model::Style::colour,
           [](const model::ResolvedStyle& s) { return std::optional<Colour>(s.colour); }},
          {QStringLiteral("inkColour"), tr("Ink"),
           tr("Of lines and hatching; else black, or light on a dark background"),
           &model::Style::inkColour, [](const model::ResolvedStyle& s) { return s.inkColour; }}};
}

std::vector<StyleField> styleFields() {
  model::Style gamma;
  gamma.gamma = Gamma();
  model::Style fill;
  fill.fill = model::Fill::none;
  std::vector<StyleField> fields{{QStringLiteral("gamma"), tr("Γ"), gamma},
                                 {QStringLiteral("fill"), tr("Fill"), fill}};
  for (const StyleNumber& row : styleNumbers())
    fields.push_back({row.id, row.text, row.look(0.0f)});
  for (const StyleColour& row : styleColours()) {
    model::Style which;
    which.*row.field = Colour();
    // What a structure is drawn like goes for others too, what colour it has hardly ever.
    fields.push_back({row.id, row.text, which, false});
  }
  return fields;
}

}  // namespace sline::widgets
