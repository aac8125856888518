// SPDX-License-Identifier: Apache-2.0
// What a person can set, described as a value: preferences, the options of exports and those of
// imports are fields, and their controls are made of them (control.h).
#pragma once

#include <QString>
#include <QVariant>
#include <variant>
#include <vector>

namespace sline::widgets {

/// One of several values.
struct Choice {
  QString id;  ///< in settings and of tests
  QString text;
};

/// A box to tick. Its value is a `bool`.
struct SwitchField {};
/// Its value is a choice's id.
struct ChoiceField {
  std::vector<Choice> choices;
};
/// Its value is a `double`; both limits are allowed.
struct NumberField {
  double low = 0.0;
  double high = 100.0;
  int decimals = 0;
  double step = 1.0;
  QString unit;        ///< behind the number: "s"
  QString lowestText;  ///< instead of the lowest number: "Never"; may be empty
};
/// A line of text, or several. Its value is a `QString`.
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
