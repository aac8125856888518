// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/table_rows.h"

namespace sline::model {

std::vector<std::string_view> cutAt(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos)
      return parts;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::vector<std::string_view>> tableRows(std::string_view text) {
  std::vector<std::vector<std::string_view>> rows;
  for (std::string_view line : cutAt(text, '\n')) {
    if (line.ends_with('\r'))
      line.remove_suffix(1);
    if (!line.empty() && !line.starts_with("# "))
      rows.push_back(cutAt(line, '\t'));
  }
  return rows;
}

}  // namespace sline::model
