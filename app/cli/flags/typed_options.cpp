// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/typed_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/cli/flags/option_kinds.h"
#include "model/disk/whole_file.h"

namespace sline::cli {

namespace {

/// This is enough for a book; anything longer is not a leaflet's text.
constexpr std::size_t mostBytes = 1'000'000;

/// Returns "--grey" for "--grey,--gray".
std::string flagOf(const render::ExportOption& option) {
  const std::string flag = option.flag;
  return flag.substr(0, flag.find(','));
}

/// Tells whether the text is a single word with a folder or an ending, as in
/// "leaflets/bladder.txt", but not a page's address.
bool looksLikeFile(const std::string& text) {
  if (text.empty() || text.find_first_of(" \t\r\n") != std::string::npos ||
      text.find("://") != std::string::npos)
    return false;
  return text.find('/') != std::string::npos ||
         std::filesystem::path(text).extension().string().size() > 1;
}

/// Returns the text of the file of that name if there is one, else the text itself.
Result<std::string> textOrFile(const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const fs::file_status there = text.find('\n') == std::string::npos && text.size() <= 4000
                                    ? fs::status(text, fault)
                                    : fs::file_status(fs::file_type::not_found);
  if (fs::exists(there) && !fs::is_directory(there))
    return model::readText(text, mostBytes);
  if (looksLikeFile(text))
    return Error{.file = text,
                 .reason = fs::is_directory(there) ? "it is a folder, and no text for a patient"
                                                   : "there is no such file with a text",
                 .remedy = "Check its name; a text of one word ends with a full stop"};
  return text;
}

std::string valueName(const render::ExportOption& option) {
  const auto* several = std::get_if<render::ChoiceOption>(&option.kind);
  if (!several)
    return option.value;
  std::string names;
  for (const render::OptionChoice& choice : several->choices)
    names += (names.empty() ? "" : "|") + std::string(choice.id);
  return names;
}

}  // namespace

CLI::Option* TypedOptions::declare(CLI::App& command, const render::ExportOption& option,
                                   const std::string& kinds, const render::ExportOrder& order) {
  const std::string help = option.help + (kinds.empty() ? "" : " (" + kinds + ")");
  const std::string standard = render::optionText(option, option.field.read(order));
  if (std::holds_alternative<render::SwitchOption>(option.kind)) {
    CLI::Option* flag = command.add_flag_function(
        option.flag,
        [this, &option](std::int64_t count) { m_texts[&option] = count > 0 ? "true" : "false"; },
        help);
    // A flag that can be negated shows in its help what holds without it.
    if (std::string_view(option.flag).find('!') != std::string_view::npos)
      flag->default_str(standard);
    return flag;
  }
  CLI::Option* made = command.add_option_function<std::string>(
      option.flag, [this, &option](const std::string& text) { m_texts[&option] = text; }, help);
  made->type_name(valueName(option));
  const auto* number = std::get_if<render::NumberOption>(&option.kind);
  if (number)
    made->check(within(number->low, number->high));
  // A number that the writer decides when it is left out has no default.
  const bool open = number && standard.starts_with('-');
  if (!standard.empty() && !open)
    made->default_str(standard);
  return made;
}

std::string TypedOptions::typed(const render::ExportOption& option) const {
  const auto found = m_texts.find(&option);
  return found == m_texts.end() ? std::string() : found->second;
}

Result<render::OptionValue> parseTypedOption(const render::ExportOption& option,
                                             const std::string& typed) {
  std::string text = typed;
  if (const auto* kind = std::get_if<render::TextOption>(&option.kind); kind && kind->fromFile) {
    text = TRY(textOrFile(typed));
  }
  Result<render::OptionValue> value = render::parseOption(option, text);
  if (value.ok())
    return value;
  const bool longText = std::holds_alternative<render::TextOption>(option.kind);
  return Error{
      .reason = flagOf(option) + (longText ? " " : " " + text + " ") + value.error().reason,
      .remedy = value.error().remedy};
}

Status TypedOptions::applyTo(render::ExportOrder& order) const {
  for (const auto& [option, text] : m_texts) {
    const render::OptionValue value = TRY(parseTypedOption(*option, text));
    option->field.write(order, value);
  }
  return Unit{};
}

}  // namespace sline::cli
