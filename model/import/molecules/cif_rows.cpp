// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gemmi/cif.hpp>

#include "model/base/letters.h"
#include "model/import/molecules/entry_files.h"
#include "model/import/molecules/entry_rows.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

namespace grammar = gemmi::cif::rules;
namespace pegtl = tao::pegtl;

/// Returns the value that written text stands for. Text between lines that begin with a semicolon
/// ends with the line before the second.
EntryValue valueOf(std::string_view written) {
  if (written.starts_with('\'') || written.starts_with('"'))
    return {written.substr(1, written.size() - 2), true};
  if (!written.starts_with(';') || written.find('\n') == std::string_view::npos)
    return {written};
  written.remove_prefix(1);
  written.remove_suffix(1);
  for (const char end : {'\n', '\r'})
    if (written.ends_with(end))
      written.remove_suffix(1);
  return {written, true};
}

/// Gathers the elements that the grammar finds into rows.
class CifRowMaker {
 public:
  explicit CifRowMaker(EntryRowReader& reader) : m_reader(reader) {}

  /// Begins an item outside of tables: such items of one category in a run are its only row.
  void beginItem(std::string_view name) {
    std::string lower = lowerCase(name);
    const std::size_t dot = lower.find('.');
    if (m_inLoop || dot == std::string::npos || !m_columns.areOf(lower.substr(0, dot + 1)))
      finish();
    m_columns.names.push_back(std::move(lower));
    m_values.emplace_back();
  }
  void setItem(std::string_view written) { m_values.back() = valueOf(written); }

  void beginLoop() {
    finish();
    m_inLoop = true;
  }
  void addColumn(std::string_view name) { m_columns.names.push_back(lowerCase(name)); }
  void addValue(std::string_view written) {
    m_values.push_back(valueOf(written));
    if (m_values.size() < m_columns.names.size())
      return;
    m_reader.readRow(m_columns, m_values);
    m_values.clear();
  }

  /// Hands over the row or table that is still open.
  void finish() {
    if (!m_values.empty() && m_inLoop)
      m_reader.missRow(m_columns);
    else if (!m_values.empty())
      m_reader.readRow(m_columns, m_values);
    m_columns.names.clear();
    m_values.clear();
    m_inLoop = false;
  }

 private:
  EntryRowReader& m_reader;
  EntryColumns m_columns;
  std::vector<EntryValue> m_values;
  bool m_inLoop = false;
};

/// Tells the maker of rows about a rule of the grammar that was seen in the text.
template <auto tell>
struct Telling {
  template <class Input>
  static void apply(const Input& in, CifRowMaker& maker) {
    (maker.*tell)(std::string_view(in.begin(), in.size()));
  }
};
template <auto tell>
struct TellingOnly {
  static void apply0(CifRowMaker& maker) { (maker.*tell)(); }
};

template <class Rule>
struct CifAction : pegtl::nothing<Rule> {};
template <>
struct CifAction<grammar::item_tag> : Telling<&CifRowMaker::beginItem> {};
template <>
struct CifAction<grammar::item_value> : Telling<&CifRowMaker::setItem> {};
template <>
struct CifAction<grammar::str_loop> : TellingOnly<&CifRowMaker::beginLoop> {};
template <>
struct CifAction<grammar::loop_tag> : Telling<&CifRowMaker::addColumn> {};
template <>
struct CifAction<grammar::loop_value> : Telling<&CifRowMaker::addValue> {};
template <>
struct CifAction<grammar::loop> : TellingOnly<&CifRowMaker::finish> {};

constexpr const char* beyondGrammar = "cannot be read as CIF from here on";
constexpr const char* getAgain = "Get the entry again";

std::string reasonOf(std::string_view message) {
  // gemmi names the elements that never end and those that have no name.
  return message == "parse error" ? beyondGrammar : std::string(message);
}

bool beginsBlock(std::string_view text) {
  return text.empty() || equalsIgnoringCase(text.substr(0, 5), "data_") ||
         equalsIgnoringCase(text.substr(0, 7), "global_");
}

}  // namespace

std::size_t EntryColumns::column(std::string_view name) const {
  return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
}

Status readCifRows(const Source& source, EntryRowReader& reader) {
  TextCursor first(source.text());
  first.skipSpace();
  while (!first.atEnd() && first.peek() == '#') {
    first.skipLine();
    first.skipSpace();
  }
  if (!equalsIgnoringCase(first.peekWord().substr(0, 5), "data_"))
    return source.atLine(first.at(), "does not begin with a data block (data_…)",
                         "Check that the file is an mmCIF file");
  CifRowMaker maker(reader);
  try {
    pegtl::memory_input<> in(source.begin(), source.end(), source.file());
    while (!in.empty() && !reader.hasEnough()) {
      pegtl::parse<grammar::one_block, CifAction, gemmi::cif::Errors>(in, maker);
      maker.finish();
      if (const std::string_view rest(in.current(), in.size()); !beginsBlock(rest))
        return source.atLine(rest.data(), beyondGrammar, getAgain);
    }
  } catch (const pegtl::parse_error& error) {
    maker.finish();
    return source.at("line " + std::to_string(error.positions().front().line),
                     reasonOf(error.message()), getAgain);
  }
  return Unit{};
}

}  // namespace sline::model
