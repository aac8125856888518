// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/view_words.h"

#include <set>
#include <utility>

#include "app/cli/files/language_tag.h"
#include "model/scene_json/json_value.h"

namespace sline::cli {

namespace {

/// Sets what a flag's values say: TEXT or LANGUAGE=TEXT each; no words take away what there is.
Status applyWords(const char* flag, const std::vector<std::string>& values,
                  model::Wording& wording) {
  std::set<std::string> said;
  for (const std::string& value : values) {
    const std::size_t cut = value.find('=');
    const bool tagged = cut != std::string::npos && isLanguageTag(value.substr(0, cut));
    const std::string language = tagged ? value.substr(0, cut) : std::string();
    if (!said.insert(language).second)
      return Error{.reason = std::string(flag) + " says two things in " +
                             (language.empty() ? std::string("the scene's own language")
                                               : "the language " + language),
                   .remedy = "Leave one out"};
    wording.set(language, tagged ? value.substr(cut + 1) : value);
  }
  return Unit{};
}

nlohmann::json jsonWording(const model::Wording& wording) {
  nlohmann::json json = nlohmann::json::object();
  if (!wording.text.empty())
    json[""] = wording.text;
  for (const auto& [language, text] : wording.texts)
    json[language] = text;
  return json;
}

}  // namespace

std::vector<CLI::Option*> addViewWordOptions(CLI::App& command, ViewWordFlags& flags) {
  const auto add = [&command](const char* flag, std::vector<std::string>& values,
                              const char* meaning) {
    return command.add_option(flag, values, meaning)->type_name("[LANG=]TEXT")->take_all();
  };
  return {add("--title", flags.title,
              "The view's title where that is not its name; with de= and the like in another "
              "language, and without words taken away"),
          add("--text", flags.text,
              "What is to be read with the view, marked up as callouts are: *italic*, **bold**"),
          add("--notes", flags.notes, "Notes for who presents the view"),
          add("--alt", flags.alt,
              "What the view shows, for who does not see it; exports say it where labels are "
              "written out, and else what is seen (`sline describe`)"),
          command
              .add_option("--seconds", flags.seconds,
                          "How long the view is shown in films; 0 for as long as others")
              ->type_name("S")};
}

Result<model::ViewWords> withWordFlags(const model::ViewWords& words, const ViewWordFlags& flags) {
  model::ViewWords changed = words;
  struct Said {
    const char* flag;
    const std::vector<std::string>& values;
    model::Wording& wording;
  };
  for (const Said& said :
       {Said{"--title", flags.title, changed.title}, Said{"--text", flags.text, changed.text},
        Said{"--notes", flags.notes, changed.notes}, Said{"--alt", flags.alt, changed.description}})
    TRY(applyWords(said.flag, said.values, said.wording));
  if (flags.seconds && *flags.seconds != 0.0f && !model::viewSecondsLimits.contain(*flags.seconds))
    return Error{.reason = "--seconds takes 0.1 to 3600, or 0 for as long as others",
                 .remedy = "Choose another time"};
  if (flags.seconds)
    changed.seconds = *flags.seconds != 0.0f ? flags.seconds : std::nullopt;
  return changed;
}

nlohmann::json jsonWords(const model::ViewWords& words) {
  nlohmann::json json{{"title", jsonWording(words.title)},
                      {"text", jsonWording(words.text)},
                      {"notes", jsonWording(words.notes)},
                      {"alt", jsonWording(words.description)}};
  json["seconds"] = words.seconds ? nlohmann::json(model::jsonNumber(*words.seconds)) : nullptr;
  return json;
}

}  // namespace sline::cli
