// SPDX-License-Identifier: Apache-2.0
// Describes each choice that the user has about an export once. The command line's flags with their
// help, the dialog's rows, the settings and the checks of both are made from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "model/base/result.h"
#include "model/base/units.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// A value of an option; that of a choice is an `int`, from the enumeration of its field.
using OptionValue = std::variant<bool, int, double, std::string>;

/// Describes one of several values. Without a text it exists only on the command line.
struct OptionChoice {
  const char* id = "";  ///< as typed after the flag, and in settings
  const char* text = nullptr;
  int value = 0;
};
struct SwitchOption {};
struct ChoiceOption {
  std::span<const OptionChoice> choices;
};
/// Bounds a number; both limits are allowed.
struct NumberOption {
  double low = 0.0;
  double high = 100.0;
  int decimals = 0;  ///< 0: a whole number
  double step = 1.0;
  const char* unit = "";  ///< "px", after the number
};
struct TextOption {
  int longest = 200;      ///< characters
  int lines = 1;          ///< shown at once; more than 1: the text has paragraphs
  bool fromFile = false;  ///< the command line also accepts the name of a file with the text
};
using OptionKind = std::variant<SwitchOption, ChoiceOption, NumberOption, TextOption>;

/// Tells where an option belongs: to all pictures, or to the kinds that name it.
enum class OptionGroup { picture, labels, marks, kind, credit };

/// Binds an option to a field of the order. `write` expects the alternative that `read` gives.
struct OptionField {
  OptionValue (*read)(const ExportOrder& order) = nullptr;
  void (*write)(ExportOrder& order, const OptionValue& value) = nullptr;
};

/// Describes an option completely. Texts are English; `title`, `tip` and those of choices are
/// translated in the context "sline::render::ExportOption".
struct ExportOption {
  const char* id = "";  ///< in settings; the dialog's control is named "export-" and this
  OptionGroup group = OptionGroup::kind;
  const char* flag =
      "";  ///< flag of `sline export`, as "--grey,--gray"; of marks: their name in --marks
  const char* value = "";       ///< what is typed after the flag, as "PIXELS"; of choices their ids
  const char* help = "";        ///< help text of the flag
  const char* title = nullptr;  ///< in the dialog; null: the option exists only on the command line
  const char* tip = "";         ///< in the dialog
  OptionKind kind = SwitchOption{};
  OptionField field = {};
  bool kept = true;  ///< kept from one session to the next
  /// Tells whether the option means anything beside the others that were chosen; null: always.
  bool (*applies)(const ExportOrder& order) = nullptr;
};

/// Lists options in the order in which the user should meet them.
using OptionList = std::span<const ExportOption* const>;

/// Describes a number within limits that the writer has.
template <class Number>
constexpr NumberOption numberWithin(const Limits<Number>& limits, int decimals, double step,
                                    const char* unit) {
  return {double(limits.low), double(limits.high), decimals, step, unit};
}

template <class T>
OptionValue optionValue(const T& value) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>)
    return value;
  else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>)
    return int(value);
  else
    return double(value);
}

template <class T>
T fromOptionValue(const OptionValue& value) {
  if constexpr (std::is_same_v<T, std::string>)
    return std::get<std::string>(value);
  else
    return std::visit(
        [](const auto& held) -> T {
          if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::string>)
            return T{};
          else
            return T(held);
        },
        value);
}

/// Binds an option to the field that `Access` names: `boundTo([](auto& o) -> auto& { … })`.
template <class Access>
constexpr OptionField boundTo(Access) {
  return {[](const ExportOrder& order) { return optionValue(Access{}(order)); },
          [](ExportOrder& order, const OptionValue& value) {
            auto& field = Access{}(order);
            field = fromOptionValue<std::decay_t<decltype(field)>>(value);
          }};
}

/// Reads the value that was typed or kept as text: a choice's id, "true" or "false", a number with
/// a point, or the text itself. The error's reason is the end of a sentence that begins with the
/// option's name and the text: "is unknown".
Result<OptionValue> parseOption(const ExportOption& option, std::string_view text);
/// Returns the text that `parseOption` reads as that value.
std::string optionText(const ExportOption& option, const OptionValue& value);

/// Returns the ids of choices as a sentence lists them: "a, b or c".
std::string choiceList(std::span<const OptionChoice> choices);

}  // namespace sline::render
