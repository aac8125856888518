// SPDX-License-Identifier: Apache-2.0
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

template <class T>
void answerField(T& resolved, const std::optional<T>& own) {
  if (own)
    resolved = *own;
}
template <class T>
void answerField(std::optional<T>& resolved, const std::optional<T>& own) {
  resolved = own;
}

/// Converts to an answer of any type.
struct AnyAnswer {
  template <class T>
  operator std::optional<T>() const;
};

template <class... Answers>
consteval std::size_t styleMembers() {
  if constexpr (requires { Style{Answers()..., AnyAnswer()}; })
    return styleMembers<Answers..., AnyAnswer>();
  else
    return sizeof...(Answers);
}

consteval std::size_t styleRows() {
  std::size_t count = 0;
  forEachStyleField([&count](const auto&) { ++count; });
  return count;
}
static_assert(styleRows() == styleMembers(), "a field of Style has no row");
}  // namespace

void inherit(Style& style, const Style& above) {
  forEachLookField([&](const auto& field) {
    if (!(style.*field.own))
      style.*field.own = above.*field.own;
  });
}

void answer(ResolvedStyle& resolved, const Style& style) {
  forEachLookField(
      [&](const auto& field) { answerField(resolved.*field.resolved, style.*field.own); });
}

void patch(Style& style, const Style& patch) {
  forEachStyleField([&](const auto& field) {
    if (patch.*field.own)
      style.*field.own = patch.*field.own;
  });
}

void forget(Style& style, const Style& which) {
  forEachStyleField([&](const auto& field) {
    if (which.*field.own)
      (style.*field.own).reset();
  });
}

Style picked(const Style& style, const Style& which) {
  Style some;
  forEachStyleField([&](const auto& field) {
    if (which.*field.own)
      some.*field.own = style.*field.own;
  });
  return some;
}

Style answersOf(const ResolvedStyle& resolved) {
  Style style;
  forEachStyleField([&](const auto& field) { style.*field.own = resolved.*field.resolved; });
  return style;
}

Style wholeLook() {
  Style look;
  forEachLookField([&](const auto& field) { (look.*field.own).emplace(); });
  return look;
}

std::string camelCase(std::string_view key) {
  std::string name;
  bool begins = false;
  for (const char c : key) {
    if (c != '_')
      name += begins ? char(c - 'a' + 'A') : c;
    begins = c == '_';
  }
  return name;
}

}  // namespace sline::model
