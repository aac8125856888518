// SPDX-License-Identifier: Apache-2.0
// Describes settings as values: preferences and the options of exports and imports are fields, and
// their controls are made of them (control.h).
#pragma once

#include <QString>
#include <QVariant>
#include <variant>
#include <vector>

namespace sline::widgets {

/// A choice is one of several values.
struct Choice {
  QString id;  ///< in settings and in tests
  QString text;
};

/// Describes a box to tick, with a `bool` as its value.
struct SwitchField {};
/// Describes a list of choices, with a choice's id as its value.
struct ChoiceField {
  std::vector<Choice> choices;
};
/// Describes a number, with a `double` as its value; both limits are allowed.
struct NumberField {
  double low = 0.0;
  double high = 100.0;
  int decimals = 0;
  double step = 1.0;
  QString unit;        ///< after the number, such as "s"
  QString lowestText;  ///< shown instead of the lowest number, such as "Never"; may be empty
};
/// Describes one or several lines of text, with a `QString` as its value.
struct TextField {
  int longest = 200;
  int lines = 1;
};
using FieldKind = std::variant<SwitchField, ChoiceField, NumberField, TextField>;

struct Field {
  QString id;    ///< the control's objectName
  QString text;  ///< plain, "&" before the letter of its key
  QString tip;
  FieldKind kind;
};

/// Returns whether the field can have the value, which may come from a settings file.
bool allows(const FieldKind& kind, const QVariant& value);

}  // namespace sline::widgets
