// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/style_rows.h"

#include "model/scene/style_fields.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

/// Completes the row of a field; the field's key gives the row's id.
template <const auto& Field>
StyleNumber with(StyleNumber row) {
  row.id = QString::fromStdString(model::camelCase(Field.key));
  row.field = model::lookNumber<Field>();
  row.field.limits.high = float(row.high / row.shown);
  return row;
}

template <const auto& Field>
StyleChoice with(StyleChoice row) {
  using Value = typename std::remove_cvref_t<decltype(Field)>::Value;
  row.id = QString::fromStdString(model::camelCase(Field.key));
  row.value = [](const model::ResolvedStyle& style) { return int(style.*Field.resolved); };
  row.own = [](const model::Style& style) { return (style.*Field.own).has_value(); };
  row.look = [](int value) {
    model::Style style;
    style.*Field.own = Value(value);
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
  return {with<fields::penWeight>(
              StyleNumber{.text = tr("Line width"),
                          .tip = tr("How wide lines are, times the usual; 0 draws none"),
                          .high = 4.0,
                          .power = 2.0}),
          with<fields::lineVariation>(StyleNumber{
              .text = tr("Line weight"),
              .tip = tr("How much the pen's width tells light, depth and form; 0 is an even pen"),
              .high = 1.0}),
          with<fields::lineSmoothing>(StyleNumber{
              .text = tr("Line smoothing"),
              .tip = tr("How far lines leave what turns back and forth, times the usual"),
              .high = 2.0}),
          with<fields::shortestLine>(StyleNumber{
              .text = tr("Shortest line"),
              .tip = tr("Shorter pieces of lines are left out; in 1/720 of the picture's height"),
              .high = 40.0,
              .step = 1.0,
              .decimals = 0}),
          with<fields::lineScale>(StyleNumber{
              .text = tr("Line scale"),
              .tip = tr("How large a form must be to get suggestive contours, times the usual; 0 "
                        "draws all that were measured"),
              .high = 2.0}),
          with<fields::halo>(
              StyleNumber{.text = tr("Halo"),
                          .tip = tr("How many line widths before its outline lines behind stop"),
                          .high = 4.0,
                          .step = 0.25}),
          with<fields::grain>(StyleNumber{.text = tr("Pencil grain"),
                                          .tip = tr("How much the pen is a pencil on rough paper"),
                                          .high = 1.0}),
          with<fields::hatchDensity>(StyleNumber{
              .text = tr("Hatching: strokes"),
              .tip = tr("How many strokes hatching has, times the usual; its tone stays"),
              .high = 4.0,
              .power = 2.0}),
          with<fields::hatchTone>(StyleNumber{
              .text = tr("Hatching: tone"),
              .tip = tr("How dark hatching is, times the usual, by the width of its strokes"),
              .high = 4.0,
              .power = 2.0}),
          with<fields::opacity>(StyleNumber{
              .text = tr("Opacity"),
              .tip = tr("How much of what lies behind the colour is hidden; lines stay"),
              .unit = tr(" %"),
              .shown = 100.0,
              .high = 100.0,
              .step = 5.0,
              .decimals = 0})};
}

std::vector<StyleChoice> styleChoices() {
  namespace fields = model::style_fields;
  return {
      with<fields::technique>(StyleChoice{
          .text = tr("Technique"),
          .tip = tr("What draws the form within contours: suggestive contours and hatching, or "
                    "short streamlines along contours and where the curvature has an extremum, "
                    "or lines, streamlines and noise that these are compared with"),
          .names = {tr("Sline"), tr("ConFIS"), tr("Apparent ridges"), tr("Ridges and valleys"),
                    tr("Photic extremum lines"), tr("Laplacian lines"), tr("Demarcating curves"),
                    tr("Highlights"), tr("Streamline hatching"), tr("Noise LIC")}}),
      with<fields::hiddenLines>(
          StyleChoice{.text = tr("Hidden outlines"),
                      .tip = tr("How outlines are drawn where other structures hide them"),
                      .names = {tr("Not drawn"), tr("Thin"), tr("Dashed")}})};
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
    fields.push_back({row.id, row.text, row.field.look(0.0f)});
  for (const StyleChoice& row : styleChoices())
    fields.push_back({row.id, row.text, row.look(0)});
  fields.push_back({QStringLiteral("lineThresholds"),
                    tr("Thresholds of lines"),
                    {.lineThresholds = model::ThresholdValues()}});
  // Which part of a structure is told more is said of it alone.
  fields.push_back({QStringLiteral("gammaMap"),
                    tr("Γ over the surface"),
                    {.gammaMap = model::GammaMap()},
                    false});
  for (const StyleColour& row : styleColours()) {
    model::Style which;
    which.*row.field = Colour();
    // How a structure is drawn often suits others too, but its colour hardly ever does.
    fields.push_back({row.id, row.text, which, false});
  }
  return fields;
}

}  // namespace sline::widgets
