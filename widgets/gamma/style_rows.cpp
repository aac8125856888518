// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/style_rows.h"

#include "model/scene/style_fields.h"
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
T fromNumber(float value) {
  if constexpr (std::is_same_v<T, float>)
    return value;
  else
    return T::clamped(value);
}

/// Completes the row of a field; the field's key gives the row's id.
template <const auto& Field>
StyleNumber with(StyleNumber row) {
  using Value = typename std::remove_cvref_t<decltype(Field)>::Value;
  row.id = QString::fromStdString(model::camelCase(Field.key));
  row.value = [](const model::ResolvedStyle& style) { return number(style.*Field.resolved); };
  row.own = [](const model::Style& style) {
    const auto& own = style.*Field.own;
    return own ? std::optional<float>(number(*own)) : std::nullopt;
  };
  row.look = [](float value) {
    model::Style style;
    style.*Field.own = fromNumber<Value>(value);
    return style;
  };
  return row;
}

template <const auto& Field>
StyleColour with(const QString& text, const QString& tip) {
  return {QString::fromStdString(model::camelCase(Field.key)), text, tip, Field.own,
          [](const model::ResolvedStyle& style) {
            return std::optional<Colour>(style.*Field.resolved);
          }};
}

}  // namespace

std::vector<StyleNumber> styleNumbers() {
  namespace fields = model::style_fields;
  // A power of 2 puts the usual value, 1 of 4, in the slider's middle.
  return {with<fields::penWeight>({.text = tr("Line width"),
                                   .tip = tr("How wide lines are, times the usual; 0 draws none"),
                                   .high = 4.0,
                                   .power = 2.0}),
          with<fields::hatchDensity>(
              {.text = tr("Hatching: strokes"),
               .tip = tr("How many strokes hatching has, times the usual; its tone stays"),
               .high = 4.0,
               .power = 2.0}),
          with<fields::hatchTone>(
              {.text = tr("Hatching: tone"),
               .tip = tr("How dark hatching is, times the usual, by the width of its strokes"),
               .high = 4.0,
               .power = 2.0}),
          with<fields::opacity>(
              {.text = tr("Opacity"),
               .tip = tr("How much of what lies behind the colour is hidden; lines stay"),
               .unit = tr(" %"),
               .shown = 100.0,
               .high = 100.0,
               .step = 5.0,
               .decimals = 0})};
}

std::vector<StyleColour> styleColours() {
  namespace fields = model::style_fields;
  return {with<fields::colour>(tr("Colour"), tr("Of the shaded surface and of washes")),
          with<fields::inkColour>(
              tr("Ink"), tr("Of lines and hatching; else black, or light on a dark background"))};
}

std::vector<StyleField> styleFields() {
  std::vector<StyleField> fields{{QStringLiteral("gamma"), tr("Γ"), {.gamma = Gamma()}},
                                 {QStringLiteral("fill"), tr("Fill"), {.fill = model::Fill::none}}};
  for (const StyleNumber& row : styleNumbers())
    fields.push_back({row.id, row.text, row.look(0.0f)});
  for (const StyleColour& row : styleColours()) {
    model::Style which;
    which.*row.field = Colour();
    // How a structure is drawn often suits others too, but its colour hardly ever does.
    fields.push_back({row.id, row.text, which, false});
  }
  return fields;
}

}  // namespace sline::widgets
