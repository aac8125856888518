// SPDX-License-Identifier: Apache-2.0
// Reads JSON that is not trusted: each value knows its place, the first fault is remembered with
// its place, and unused keys are handed back.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"

namespace sline::model {

/// Holds JSON with sorted keys, so that an object of a million keys takes no more than its share of
/// time.
using Json = nlohmann::json;

struct JsonLimits {
  std::size_t bytes = std::size_t(128) << 20;
  std::size_t values = 4'000'000;
  std::size_t keysOfObject = 4096;
  int depth = 64;
};

/// Parses the text; the error's `where` is a byte ("byte 84").
Result<Json> parseJson(std::string_view text, const JsonLimits& limits = {});

/// Returns the double that prints with no more digits than the float needs, so that 0.1f is written
/// 0.1; converted back to float it is the same bit for bit. The value must be finite.
double jsonNumber(float value);

/// Returns [x, y, z].
nlohmann::ordered_json jsonPoint(const glm::vec3& p);

/// Says what is wrong, and where: "nodes[3].style.gamma".
struct JsonRefusal {
  std::string where;
  std::string reason;

  /// Returns it as one line.
  std::string text() const { return where + (where.empty() ? "" : ": ") + reason; }
  bool operator==(const JsonRefusal&) const = default;
};

/// Collects what is wrong. Reading ends at the first fault, unless `all` is there to take each:
/// then it goes on, and who reads leaves out what is at fault.
struct JsonFault : JsonRefusal {
  std::vector<JsonRefusal>* all = nullptr;
  std::size_t count = 0;

  bool any() const { return count > 0; }
  bool ends() const { return any() && !all; }
};
/// The most faults that are told one by one.
inline constexpr std::size_t mostToldFaults = 1000;

/// Tells whether all was well with what was read since.
class FaultWatch {
 public:
  explicit FaultWatch(const JsonFault& fault) : m_fault(&fault), m_before(fault.count) {}
  bool clean() const { return m_fault->count == m_before; }

 private:
  const JsonFault* m_fault;
  std::size_t m_before;
};

/// Holds a value and the path to it. The value, the fault and the value above must outlive it. A
/// value of the wrong kind counts as zero or empty and is noted as the fault.
class JsonValue {
 public:
  JsonValue(const Json& json, JsonFault& fault) : m_json(&json), m_fault(&fault) {}
  JsonValue(const Json& json, const JsonValue& above, std::string_view key)
      : m_json(&json), m_fault(above.m_fault), m_above(&above), m_key(key) {}
  JsonValue(const Json& json, const JsonValue& above, std::size_t index)
      : m_json(&json), m_fault(above.m_fault), m_above(&above), m_index(index) {}

  const Json& json() const { return *m_json; }
  JsonFault& fault() const { return *m_fault; }
  std::string place() const;
  /// Notes the reason: the first one of all, and each where all are collected.
  void fail(std::string_view reason) const;

  std::string text() const;
  /// Returns a finite number, exactly the float that was written (see jsonNumber).
  float number() const;
  /// Returns a finite number.
  double real() const;
  std::int64_t whole(std::int64_t low, std::int64_t high) const;
  bool flag() const;
  glm::vec3 point() const;
  /// Returns a list of exactly that many numbers.
  template <std::size_t count>
  std::array<float, count> numbers() const {
    std::array<float, count> all{};
    if (!m_json->is_array() || m_json->size() != count)
      fail("a list of " + std::to_string(count) + " numbers is expected here");
    else
      for (std::size_t i = 0; i < count; ++i)
        all[i] = JsonValue((*m_json)[i], *this, i).number();
    return all;
  }
  /// Returns the colour written as "#rrggbb".
  Colour colour() const;
  /// Returns which of the names the value is; absent where it is none of them.
  std::optional<std::size_t> oneOf(std::span<const std::string_view> names) const;

  /// Calls visit(JsonValue) for each element of a list until something is wrong for good.
  template <class Visit>
  void forEach(const Visit& visit) const {
    if (!m_json->is_array())
      return fail("a list is expected here");
    for (std::size_t i = 0; i < m_json->size() && !m_fault->ends(); ++i)
      visit(JsonValue((*m_json)[i], *this, i));
  }

 private:
  const Json* m_json;
  JsonFault* m_fault;
  const JsonValue* m_above = nullptr;
  std::string_view m_key;
  std::size_t m_index = 0;
};

/// Returns what read(value) returns; absent where something was at fault on the way.
template <class Read>
auto sound(const JsonValue& value, const Read& read) -> std::optional<decltype(read(value))> {
  const FaultWatch watch(value.fault());
  auto got = read(value);
  if (!watch.clean())
    return std::nullopt;
  return got;
}

/// Sets the target to what was read, unless that was at fault.
template <class Target, class Read>
void readInto(const std::optional<JsonValue>& value, Target& target, const Read& read) {
  if (!value)
    return;
  if (auto got = sound(*value, read))
    target = std::move(*got);
}
inline constexpr auto asText = [](const JsonValue& value) { return value.text(); };
inline constexpr auto asNumber = [](const JsonValue& value) { return value.number(); };
inline constexpr auto asFlag = [](const JsonValue& value) { return value.flag(); };

/// So many keys of an object may be without a meaning here.
inline constexpr std::size_t mostUnreadKeys = 4000;

/// An object whose keys are taken one by one.
class JsonObject {
 public:
  explicit JsonObject(const JsonValue& value);
  JsonObject(const JsonObject&) = delete;
  JsonObject& operator=(const JsonObject&) = delete;

  const JsonValue& value() const { return m_value; }
  /// Takes the value of the key; absent where there is no such key. `key` must outlive the value: a
  /// literal.
  std::optional<JsonValue> take(std::string_view key);
  /// Takes the value of the key, or returns a null with a fault where there is no such key.
  JsonValue need(std::string_view key);
  /// Takes a value that is one of the names, and returns which; absent where there is no such key.
  /// Any other word is a fault, except in a file of a newer schema, where it is given back.
  std::optional<std::size_t> takeChoice(std::string_view key,
                                        std::span<const std::string_view> names, bool newer);
  /// Puts back the rest of a value that was taken.
  void giveBack(std::string_view key, Json rest);
  /// Returns the keys that were not taken: an object, or null where there are none. Of more than
  /// `mostUnreadKeys` the rest is a fault, since they are written again beside what is known.
  Json rest() const;
  /// Returns the keys that were not taken as text, empty where there are none.
  std::string unread() const;

 private:
  JsonValue m_value;
  std::vector<std::string_view> m_taken;
  Json m_back;
};

}  // namespace sline::model
