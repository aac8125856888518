// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "model/base/letters.h"
#include "model/import/molecules/assemblies.h"
#include "model/import/molecules/entry_files.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

constexpr std::size_t textBegins = 11;  ///< behind "REMARK 350 "

class AssemblyRemarks {
 public:
  void readLine(std::string_view line) {
    const std::string_view text = line.substr(std::min(line.size(), textBegins));
    const std::size_t colon = text.find(':');
    const std::string_view key = text.substr(0, colon);
    const std::string_view value =
        colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
    if (key == "BIOMOLECULE")
      m_result.all.push_back({asciiOf(TextCursor(value).restOfLine()), {}, {}});
    else if (m_result.all.empty())
      return;
    else if (key.find(" DETERMINED ") != std::string_view::npos)
      m_result.all.back().details = lowerCase(asciiOf(TextCursor(value).restOfLine()));
    else if (key.ends_with("TO CHAINS"))
      m_result.all.back().steps.push_back({namesInList(value), {}});
    else if (key.ends_with("AND CHAINS"))
      addChains(namesInList(value));
    else
      readMatrix(text);
  }

  Assemblies take() { return std::move(m_result); }

 private:
  void addChains(const std::vector<std::string>& names) {
    if (m_result.all.back().steps.empty())
      return;
    std::vector<std::string>& parts = m_result.all.back().steps.back().parts;
    parts.insert(parts.end(), names.begin(), names.end());
  }

  /// Reads "BIOMT2   1  0.000000 -1.000000  0.000000        0.00000": row, number, rotation, shift.
  void readMatrix(std::string_view text) {
    TextCursor at(text);
    at.skipSpace();
    const std::string_view name = at.word();
    if (name.size() != 6 || !name.starts_with("BIOMT") || name[5] < '1' || name[5] > '3' ||
        m_result.all.back().steps.empty())
      return;
    const int row = name[5] - '1';
    at.skipSpace();
    at.word();
    std::array<double, 4> numbers{};
    for (double& number : numbers) {
      at.skipSpace();
      if (!at.number(number))
        return;
    }
    for (int column = 0; column < 3; ++column)
      m_matrix.rotation[column][row] = numbers[std::size_t(column)];
    m_matrix.shift[row] = numbers[3];
    if (row == 2)
      addOperator();
  }

  /// Adds an operator under a name of its own; files number them anew in each assembly.
  void addOperator() {
    const std::string name = std::to_string(m_result.operators.size() + 1);
    std::string& list = m_result.all.back().steps.back().operators;
    list += (list.empty() ? "" : ",") + name;
    m_result.operators.emplace(name, m_matrix);
    m_matrix = {};
  }

  Assemblies m_result;
  AssemblyOperator m_matrix;
};

}  // namespace

std::vector<std::string> namesInList(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    TextCursor at(list.substr(0, end));
    at.skipSpace();
    if (const std::string_view name = at.restOfLine(); !name.empty())
      names.emplace_back(name);
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return names;
}

Assemblies assembliesOfRemarks(std::string_view lines) {
  AssemblyRemarks remarks;
  for (TextCursor at(lines); !at.atEnd(); at.skipLine()) {
    const char* begin = at.at();
    TextCursor end = at;
    while (!end.atLineEnd())
      end.moveTo(end.at() + 1);
    remarks.readLine({begin, std::size_t(end.at() - begin)});
  }
  return remarks.take();
}

}  // namespace sline::model
