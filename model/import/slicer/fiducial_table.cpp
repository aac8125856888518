// SPDX-License-Identifier: Apache-2.0
// Reads .fcsv: comments that give settings, then one line of comma-separated values per point.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "model/import/slicer/fiducial_files.h"
#include "model/import/source/source.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

/// Returns the fields of a line; one in double quotes may hold commas, and two such quotes for one.
std::vector<std::string> fieldsOf(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && TextCursor::isSpace(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && TextCursor::isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

std::optional<double> numberIn(std::string_view field) {
  field = trimmed(field);
  double value = 0.0;
  const char* const end = field.data() + field.size();
  const auto [next, fault] = std::from_chars(field.data(), end, value);
  if (fault != std::errc() || next != end || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<Colour> colourIn(std::string_view text) {
  std::array<std::uint8_t, 3> channels{};
  const std::vector<std::string> fields = fieldsOf(text);
  if (fields.size() != channels.size())
    return std::nullopt;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::optional<double> value = numberIn(fields[i]);
    if (!value)
      return std::nullopt;
    channels[i] = std::uint8_t(std::lround(255.0 * std::clamp(*value, 0.0, 1.0)));
  }
  return Colour{channels[0], channels[1], channels[2]};
}

class TableReader {
 public:
  TableReader(std::string_view text, const std::filesystem::path& file)
      : m_cursor(text), m_file(file.string()) {}

  Result<Fiducials> read() {
    Fiducials all;
    for (m_line = 1; !m_cursor.atEnd(); ++m_line) {
      const std::string_view line = m_cursor.restOfLine();
      if (line.empty())
        continue;
      TRY(line.front() == '#' ? setting(line.substr(1)) : point(line, all));
    }
    if (m_line == 1)
      return Error{.file = m_file, .reason = "the file is empty"};
    return all;
  }

 private:
  Error wrong(std::string reason) const {
    return {.file = m_file,
            .where = "line " + std::to_string(m_line),
            .reason = std::move(reason),
            .remedy = "Save the fiducials again in 3D Slicer"};
  }

  /// Reads "# key = value".
  Status setting(std::string_view text) {
    const std::size_t cut = text.find('=');
    if (cut == std::string_view::npos)
      return Unit{};
    const std::string_view key = trimmed(text.substr(0, cut));
    const std::string_view value = trimmed(text.substr(cut + 1));
    if (key == "Markups fiducial file version")
      m_columns = {"id", "x",   "y",   "z",    "ow",    "ox",   "oy",
                   "oz", "vis", "sel", "lock", "label", "desc", "associatedNodeID"};
    else if (key == "columns")
      m_columns = fieldsOf(value);
    else if (key == "color")
      m_colour = colourIn(value);
    else if (key == "selectedColor")
      m_selectedColour = colourIn(value);
    else if (key == "visibility")
      m_visible = value != "0";
    else if (key == "locked")
      m_locked = value != "0";
    else if (key == "CoordinateSystem" || key == "coordinateSystem")
      return system(value);
    return Unit{};
  }

  Status system(std::string_view value) {
    if (value == "0" || value == "RAS")
      m_frame = Frame::ras;
    else if (value == "1" || value == "LPS")
      m_frame = Frame::lps;
    else
      return wrong("the coordinate system " + inQuotes(value) + " is neither RAS nor LPS");
    return Unit{};
  }

  std::optional<std::string_view> field(const std::vector<std::string>& fields,
                                        std::string_view column) const {
    const auto found = std::find_if(m_columns.begin(), m_columns.end(),
                                    [&](const auto& name) { return trimmed(name) == column; });
    const auto index = std::size_t(found - m_columns.begin());
    if (index >= fields.size() || found == m_columns.end())
      return std::nullopt;
    return trimmed(fields[index]);
  }

  Status point(std::string_view line, Fiducials& all) const {
    const std::vector<std::string> fields = fieldsOf(line);
    const auto isOff = [&](std::string_view column) { return field(fields, column) == "0"; };
    Fiducial fiducial{.frame = m_frame};
    glm::dvec3 place(0.0);
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto text = field(fields, axes[i]);
      const auto number = text ? numberIn(*text) : std::nullopt;
      if (!number)
        return wrong(std::string(axes[i]) + " is " +
                     (text ? "no number: " + inQuotes(*text) : std::string("missing")));
      place[int(i)] = *number;
    }
    fiducial.places = {place};
    fiducial.text = field(fields, "label").value_or(std::string_view());
    fiducial.selected = !isOff("sel");
    fiducial.visible = m_visible && !isOff("vis");
    fiducial.locked = m_locked || field(fields, "lock") == "1";
    fiducial.colour = fiducial.selected ? m_selectedColour : m_colour;
    all.items.push_back(std::move(fiducial));
    return Unit{};
  }

  TextCursor m_cursor;
  std::string m_file;
  std::size_t m_line = 1;
  std::vector<std::string> m_columns{"label", "x", "y", "z", "sel", "vis"};
  std::optional<Colour> m_colour;
  std::optional<Colour> m_selectedColour;
  Frame m_frame = Frame::ras;
  bool m_visible = true;
  bool m_locked = false;
};

}  // namespace

Result<Fiducials> fiducialsInTable(std::string_view text, const std::filesystem::path& file) {
  return TableReader(text, file).read();
}

}  // namespace sline::model
