// SPDX-License-Identifier: Apache-2.0
// Implements `sline annotate`: writes words that point at the anatomy into a scene file.
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <iomanip>
#include <sstream>

#include "app/cli/commands/command.h"
#include "app/cli/files/language_tag.h"
#include "app/cli/files/names.h"
#include "app/cli/flags/picture_flags.h"
#include "model/anatomy/anatomical_names.h"
#include "model/edit/annotations.h"
#include "model/edit/views.h"
#include "model/edit/visibility.h"
#include "model/geometry/nearest_point.h"
#include "model/lengths/shortest_distance.h"
#include "model/lengths/told_length.h"
#include "model/scene/markup.h"
#include "model/scene_file/scene_file.h"
#include "render/labels/seen/seen_map.h"

namespace sline::cli {

namespace {

using model::Annotation;
using model::AnnotationKind;

constexpr std::array<std::string_view, 4> annotationKindNames{"label", "callout", "pin",
                                                              "distance"};

struct AnnotateFlags {
  std::string scene;
  std::optional<std::string> label;
  std::vector<std::string> on;
  std::string at;
  std::string to;
  std::string kind = "label";
  std::vector<std::string> texts;
  std::string view = "anterior";
  bool viewGiven = false;
  bool onlyInView = false;
  bool list = false;
  std::vector<std::uint64_t> remove;
};

Error usageError(const std::string& reason, const std::string& remedy) {
  return {.reason = reason, .remedy = remedy};
}

Result<glm::vec3> parsePoint(std::string_view text) {
  std::array<float, 3> values{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t cut = std::min(rest.find(','), rest.size());
    const auto [end, failure] = std::from_chars(rest.data(), rest.data() + cut, values[i]);
    if (failure != std::errc{} || end != rest.data() + cut || !std::isfinite(values[i]) ||
        (cut == rest.size()) != (i + 1 == values.size()))
      return usageError("the place \"" + std::string(text) + "\" is not understood",
                        "Give x,y,z in millimetres, LPS");
    rest.remove_prefix(std::min(cut + 1, rest.size()));
  }
  return glm::vec3(values[0], values[1], values[2]);
}

bool isBlank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

/// Returns the texts by language; the map is the annotation's as a whole.
Result<std::map<std::string, std::string>> parseTexts(const std::vector<std::string>& texts) {
  std::map<std::string, std::string> parsed;
  for (const std::string& text : texts) {
    const std::size_t cut = text.find('=');
    if (cut == std::string::npos || !isLanguageTag(text.substr(0, cut)))
      return usageError("the text \"" + text + "\" does not say its language",
                        "Write de=\"Niere\"");
    if (isBlank(text.substr(cut + 1)))
      return usageError("--text " + text + " has no words", "Write some, or leave it out");
    if (!parsed.emplace(text.substr(0, cut), text.substr(cut + 1)).second)
      return usageError("--text says two things in the language " + text.substr(0, cut),
                        "Leave one out");
  }
  return parsed;
}

Result<model::NodeId> structureNamed(const model::Scene& scene, const std::string& name) {
  const auto nodes = TRY(nodesNamed(scene, name));
  std::vector<model::NodeId> structures;
  for (const model::NodeId id : nodes)
    if (!scene.find(id)->isGroup())
      structures.push_back(id);
  if (structures.size() == 1)
    return structures.front();
  if (!structures.empty())
    return ambiguousName(scene, name, structures);
  std::string inside;
  for (const model::NodeId id : scene.structuresBelow(nodes.front()))
    inside += (inside.empty() ? "" : ", ") + scene.find(id)->name;
  return usageError("\"" + name + "\" is a group, which has no surface to point at",
                    "Name a structure in it: " + inside);
}

/// Tells whether --to names a structure rather than a place.
bool namesEnd(const AnnotateFlags& flags) {
  return !flags.to.empty() && !parsePoint(flags.to).ok();
}

/// Holds what is needed to find annotations' places.
class Where {
 public:
  Where(const model::Scene& shown, const render::Screen& on) : scene(shown), screen(on) {}

  const model::Scene& scene;  ///< as the view shows it
  render::Screen screen;

  /// Returns what the view shows; it is drawn at the first call.
  const render::SeenMap& map() {
    if (!m_map)
      m_map.emplace(scene, screen);
    return *m_map;
  }

 private:
  std::optional<render::SeenMap> m_map;
};

Result<model::Anchor> anchorOn(Where& where, model::NodeId structure) {
  const std::string name = '"' + where.scene.find(structure)->name + '"';
  const auto found = [&](const render::SeenMap& map) -> Result<render::SeenPlace> {
    if (const std::optional<render::SeenPlace> best = map.find(structure))
      return *best;
    return usageError(name + " is not within that view",
                      "Give another --view, or a place with --at x,y,z");
  };
  const auto anchor = [&](const render::SeenPlace& place) {
    return render::SeenMap::labelAt(structure, place).anchors.front();
  };
  if (where.scene.resolve(structure).visible) {
    const render::SeenPlace place = TRY(found(where.map()));
    if (place.hidden)
      warn(name + " is hidden by other structures in that view; the label points through them");
    return anchor(place);
  }
  const model::Scene alone = model::withOnlyVisible(where.scene, std::array{structure}).scene;
  const render::SeenPlace place = TRY(found(render::SeenMap(alone, where.screen)));
  warn(name + " is not visible in that view; nor is its label, until it is");
  return anchor(place);
}

Result<model::Anchor> anchorFor(Where& where, std::optional<model::NodeId> structure,
                                const std::string& at) {
  if (at.empty())
    return anchorOn(where, *structure);
  const glm::vec3 place = TRY(parsePoint(at));
  if (!structure)
    return model::Anchor(place);
  const auto nearest = model::nearestPoint(*where.scene.find(*structure)->mesh, place);
  if (!nearest)
    return usageError("\"" + where.scene.find(*structure)->name + "\" has no surface",
                      "Name another structure");
  const model::Anchor anchor = model::SurfacePoint{*structure, nearest->triangle, nearest->weights};
  const float way = glm::distance(where.scene.placeOf(anchor).value_or(place), place);
  if (way > 1.0f)
    warn(at + ": put on the surface, " + std::to_string(std::lround(way)) + " mm from there");
  return anchor;
}

/// Returns the distance from that structure to the one that --to names, from --at if it is given.
Result<Annotation> distanceFrom(model::NodeId from, const AnnotateFlags& flags, Where& where) {
  const model::NodeId to = TRY(structureNamed(where.scene, flags.to));
  std::optional<glm::vec3> at;
  if (!flags.at.empty()) {
    at = TRY(parsePoint(flags.at));
  }
  const std::optional<Annotation> distance = model::shortestDistance(where.scene, from, to, at);
  if (!distance)
    return usageError("one of the structures has no surface", "Name others");
  return *distance;
}

/// Names the annotation after the structure in the languages that the table of names has.
void nameAfter(const std::string& name, Annotation& annotation) {
  const model::AnatomicalNames names;
  annotation.text = name;
  if (!names.knows(name))
    return;
  for (std::size_t i = 0; i < model::nameLanguages; ++i)
    if (const auto language = model::NameLanguage(i); language != model::NameLanguage::english)
      annotation.texts.emplace(model::nameLanguageTags[i], names.displayName(name, language));
}

Result<Annotation> annotationFor(const AnnotateFlags& flags, Where& where,
                                 const std::optional<std::string>& on) {
  Annotation made;
  made.kind =
      AnnotationKind(std::find(annotationKindNames.begin(), annotationKindNames.end(), flags.kind) -
                     annotationKindNames.begin());
  made.texts = TRY(parseTexts(flags.texts));
  std::optional<model::NodeId> structure;
  if (on) {
    structure = TRY(structureNamed(where.scene, *on));
    if (!flags.label && !namesEnd(flags))
      nameAfter(where.scene.find(*structure)->name, made);
  }
  if (flags.label)
    made.text = *flags.label;
  if (namesEnd(flags)) {
    const Annotation distance = TRY(distanceFrom(*structure, flags, where));
    made.anchors = distance.anchors;
    return made;
  }
  for (const std::string* place : {&flags.at, &flags.to}) {
    if (place == &flags.to && made.kind != AnnotationKind::distance)
      continue;
    const model::Anchor anchor = TRY(anchorFor(where, structure, *place));
    made.anchors.push_back(anchor);
  }
  // A place that the user has given stays; any other is found anew for each picture.
  made.found = flags.at.empty();
  return made;
}

/// Returns the fault that makes the flags unusable together.
std::optional<Error> conflictIn(const AnnotateFlags& flags) {
  const int tasks = int(flags.list) + int(!flags.remove.empty()) +
                    int(flags.label || !flags.on.empty() || !flags.at.empty());
  if (tasks != 1)
    return usageError("there is not one thing to do",
                      "Give --on (with --label), --list or --remove, one of them");
  if (!model::isSceneFile(flags.scene))
    return Error{.file = flags.scene,
                 .reason = "a scene file's name ends with " + std::string(model::sceneExtension),
                 .remedy = "Name a scene file; `sline import` makes one"};
  if (flags.on.size() > 1 && (flags.label || !flags.at.empty() || !flags.texts.empty()))
    return usageError("one text or place is given for several structures",
                      "Leave --label, --text and --at out, or name one structure");
  if (flags.label && isBlank(*flags.label))
    return usageError("--label has no words",
                      "Write some, or leave it out for the structure's name");
  const bool making = !flags.list && flags.remove.empty();
  if (making && flags.on.empty() && (flags.at.empty() || (!flags.label && flags.to.empty())))
    return usageError("the label has no text or no place",
                      "Give --on STRUCTURE, or --label TEXT and --at x,y,z");
  if (making && (flags.kind == "distance") == flags.to.empty())
    return usageError("a distance has two places, any other annotation one",
                      "Give --kind distance with --at x,y,z and --to x,y,z");
  if (making && namesEnd(flags) && flags.on.size() != 1)
    return usageError("--to names a structure, and --on does not name one beside it",
                      "Give --on STRUCTURE --to STRUCTURE, or two places");
  if (making && flags.kind == "distance" && flags.at.empty() && !namesEnd(flags))
    return usageError("a distance has two places",
                      "Give --at x,y,z and --to x,y,z, or --on STRUCTURE --to STRUCTURE");
  return std::nullopt;
}

/// Returns the scene with what the flags ask for; an error counts as wrong use.
Result<model::Scene> addAnnotations(const model::Scene& scene, const AnnotateFlags& flags) {
  PictureSpec spec;
  spec.view = flags.view;
  const model::Scene shown = withSavedView(scene, spec);
  const model::Camera camera = TRY(cameraFor(shown, spec));
  const model::View* saved = savedView(scene, flags.view);
  const auto view = saved ? std::optional(std::size_t(saved - scene.views().data())) : std::nullopt;
  if (flags.onlyInView && !view)
    return usageError("\"" + flags.view + "\" is no saved view", "Name one with --view");
  const float height = render::usualHeightMm;
  Where where(shown, render::Screen(camera, {spec.size.aspect() * height, height}));
  std::vector<std::optional<std::string>> targets(flags.on.begin(), flags.on.end());
  if (targets.empty())
    targets.emplace_back();
  model::Scene after = scene;
  for (const std::optional<std::string>& on : targets) {
    const Annotation made = TRY(annotationFor(flags, where, on));
    if (!flags.onlyInView) {
      after = (view && flags.viewGiven ? model::withAnnotationMade(after, made, view)
                                       : model::withAnnotationForAll(after, made))
                  .scene;
      continue;
    }
    after = model::withAnnotation(after, made).scene;
    const model::AnnotationId id = after.annotations().back().id;
    after = model::withAnnotationOnlyInView(after, id, *view).scene;
  }
  return after;
}

Result<model::Scene> removeAnnotations(const model::Scene& scene, const AnnotateFlags& flags) {
  std::vector<model::AnnotationId> ids;
  for (const std::uint64_t number : flags.remove) {
    const auto& all = scene.annotations();
    if (std::none_of(all.begin(), all.end(), [&](const auto& a) { return a.id.value == number; }))
      return usageError("no annotation has the number " + std::to_string(number),
                        "`sline annotate SCENE --list` lists them");
    ids.push_back({number});
  }
  return model::withoutAnnotations(scene, ids).scene;
}

/// Returns the names of the structures that the annotation is on, each once.
std::string structuresOf(const model::Scene& scene, const Annotation& annotation) {
  std::string names;
  std::optional<model::NodeId> last;
  for (const model::Anchor& anchor : annotation.anchors) {
    const auto* point = std::get_if<model::SurfacePoint>(&anchor);
    const model::Node* node = point ? scene.find(point->structure) : nullptr;
    if (!node || last == node->id)
      continue;
    last = node->id;
    names += (names.empty() ? "" : " – ") + onOneLine(node->name);
  }
  return names;
}

/// Returns "mm=25.00", or "mm=25.00±0.80" between surfaces that import has moved, with a question
/// mark where the unit is doubted, or "Å=0.60".
std::string lengthField(const model::DrawnLength& length, model::DrawnUnit unit) {
  const model::ToldUnit told = model::toldUnit(double(length.mm), unit);
  std::ostringstream text;
  text << told.symbol << '=' << std::fixed << std::setprecision(2)
       << double(length.mm) / told.millimetres;
  if (length.offMm > 0.0f)
    text << "±" << double(length.offMm) / told.millimetres;
  text << (told.doubted ? "?" : "");
  return text.str();
}

Exit list(const model::Scene& scene) {
  for (const Annotation& annotation : scene.annotations()) {
    std::cout << annotation.id.value << '\t' << annotationKindNames[std::size_t(annotation.kind)]
              << '\t';
    const auto words = [&annotation](const std::string& text) {
      return onOneLine(model::plainText(annotation.kind, text));
    };
    std::cout << structuresOf(scene, annotation) << '\t' << words(annotation.text);
    if (const auto length = model::drawnLength(scene, annotation))
      std::cout << '\t' << lengthField(*length, drawnUnit(scene));
    for (const auto& [language, text] : annotation.texts)
      std::cout << '\t' << language << '=' << words(text);
    std::cout << '\n';
  }
  return Exit::done;
}

Exit runAnnotate(const AnnotateFlags& flags) {
  if (const std::optional<Error> error = conflictIn(flags))
    return complain(*error, Exit::wrongUse);
  if (flags.list) {
    const auto document = openedScene(flags.scene);
    return document.ok() ? list(document->scene) : complain(document.error(), Exit::failed);
  }
  const auto lock = model::FileLock::acquire(flags.scene);
  if (!lock.ok())
    return complain(lock.error(), Exit::failed);
  Result<model::SceneDocument> document = openedScene(flags.scene);
  if (!document.ok())
    return complain(document.error(), Exit::failed);
  Result<model::Scene> after = flags.remove.empty() ? addAnnotations(document->scene, flags)
                                                    : removeAnnotations(document->scene, flags);
  if (!after.ok())
    return complain(after.error(), Exit::wrongUse);
  document->scene = std::move(*after);
  const std::size_t made = flags.remove.empty() ? std::max<std::size_t>(flags.on.size(), 1) : 0;
  if (const Status written = model::writeSceneFile(*lock, *document); !written.ok())
    return complain(written.error(), Exit::failed);
  const std::vector<Annotation>& all = document->scene.annotations();
  for (std::size_t i = all.size() - made; i < all.size(); ++i)
    std::cout << all[i].id.value << '\n';
  return Exit::done;
}

void addEnd(CLI::App& command, AnnotateFlags& flags) {
  command
      .add_option("--to", flags.to,
                  "Where a distance ends: a place, or a structure. Between two structures it is "
                  "the shortest one, or with --at the shortest from there")
      ->type_name("X,Y,Z|STRUCTURE");
}

void declareAnnotate(CLI::App& command, AnnotateFlags& flags) {
  const auto repeatable = [](CLI::Option* option) {
    return option->take_all()->type_size(1)->expected(1)->allow_extra_args(false);
  };
  command.add_option("SCENE", flags.scene, "A scene file (sline), which is changed")->required();
  command
      .add_option(
          "--label", flags.label,
          "What it says, as plain text, a callout's with markup (see below); without it, what "
          "the structure is called, in every language in which its name is known")
      ->type_name("TEXT");
  repeatable(command.add_option("--on", flags.on,
                                "The structure it points at; may be given again, without --label"))
      ->type_name("STRUCTURE");
  command
      .add_option("--at", flags.at,
                  "Where: the nearest place on the structure, or without one in space, mm, LPS. "
                  "Else where the structure is well seen in the view")
      ->type_name("X,Y,Z");
  addEnd(command, flags);
  command
      .add_option("--kind", flags.kind,
                  "label: beside the anatomy at the end of a line; callout: framed; pin: a mark "
                  "with its text beside it; distance: a measured line")
      ->check(CLI::IsMember({"label", "callout", "pin", "distance"}))
      ->capture_default_str();
  repeatable(
      command.add_option("--text", flags.texts, "The text in another language; may be given again"))
      ->type_name("TAG=TEXT");
  CLI::Option* view =
      command
          .add_option("--view", flags.view,
                      "A saved view or an anatomical one: what is well seen is seen from there. A "
                      "saved view that is named gets the label, and no other")
          ->each([&flags](const std::string&) { flags.viewGiven = true; })
          ->type_name("NAME")
          ->capture_default_str();
  command.add_flag("--only-in-view", flags.onlyInView, "Shown in that saved view alone")
      ->needs(view);
  command.add_flag("--list", flags.list,
                   "Lists number, kind, structures, text, a distance's length and texts in other "
                   "languages, between tabs, and changes nothing");
  repeatable(command.add_option("--remove", flags.remove, "Removes it; may be given again"))
      ->type_name("NUMBER");
  command.footer(
      "The numbers of new annotations go to standard output. `sline render --labels on` draws "
      "them.\n\n"
      "A callout's text may have lines, **bold** and *italic* words, one within the other, and "
      "lines that begin with \"- \", which become items of a list. \\*, \\- and \\\\ are "
      "these signs themselves. There is no HTML; other kinds of labels show signs as they are.\n\n"
      "  sline annotate abdomen.sline --on liver --on spleen --on \"left kidney\"\n"
      "  sline annotate pelvis.sline --label Promontory --on sacrum --at 0,-20,110 --text "
      "de=Promontorium\n"
      "  sline annotate pelvis.sline --kind callout --on bladder --label $'**Bladder**\\n- "
      "*detrusor*\\n- trigone'\n"
      "  sline annotate pelvis.sline --kind distance --on tumour --to \"iliac vein\"\n"
      "  sline annotate pelvis.sline --list\n"
      "  sline render abdomen.sline -o abdomen.png --labels on --language la");
}

}  // namespace

void addAnnotate(CLI::App& program, Exit& exit) {
  addCommand<AnnotateFlags>(program, exit,
                            {"annotate", "Write labels, pins and distances into a scene file"},
                            declareAnnotate, runAnnotate);
}

}  // namespace sline::cli
