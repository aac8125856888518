// SPDX-License-Identifier: Apache-2.0
// Writes man pages in the macros of man(7), as Debian's man and mandoc read them.
#include "app/cli/manual/man_page.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <sstream>

#include "model/base/letters.h"

namespace sline::cli {

namespace {

/// Returns the code point at `at`, which moves to its last byte. The texts are our own, so they are
/// UTF-8.
unsigned codePoint(const std::string& text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const int more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
  unsigned code = lead & (0x3fu >> more);
  for (int i = 0; i < more && at + 1 < text.size(); ++i)
    code = code << 6 | (static_cast<unsigned char>(text[++at]) & 0x3fu);
  return code;
}

/// Escapes a character that troff would change: a hyphen into a dash, quotes into typographic ones.
std::string troffSign(char sign) {
  switch (sign) {
    case '\\':
      return "\\(rs";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '"':
      return "\\(dq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return {sign};
  }
}

/// Returns a line of text; at its beginning a dot would call a macro.
std::string troffLine(const std::string& text) {
  return (text.starts_with('.') ? "\\&" : "") + troffEscaped(text) + "\n";
}

/// Returns prose, which is filled; indented lines are examples and stay as they are, and an empty
/// line separates paragraphs.
std::string troffProse(const std::string& text) {
  std::string out;
  bool example = false;
  bool parted = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool indented = line.starts_with("  ");
    if (line.empty()) {
      parted = true;
      continue;
    }
    if (indented && !example)
      out += out.empty() ? ".EX\n" : ".PP\n.EX\n";
    else if (indented && parted)
      out += ".sp\n";
    else if (!indented && example)
      out += ".EE\n.PP\n";
    else if (parted)
      out += ".PP\n";
    out += troffLine(line);
    example = indented;
    parted = false;
  }
  return out + (example ? ".EE\n" : "");
}

std::string pageHeader(const std::string& title) {
  std::string upper = title;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return ".\\\" SPDX-License-Identifier: Apache-2.0\n.TH " + troffEscaped(upper) +
         " 1 \"\" \"Sline " SLINE_VERSION
         "\" \"User commands\"\n"
         // Names of options and JSON are neither hyphenated nor stretched.
         ".nh\n.ad l\n";
}

std::string summary(const std::string& description) {
  std::string line = description.substr(0, description.find('\n'));
  if (!line.empty() && !line.starts_with("Sline"))
    line[0] = lowerCase(line[0]);
  if (line.ends_with('.'))
    line.pop_back();
  return line;
}

std::string optionsSection(const CommandTable& command) {
  std::vector<std::string> groups;
  for (const TableOption& option : command.options)
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
      groups.push_back(option.group);
  std::string out = ".SH OPTIONS\n";
  for (const std::string& group : groups) {
    if (group != "Options")
      out += ".SS " + troffEscaped(group) + "\n";
    for (const TableOption& option : command.options) {
      if (option.group != group)
        continue;
      out += ".TP\n";
      for (std::size_t i = 0; i < option.names.size(); ++i)
        out += std::string(i == 0 ? "" : ", ") + "\\fB" + troffEscaped(option.names[i]) + "\\fR";
      if (!option.about.empty())
        out += " " + troffEscaped(option.about);
      out += "\n" + troffProse(option.help);
    }
  }
  return out;
}

std::string synopsis(const std::string& usage) {
  return ".SH SYNOPSIS\n" + troffLine(usage);
}

std::string exitStatus() {
  return ".SH EXIT STATUS\n.TP\n0\nDone; parts that are missing or broken are left out, with a "
         "warning.\n.TP\n1\nNothing could be read, drawn or written.\n.TP\n2\nWrong use.\n";
}

}  // namespace

std::string troffEscaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (static_cast<unsigned char>(text[i]) < 0x80) {
      out += troffSign(text[i]);
      // Long lists of words and JSON may be broken there.
      if ((text[i] == ',' || text[i] == '|') && i + 1 < text.size() && text[i + 1] != ' ')
        out += "\\:";
      continue;
    }
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "\\[u%04X]", codePoint(text, i));
    out += name.data();
  }
  return out;
}

std::string programPage(const CommandTable& program, const std::vector<CommandTable>& commands) {
  std::string out = pageHeader("sline") + ".SH NAME\nsline \\- " +
                    troffLine("line illustrations of anatomy") + synopsis(program.usage) +
                    ".SH DESCRIPTION\n" + troffProse(program.description) + ".SH COMMANDS\n";
  for (const CommandTable& command : commands)
    out += ".TP\n.BR sline\\-" + troffEscaped(command.name) + " (1)\n" +
           troffLine(command.description);
  out += optionsSection(program) + exitStatus() + ".SH SEE ALSO\n";
  for (const CommandTable& command : commands)
    out += ".BR sline\\-" + troffEscaped(command.name) +
           (&command == &commands.back() ? " (1)\n" : " (1),\n");
  return out;
}

std::string commandPage(const CommandTable& command) {
  const std::string title = "sline-" + command.name;
  std::string out = pageHeader(title) + ".SH NAME\n" + troffEscaped(title) + " \\- " +
                    troffEscaped(summary(command.description)) + "\n" + synopsis(command.usage) +
                    ".SH DESCRIPTION\n" + troffProse(command.description + ".");
  out += optionsSection(command);
  if (!command.footer.empty())
    out += ".SH NOTES\n" + troffProse(command.footer);
  return out + exitStatus() + ".SH SEE ALSO\n.BR sline (1)\n";
}

}  // namespace sline::cli
