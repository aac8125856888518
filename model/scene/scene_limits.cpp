// SPDX-License-Identifier: Apache-2.0
#include "model/scene/scene_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

#include "model/base/utf8.h"
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

constexpr const char* leftOut = "it was left out";

std::string numbered(std::string_view before, std::size_t number, std::string_view after) {
  return std::string(before) + std::to_string(number) + std::string(after);
}

bool isId(std::uint64_t value) {
  return value >= 1 && value <= largestId;
}

bool hasFinite(const glm::vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Goes through the values of a scene, mends those that it may not hold and tells of each.
class Mender {
 public:
  explicit Mender(std::vector<SceneMending>& told) : m_told(told) {}

  /// Says of what is told next.
  void at(std::string_view kind, const std::string& name) {
    // Enough to tell it from others; the name itself may be what is too long.
    constexpr std::size_t most = 80;
    m_where = std::string(kind) + " \"" + inUtf8(cutUtf8(name, most)) +
              (name.size() > most ? "\u2026\"" : "\"");
  }
  void atAll() { m_where.clear(); }
  void tell(std::string_view fault, std::string_view done) {
    m_told.push_back({m_where, std::string(fault), std::string(done)});
  }

  void text(std::string& text, std::string_view what, std::size_t most) {
    if (!isUtf8(text)) {
      tell(std::string(what) + " has bytes that are no letters in UTF-8",
           "they became signs for unknown letters");
      text = inUtf8(text);
    }
    if (text.size() <= most)
      return;
    tell(std::string(what) + numbered(" is longer than ", most, " bytes"), "it was cut there");
    text = std::string(cutUtf8(text, most));
  }

  void wording(std::string& own, std::map<std::string, std::string>& others,
               std::string_view what) {
    text(own, what, longestSceneText);
    for (auto& [language, words] : others)
      text(words, what, longestSceneText);
    const auto isNone = [](const auto& each) {
      return !isUtf8(each.first) || each.first.size() > longestLanguageTag;
    };
    if (std::erase_if(others, isNone) > 0)
      tell(std::string(what) + " is in a language that has no name", leftOut);
    if (others.size() <= mostTextLanguages)
      return;
    others.erase(std::next(others.begin(), std::ptrdiff_t(mostTextLanguages)), others.end());
    tell(std::string(what) + numbered(" is in more than ", mostTextLanguages, " languages"),
         "the rest was left out");
  }

  /// Replaces a number that is none.
  void number(float& number, std::string_view what, float otherwise) {
    if (std::isfinite(number))
      return;
    tell(std::string(what) + " is no finite number", leftOut);
    number = otherwise;
  }

  void style(Style& style) {
    forEachStyleField([&](const auto& field) {
      using Value = typename std::remove_cvref_t<decltype(field)>::Value;
      auto& own = style.*field.own;
      bool sound = true;
      if constexpr (std::same_as<Value, float>)
        sound = !own || field.limits().contain(*own);
      else if constexpr (std::same_as<Value, GammaMap> || std::same_as<Value, ThresholdValues>)
        sound = !own || isSound(*own);
      if (sound)
        return;
      tell("the value of " + std::string(field.key) + " is out of range", leftOut);
      own.reset();
    });
  }

  void looks(std::vector<Look>& looks) {
    std::set<NodeId> seen;
    const auto isNone = [&seen](const Look& look) {
      return !isId(look.node.value) || !seen.insert(look.node).second;
    };
    if (std::erase_if(looks, isNone) > 0)
      tell("a look is of no node, or of one that has another", leftOut);
    for (Look& look : looks)
      style(look.style);
  }

  template <class Id>
  void ids(std::vector<Id>& ids) {
    if (std::erase_if(ids, [](const Id& id) { return !isId(id.value); }) > 0)
      tell("an id is none", leftOut);
  }

  /// Tells whether a picture can be taken from the camera, and all of it be written.
  bool isSound(const Camera& camera) const {
    return !cameraFault(camera) && std::isfinite(camera.fovyDegrees) &&
           std::isfinite(camera.heightMm);
  }

  void focus(Focus& focus) {
    ids(focus.targets);
    if (focus.seenFrom && !isSound(*focus.seenFrom)) {
      tell("the camera of the focus sees nothing", leftOut);
      focus.seenFrom.reset();
    }
    const auto isNone = [](const auto& wish) { return !isId(wish.first.value); };
    if (std::erase_if(focus.wishes.roles, isNone) > 0)
      tell("an id is none", leftOut);
    if (focus.nearness && !(nearnessFalloffs.contain(focus.nearness->falloffMm) &&
                            hasFinite(focus.nearness->place.value_or(glm::vec3(0.0f))))) {
      tell("the nearness of the focus is out of range", leftOut);
      focus.nearness.reset();
    }
    looks(focus.given);
  }

  void sections(std::vector<Section>& sections) {
    for (Section& section : sections)
      text(section.name, "the name of a section", longestSceneName);
    std::set<SectionId> seen;
    std::erase_if(sections, [&](const Section& section) {
      const bool placed = isId(section.id.value) && seen.insert(section.id).second &&
                          (section.scope == rootId || isId(section.scope.value));
      if (placed && !planeFault(section.plane))
        return false;
      tell(placed ? *planeFault(section.plane) : "a section has the id of another, or none",
           "the section was left out");
      return true;
    });
  }

  void provenance(Provenance& p) {
    for (const auto& [what, line] :
         {std::pair("the name of its file", &p.file), std::pair("its frame", &p.frame),
          std::pair("the reason of its frame", &p.frameReason),
          std::pair("the reason of its unit", &p.unitReason),
          std::pair("the name of its part", &p.part)})
      text(*line, what, longestSceneName);
    for (std::string* line : {&p.credit.authors, &p.credit.source, &p.credit.licence})
      text(*line, "its credit", longestCredit);
    for (int* count : {&p.smoothingSteps, &p.refinementSteps, &p.repairedFaces, &p.decimatedFrom})
      if (*count < 0) {
        tell("a count of what import did is below 0", leftOut);
        *count = 0;
      }
    number(p.displacementMm, "how far import moved it", 0.0f);
    number(p.sliceMm, "the distance of its slices", 0.0f);
    number(p.mmPerUnit, "its unit", 1.0f);
    number(p.decimationMm, "how far decimation moved it", 0.0f);
    if (p.transform && !std::all_of(p.transform->begin(), p.transform->end(),
                                    [](float number) { return std::isfinite(number); })) {
      tell("the transform of its file is no finite number", leftOut);
      p.transform.reset();
    }
    if (p.intensities && !(std::isfinite(p.intensities->low.value_or(0.0f)) &&
                           std::isfinite(p.intensities->high.value_or(0.0f)))) {
      tell("the range of its intensities is no finite number", leftOut);
      p.intensities.reset();
    }
    if (p.fingerprint && p.fingerprint->bytes > largestId) {
      tell("the size of its file is no number of bytes", leftOut);
      p.fingerprint.reset();
    }
  }

  void node(Node& node) {
    at(node.isGroup() ? "group" : "structure", node.name);
    text(node.name, "the name", longestSceneName);
    style(node.style);
    provenance(node.provenance);
    if (node.paint && (node.isGroup() || node.paint->size() != node.mesh->vertexCount())) {
      tell("what is painted on it is of another surface", leftOut);
      node.paint.reset();
    }
    if (node.atoms.set && !isSound(*node.atoms.set)) {
      tell("an atom lies nowhere, or there are too many", "the atoms were left out");
      node.atoms = {};
    }
  }

  void view(View& view) {
    at("view", view.name);
    text(view.name, "the name", longestSceneName);
    if (view.sections)
      sections(*view.sections);
    if (view.looks)
      looks(*view.looks);
    if (view.annotations)
      ids(*view.annotations);
    if (view.focus)
      focus(*view.focus);
    for (Wording* words :
         {&view.words.title, &view.words.text, &view.words.notes, &view.words.description})
      wording(words->text, words->texts, "a text");
    if (view.words.seconds && !viewSecondsLimits.contain(*view.words.seconds)) {
      tell("the time is out of range", leftOut);
      view.words.seconds.reset();
    }
  }

 private:
  static bool isSound(const GammaMap& map) {
    return !gammaMapFault(map) && std::all_of(map.targets.begin(), map.targets.end(),
                                              [](NodeId id) { return isId(id.value); });
  }
  static bool isSound(const ThresholdValues& values) {
    return values.all().size() <= mostThresholdValues &&
           std::none_of(values.all().begin(), values.all().end(), [](const ThresholdValue& each) {
             return thresholdFault(each.name, each.value).has_value();
           });
  }
  static bool isSound(const AtomSet& set) {
    const auto isPlaced = [](const glm::vec3& p) {
      return std::abs(p.x) <= farthestAtom && std::abs(p.y) <= farthestAtom &&
             std::abs(p.z) <= farthestAtom;
    };
    return set.atoms.size() <= mostKeptAtoms &&
           std::all_of(set.residues.begin(), set.residues.end(), isUtf8) &&
           std::all_of(set.atoms.begin(), set.atoms.end(), [&](const AtomBall& atom) {
             return isPlaced(atom.place) && atom.radius > 0.0f && atom.radius <= largestAtom &&
                    atom.residue < set.residues.size();
           });
  }

  std::vector<SceneMending>& m_told;
  std::string m_where;
};

/// Takes away the groups that lie too deep; what is in them goes to the group above.
void flatten(std::vector<Node>& nodes, Mender& mender) {
  std::vector<NodeId> open{rootId};
  std::map<NodeId, NodeId> above;  // of groups that are taken away
  std::erase_if(nodes, [&](Node& node) {
    if (const auto group = above.find(node.parent); group != above.end())
      node.parent = group->second;
    while (open.size() > 1 && open.back() != node.parent)
      open.pop_back();
    if (!node.isGroup())
      return false;
    if (open.size() <= deepestSceneGroup) {
      open.push_back(node.id);
      return false;
    }
    mender.at("group", node.name);
    mender.tell(numbered("it lies more than ", deepestSceneGroup, " groups deep"),
                "what is in it went to the group above");
    above[node.id] = node.parent;
    return true;
  });
}

void mendAnnotations(const Scene& scene, std::vector<Annotation>& annotations, Mender& mender) {
  for (Annotation& annotation : annotations) {
    mender.at("label", annotation.text);
    mender.wording(annotation.text, annotation.texts, "the text");
  }
  const auto isNowhere = [&scene](const Anchor& anchor) {
    return !scene.placeOf(anchor).has_value();
  };
  std::set<AnnotationId> seen;
  std::erase_if(annotations, [&](const Annotation& annotation) {
    const bool known = isId(annotation.id.value) && seen.insert(annotation.id).second;
    std::optional<std::string_view> fault = annotationFault(annotation);
    if (!fault && std::any_of(annotation.anchors.begin(), annotation.anchors.end(), isNowhere))
      fault = "it is on a triangle that no structure of the scene has";
    if (!fault && known)
      return false;
    mender.at("label", annotation.text);
    mender.tell(fault.value_or("another label has the same id"), leftOut);
    return true;
  });
}

void mendScans(std::vector<Scan>& scans, Mender& mender) {
  for (Scan& scan : scans) {
    mender.at("scan", scan.name);
    mender.text(scan.name, "the name", longestSceneName);
    mender.text(scan.file, "the name of its file", longestSceneName);
  }
  std::erase_if(scans, [&mender](const Scan& scan) {
    mender.at("scan", scan.name);
    std::string fault = scanFault(scan);
    for (int axis = 0; axis < 3; ++axis)
      if (scan.size[axis] > longestScanSide)
        fault = numbered("it has more than ", std::size_t(longestScanSide), " voxels on a side");
    if (!fault.empty())
      mender.tell(fault, leftOut);
    return !fault.empty();
  });
}

void mendViews(std::vector<View>& views, Mender& mender) {
  for (View& view : views)
    mender.view(view);
  std::erase_if(views, [&mender](const View& view) {
    if (mender.isSound(view.camera))
      return false;
    mender.at("view", view.name);
    mender.tell(cameraFault(view.camera).value_or("a number of its camera is not finite"), leftOut);
    return true;
  });
}

/// Tells whether both have the same structures and groups in the same places.
bool haveSameTree(const std::vector<Node>& a, const std::vector<Node>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Node& one, const Node& other) {
    return one.id == other.id && one.parent == other.parent && one.mesh == other.mesh;
  });
}

void mendTraces(std::vector<SourceTrace>& traces, Mender& mender) {
  std::erase_if(traces, [&mender](const SourceTrace& trace) {
    if (const auto fault = traceFault(trace))
      mender.tell(*fault, leftOut);
    return traceFault(trace).has_value();
  });
  if (traces.size() > mostSourceTraces) {
    mender.tell(numbered("it came from more than ", mostSourceTraces, " studies"),
                "the rest was left out");
    traces.resize(mostSourceTraces);
  }
}

/// Returns what there are too many of.
Status checkCounts(const Scene& scene) {
  for (const auto& [what, count, most] :
       {std::tuple("structures and groups", scene.nodes().size(), mostSceneNodes),
        std::tuple("labels", scene.annotations().size(), mostSceneLabels),
        std::tuple("sections", scene.sections().size(), mostSceneSections),
        std::tuple("views", scene.views().size(), mostSceneViews),
        std::tuple("scans", scene.scans().size(), mostSceneScans)})
    if (count > most)
      return Error{.reason = "a scene holds no more than " + std::to_string(most) + " " + what +
                             ", and these would be " + std::to_string(count),
                   .remedy = "Take fewer of them into one scene"};
  const auto isUnknown = [](const Node& node) { return !isId(node.id.value); };
  if (std::any_of(scene.nodes().begin(), scene.nodes().end(), isUnknown))
    return Error{.reason = "a structure has no id that can be kept",
                 .remedy = "Take it out, or import it again"};
  return Unit{};
}

}  // namespace

std::string SceneMending::text() const {
  return (where.empty() ? "" : where + ": ") + fault + "; " + done;
}

Status bringWithinLimits(Scene& scene, std::vector<SceneMending>& mended) {
  TRY(checkCounts(scene));
  Mender mender(mended);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    mender.node(node);
  flatten(nodes, mender);
  if (nodes != scene.nodes())
    scene.setNodes(std::move(nodes));
  mender.atAll();
  std::vector<Section> sections = scene.sections();
  mender.sections(sections);
  if (sections != scene.sections())
    scene.setSections(std::move(sections));
  std::vector<Annotation> annotations = scene.annotations();
  mendAnnotations(scene, annotations, mender);
  if (annotations != scene.annotations())
    scene.setAnnotations(std::move(annotations));
  std::vector<View> views = scene.views();
  mendViews(views, mender);
  if (views != scene.views())
    scene.setViews(std::move(views));
  mender.atAll();
  Focus focus = scene.focus();
  mender.focus(focus);
  if (focus != scene.focus())
    scene.setFocus(std::move(focus));
  if (scene.keyLight() && lightFault(*scene.keyLight())) {
    mender.tell(*lightFault(*scene.keyLight()), leftOut);
    scene.setKeyLight(std::nullopt);
  }
  std::vector<Scan> scans = scene.scans();
  mendScans(scans, mender);
  if (scans != scene.scans())
    scene.setScans(std::move(scans));
  mender.atAll();
  std::vector<SourceTrace> traces = scene.traces();
  mendTraces(traces, mender);
  if (traces != scene.traces())
    scene.setTraces(std::move(traces));
  return Unit{};
}

std::optional<Error> limitFault(const Scene& scene, const Scene& kept) {
  TRY(checkCounts(scene));
  std::vector<SceneMending> mended;
  Mender mender(mended);
  for (std::size_t i = 0; i < scene.nodes().size(); ++i)
    if (i >= kept.nodes().size() || scene.nodes()[i] != kept.nodes()[i]) {
      Node copy = scene.nodes()[i];
      mender.node(copy);
    }
  // Calls mend(copy) for a part of the scene that is not as it was.
  const auto look = [](const auto& now, const auto& before, const auto& mend) {
    if (now == before)
      return;
    auto copy = now;
    mend(copy);
  };
  const bool sameTree = haveSameTree(scene.nodes(), kept.nodes());
  if (!sameTree)
    look(scene.nodes(), kept.nodes(), [&](auto& nodes) { flatten(nodes, mender); });
  mender.atAll();
  look(scene.sections(), kept.sections(), [&](auto& all) { mender.sections(all); });
  look(scene.annotations(), sameTree ? kept.annotations() : std::vector<Annotation>(),
       [&](auto& all) { mendAnnotations(scene, all, mender); });
  look(scene.views(), kept.views(), [&](auto& all) { mendViews(all, mender); });
  mender.atAll();
  look(scene.focus(), kept.focus(), [&](auto& all) { mender.focus(all); });
  if (scene.keyLight() && lightFault(*scene.keyLight()))
    mender.tell(*lightFault(*scene.keyLight()), leftOut);
  look(scene.scans(), kept.scans(), [&](auto& all) { mendScans(all, mender); });
  mender.atAll();
  look(scene.traces(), kept.traces(), [&](auto& all) { mendTraces(all, mender); });
  if (mended.empty())
    return std::nullopt;
  return Error{.where = mended.front().where,
               .reason = mended.front().fault,
               .remedy = "Change it so that a scene file can keep it"};
}

}  // namespace sline::model
