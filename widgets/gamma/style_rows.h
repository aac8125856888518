// SPDX-License-Identifier: Apache-2.0
// Lists the numbers and colours of a style that the panel sets, as a table.
#pragma once

#include <QString>
#include <vector>

#include "model/edit/look.h"
#include "model/edit/moved_look.h"

namespace sline::widgets {

/// Describes a number of a style.
struct StyleNumber {
  QString id;
  QString text;
  QString tip;
  QString unit;        ///< after the number; may be empty
  double shown = 1.0;  ///< the factor from the style's own number to the one the user reads
  double high = 1.0;   ///< as shown; the lowest is 0
  double step = 0.05;  ///< as shown
  int decimals = 2;
  double power = 1.0;       ///< of the slider: more than 1 gives small numbers more room
  model::LookNumber field;  ///< the number as the style has it, up to `high`
};
std::vector<StyleNumber> styleNumbers();

/// Describes a field of a style that has one of a few values.
struct StyleChoice {
  QString id;
  QString text;
  QString tip;
  std::vector<QString> names;  ///< of the values, in their order
  /// Returns the value's place among the names.
  int (*value)(const model::ResolvedStyle&) = nullptr;
  bool (*own)(const model::Style&) = nullptr;
  model::Style (*look)(int) = nullptr;
};
std::vector<StyleChoice> styleChoices();

/// Describes a colour of a style.
struct StyleColour {
  QString id;
  QString text;
  QString tip;
  std::optional<Colour> model::Style::*field = nullptr;
  /// Returns the colour; empty where it goes with the background.
  std::optional<Colour> (*value)(const model::ResolvedStyle&) = nullptr;
};
std::vector<StyleColour> styleColours();

/// Describes a field that presets hold beside Γ and fill, for asking which to keep and for writing
/// them down.
struct StyleField {
  QString id;
  QString text;
  model::Style which;  ///< has only this field set
  bool usual = true;   ///< kept unless the user says otherwise
};
std::vector<StyleField> styleFields();

}  // namespace sline::widgets
