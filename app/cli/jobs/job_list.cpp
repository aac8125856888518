// SPDX-License-Identifier: Apache-2.0
#include "app/cli/jobs/job_list.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "app/cli/files/json_values.h"
#include "app/cli/jobs/json_positions.h"
#include "model/base/letters.h"
#include "model/disk/whole_file.h"

namespace sline::cli {

namespace {

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
constexpr std::size_t largestList = std::size_t(64) * 1024 * 1024;

Error fault(std::string where, std::string reason, std::string remedy) {
  return {.where = std::move(where), .reason = std::move(reason), .remedy = std::move(remedy)};
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  const auto last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// Holds a line of a table; a quoted cell may span several.
struct Row {
  std::size_t line = 1;
  std::vector<std::string> cells;
  bool empty() const {
    return std::all_of(cells.begin(), cells.end(), [](const auto& cell) { return cell.empty(); });
  }
};

/// Reads a table from its beginning to its end.
class TableReader {
 public:
  explicit TableReader(std::string_view text) : m_text(text) {
    for (const char each : text.substr(0, text.find_first_of("\r\n")))
      if (each == ',' || each == ';' || each == '\t') {
        m_separator = each;
        break;
      }
  }

  /// Returns the next row, or nothing at the end.
  Result<std::optional<Row>> next() {
    if (m_at >= m_text.size())
      return std::optional<Row>();
    Row row{.line = m_place.line, .cells = {}};
    for (;;) {
      const std::string cell = TRY(readCell());
      row.cells.push_back(cell);
      if (m_at < m_text.size() && m_text[m_at] == m_separator) {
        step();
        continue;
      }
      if (m_at < m_text.size() && m_text[m_at] == '\r')
        step();
      if (m_at < m_text.size() && m_text[m_at] == '\n')
        step();
      return std::optional<Row>(std::move(row));
    }
  }

 private:
  bool atEnd() const {
    return m_at >= m_text.size() || m_text[m_at] == m_separator || m_text[m_at] == '\n' ||
           m_text[m_at] == '\r';
  }
  void step() {
    const bool lineEnds =
        m_text[m_at] == '\n' || (m_text[m_at] == '\r' && m_text.substr(m_at + 1, 1) != "\n");
    // Characters are counted, not their bytes.
    const bool within = (static_cast<unsigned char>(m_text[m_at]) & 0xC0u) == 0x80u;
    if (lineEnds)
      m_place = {m_place.line + 1, 1};
    else
      m_place.column += within ? 0 : 1;
    ++m_at;
  }
  Result<std::string> readCell() {
    std::string cell;
    if (m_at >= m_text.size() || m_text[m_at] != '"') {
      for (; !atEnd(); step())
        cell += m_text[m_at];
      return trimmed(cell);
    }
    const std::string opened = m_place.text();
    for (step();; step()) {
      if (m_at >= m_text.size())
        return fault(opened, "a quotation mark is never closed", "Close it at the cell's end");
      if (m_text[m_at] == '"') {
        step();
        if (m_at >= m_text.size() || m_text[m_at] != '"')
          break;
      }
      cell += m_text[m_at];
    }
    if (!atEnd())
      return fault(m_place.text(), "something follows a closed quotation mark",
                   "Write a quotation mark within a cell twice");
    return cell;
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  TextPosition m_place;
  char m_separator = ',';
};

/// Returns the flag that a heading names: people write "--png" and "PNG" for "png".
std::string flagOf(const std::string& heading) {
  std::string flag = trimmed(heading);
  flag.erase(0, std::min(flag.find_first_not_of('-'), flag.size()));
  return lowerCase(flag);
}

Status checkHeading(const Row& heading) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < heading.cells.size(); ++i) {
    const std::string flag = flagOf(heading.cells[i]);
    const std::string where =
        "line " + std::to_string(heading.line) + ", column " + std::to_string(i + 1);
    if (flag.empty())
      return fault(where, "a column has no heading", "Head it with a flag of `sline export`");
    if (!seen.insert(flag).second)
      return fault(where, "two columns are headed " + flag, "Leave one out");
  }
  return Unit{};
}

/// Returns the texts of a JSON value; nothing if no flag can have such a value.
std::optional<std::vector<std::string>> valuesOf(const Json& value) {
  if (value.is_string())
    return std::vector<std::string>{value.get<std::string>()};
  if (value.is_number())
    return std::vector<std::string>{value.dump()};
  if (value.is_boolean())
    return std::vector<std::string>{};
  if (!value.is_array() || value.empty())
    return std::nullopt;
  std::vector<std::string> all;
  for (const Json& each : value) {
    if (!each.is_string() && !each.is_number())
      return std::nullopt;
    all.push_back(each.is_string() ? each.get<std::string>() : each.dump());
  }
  return all;
}

/// Returns the places of an object's keys by their names; a fault if one is there twice.
Result<std::map<std::string, TextPosition>> keyPositions(const ElementPositions& place,
                                                         const std::string& job) {
  std::map<std::string, TextPosition> places;
  std::map<std::string, TextPosition> flags;
  for (const ElementPositions::Key& key : place.keys) {
    places.emplace(key.name, key.at);
    const auto [first, fresh] = flags.emplace(flagOf(key.name), key.at);
    if (!fresh)
      return fault(job + ", " + jsonText(Json(key.name)) + ", " + key.at.text(),
                   "the job says it twice, first in " + first->second.text(), "Leave one out");
  }
  return places;
}

/// Reads one job; `name` is "job 4".
Result<Job> jobOf(const Json& object, const std::string& name, const ElementPositions& place) {
  const std::string where = name + ", " + place.at.text();
  if (!object.is_object())
    return fault(where, "it is no object", R"(Write each job as {"input": …, "svg": …})");
  const auto places = TRY(keyPositions(place, name));
  Job job{.where = name + ", line " + std::to_string(place.at.line), .fields = {}};
  for (const auto& [key, value] : object.items()) {
    const auto at = places.find(key);
    const std::string keyAt = (at == places.end() ? place.at : at->second).text();
    const std::string field = name + ", " + jsonText(Json(key)) + ", " + keyAt;
    if (value.is_null() || (value.is_boolean() && !value.get<bool>()))
      continue;
    const auto values = valuesOf(value);
    if (!values)
      return fault(field, "it is no text, number, true, false or list of texts and numbers",
                   "Write the flag's value");
    if (flagOf(key).empty())
      return fault(field, "a key without a name", "Write a flag of `sline export`");
    job.fields.push_back({flagOf(key), *values, field});
  }
  return job;
}

Error emptyListError() {
  return fault("", "the list has no jobs", "Write a line for each, below the heading");
}

}  // namespace

const JobField* Job::find(std::string_view flag) const {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [flag](const JobField& field) { return field.flag == flag; });
  return found == fields.end() ? nullptr : &*found;
}

Result<std::vector<Job>> jobsOfTable(std::string_view text) {
  if (text.starts_with(byteOrderMark))
    text.remove_prefix(byteOrderMark.size());
  TableReader reader(text);
  std::optional<Row> heading;
  std::vector<Job> jobs;
  for (;;) {
    const std::optional<Row> row = TRY(reader.next());
    if (!row)
      break;
    if (row->empty())
      continue;
    const Row& cells = *row;
    if (!heading) {
      TRY(checkHeading(cells));
      heading = cells;
      continue;
    }
    const std::string line = "line " + std::to_string(cells.line);
    if (cells.cells.size() > heading->cells.size())
      return fault(line + ", column " + std::to_string(heading->cells.size() + 1),
                   "there are more cells than columns",
                   "Put what holds a separator into quotation marks");
    Job job{.where = line, .fields = {}};
    for (std::size_t i = 0; i < cells.cells.size(); ++i)
      if (!cells.cells[i].empty()) {
        const std::string flag = flagOf(heading->cells[i]);
        job.fields.push_back({flag, {cells.cells[i]}, line + ", column " + flag});
      }
    jobs.push_back(std::move(job));
  }
  if (jobs.empty())
    return emptyListError();
  return jobs;
}

Result<std::vector<Job>> jobsOfJson(std::string_view text) {
  if (text.starts_with(byteOrderMark))
    text.remove_prefix(byteOrderMark.size());
  Json list;
  try {
    list = Json::parse(text);
  } catch (const Json::parse_error& failure) {
    // The parser counts what it has read, the byte at fault too.
    const std::size_t at = std::max<std::size_t>(failure.byte, 1) - 1;
    return fault(textPositionAt(text, at).text(), "it is no JSON",
                 "Write a list of objects, [{…}, …]");
  } catch (const Json::exception&) {
    return fault("", "it is no JSON that can be used", "Write a list of objects, [{…}, …]");
  }
  if (!list.is_array())
    return fault("", "it is no list", "Write a list of objects, [{…}, …]");
  const std::vector<ElementPositions> places = elementPositions(text);
  std::vector<Job> jobs;
  for (const Json& each : list) {
    const std::size_t i = jobs.size();
    Job job = TRY(jobOf(each, "job " + std::to_string(i + 1),
                        i < places.size() ? places[i] : ElementPositions()));
    jobs.push_back(std::move(job));
  }
  if (jobs.empty())
    return emptyListError();
  return jobs;
}

Result<std::vector<Job>> readJobList(const std::filesystem::path& file) {
  const std::string text = TRY(model::readText(file, largestList));
  Result<std::vector<Job>> jobs =
      lowerExtension(file) == ".json" ? jobsOfJson(text) : jobsOfTable(text);
  if (jobs.ok())
    return jobs;
  Error error = jobs.error();
  error.file = file.string();
  return error;
}

Result<Shard> parseShard(std::string_view text) {
  const auto number = [](std::string_view part) -> std::size_t {
    constexpr std::size_t most = 1'000'000;
    std::size_t value = 0;
    const auto [end, wrong] = std::from_chars(part.data(), part.data() + part.size(), value);
    return wrong == std::errc() && end == part.data() + part.size() && value <= most ? value : 0;
  };
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) {
    const Shard shard{.index = number(text.substr(0, slash)),
                      .count = number(text.substr(slash + 1))};
    if (shard.index >= 1 && shard.index <= shard.count)
      return shard;
  }
  return Error{.reason = "\"" + std::string(text) + "\" is no part of a list",
               .remedy = "Write --shard 3/16 for the third of 16, from 1/16 to 16/16"};
}

}  // namespace sline::cli
