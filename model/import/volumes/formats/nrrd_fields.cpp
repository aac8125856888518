// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/nrrd_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

#include "model/base/letters.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

std::optional<ScalarType> nrrdType(std::string_view name) {
  struct Row {
    ScalarType type;
    std::initializer_list<std::string_view> names;
  };
  static const Row rows[] = {
      {ScalarType::int8, {"signed char", "int8", "int8_t"}},
      {ScalarType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {ScalarType::int16,
       {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {ScalarType::uint16,
       {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {ScalarType::int32, {"int", "signed int", "int32", "int32_t"}},
      {ScalarType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {ScalarType::int64,
       {"longlong", "long long", "long long int", "signed long long", "signed long long int",
        "int64", "int64_t"}},
      {ScalarType::uint64,
       {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {ScalarType::float32, {"float"}},
      {ScalarType::float64, {"double"}}};
  for (const Row& row : rows)
    for (const std::string_view known : row.names)
      if (equalsIgnoringCase(name, known))
        return row.type;
  return std::nullopt;
}

std::vector<std::string_view> nrrdWords(std::string_view text) {
  std::vector<std::string_view> words;
  TextCursor at(text);
  for (at.skipSpace(); !at.atEnd(); at.skipSpace())
    words.push_back(at.word());
  return words;
}

Result<NrrdSpace> nrrdSpace(const Source& source, const NrrdHeader& header) {
  const std::string_view name = header.field("space");
  struct Row {
    std::string_view name;
    std::string_view brief;
    NrrdSpace space;
  };
  const Row rows[] = {{"left-posterior-superior", "lps", {{1.0, 1.0, 1.0}, Frame::lps}},
                      {"right-anterior-superior", "ras", {{-1.0, -1.0, 1.0}, Frame::ras}},
                      {"left-anterior-superior", "las", {{1.0, -1.0, 1.0}, Frame::lps}},
                      {"", "", {{1.0, 1.0, 1.0}, std::nullopt}},
                      {"scanner-xyz", "", {{1.0, 1.0, 1.0}, std::nullopt}},
                      {"3d-right-handed", "", {{1.0, 1.0, 1.0}, std::nullopt}}};
  for (const Row& row : rows)
    if (equalsIgnoringCase(name, row.name) ||
        (!name.empty() && equalsIgnoringCase(name, row.brief)))
      return row.space;
  return source.at("field space",
                   "its space " + inQuotes(name) + " does not say how it lies in the patient",
                   "Export it in the space left-posterior-superior");
}

double nrrdUnit(const NrrdHeader& header) {
  const std::string_view units = header.field("space units");
  struct Row {
    std::string_view name;
    double millimetres;
  };
  for (const Row& row : {Row{"\"mm\"", 1.0}, Row{"\"cm\"", 10.0}, Row{"\"m\"", 1000.0},
                         Row{"\"um\"", 0.001}, Row{"\"µm\"", 0.001}, Row{"\"microns\"", 0.001}})
    if (units.starts_with(row.name))
      return row.millimetres;
  return 0.0;
}

LabelNames nrrdSegments(const NrrdHeader& header, bool layered, std::size_t layer) {
  LabelNames names;
  for (std::size_t i = 0; i < 65'536; ++i) {
    const std::string segment = "Segment" + std::to_string(i) + "_";
    const std::string_view name = header.key(segment + "Name");
    const std::string_view id = header.key(segment + "ID");
    if (name.empty() && id.empty())
      break;
    std::int64_t value = 1;
    TextCursor(header.key(segment + "LabelValue")).integer(value);
    // Before there were layers, each segment had one of its own.
    std::int64_t its = layered ? std::int64_t(i) : 0;
    TextCursor(header.key(segment + "Layer")).integer(its);
    if (its != std::int64_t(layer))
      continue;
    Label label{value, std::string(name.empty() ? id : name), {}, {}};
    TextCursor at(header.key(segment + "Color"));
    std::array<float, 3> channels{-1.0f, -1.0f, -1.0f};
    for (float& channel : channels) {
      at.skipSpace();
      at.number(channel);
    }
    if (std::all_of(channels.begin(), channels.end(),
                    [](float c) { return c >= 0.0f && c <= 1.0f; }))
      label.colour = Colour{std::uint8_t(std::lround(255.0f * channels[0])),
                            std::uint8_t(std::lround(255.0f * channels[1])),
                            std::uint8_t(std::lround(255.0f * channels[2]))};
    names.insert_or_assign(value, std::move(label));
  }
  return names;
}

}  // namespace sline::model
