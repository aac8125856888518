// SPDX-License-Identifier: Apache-2.0
#include "app/cli/manual/option_table.h"

#include <algorithm>
#include <sstream>

namespace sline::cli {

namespace {

std::vector<std::string> partsOf(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);)
    parts.push_back(part);
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \n");
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \n") + 1 - first);
}

/// Tells whether the word, such as "N" in "auto|N", stands for values instead of being one.
bool standsForValues(const std::string& word) {
  static const std::vector<std::string> names{"N", "LIST", "IDS", "FILE", "FOLDER"};
  return std::find(names.begin(), names.end(), word) != names.end();
}

/// Returns the words that an option takes: those of a check for membership ("TEXT:{a,b}"), else
/// those between the bars of its type's name.
std::vector<std::string> choicesOf(const std::string& type) {
  const std::size_t open = type.find(":{");
  if (open != std::string::npos)
    return partsOf(type.substr(open + 2, type.find('}', open) - open - 2), ',');
  if (type.find('|') == std::string::npos)
    return {};
  std::vector<std::string> words = partsOf(type.substr(0, type.find(':')), '|');
  std::erase_if(words, standsForValues);
  return words;
}

Completes completionOf(const TableOption& option) {
  if (!option.takesValue)
    return Completes::nothing;
  if (!option.choices.empty())
    return Completes::choices;
  if (option.value.find("FILE") != std::string::npos || option.positional)
    return Completes::files;
  return option.value.find("FOLDER") != std::string::npos ? Completes::folders : Completes::nothing;
}

TableOption rowOf(const CLI::Option& declared) {
  TableOption row;
  row.positional = declared.get_positional();
  if (row.positional)
    row.names.push_back(declared.get_name(true));
  for (const std::string& name : declared.get_snames())
    row.names.push_back("-" + name);
  for (const std::string& name : declared.get_lnames())
    row.names.push_back("--" + name);
  const std::string type = declared.get_type_name();
  row.takesValue = declared.get_items_expected_max() > 0;
  row.value = row.takesValue ? type.substr(0, type.find(':')) : std::string();
  row.about = trimmed(CLI::Formatter().make_option_opts(&declared));
  row.help = declared.get_description();
  row.group = declared.get_group();
  row.choices = row.takesValue ? choicesOf(type) : std::vector<std::string>();
  row.completes = completionOf(row);
  row.repeated = declared.get_items_expected_max() >= CLI::detail::expected_max_vector_size;
  return row;
}

/// Collects a command's options and those of its option groups. An option group is a sub-command
/// without a name; it has a --help of its own, which counts once.
void collect(const CLI::App& command, const std::string& group, std::vector<TableOption>& rows) {
  for (const CLI::Option* declared : command.get_options()) {
    const bool helpAgain = !group.empty() && declared == command.get_help_ptr();
    if (declared->get_group().empty() || helpAgain)
      continue;
    TableOption row = rowOf(*declared);
    if (!group.empty())
      row.group = group;
    rows.push_back(std::move(row));
  }
  for (const CLI::App* part :
       command.get_subcommands([](const CLI::App* each) { return each->get_name().empty(); }))
    collect(*part, part->get_group(), rows);
}

}  // namespace

CommandTable tableOf(const CLI::App& command, const std::string& title) {
  std::string usage = trimmed(CLI::Formatter().make_usage(&command, title));
  const std::string label = "Usage: ";
  if (usage.starts_with(label))
    usage.erase(0, label.size());
  CommandTable table{.name = command.get_name(),
                     .usage = usage,
                     .description = command.get_description(),
                     .footer = command.get_footer(),
                     .options = {}};
  collect(command, "", table.options);
  return table;
}

std::vector<const CLI::App*> shownCommands(const CLI::App& program) {
  return program.get_subcommands(
      [](const CLI::App* each) { return !each->get_name().empty() && !each->get_group().empty(); });
}

}  // namespace sline::cli
