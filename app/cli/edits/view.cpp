// SPDX-License-Identifier: Apache-2.0
// Implements `sline view`: lists and changes the saved views of a scene file.
#include <algorithm>
#include <charconv>

#include "app/cli/commands/command.h"
#include "app/cli/files/json_values.h"
#include "app/cli/files/names.h"
#include "app/cli/files/thumbnail.h"
#include "app/cli/flags/picture_options.h"
#include "app/cli/flags/view_words.h"
#include "model/edit/annotations.h"
#include "model/edit/views.h"
#include "model/look/opening_look.h"
#include "model/scene/markup.h"
#include "model/scene_file/scene_file.h"
#include "model/scene_json/camera_json.h"

namespace sline::cli {

namespace {

struct ViewFlags {
  std::string scene;
  std::string output;
  std::string add;
  std::string update;
  std::string tell;
  std::string rename;
  std::string remove;
  std::string move;
  bool list = false;
  bool json = false;
  std::string labels;
  ViewWordFlags words;
  PictureFlags picture;
};

/// Holds the edited scene, or an error that counts as wrong use.
using Outcome = Result<model::Edited>;

Error unknownSaved(const model::Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const model::View& view : scene.views())
    names.push_back(view.name);
  Error error = unknownName("saved view", name, names);
  if (names.empty())
    error.remedy = "The scene has no saved views; --add makes one";
  else if (nearNames(name, names).empty())
    error.remedy = "`sline view SCENE --list` lists them";
  return error;
}

Result<std::size_t> indexOfView(const model::Scene& scene, const std::string& name) {
  const model::View* view = savedView(scene, name);
  if (!view)
    return unknownSaved(scene, name);
  return std::size_t(view - scene.views().data());
}

/// Reads a whole number from 1 upwards, as people count.
std::optional<std::uint64_t> parseOrdinal(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number == 0)
    return std::nullopt;
  return number;
}

/// Reads "all", "none" or ids as the annotations that the view shows.
Status chooseLabels(const model::Scene& scene, const std::string& text, model::View& view) {
  if (text.empty())
    return Unit{};
  view.annotations.emplace();
  if (text == "none")
    return Unit{};
  if (text == "all") {
    for (const model::Annotation& annotation : scene.annotations())
      view.annotations->push_back(annotation.id);
    return Unit{};
  }
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const model::AnnotationId id{parseOrdinal(word).value_or(0)};
    const auto& all = scene.annotations();
    if (std::none_of(all.begin(), all.end(), [id](const auto& each) { return each.id == id; }))
      return Error{.reason = "no annotation has the number \"" + word + "\"",
                   .remedy =
                       "Give --labels all, none, or numbers such as 1,4; `sline view SCENE "
                       "--list --json` lists those of the scene"};
    view.annotations->push_back(id);
    begin = end + 1;
  }
  return Unit{};
}

/// Returns the view that the flags describe, of a scene that they leave unchanged. `before` is the
/// view that it replaces: what they do not say stays as that has it.
Result<model::View> viewFromFlags(const model::Scene& scene, const ViewFlags& flags,
                                  const std::string& name, const model::View* before = nullptr) {
  PictureSpec spec = TRY(parseFlagsWithoutOutput(flags.picture));
  const bool fromBefore = before && !savedView(scene, spec.view);
  const model::Scene start =
      fromBefore ? model::withViewApplied(scene, *before).scene : withSavedView(scene, spec);
  if (fromBefore && spec.view.empty() && !spec.camera)
    spec.camera = before->camera;
  const model::Scene focus = TRY(inFocus(start, spec));
  const model::Scene dressed = TRY(styled(focus, spec));
  const model::Scene cut = TRY(cutOpen(dressed, spec));
  const model::Camera camera = TRY(cameraFor(cut, spec));
  model::View view = model::viewOf(cut, camera, name);
  TRY(chooseLabels(scene, flags.labels, view));
  view.words = TRY(withWordFlags({}, flags.words));
  return view;
}

/// Warns that a saved view is found before the side of the body of the same name.
void warnOfSide(const std::string& name) {
  if (model::anatomicalViewNamed(model::normalisedName(name)))
    warn("--view " + onOneLine(name) + " shows this saved view from now on, not the " +
         model::normalisedName(name) + " view fitted to what is visible");
}

/// Gives a new view the labels that no other has, and says so where others have all.
void takeUnclaimed(const model::Scene& scene, model::View& view) {
  view.annotations = model::unclaimedAnnotations(scene);
  const auto& all = scene.annotations();
  if (view.annotations->empty() &&
      std::any_of(all.begin(), all.end(), [](const auto& each) { return each.visible; }))
    warn(
        "the new view shows no labels, as they are those of other views. Give --labels all, or "
        "numbers");
}

Outcome addNamedView(const model::Scene& scene, const ViewFlags& flags) {
  if (model::normalisedName(flags.add).empty())
    return Error{.reason = "a view needs a name", .remedy = "Write --add NAME"};
  if (savedView(scene, flags.add))
    return Error{.reason = "a view named \"" + flags.add + "\" is already saved",
                 .remedy = "Take another name, or --update it"};
  model::View view = TRY(viewFromFlags(scene, flags, flags.add));
  if (flags.labels.empty())
    takeUnclaimed(scene, view);
  warnOfSide(flags.add);
  return model::withView(scene, view);
}

/// Changes what is said with a view.
Outcome tellOfView(const model::Scene& scene, const ViewFlags& flags, const std::string& name) {
  const std::size_t place = TRY(indexOfView(scene, name));
  const auto words = TRY(withWordFlags(scene.views()[place].words, flags.words));
  return model::withViewWords(scene, place, words);
}

Outcome updateNamedView(const model::Scene& scene, const ViewFlags& flags) {
  const std::size_t place = TRY(indexOfView(scene, flags.update));
  const model::View view = TRY(viewFromFlags(scene, flags, flags.update, &scene.views()[place]));
  model::Edited updated = model::withViewUpdated(scene, place, view);
  if (!flags.words.any())
    return updated;
  Outcome told = tellOfView(updated.scene, flags, flags.update);
  if (told.ok())
    told->changed = told->changed || updated.changed;
  return told;
}

/// Renames a saved view. Names may have an '=' in them: of the places where the text could be cut,
/// the first that leaves a saved view's name before it is taken.
Outcome renameView(const model::Scene& scene, const std::string& text) {
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    const model::View* view = savedView(scene, text.substr(0, at));
    if (!view)
      continue;
    const auto place = std::size_t(view - scene.views().data());
    const std::string name = text.substr(at + 1);
    if (model::normalisedName(name).empty())
      return Error{.reason = "a view needs a name", .remedy = "Write --rename OLD=NEW"};
    const model::View* taken = savedView(scene, name);
    if (taken && taken != view)
      return Error{.reason = "a view named \"" + name + "\" is already saved",
                   .remedy = "Take another name"};
    warnOfSide(name);
    return model::withViewRenamed(scene, place, name);
  }
  if (text.find('=') == std::string::npos)
    return Error{.reason = "--rename " + text + " gives no new name",
                 .remedy = "Write --rename OLD=NEW"};
  return unknownSaved(scene, text.substr(0, text.find('=')));
}

Outcome moveView(const model::Scene& scene, const std::string& text) {
  const std::optional<NamedValue> named = splitNamed(text);
  const std::size_t count = scene.views().size();
  const auto position = named ? parseOrdinal(named->value) : std::nullopt;
  if (!named || !position)
    return Error{.reason = "--move " + text + " gives no position",
                 .remedy = "Write --move NAME=POSITION; 1 is the first"};
  const std::size_t place = TRY(indexOfView(scene, named->name));
  if (*position > count)
    return Error{.reason = "position " + named->value + " is beyond the last view",
                 .remedy = "The scene has " + std::to_string(count)};
  return model::withViewMoved(scene, place, std::size_t(*position - 1));
}

Outcome removeView(const model::Scene& scene, const std::string& name) {
  const std::size_t place = TRY(indexOfView(scene, name));
  return model::withoutView(scene, place);
}

Outcome applyEdit(const model::Scene& given, const ViewFlags& flags) {
  // A view says how everything is drawn, and a scene with such a view opens without a look of its
  // own (model::hasNoLook): it keeps the one that it has been drawn with.
  const bool looks = !flags.add.empty() || !flags.update.empty();
  const model::Scene scene = looks ? model::dressed(given) : given;
  if (!flags.update.empty())
    return updateNamedView(scene, flags);
  if (!flags.tell.empty())
    return tellOfView(scene, flags, flags.tell);
  if (!flags.rename.empty())
    return renameView(scene, flags.rename);
  if (!flags.remove.empty())
    return removeView(scene, flags.remove);
  if (!flags.move.empty())
    return moveView(scene, flags.move);
  return addNamedView(scene, flags);
}

Json jsonView(const model::Scene& scene, const model::View& view) {
  Json json{{"name", view.name}, {"camera", model::cameraJson(view.camera)}};
  json["looks"] = view.looks ? Json(view.looks->size()) : Json();
  json["sections"] = view.sections ? Json(view.sections->size()) : Json();
  json["labels"] = Json();
  if (view.annotations) {
    json["labels"] = Json::array();
    for (const model::AnnotationId id : *view.annotations)
      json["labels"].push_back(id.value);
  }
  json["absent"] = model::absentFrom(scene, view);
  json.update(jsonWords(view.words));
  return json;
}

void printJson(const model::Scene& scene) {
  Json root;
  root["views"] = Json::array();
  for (const model::View& view : scene.views())
    root["views"].push_back(jsonView(scene, view));
  root["labels"] = Json::array();
  for (const model::Annotation& annotation : scene.annotations())
    root["labels"].push_back({{"id", annotation.id.value},
                              {"text", model::plainText(annotation.kind, annotation.text)}});
  std::cout << jsonText(root, 2) << '\n';
}

void printList(const model::Scene& scene) {
  std::size_t number = 0;
  for (const model::View& view : scene.views()) {
    std::cout << ++number << "  " << onOneLine(view.name);
    if (const std::size_t absent = model::absentFrom(scene, view); absent > 0)
      std::cout << "  (" << absent << " of what it shows " << (absent == 1 ? "is" : "are")
                << " no longer in the scene)";
    std::cout << '\n';
  }
  if (scene.views().empty())
    std::cout << "the scene has no saved views\n";
}

Exit list(const ViewFlags& flags) {
  const Result<model::SceneDocument> document = openedScene(flags.scene);
  if (!document.ok())
    return complain(document.error(), Exit::failed);
  if (flags.json)
    printJson(document->scene);
  else
    printList(document->scene);
  return Exit::done;
}

/// Reads, edits and writes; the file written to is locked all the while.
Exit edit(const ViewFlags& flags) {
  const auto lock = model::FileLock::acquire(flags.output.empty() ? flags.scene : flags.output);
  if (!lock.ok())
    return complain(lock.error(), Exit::failed);
  Result<model::SceneDocument> document = openedScene(flags.scene);
  if (!document.ok())
    return complain(document.error(), Exit::failed);
  Outcome outcome = applyEdit(document->scene, flags);
  if (!outcome.ok())
    return complain(outcome.error(), Exit::wrongUse);
  if (!outcome->changed && flags.output.empty())
    return Exit::done;
  const auto first = [](const model::Scene& scene) {
    return scene.views().empty() ? std::nullopt : std::optional(scene.views().front().camera);
  };
  const bool another = !(first(document->scene) == first(outcome->scene));
  document->scene = std::move(outcome->scene);
  if (another)  // its small picture is taken from the first view
    document->thumbnail = thumbnailOf(document->scene);
  if (const Status written = model::writeSceneFile(*lock, *document); !written.ok())
    return complain(written.error(), Exit::failed);
  return Exit::done;
}

Exit runView(const ViewFlags& flags) {
  for (const std::string& file : {flags.scene, flags.output})
    if (!file.empty() && !model::isSceneFile(file))
      return complain(
          {.file = file,
           .reason = "a scene file's name ends with " + std::string(model::sceneExtension),
           .remedy = "Name a scene file; `sline import` makes one"},
          Exit::wrongUse);
  return flags.list ? list(flags) : edit(flags);
}

void declareWork(CLI::App& command, ViewFlags& flags) {
  CLI::Option_group* work = command.add_option_group("What to do, one of");
  work->add_option("--add", flags.add, "Saves a view by that name, after those there are")
      ->type_name("NAME");
  work->add_option("--update", flags.update, "Changes that view: what is not said stays as it is")
      ->type_name("NAME");
  work->add_option("--tell", flags.tell, "Changes what is said with that view, and nothing else")
      ->type_name("NAME");
  work->add_option("--rename", flags.rename, "Gives a view another name")->type_name("OLD=NEW");
  work->add_option("--remove", flags.remove, "Takes a view out of the scene")->type_name("NAME");
  work->add_option("--move", flags.move, "Puts a view elsewhere in the tour; 1 is the first")
      ->type_name("NAME=POSITION");
  CLI::Option* list = work->add_flag("--list", flags.list, "Lists the views; writes nothing");
  work->require_option(1);
  command.add_flag("--json", flags.json, "For programs: the list as one JSON object")->needs(list);
  command.add_option("-o,--output", flags.output, "Writes there and leaves SCENE as it is")
      ->type_name("FILE.sline")
      ->excludes(list);
}

void declareView(CLI::App& command, ViewFlags& flags) {
  command.add_option("SCENE", flags.scene, "A scene file (sline)")->required();
  declareWork(command, flags);
  CLI::Option* from =
      command
          .add_option("--from", flags.picture.view,
                      "A saved view of the scene to start from; else anterior, posterior, left, "
                      "right, superior or inferior, fitted to what is visible")
          ->type_name("NAME")
          ->capture_default_str();
  addCameraOption(command, flags.picture, from);
  command
      .add_option("--size", flags.picture.size,
                  "The shape of picture that it is fitted to, width and height")
      ->type_name("WxH")
      ->capture_default_str();
  addDetailOptions(command, flags.picture);
  addStyleOptions(command, flags.picture);
  addSectionOptions(command, flags.picture.sections);
  command
      .add_option("--labels", flags.labels,
                  "Which annotations the view shows: all, none, or their numbers (1,4); else those "
                  "that the scene shows, of which a new view takes what no other view has")
      ->type_name("all|none|IDS");
  for (CLI::Option* option : addViewWordOptions(command, flags.words)) {
    option->group("What is said with it");
    for (const char* other : {"--rename", "--remove", "--move", "--list"})
      option->excludes(command.get_option(other));
  }
  command.footer(
      "A view holds camera, visibility, gamma, colours, sections and which labels are shown; what\n"
      "the flags say is said of the view, and the scene itself stays as it looks. Views are shown\n"
      "by `sline render SCENE --view NAME`, in the window and, in their order, as a tour.\n\n"
      "  sline view pelvis.sline --add \"Pelvic floor\" --from inferior --gamma bladder=4\n"
      "  sline view pelvis.sline --tell \"Pelvic floor\" --text \"Seen **from below**\" "
      "--text de=\"Von **unten**\"\n"
      "  sline view pelvis.sline --move \"Pelvic floor=1\"\n"
      "  sline view pelvis.sline --list --json");
}

}  // namespace

void addView(CLI::App& program, Exit& exit) {
  addCommand<ViewFlags>(program, exit, {"view", "Save, list and order the views of a scene file"},
                        declareView, runView);
}

}  // namespace sline::cli
