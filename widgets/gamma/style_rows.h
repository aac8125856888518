// SPDX-License-Identifier: Apache-2.0
// The numbers and colours of a style that the panel sets, as a table.
#pragma once

#include <QString>
#include <vector>

#include "model/edit/look.h"

namespace sline::widgets {

/// A number of a style.
struct StyleNumber {
  QString id;
  QString text;
  QString tip;
  QString unit;        ///< behind the number; may be empty
  double shown = 1.0;  ///< times the style's own number is what a person reads
  double high = 1.0;   ///< as shown; the lowest is 0
  double step = 0.05;  ///< as shown
  int decimals = 2;
  double power = 1.0;  ///< of the slider: more than 1 gives small numbers more room
  /// As the style has it.
  float (*value)(const model::ResolvedStyle&) = nullptr;
  std::optional<float> (*own)(const model::Style&) = nullptr;
  model::Style (*look)(float) = nullptr;
};
std::vector<StyleNumber> styleNumbers();

/// A colour of a style.
struct StyleColour {
  QString id;
  QString text;
  QString tip;
  std::optional<Colour> model::Style::*field = nullptr;
  /// Nothing where it goes with the background.
  std::optional<Colour> (*value)(const model::ResolvedStyle&) = nullptr;
};
std::vector<StyleColour> styleColours();

/// What presets hold, beside Γ and fill; for asking what is to be kept and for writing them down.
struct StyleField {
  QString id;
  QString text;
  model::Style which;  ///< answers the field
  bool usual = true;   ///< kept unless somebody says otherwise
};
std::vector<StyleField> styleFields();

}  // namespace sline::widgets
