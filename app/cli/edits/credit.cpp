// SPDX-License-Identifier: Apache-2.0
// Implements `sline credit`: says and tells whose work the surfaces of a scene file are.
#include <map>

#include "app/cli/commands/command.h"
#include "app/cli/files/json_values.h"
#include "app/cli/files/names.h"
#include "model/edit/credits.h"
#include "model/scene_file/scene_file.h"

namespace sline::cli {

namespace {

struct CreditFlags {
  std::string scene;
  std::vector<std::string> names;
  std::optional<std::string> authors;
  std::optional<std::string> source;
  std::optional<std::string> licence;
  bool clear = false;
  bool json = false;
  std::string output;

  bool changes() const { return authors || source || licence || clear; }
};

void printCredits(const model::Scene& scene, bool json) {
  Json root{{"credits", Json::array()}};
  for (const model::Node& node : scene.nodes()) {
    const model::SourceCredit& credit = node.provenance.credit;
    if (node.isGroup() || (!json && credit.empty()))
      continue;
    if (!json)
      std::cout << onOneLine(node.name) << ": " << onOneLine(credit.line()) << '\n';
    root["credits"].push_back({{"name", node.name},
                               {"authors", credit.authors},
                               {"source", credit.source},
                               {"licence", credit.licence}});
  }
  if (json)
    std::cout << jsonText(root, 2) << '\n';
  else if (root["credits"].empty())
    std::cout << "the scene does not say whose work its surfaces are\n";
}

/// Returns the scene in which the named structures say what was typed, and keep what was not.
Result<model::Edited> credited(const model::Scene& scene, const CreditFlags& flags) {
  std::vector<model::NodeId> ids;
  for (const std::string& name : flags.names) {
    const std::vector<model::NodeId> found = scene.named(name);
    if (found.empty()) {
      std::vector<std::string> known;
      for (const model::Node& node : scene.nodes())
        known.push_back(node.name);
      return unknownName("structure or group", name, known);
    }
    ids.insert(ids.end(), found.begin(), found.end());
  }
  if (ids.empty())
    ids.push_back(model::rootId);
  const std::optional<std::string> cleared =
      flags.clear ? std::optional(std::string()) : std::nullopt;
  return model::withCredit(scene, ids,
                           {.authors = flags.authors ? flags.authors : cleared,
                            .source = flags.source ? flags.source : cleared,
                            .licence = flags.licence ? flags.licence : cleared});
}

Exit runCredit(const CreditFlags& flags) {
  for (const std::string& file : {flags.scene, flags.output})
    if (!file.empty() && !model::isSceneFile(file))
      return complain(
          {.file = file,
           .reason = "a scene file's name ends with " + std::string(model::sceneExtension),
           .remedy = "Name a scene file; `sline import` makes one"},
          Exit::wrongUse);
  if (!flags.changes()) {
    const Result<model::SceneDocument> document = openedScene(flags.scene);
    if (!document.ok())
      return complain(document.error(), Exit::failed);
    printCredits(document->scene, flags.json);
    return Exit::done;
  }
  const auto lock = model::FileLock::acquire(flags.output.empty() ? flags.scene : flags.output);
  if (!lock.ok())
    return complain(lock.error(), Exit::failed);
  Result<model::SceneDocument> document = openedScene(flags.scene);
  if (!document.ok())
    return complain(document.error(), Exit::failed);
  Result<model::Edited> edited = credited(document->scene, flags);
  if (!edited.ok())
    return complain(edited.error(), Exit::wrongUse);
  if (!edited->changed && flags.output.empty())
    return Exit::done;
  document->scene = std::move(edited->scene);
  if (const Status written = model::writeSceneFile(*lock, *document); !written.ok())
    return complain(written.error(), Exit::failed);
  return Exit::done;
}

void declareCredit(CLI::App& command, CreditFlags& flags) {
  command.add_option("SCENE", flags.scene, "A scene file (sline)")->required();
  command.add_option("NAME", flags.names,
                     "Structures, or groups and all in them; without one, all of the scene");
  const auto add = [&command](const char* flag, std::optional<std::string>& text,
                              const char* meaning) {
    command.add_option(flag, text, meaning)->type_name("TEXT");
  };
  add("--authors", flags.authors, "Who made the surfaces; without words taken away");
  add("--source", flags.source, "The collection they are of, or its address");
  add("--licence,--license", flags.licence, "Under what terms they may be used: \"CC BY 4.0\"");
  command.add_flag("--clear", flags.clear, "Takes away what the scene says first");
  command.add_flag("--json", flags.json, "For programs: what the scene says as one JSON object");
  command.add_option("-o,--output", flags.output, "Writes there and leaves SCENE as it is")
      ->type_name("FILE.sline");
  command.footer(
      "Without any of the flags it tells what the scene says. Importing reads it from the files'\n"
      "own comments and from a LICENSE, CITATION or README beside them; exports print it with\n"
      "--credits line or page.\n\n"
      "  sline credit pelvis.sline --source BodyParts3D --licence \"CC BY-SA 2.1 JP\"\n"
      "  sline credit pelvis.sline tumour --authors \"Jane Doe\"");
}

}  // namespace

void addCredit(CLI::App& program, Exit& exit) {
  addCommand<CreditFlags>(program, exit,
                          {"credit", "Say or tell whose work the surfaces of a scene file are"},
                          declareCredit, runCredit);
}

}  // namespace sline::cli
