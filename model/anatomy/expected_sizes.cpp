// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/expected_sizes.h"

#include <charconv>
#include <string>

#include "model/anatomy/name_words.h"
#include "model/anatomy/systems_table.h"
#include "model/anatomy/table_rows.h"

namespace sline::model {

namespace {

std::optional<float> lengthIn(std::string_view text) {
  float value = 0.0f;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !(value > 0.0f))
    return std::nullopt;
  return value;
}

}  // namespace

ExpectedSizes::ExpectedSizes() : ExpectedSizes(sizesText()) {}

ExpectedSizes::ExpectedSizes(std::string_view table) {
  for (const std::vector<std::string_view>& fields : tableRows(table))
    if (!add(fields))
      ++m_badRows;
}

bool ExpectedSizes::add(const std::vector<std::string_view>& fields) {
  if (fields.size() != 3)
    return false;
  const std::optional<float> low = lengthIn(fields[1]);
  const std::optional<float> high = lengthIn(fields[2]);
  if (!low || !high || *low >= *high)
    return false;
  bool fits = true;
  for (const std::string_view name : cutAt(fields[0], '|'))
    fits = m_patterns.add(name, m_sizes.size()) && fits;
  m_sizes.push_back({*low, *high});
  return fits;
}

std::optional<Limits<float>> ExpectedSizes::of(std::string_view name) const {
  std::string unsided;
  for (const std::string& word : nameWords(m_names.displayName(name, NameLanguage::english)))
    if (sideOfWord(word) == Side::none)
      unsided += (unsided.empty() ? "" : " ") + word;
  const std::optional<std::size_t> row = m_patterns.match(unsided);
  if (!row)
    return std::nullopt;
  return m_sizes[*row];
}

}  // namespace sline::model
