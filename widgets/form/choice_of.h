// SPDX-License-Identifier: Apache-2.0
// Offers choices that stand for values of any type; "nothing" may be one of them.
#pragma once

#include <QVariant>
#include <optional>
#include <vector>

#include "widgets/form/field.h"

namespace sline::widgets {

/// Pairs a choice with the value that it means.
template <class T>
struct ChoiceOf : Choice {
  T value;
};

/// Returns the choices alone, after one that means nothing where `none` is its text.
template <class T>
ChoiceField choiceField(const QString& none, const std::vector<ChoiceOf<T>>& choices) {
  ChoiceField field;
  if (!none.isEmpty())
    field.choices.push_back({QString(), none});
  field.choices.insert(field.choices.end(), choices.begin(), choices.end());
  return field;
}

/// Returns the value that the choice of that id means; empty where there is no such choice.
template <class T>
std::optional<T> meaningOf(const QVariant& id, const std::vector<ChoiceOf<T>>& choices) {
  for (const ChoiceOf<T>& choice : choices)
    if (id.toString() == choice.id)
      return choice.value;
  return std::nullopt;
}

/// Returns the id of the choice that means the value; an empty id for no value, none where no
/// choice means it.
template <class T>
QVariant idOf(const std::optional<T>& value, const std::vector<ChoiceOf<T>>& choices) {
  if (!value)
    return QString();
  for (const ChoiceOf<T>& choice : choices)
    if (*value == choice.value)
      return choice.id;
  return {};
}

}  // namespace sline::widgets
