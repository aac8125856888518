// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/label_names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "model/base/colour_text.h"
#include "model/base/letters.h"
#include "model/base/utf8.h"
#include "model/import/source/source.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/xml_tags.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Fields = std::vector<std::string_view>;

constexpr std::size_t mostNames = 65'536;
/// More than a scene may hold, so that whoever cuts a name to that says so.
constexpr std::size_t longestName = 4096;
constexpr std::uint64_t largestTable = std::uint64_t(8) << 20;

std::string_view unquoted(std::string_view text) {
  constexpr std::string_view around = " \t\r\n\"'";
  const std::size_t begin = text.find_first_not_of(around);
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(around) - begin + 1);
}

std::optional<std::int64_t> whole(std::string_view text) {
  std::int64_t value = 0;
  text = unquoted(text);
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

std::optional<double> real(std::string_view text) {
  text = unquoted(text);
  TextCursor at(text);
  double value = 0.0;
  if (!at.number(value) || !at.atEnd() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Returns the colour of channels in 0 … 255, or in 0 … 1 where `unit`.
std::optional<Colour> colourOfChannels(const std::array<std::optional<double>, 3>& channels,
                                       bool unit) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!channels[i])
      return std::nullopt;
    const double value = std::round(*channels[i] * (unit ? 255.0 : 1.0));
    if (!(value >= 0.0 && value <= 255.0))
      return std::nullopt;
    bytes[i] = std::uint8_t(value);
  }
  return Colour{bytes[0], bytes[1], bytes[2]};
}

void add(LabelNames& names, std::int64_t value, std::string_view name,
         std::optional<Colour> colour) {
  if (name = unquoted(name); !name.empty() && names.size() < mostNames)
    names.emplace(value, Label{value, std::string(cutUtf8(name, longestName)), colour, {}});
}

Fields fieldsOf(std::string_view line, char separator) {
  Fields fields;
  while (true) {
    const std::size_t end = std::min(line.find(separator), line.size());
    fields.push_back(line.substr(0, end));
    if (end == line.size())
      return fields;
    line.remove_prefix(end + 1);
  }
}

Fields columnsOf(std::string_view line) {
  Fields words;
  TextCursor at(line);
  for (at.skipSpace(); !at.atEnd(); at.skipSpace())
    words.push_back(at.word());
  return words;
}

/// Says where the columns of a table lie that has a first line of headings.
struct Columns {
  std::optional<std::size_t> value;
  std::optional<std::size_t> name;
  std::optional<std::size_t> colour;  ///< #rrggbb
  std::array<std::optional<std::size_t>, 3> channels;

  explicit Columns(const Fields& headings) {
    for (std::size_t i = 0; i < headings.size(); ++i) {
      const auto is = [&](std::initializer_list<std::string_view> known) {
        return std::any_of(known.begin(), known.end(), [&](std::string_view heading) {
          return equalsIgnoringCase(unquoted(headings[i]), heading);
        });
      };
      const auto take = [i](std::optional<std::size_t>& column) {
        if (!column)
          column = i;
      };
      if (is({"index", "label", "value", "id", "labelvalue", "key", "number"}))
        take(value);
      else if (is({"name", "structure", "labelname", "region", "abbreviation"}))
        take(name);
      else if (is({"color", "colour"}))
        take(colour);
      else if (is({"r", "red"}))
        take(channels[0]);
      else if (is({"g", "green"}))
        take(channels[1]);
      else if (is({"b", "blue"}))
        take(channels[2]);
    }
  }
  bool known() const { return value && name; }
};

void addRow(LabelNames& names, const Fields& fields, const Columns& columns) {
  const auto at = [&](const std::optional<std::size_t>& column) {
    return column && *column < fields.size() ? fields[*column] : std::string_view();
  };
  const std::optional<std::int64_t> value = whole(at(columns.value));
  if (!value)
    return;
  std::optional<Colour> colour = colourFrom(unquoted(at(columns.colour)));
  if (!colour)
    colour = colourOfChannels({real(at(columns.channels[0])), real(at(columns.channels[1])),
                               real(at(columns.channels[2]))},
                              false);
  add(names, *value, at(columns.name), colour);
}

/// Adds a line without headings: number, then name and perhaps colour, or colour and name in
/// quotes.
void addLine(LabelNames& names, std::string_view line, char separator) {
  const Fields words = separator == ' ' ? columnsOf(line) : fieldsOf(line, separator);
  std::string_view first = words.front();
  if (first.ends_with(':') || first.ends_with('='))
    first.remove_suffix(1);
  const std::optional<std::int64_t> value = whole(first);
  if (!value || words.size() < 2)
    return;
  const auto colourAt = [&](std::size_t at) -> std::optional<Colour> {
    if (at + 3 > words.size())
      return std::nullopt;
    return colourOfChannels({real(words[at]), real(words[at + 1]), real(words[at + 2])}, false);
  };
  const std::size_t quote = line.find('"');
  if (const std::optional<Colour> colour = colourAt(1); colour && quote != std::string_view::npos)
    return add(names, *value, line.substr(quote), colour);
  if (separator != ' ')
    return add(names, *value, words[1], colourAt(2));
  // The name reaches to the end or to red, green, blue (and alpha).
  std::size_t end = words.size();
  std::optional<Colour> colour;
  for (const std::size_t channels : {std::size_t(4), std::size_t(3)})
    if (!colour && words.size() >= 2 + channels)
      if ((colour = colourAt(words.size() - channels)))
        end = words.size() - channels;
  const char* begin = words[1].data();
  const char* stop = words[end - 1].data() + words[end - 1].size();
  add(names, *value, {begin, std::size_t(stop - begin)}, colour);
}

std::optional<Colour> colourIn(const Json& entry) {
  for (const char* key : {"color", "colour", "rgb"}) {
    const auto found = entry.find(key);
    if (found == entry.end())
      continue;
    if (found->is_string())
      return colourFrom(unquoted(found->get_ref<const std::string&>()));
    if (!found->is_array() || found->size() < 3)
      return std::nullopt;
    std::array<std::optional<double>, 3> channels;
    bool unit = true;
    for (std::size_t i = 0; i < 3; ++i)
      if ((*found)[i].is_number()) {
        channels[i] = (*found)[i].get<double>();
        unit = unit && (*found)[i].is_number_float() && *channels[i] <= 1.0;
      }
    return colourOfChannels(channels, unit);
  }
  return std::nullopt;
}

void addEntry(LabelNames& names, const Json& entry) {
  if (!entry.is_object())
    return;
  const auto first = [&](std::initializer_list<const char*> keys) -> const Json* {
    for (const char* key : keys)
      if (const auto found = entry.find(key); found != entry.end())
        return &*found;
    return nullptr;
  };
  const Json* value = first({"value", "labelValue", "label", "id", "index", "labelID"});
  const Json* name = first({"name", "SegmentLabel", "structure"});
  if (value && name && value->is_number_integer() && name->is_string())
    add(names, value->get<std::int64_t>(), name->get_ref<const std::string&>(), colourIn(entry));
}

/// Adds names that stand in one list, their colours in three and their numbers in another:
/// "labels", "R", "G", "B", "I". Without numbers they are counted from 0.
void addLists(LabelNames& names, const Json& table, const Json& labels) {
  const auto numberIn = [&table](const char* key, std::size_t i) -> std::optional<double> {
    const auto list = table.find(key);
    if (list == table.end() || !list->is_array() || i >= list->size() || !(*list)[i].is_number())
      return std::nullopt;
    return (*list)[i].get<double>();
  };
  const bool numbered = table.contains("I");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::optional<double> value = numbered ? numberIn("I", i) : std::optional(double(i));
    if (!labels[i].is_string() || !value || std::abs(*value) > 1e15)
      continue;
    add(names, std::int64_t(*value), labels[i].get_ref<const std::string&>(),
        colourOfChannels({numberIn("R", i), numberIn("G", i), numberIn("B", i)}, false));
  }
}

/// Returns the name without the number at its end, or nothing where it has none.
std::string_view withoutCode(std::string_view name) {
  const std::size_t space = name.find_last_of(" \t");
  if (space == std::string_view::npos || !whole(name.substr(space + 1)))
    return {};
  return unquoted(name.substr(0, space));
}

/// Takes a third column off the names, a code such as atlases of the brain have: "1 Precentral_L
/// 2001". It is one where each name ends in a number and is told from the others without it; "rib
/// 1" and "rib 2" keep theirs.
void dropCodes(LabelNames& names) {
  constexpr std::size_t fewest = 3;
  std::set<std::string_view> told;
  for (const auto& [value, label] : names)
    if (const std::string_view plain = withoutCode(label.name);
        label.colour || plain.empty() || !told.insert(plain).second)
      return;
  if (names.size() < fewest)
    return;
  for (auto& [value, label] : names)
    label.name = std::string(withoutCode(label.name));
}
}  // namespace

LabelNames labelsInTable(std::string_view text) {
  LabelNames names;
  std::optional<Columns> columns;
  bool first = true;
  for (TextCursor at(text); !at.atEnd();) {
    at.skipSpace();
    const std::string_view line = at.restOfLine();
    if (line.empty() || line.front() == '#')
      continue;
    const char separator = line.find('\t') != std::string_view::npos  ? '\t'
                           : line.find(',') != std::string_view::npos ? ','
                                                                      : ' ';
    if (std::exchange(first, false) && separator != ' ')
      if (Columns headed(fieldsOf(line, separator)); headed.known()) {
        columns = headed;
        continue;
      }
    if (columns)
      addRow(names, fieldsOf(line, separator), *columns);
    else
      addLine(names, line, separator);
  }
  if (!columns)
    dropCodes(names);
  return names;
}

LabelNames labelsInJson(std::string_view text) {
  LabelNames names;
  const Json whole_ = Json::parse(text, nullptr, false);
  if (!whole_.is_object() && !whole_.is_array())
    return names;
  const Json* labels = &whole_;
  for (const char* key : {"labels", "segments"})
    if (whole_.is_object())
      if (const auto found = whole_.find(key); found != whole_.end() && found->is_structured()) {
        labels = &*found;
        break;
      }
  if (labels->is_array()) {
    for (const Json& entry : *labels)
      addEntry(names, entry);
    if (names.empty() && whole_.is_object())
      addLists(names, whole_, *labels);
    return names;
  }
  for (const auto& [key, value] : labels->items()) {
    if (const std::optional<std::int64_t> number = whole(key); number && value.is_string())
      add(names, *number, value.get_ref<const std::string&>(), std::nullopt);
    else if (value.is_number_integer())
      add(names, value.get<std::int64_t>(), key, std::nullopt);
  }
  return names;
}

LabelNames labelsInCaret(std::string_view xml) {
  LabelNames names;
  XmlTags tags(xml);
  while (const std::optional<XmlTag> tag = tags.next()) {
    if (tag->name != "Label" || tag->closing || tag->empty)
      continue;
    const std::optional<std::int64_t> value = whole(tag->attribute("Key"));
    std::string_view name(tag->end(), std::size_t(xml.data() + xml.size() - tag->end()));
    constexpr std::string_view data = "<![CDATA[";
    if (name.starts_with(data))
      name = name.substr(data.size(), name.find("]]>") - data.size());
    else
      name = name.substr(0, name.find('<'));
    if (value)
      add(names, *value, name,
          colourOfChannels({real(tag->attribute("Red")), real(tag->attribute("Green")),
                            real(tag->attribute("Blue"))},
                           true));
  }
  return names;
}

LabelNames labelsBeside(const fs::path& volume, const ReadLimits& limits, std::string& from) {
  ReadLimits small = limits;
  small.fileBytes = std::min(limits.fileBytes, largestTable);
  const auto tryFile = [&](const fs::path& file) {
    LabelNames names;
    std::error_code code;
    if (!fs::is_regular_file(file, code))
      return names;
    const Result<Source> source = Source::read(file, small);
    if (!source)
      return names;
    names =
        file.extension() == ".json" ? labelsInJson(source->text()) : labelsInTable(source->text());
    if (!names.empty())
      from = file.filename().string();
    return names;
  };
  const fs::path folder = volume.parent_path();
  fs::path stem = volume.filename();
  while (stem.has_extension()) {
    stem.replace_extension();
    for (const char* more : {"", "_names", "_labels"})
      for (const char* ending : {".ctbl", ".tsv", ".csv", ".txt", ".label", ".json"})
        if (LabelNames names = tryFile(folder / (stem.string() + more + ending)); !names.empty())
          return names;
  }
  std::error_code code;
  std::vector<fs::path> tables;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, code), end;
       !code && entry != end; entry.increment(code))
    if (entry->path().extension() == ".ctbl")
      tables.push_back(entry->path());
  return tables.size() == 1 ? tryFile(tables.front()) : LabelNames();
}

std::string tableBeside(const fs::path& volume) {
  fs::path stem = volume.filename();
  std::error_code code;
  while (stem.has_extension()) {
    stem.replace_extension();
    for (const char* more : {"", "_names", "_labels"})
      for (const char* ending : {".ctbl", ".tsv", ".csv", ".txt", ".label", ".json"})
        if (std::string name = stem.string() + more + ending;
            fs::is_regular_file(volume.parent_path() / name, code))
          return name;
  }
  return {};
}

void nameLabels(LabelVolume& volume, const LabelNames& names) {
  for (Label& label : volume.labels) {
    if (const auto found = names.find(label.value); found != names.end()) {
      label = found->second;
    } else if (label.name.empty() && volume.labels.size() > 1) {
      label.name = "label ";
      label.name += std::to_string(label.value);
    }
  }
}

}  // namespace sline::model
