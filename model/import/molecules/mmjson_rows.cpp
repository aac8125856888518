// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdio>

#include "model/base/letters.h"
#include "model/import/molecules/entry_files.h"
#include "model/import/molecules/entry_rows.h"
#include "model/import/molecules/molecules.h"
#include "model/import/source/packed_bytes.h"
#include "model/import/source/text_cursor.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

namespace {

constexpr const char* getAgainOrMmcif = "Get the entry again, or as mmCIF";

/// A JSON value takes 16 bytes or more, far above the two with which it may be written.
constexpr JsonLimits mmjsonLimits{.bytes = std::size_t(512) << 20, .values = 30'000'000};

/// Returns the value as mmCIF would write it: an unknown value is null, one that does not apply is
/// false.
EntryValue valueOfJson(const Json& value, std::string& store) {
  if (value.is_string())
    return {value.get_ref<const std::string&>(), true};
  if (value.is_boolean())
    return {"."};
  if (!value.is_number())
    return {};
  store = value.dump();
  return {store};
}

/// Returns the columns of a category, all equally long; else nothing.
std::vector<const Json*> columnsOf(const Json& category) {
  std::vector<const Json*> columns;
  if (!category.is_object())
    return columns;
  for (const Json& column : category) {
    if (!column.is_array() || column.size() != category.front().size())
      return {};
    columns.push_back(&column);
  }
  return columns;
}

void readCategory(const std::string& name, const Json& category,
                  const std::vector<const Json*>& columns, EntryRowReader& reader) {
  EntryColumns names;
  for (const auto& item : category.items())
    names.names.push_back("_" + lowerCase(name + "." + item.key()));
  std::vector<EntryValue> row(columns.size());
  std::vector<std::string> numbers(columns.size());
  for (std::size_t i = 0; i < columns.front()->size(); ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      row[c] = valueOfJson((*columns[c])[i], numbers[c]);
    reader.readRow(names, row);
  }
}

}  // namespace

Status readMmjsonRows(const Source& source, EntryRowReader& reader) {
  const Result<Json> root = parseJson(source.text(), mmjsonLimits);
  if (!root)
    return source.at(root.error().where, "cannot be read as JSON: " + root.error().reason,
                     getAgainOrMmcif);
  if (!root->is_object() || root->size() != 1 || !root->begin().key().starts_with("data_") ||
      !root->front().is_object())
    return source.whole("is no mmJSON, which holds one object called data_…", getAgainOrMmcif);
  const Json& block = root->front();
  for (const auto& [name, category] : block.items())
    if (columnsOf(category).empty())
      return source.at(inQuotes(name), "is no table: its columns are not all equally long lists",
                       getAgainOrMmcif);
  for (const auto& [name, category] : block.items())
    readCategory(name, category, columnsOf(category), reader);
  return Unit{};
}

bool isMmjson(const std::filesystem::path& file) {
  std::array<char, 4096> stored{};
  std::FILE* handle = std::fopen(file.string().c_str(), "rb");
  if (!handle)
    return false;
  const std::size_t size = std::fread(stored.data(), 1, stored.size(), handle);
  std::fclose(handle);
  const std::string_view bytes(stored.data(), size);
  std::array<char, 256> head{};
  PackedBytes text(bytes, beginsLikeGzip(bytes) ? Packing::deflated : Packing::none);
  TextCursor at(std::string_view(head.data(), text.read(head.data(), head.size())));
  at.skipSpace();
  if (at.peek() != '{')
    return false;
  at.moveTo(at.at() + 1);
  at.skipSpace();
  return at.peekWord().starts_with("\"data_");
}

}  // namespace sline::model
