// SPDX-License-Identifier: Apache-2.0
#include "app/cli/manual/completions.h"

namespace sline::cli {

namespace {

constexpr const char* licenceLine = "# SPDX-License-Identifier: Apache-2.0\n";

/// Returns the text with a backslash before each character that is one of `signs`.
std::string backslashed(const std::string& text, const std::string& signs) {
  std::string out;
  for (const char sign : text) {
    if (signs.find(sign) != std::string::npos)
      out += '\\';
    out += sign == '\n' ? ' ' : sign;
  }
  return out;
}

/// Returns the text as one word of bash and zsh.
std::string inQuotes(const std::string& text) {
  std::string out = "'";
  for (const char sign : text)
    out += sign == '\'' ? "'\\''" : std::string(1, sign);
  return out + "'";
}

/// Returns the text as one word of fish, where a backslash has a meaning within quotes too.
std::string inFishQuotes(const std::string& text) {
  return "'" + backslashed(text, "\\'") + "'";
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string out;
  for (const std::string& word : words)
    out += (out.empty() ? "" : separator) + word;
  return out;
}

std::string optionNames(const CommandTable& command) {
  std::vector<std::string> names;
  for (const TableOption& option : command.options)
    if (!option.positional)
      names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names, " ");
}

std::vector<std::string> commandNames(const ProgramTable& table) {
  std::vector<std::string> names;
  for (const CommandTable& command : table.commands)
    names.push_back(command.name);
  return names;
}

/// Returns the possible values as an assignment to the variables of `_sline` below.
std::string bashValues(const TableOption& option) {
  switch (option.completes) {
    case Completes::choices:
      return "words=" + inQuotes(joined(option.choices, " "));
    case Completes::files:
      return "paths=-f";
    case Completes::folders:
      return "paths=-d";
    case Completes::nothing:
      break;
  }
  return ":";
}

/// Appends cases of "COMMAND OPTION" for options with a value, and of "COMMAND" for its options and
/// positional arguments.
void appendBashCases(const CommandTable& command, std::string& values, std::string& rest) {
  std::string alone = ":";
  for (const TableOption& option : command.options) {
    if (option.positional) {
      alone = bashValues(option);
      continue;
    }
    if (!option.takesValue)
      continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names)
      patterns.push_back(inQuotes(command.name + " " + name));
    values += "    " + joined(patterns, " | ") + ") " + bashValues(option) + " ;;\n";
  }
  rest += "    " + inQuotes(command.name) + ") options=" + inQuotes(optionNames(command)) + "; " +
          alone + " ;;\n";
}

/// Returns what `_arguments` of zsh appends to an option that takes a value.
std::string zshValue(const TableOption& option) {
  if (!option.takesValue)
    return {};
  const std::string message =
      ":" + backslashed(option.value.empty() ? option.names.front() : option.value, "\\:");
  switch (option.completes) {
    case Completes::choices:
      return message + ":(" + joined(option.choices, " ") + ")";
    case Completes::files:
      return message + ":_files";
    case Completes::folders:
      return message + ":_files -/";
    case Completes::nothing:
      break;
  }
  return message + ": ";
}

std::string zshArguments(const CommandTable& command) {
  std::string out;
  for (const TableOption& option : command.options) {
    if (option.positional) {
      out += " \\\n        " + inQuotes((option.repeated ? "*" : "1") + zshValue(option));
      continue;
    }
    for (const std::string& name : option.names)
      out += " \\\n        " + inQuotes((option.repeated ? "*" : "") + name + "[" +
                                        backslashed(option.help, "\\[]") + "]" + zshValue(option));
  }
  return out;
}

std::string fishValue(const TableOption& option) {
  switch (option.completes) {
    case Completes::choices:
      return " -x -a " + inFishQuotes(joined(option.choices, " "));
    case Completes::files:
      return " -r -F";
    case Completes::folders:
      return " -x -a '(__fish_complete_directories)'";
    case Completes::nothing:
      break;
  }
  return option.takesValue ? " -x" : "";
}

std::string fishOptions(const CommandTable& command, const std::string& when) {
  std::string out;
  for (const TableOption& option : command.options) {
    const std::string line = "complete -c sline -n " + inFishQuotes(when);
    if (option.positional) {
      if (option.completes == Completes::choices)
        out += line + " -f -a " + inFishQuotes(joined(option.choices, " ")) + "\n";
      continue;
    }
    out += line;
    for (const std::string& name : option.names)
      out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    out += fishValue(option) + " -d " + inFishQuotes(option.help) + "\n";
  }
  return out;
}

}  // namespace

std::string bashCompletion(const ProgramTable& table) {
  std::string values;
  std::string rest;
  for (const CommandTable& command : table.commands)
    appendBashCases(command, values, rest);
  const std::string first =
      inQuotes(joined(commandNames(table), " ") + " " + optionNames(table.program));
  return std::string(licenceLine) + R"(_sline() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local command=${COMP_WORDS[1]} words= paths= options=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W )" +
         first + R"( -- "$current")
    return
  fi
  # "--option=value" comes as three words.
  if [[ $current == '=' ]]; then
    current=
  elif [[ $previous == '=' ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case "$command $previous" in
)" + values +
         R"(    *) case "$command" in
)" + rest +
         R"(    esac ;;
  esac
  if [[ $current == -* && -n $options ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  elif [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  elif [[ -n $paths ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$paths" -- "$current")
  fi
}
complete -F _sline sline
)";
}

std::string zshCompletion(const ProgramTable& table) {
  std::string out = "#compdef sline\n" + std::string(licenceLine) + "_sline() {\n" +
                    "  local -a commands\n  commands=(\n";
  for (const CommandTable& command : table.commands)
    out += "    " + inQuotes(command.name + ":" + backslashed(command.description, "\\:")) + "\n";
  out += "  )\n  if (( CURRENT == 2 )); then\n    _describe -t commands command commands\n" +
         ("    _arguments" + zshArguments(table.program)) +
         "\n    return\n  fi\n  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n" +
         "  case $command in\n";
  for (const CommandTable& command : table.commands)
    out += "    " + command.name + ")\n      _arguments" + zshArguments(command) + "\n      ;;\n";
  return out + "  esac\n}\n_sline \"$@\"\n";
}

std::string fishCompletion(const ProgramTable& table) {
  const std::string first = "__fish_use_subcommand";
  std::string out = std::string(licenceLine) + "complete -c sline -n " + first + " -f\n";
  for (const CommandTable& command : table.commands)
    out += "complete -c sline -n " + first + " -f -a " + command.name + " -d " +
           inFishQuotes(command.description) + "\n";
  out += fishOptions(table.program, first);
  for (const CommandTable& command : table.commands)
    out += fishOptions(command, "__fish_seen_subcommand_from " + command.name);
  return out;
}

}  // namespace sline::cli
