// SPDX-License-Identifier: Apache-2.0
// Reading JSON that nobody vouches for: each value knows its place, the first thing that is wrong
// is remembered with it, and what nobody asked for is handed back.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/base/units.h"

namespace sline::model {

/// Keys sorted: an object of a million keys takes no more than its share of time.
using Json = nlohmann::json;

struct JsonLimits {
  std::size_t bytes = std::size_t(128) << 20;
  std::size_t values = 4'000'000;
  std::size_t keysOfObject = 4096;
  int depth = 64;
};

/// The text as a value; the error's `where` is a byte ("byte 84").
Result<Json> parseJson(std::string_view text, const JsonLimits& limits = {});

/// The double that prints with no more digits than the float needs, so that 0.1f is written 0.1;
/// made a float again it is the same bit for bit. The value must be finite.
double jsonNumber(float value);

/// Returns [x, y, z].
nlohmann::ordered_json jsonPoint(const glm::vec3& p);

/// The first thing that is wrong, and where: "nodes[3].style.gamma".
struct JsonFault {
  std::string where;
  std::string reason;
  bool any() const { return !reason.empty(); }
};

/// A value and the way to it. The value, the fault and the value above must outlive it. A value of
/// the wrong kind counts as zero or empty and is noted as the fault.
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
  /// Notes the reason, where nothing was noted before.
  void fail(std::string_view reason) const;

  std::string text() const;
  /// Finite, and exactly the float that was written (see jsonNumber).
  float number() const;
  /// Finite.
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
  /// "#rrggbb".
  Colour colour() const;
  /// Which of the names it is; absent where it is none of them.
  std::optional<std::size_t> oneOf(std::span<const std::string_view> names) const;

  /// Calls visit(JsonValue) for each element of a list until something is wrong.
  template <class Visit>
  void forEach(const Visit& visit) const {
    if (!m_json->is_array())
      return fail("a list is expected here");
    for (std::size_t i = 0; i < m_json->size() && !m_fault->any(); ++i)
      visit(JsonValue((*m_json)[i], *this, i));
  }

 private:
  const Json* m_json;
  JsonFault* m_fault;
  const JsonValue* m_above = nullptr;
  std::string_view m_key;
  std::size_t m_index = 0;
};

/// An object whose keys are taken one by one.
class JsonObject {
 public:
  explicit JsonObject(const JsonValue& value);
  JsonObject(const JsonObject&) = delete;
  JsonObject& operator=(const JsonObject&) = delete;

  const JsonValue& value() const { return m_value; }
  /// Absent where there is no such key. `key` must outlive the value: a literal.
  std::optional<JsonValue> take(std::string_view key);
  /// A null with a fault where there is no such key.
  JsonValue need(std::string_view key);
  /// Takes a value that is one of the names, and returns which; absent where there is no such key.
  /// Any other word is a fault, but in a file of a newer schema, where it is given back.
  std::optional<std::size_t> takeChoice(std::string_view key,
                                        std::span<const std::string_view> names, bool newer);
  /// Puts back what was left of a value that was taken.
  void giveBack(std::string_view key, Json rest);
  /// What was not taken: an object, or null where that is nothing.
  Json rest() const;
  /// The same as text, empty where that is nothing.
  std::string unread() const;

 private:
  JsonValue m_value;
  std::vector<std::string_view> m_taken;
  Json m_back;
};

}  // namespace sline::model
