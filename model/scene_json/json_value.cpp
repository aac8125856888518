// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/json_value.h"
#include "model/base/colour_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace sline::model {

namespace {

const Json nothing;

Error refusal(std::size_t byte, const std::string& reason) {
  return {.where = "byte " + std::to_string(byte), .reason = reason};
}

/// Counts brackets, commas and colons outside of texts before anything is parsed, so that a small
/// text cannot demand much time or memory.
class Census {
 public:
  explicit Census(const JsonLimits& limits) : m_limits(limits) {}

  std::optional<Error> of(std::string_view text) {
    bool inText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const char c = text[i];
      if (inText) {
        i += c == '\\';
        inText = c != '"';
      } else if (c == '"') {
        inText = true;
      } else if (!count(c)) {
        return refusal(i, m_reason);
      }
    }
    return std::nullopt;
  }

 private:
  bool count(char c) {
    if (c == '[' || c == '{') {
      if (int(m_keys.size()) >= m_limits.depth)
        return refuse("objects and lists lie more than " + std::to_string(m_limits.depth) +
                      " deep in each other");
      m_keys.push_back(0);
    } else if ((c == ']' || c == '}') && !m_keys.empty()) {
      m_keys.pop_back();
    } else if (c == ':' && !m_keys.empty() && ++m_keys.back() > m_limits.keysOfObject) {
      return refuse("an object has more than " + std::to_string(m_limits.keysOfObject) + " keys");
    }
    if ((c == ',' || c == '[' || c == '{') && ++m_values > m_limits.values)
      return refuse("there are more than " + std::to_string(m_limits.values) + " values");
    return true;
  }
  bool refuse(const std::string& reason) {
    m_reason = reason;
    return false;
  }

  JsonLimits m_limits;
  std::vector<std::size_t> m_keys;  ///< number of keys of each open object
  std::size_t m_values = 0;
  std::string m_reason;
};

/// Returns the library's message without its own number: "[json.exception.parse_error.101] parse
/// error …".
std::string plainMessage(std::string_view message) {
  const std::size_t end = message.find("] ");
  return std::string(end == std::string_view::npos ? message : message.substr(end + 2));
}

}  // namespace

Result<Json> parseJson(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    return Error{.reason = "it is larger than " + std::to_string(limits.bytes) + " bytes"};
  if (std::optional<Error> tooMuch = Census(limits).of(text))
    return *tooMuch;
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& failure) {
    return refusal(failure.byte, plainMessage(failure.what()));
  } catch (const Json::exception& failure) {
    return Error{.reason = plainMessage(failure.what())};
  }
}

double jsonNumber(float value) {
  // Where it is not finite after all, null is written, which readers refuse.
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  double nearest = double(value);
  std::from_chars(digits.data(), end, nearest);
  // A float read from those digits is this one; a double read from them and converted to float
  // could be its neighbour.
  return float(nearest) == value ? nearest : double(value);
}

nlohmann::ordered_json jsonPoint(const glm::vec3& p) {
  return nlohmann::ordered_json::array({jsonNumber(p.x), jsonNumber(p.y), jsonNumber(p.z)});
}

std::string JsonValue::place() const {
  if (!m_above)
    return {};
  const std::string above = m_above->place();
  if (m_key.empty())
    return above + "[" + std::to_string(m_index) + "]";
  return (above.empty() ? "" : above + ".") + std::string(m_key);
}

void JsonValue::fail(std::string_view reason) const {
  ++m_fault->count;
  if (m_fault->count > 1 && (!m_fault->all || m_fault->all->size() >= mostToldFaults))
    return;
  const JsonRefusal refusal{place(), std::string(reason)};
  if (m_fault->count == 1)
    static_cast<JsonRefusal&>(*m_fault) = refusal;
  if (m_fault->all)
    m_fault->all->push_back(refusal);
}

std::string JsonValue::text() const {
  if (m_json->is_string())
    return m_json->get<std::string>();
  fail("a text is expected here");
  return {};
}

float JsonValue::number() const {
  if (!m_json->is_number()) {
    fail("a number is expected here");
    return 0.0f;
  }
  const auto value = float(m_json->get<double>());
  if (!std::isfinite(value)) {
    fail("the number is too large");
    return 0.0f;
  }
  return value;
}

double JsonValue::real() const {
  if (!m_json->is_number() || !std::isfinite(m_json->get<double>())) {
    fail("a number is expected here");
    return 0.0;
  }
  return m_json->get<double>();
}

std::int64_t JsonValue::whole(std::int64_t low, std::int64_t high) const {
  const bool fits =
      m_json->is_number_integer() &&
      (!m_json->is_number_unsigned() || m_json->get<std::uint64_t>() <= std::uint64_t(INT64_MAX));
  const std::int64_t value = fits ? m_json->get<std::int64_t>() : low;
  if (fits && value >= low && value <= high)
    return value;
  fail("a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
       " is expected here");
  return low;
}

bool JsonValue::flag() const {
  if (m_json->is_boolean())
    return m_json->get<bool>();
  fail("true or false is expected here");
  return false;
}

glm::vec3 JsonValue::point() const {
  glm::vec3 p(0.0f);
  if (!m_json->is_array() || m_json->size() != 3) {
    fail("a list of three numbers is expected here");
    return p;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    p[int(axis)] = JsonValue((*m_json)[axis], *this, axis).number();
  return p;
}

Colour JsonValue::colour() const {
  const auto* text = m_json->get_ptr<const std::string*>();
  const std::optional<Colour> colour = text ? colourFrom(*text) : std::nullopt;
  if (!colour)
    fail("a colour as \"#rrggbb\" is expected here");
  return colour.value_or(Colour());
}

std::optional<std::size_t> JsonValue::oneOf(std::span<const std::string_view> names) const {
  if (!m_json->is_string())
    return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), m_json->get_ref<const std::string&>());
  if (found == names.end())
    return std::nullopt;
  return std::size_t(found - names.begin());
}

JsonObject::JsonObject(const JsonValue& value) : m_value(value) {
  if (!value.json().is_object())
    value.fail("an object is expected here");
}

std::optional<JsonValue> JsonObject::take(std::string_view key) {
  if (!m_value.json().is_object())
    return std::nullopt;
  const auto found = m_value.json().find(key);
  if (found == m_value.json().end())
    return std::nullopt;
  m_taken.push_back(key);
  return JsonValue(*found, m_value, key);
}

JsonValue JsonObject::need(std::string_view key) {
  if (std::optional<JsonValue> value = take(key))
    return *value;
  m_value.fail("\"" + std::string(key) + "\" is missing");
  return {nothing, m_value, key};
}

std::optional<std::size_t> JsonObject::takeChoice(std::string_view key,
                                                  std::span<const std::string_view> names,
                                                  bool newer) {
  const std::optional<JsonValue> value = take(key);
  if (!value)
    return std::nullopt;
  const std::optional<std::size_t> index = value->oneOf(names);
  if (!index && newer)
    giveBack(key, value->json());
  else if (!index)
    value->fail("\"" + std::string(names.front()) +
                "\" or another word of this format is expected here");
  return index;
}

void JsonObject::giveBack(std::string_view key, Json rest) {
  if (!rest.is_null())
    m_back[std::string(key)] = std::move(rest);
}

Json JsonObject::rest() const {
  Json rest = m_back;
  if (m_value.json().is_object())
    for (const auto& [key, value] : m_value.json().items())
      if (std::find(m_taken.begin(), m_taken.end(), key) == m_taken.end()) {
        if (rest.size() >= mostUnreadKeys) {
          m_value.fail("there are more than " + std::to_string(mostUnreadKeys) +
                       " keys without a meaning here");
          break;
        }
        rest[key] = value;
      }
  return rest;
}

std::string JsonObject::unread() const {
  const Json left = rest();
  return left.is_null() ? std::string() : left.dump();
}

}  // namespace sline::model
