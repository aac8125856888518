// SPDX-License-Identifier: Apache-2.0
#include "tests/model/scene_file/limit_cases.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "model/scene/scene_limits.h"
#include "model/scene/style_fields.h"

namespace sline::test {

using namespace model;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float noNumber = std::numeric_limits<float>::quiet_NaN();

/// Returns a text of so many bytes with letters of one, two and three bytes.
std::string textOf(std::size_t bytes) {
  std::string text;
  while (text.size() + 6 <= bytes)
    text += "a\xc3\xa4\xe2\x89\xa4";
  return text + std::string(bytes - text.size(), 'z');
}

template <class Change>
Put nodePut(std::size_t index, const Change& change) {
  return [index, change](Scene& scene) {
    std::vector<Node> nodes = scene.nodes();
    change(nodes[index]);
    scene.setNodes(std::move(nodes));
  };
}
template <class Change>
Put structurePut(const Change& change) {
  return nodePut(2, change);
}
template <class Change>
Put viewPut(const Change& change) {
  return [change](Scene& scene) {
    std::vector<View> views = scene.views();
    change(views[0]);
    scene.setViews(std::move(views));
  };
}
template <class Change>
Put sectionPut(const Change& change) {
  return [change](Scene& scene) {
    std::vector<Section> sections = scene.sections();
    change(sections[0]);
    scene.setSections(std::move(sections));
  };
}
template <class Change>
Put labelPut(const Change& change) {
  return [change](Scene& scene) {
    std::vector<Annotation> labels = scene.annotations();
    change(labels[0]);
    scene.setAnnotations(std::move(labels));
  };
}
template <class Change>
Put focusPut(const Change& change) {
  return [change](Scene& scene) {
    Focus focus = scene.focus();
    change(focus);
    scene.setFocus(std::move(focus));
  };
}
template <class Change>
Put scanPut(const Change& change) {
  return [change](Scene& scene) {
    Scan scan{.name = "CT", .file = "ct.nii", .size = {2, 3, 4}};
    scan.voxels = std::make_shared<const std::vector<std::int16_t>>(24, 7);
    change(scan);
    scene.setScans({scan});
  };
}

class Cases {
 public:
  std::vector<LimitCase> all;

  void add(std::string field, std::string value, bool within, Put put, bool slow = false) {
    const auto isOf = [&field](const char* thing) { return field.ends_with(thing); };
    const bool asserted =
        !within && (isOf(" of a section") || isOf(" of a label") || isOf(" of a scan"));
    all.push_back({std::move(field), std::move(value), within, slow, asserted, std::move(put)});
  }

  /// Adds texts around the limit, with what is no text, and with signs that are no letters.
  template <class Make>
  void text(const std::string& field, std::size_t most, const Make& make) {
    for (const std::size_t bytes : {std::size_t(0), most - 1, most})
      add(field, std::to_string(bytes) + " bytes", true, make(textOf(bytes)));
    for (const std::size_t bytes : {most + 1, 3 * most})
      add(field, std::to_string(bytes) + " bytes", false, make(textOf(bytes)));
    add(field, "control characters", true, make(std::string("a\x01\x1f\n\t\x7f\"\\{}[]", 12)));
    add(field, "a zero", true, make(std::string("a\0b", 3)));
    for (const char* bytes : {"\xff\xfe", "half \xe2\x82", "\xc0\xaf", "\xed\xa0\x80", "\x80"})
      add(field, "no UTF-8", false, make(bytes));
    // As U+FFFD each of these bytes takes three.
    add(field, "no UTF-8 up to the limit", false, make(std::string(most, '\x99')));
  }

  /// Adds numbers at and beyond both limits.
  template <class Make>
  void number(const std::string& field, Limits<float> limits, const Make& make) {
    for (const float value : {limits.low, limits.high, std::nextafter(limits.high, limits.low)})
      add(field, std::to_string(value), true, make(value));
    for (const float value :
         {std::nextafter(limits.high, infinite), std::nextafter(limits.low, -infinite), 3e38f,
          -3e38f, infinite, -infinite, noNumber})
      add(field, std::to_string(value), false, make(value));
  }

  /// Adds what a finite number may be and no other.
  template <class Make>
  void finite(const std::string& field, const Make& make) {
    number(field, {-std::numeric_limits<float>::max(), std::numeric_limits<float>::max()}, make);
    for (std::size_t i = all.size() - 7; i < all.size() - 3; ++i)
      all[i].within = std::isfinite(std::stof(all[i].value));
  }

  void counts(const std::string& field, std::size_t most,
              const std::function<Put(std::size_t)>& make, bool slow = false) {
    add(field, std::to_string(most), true, make(most), slow);
    add(field, std::to_string(most + 1), false, make(most + 1), slow);
  }
};

void addTexts(Cases& cases) {
  using Text = std::string;
  cases.text("name of a structure", longestSceneName,
             [](const Text& t) { return structurePut([t](Node& node) { node.name = t; }); });
  cases.text("name of a group", longestSceneName,
             [](const Text& t) { return nodePut(0, [t](Node& node) { node.name = t; }); });
  cases.text("name of a view", longestSceneName,
             [](const Text& t) { return viewPut([t](View& view) { view.name = t; }); });
  cases.text("name of a section", longestSceneName,
             [](const Text& t) { return sectionPut([t](Section& s) { s.name = t; }); });
  cases.text("name of a section in a view", longestSceneName, [](const Text& t) {
    return viewPut(
        [t](View& view) { view.sections = std::vector<Section>{{.id = {1}, .name = t}}; });
  });
  cases.text("text of a label", longestSceneText,
             [](const Text& t) { return labelPut([t](Annotation& a) { a.text = t; }); });
  cases.text("text of a label in German", longestSceneText,
             [](const Text& t) { return labelPut([t](Annotation& a) { a.texts["de"] = t; }); });
  for (const auto& [field, words] :
       {std::pair("title", &ViewWords::title), std::pair("words", &ViewWords::text),
        std::pair("notes", &ViewWords::notes), std::pair("description", &ViewWords::description)})
    cases.text(std::string(field) + " of a view", longestSceneText, [words = words](const Text& t) {
      return viewPut([t, words](View& view) { (view.words.*words).text = t; });
    });
  for (const auto& [field, line] :
       {std::pair("authors", &SourceCredit::authors), std::pair("source", &SourceCredit::source),
        std::pair("licence", &SourceCredit::licence)})
    cases.text(field, longestCredit, [line = line](const Text& t) {
      return structurePut([t, line](Node& node) { node.provenance.credit.*line = t; });
    });
  for (const auto& [field, line] :
       {std::pair("file", &Provenance::file), std::pair("frame", &Provenance::frame),
        std::pair("reason of the frame", &Provenance::frameReason),
        std::pair("reason of the unit", &Provenance::unitReason),
        std::pair("part", &Provenance::part)})
    cases.text(field, longestSceneName, [line = line](const Text& t) {
      return structurePut([t, line](Node& node) { node.provenance.*line = t; });
    });
  cases.text("name of a scan", longestSceneName,
             [](const Text& t) { return scanPut([t](Scan& scan) { scan.name = t; }); });
  cases.text("file of a scan", longestSceneName,
             [](const Text& t) { return scanPut([t](Scan& scan) { scan.file = t; }); });
  for (const std::size_t bytes : {longestLanguageTag, longestLanguageTag + 1})
    cases.add("language of a label", std::to_string(bytes) + " bytes", bytes <= longestLanguageTag,
              labelPut([bytes](Annotation& a) { a.texts[textOf(bytes)] = "word"; }));
  cases.counts("languages of a label", mostTextLanguages, [](std::size_t count) {
    return labelPut([count](Annotation& a) {
      a.texts.clear();
      for (std::size_t i = 0; i < count; ++i)
        a.texts["x-" + std::to_string(i)] = "word";
    });
  });
}

void addStyle(Cases& cases) {
  forEachStyleField([&cases](const auto& field) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Value;
    if constexpr (std::same_as<Value, float>) {
      const auto own = field.own;
      cases.number(std::string(field.key), field.limits(), [own](float value) {
        return structurePut([=](Node& node) { node.style.*own = value; });
      });
      cases.number(std::string(field.key) + " in a view", field.limits(), [own](float value) {
        return viewPut([=](View& view) {
          view.looks = std::vector<Look>{{.node = {1}}};
          (*view.looks)[0].style.*own = value;
        });
      });
    }
  });
  const auto map = [&cases](const char* field, const char* value, bool within, const GammaMap& m) {
    cases.add(field, value, within, structurePut([m](Node& node) { node.style.gammaMap = m; }));
  };
  const auto curveOf = [](std::size_t points) {
    GammaMap m{.scalar = GammaScalar::occlusion};
    for (std::size_t i = 0; i < points; ++i)
      m.curve.push_back({float(i), 1.0f});
    return m;
  };
  map("points of a curve", "2", true, curveOf(2));
  map("points of a curve", "8", true, curveOf(8));
  map("points of a curve", "9", false, curveOf(9));
  map("points of a curve", "1", false, curveOf(1));
  cases.number("offset of a curve", gammaOffsets, [&](float value) {
    GammaMap m = curveOf(2);
    m.curve[1].offset = value;
    return structurePut([m](Node& node) { node.style.gammaMap = m; });
  });
  cases.number("scalar of a curve", gammaScalars, [&](float value) {
    GammaMap m = curveOf(2);
    m.curve[value > 0.0f ? 1 : 0].scalar = value;
    return structurePut([m](Node& node) { node.style.gammaMap = m; });
  });
  cases.counts("targets of a curve", mostGammaTargets, [&](std::size_t count) {
    GammaMap m = curveOf(2);
    m.scalar = GammaScalar::distance;
    m.targets.assign(count, NodeId{1});
    return structurePut([m](Node& node) { node.style.gammaMap = m; });
  });
}

void addThresholds(Cases& cases) {
  cases.number("threshold", thresholdValueLimits, [](float value) {
    return structurePut([value](Node& node) {
      node.style.lineThresholds = ThresholdValues{{"a.b", value}};
    });
  });
  cases.counts("thresholds", mostThresholdValues, [](std::size_t count) {
    ThresholdValues values;
    for (std::size_t i = 0; i < count; ++i)
      values.set("t" + std::to_string(i), 1.0f);
    return structurePut([values](Node& node) { node.style.lineThresholds = values; });
  });
  cases.counts("letters of a threshold's name", longestThresholdName, [](std::size_t count) {
    return structurePut([count](Node& node) {
      node.style.lineThresholds = ThresholdValues{{std::string(count, 'n'), 1.0f}};
    });
  });
}

void addOrigin(Cases& cases) {
  for (const auto& [field, number] : {std::pair("displacement", &Provenance::displacementMm),
                                      std::pair("unit", &Provenance::mmPerUnit),
                                      std::pair("decimation", &Provenance::decimationMm)})
    cases.finite(field, [number = number](float value) {
      return structurePut([=](Node& node) {
        node.provenance.*number = value;
        node.provenance.decimatedFrom = 7;
      });
    });
  cases.finite("transform", [](float value) {
    return structurePut([value](Node& node) { (*node.provenance.transform)[11] = value; });
  });
  cases.finite("intensities", [](float value) {
    return structurePut([value](Node& node) {
      node.provenance.intensities = IntensityRange{.low = value, .high = {}};
    });
  });
  for (const auto& [field, count] : {std::pair("smoothing steps", &Provenance::smoothingSteps),
                                     std::pair("refinement steps", &Provenance::refinementSteps),
                                     std::pair("repaired faces", &Provenance::repairedFaces)})
    for (const int value :
         {0, std::numeric_limits<int>::max(), -1, std::numeric_limits<int>::min()})
      cases.add(field, std::to_string(value), value >= 0,
                structurePut([=, count = count](Node& node) { node.provenance.*count = value; }));
  for (const std::uint64_t bytes : {largestId, largestId + 1, ~std::uint64_t(0)})
    cases.add("bytes of the file", std::to_string(bytes), bytes <= largestId,
              structurePut([bytes](Node& node) { node.provenance.fingerprint->bytes = bytes; }));
  const auto atom = [&cases](const char* field, const std::string& value, bool within,
                             const AtomBall& ball, const std::string& residue = "LYS A 1") {
    auto set = std::make_shared<const AtomSet>(AtomSet{{residue}, {ball}});
    cases.add(field, value, within, structurePut([set](Node& node) { node.atoms = {set}; }));
  };
  atom("place of an atom", "at the limit", true, {{-farthestAtom, 0, farthestAtom}, 1, 0});
  atom("place of an atom", "beyond", false, {{0, std::nextafter(farthestAtom, infinite), 0}, 1, 0});
  atom("place of an atom", "nowhere", false, {{0, 0, noNumber}, 1, 0});
  atom("size of an atom", "at the limit", true, {{0, 0, 0}, largestAtom, 0});
  atom("size of an atom", "beyond", false, {{0, 0, 0}, std::nextafter(largestAtom, infinite), 0});
  atom("size of an atom", "none", false, {{0, 0, 0}, 0.0f, 0});
  atom("name of a residue", "with a bar", true, {{1, 2, 3}, 1, 0}, "A |B | 1");
  atom("name of a residue", "no UTF-8", false, {{1, 2, 3}, 1, 0}, "\xff");
  cases.counts("atoms", mostKeptAtoms, [](std::size_t count) {
    auto set = std::make_shared<const AtomSet>(
        AtomSet{{"W"}, std::vector<AtomBall>(count, AtomBall{{1, 2, 3}, 1, 0})});
    return structurePut([set](Node& node) { node.atoms = {set}; });
  });
  for (const std::size_t more : {0ul, 1ul})
    cases.add("values of paint", std::to_string(more) + " more than vertices", more == 0,
              structurePut([more](Node& node) {
                node.paint = std::make_shared<const Paint>(node.mesh->vertexCount() + more, 9);
              }));
}

void addPlaces(Cases& cases) {
  cases.finite("place of a section", [](float value) {
    return sectionPut([value](Section& s) { s.plane.offset = value; });
  });
  for (const float length : {1.0f, 1.00005f, 1.001f, 0.0f, noNumber})
    cases.add("normal of a section", std::to_string(length), std::abs(length - 1.0f) < 1e-4f,
              sectionPut([length](Section& s) {
                s.plane.normal = {0, 0, length};
              }));
  cases.finite("place of a label", [](float value) {
    return labelPut([value](Annotation& a) { a.anchors = {glm::vec3(0, value, 0)}; });
  });
  cases.number("offset of a label", {-100.0f, 100.0f}, [](float value) {
    return labelPut([value](Annotation& a) { a.offset = glm::vec2(0, value); });
  });
  for (const std::uint32_t triangle : {0u, 319u, 320u, ~0u})
    cases.add("triangle of a label", std::to_string(triangle), triangle < 320,
              labelPut([triangle](Annotation& a) {
                a.anchors = {SurfacePoint{NodeId{3}, triangle, {0.5f, 0.5f}}};
              }));
  cases.number("time of a view", viewSecondsLimits, [](float value) {
    return viewPut([value](View& view) { view.words.seconds = value; });
  });
  cases.number("reach of a focus", nearnessFalloffs, [](float value) {
    return focusPut([value](Focus& focus) { focus.nearness = FocusNearness{{}, value}; });
  });
  cases.finite("place of a focus", [](float value) {
    return focusPut([value](Focus& focus) {
      focus.nearness = FocusNearness{glm::vec3(value, 0, 0), 60.0f};
    });
  });
  cases.number("opening of a camera", {1.0f, 170.0f}, [](float value) {
    return viewPut([value](View& view) {
      view.camera = {};
      view.camera.fovyDegrees = value;
    });
  });
  for (const float value : {infinite, noNumber}) {
    cases.add("opening of a camera that has none", std::to_string(value), false,
              viewPut([value](View& view) { view.camera.fovyDegrees = value; }));
    cases.add("height of a camera that has none", std::to_string(value), false,
              focusPut([value](Focus& focus) {
                focus.seenFrom = Camera();
                focus.seenFrom->heightMm = value;
              }));
    cases.add("eye of a camera", std::to_string(value), false,
              viewPut([value](View& view) { view.camera.eye.x = value; }));
  }
  for (const float length : {1.0f, 1.01f, noNumber})
    cases.add("key light", std::to_string(length), length == 1.0f, [length](Scene& scene) {
      scene.setKeyLight(KeyLight{.towards = {0, 0, length}});
    });
}

void addScans(Cases& cases) {
  for (const int side : {longestScanSide, longestScanSide + 1})
    cases.add("side of a scan", std::to_string(side), side <= longestScanSide,
              scanPut([side](Scan& scan) {
                scan.size = {side, 1, 1};
                scan.voxels = std::make_shared<const std::vector<std::int16_t>>(side, 1);
              }));
  const auto scan = [&cases](const char* field, double value, bool within, double& (*of)(Scan&)) {
    cases.add(field, std::to_string(value), within,
              scanPut([=](Scan& changed) { of(changed) = value; }));
  };
  constexpr double endless = std::numeric_limits<double>::infinity();
  const auto slope = [](Scan& s) -> double& { return s.slope; };
  const auto intercept = [](Scan& s) -> double& { return s.intercept; };
  const auto place = [](Scan& s) -> double& { return s.toLps[3][0]; };
  scan("slope of a scan", 1e-300, true, slope);
  scan("slope of a scan", 0.0, false, slope);
  scan("slope of a scan", double(noNumber), false, slope);
  scan("intercept of a scan", -1e308, true, intercept);
  scan("intercept of a scan", endless, false, intercept);
  scan("place of a scan", 9.999999e6, true, place);
  scan("place of a scan", 1e7, false, place);
  cases.counts("scans", mostSceneScans, [](std::size_t count) -> Put {
    return [count](Scene& scene) {
      scanPut([](Scan&) {})(scene);
      scene.setScans(std::vector<Scan>(count, scene.scans()[0]));
    };
  });
}

void addTraces(Cases& cases) {
  const SourceTrace sound{std::string(traceDigits, '1'), std::string(traceDigits, '2'), {}, {}};
  for (const auto& [count, digit] : {std::pair(traceDigits, 'f'), std::pair(traceDigits, 'F'),
                                     std::pair(traceDigits - 1, '0'), std::pair(70'000ul, '0')})
    for (const auto of : {&SourceTrace::salt, &SourceTrace::study})
      cases.add(of == &SourceTrace::salt ? "salt" : "study", std::to_string(count), digit == 'f',
                [trace = sound, of, text = std::string(count, digit)](Scene& scene) mutable {
                  trace.*of = text;
                  scene.setTraces({trace});
                });
  cases.counts("traces", mostSourceTraces, [sound](std::size_t count) -> Put {
    return [all = std::vector(count, sound)](Scene& scene) { scene.setTraces(all); };
  });
}

void addCounts(Cases& cases) {
  cases.counts("groups in each other", deepestSceneGroup, [](std::size_t count) -> Put {
    return [count](Scene& scene) {
      NodeId parent = rootId;
      for (std::size_t i = 0; i < count; ++i)
        parent = scene.append({.parent = parent, .name = "in"});
      scene.append({.parent = parent, .name = "inmost", .mesh = scene.nodes()[2].mesh});
    };
  });
  cases.counts(
      "structures and groups", mostSceneNodes,
      [](std::size_t count) -> Put {
        return [count](Scene& scene) {
          std::vector<Node> nodes = scene.nodes();
          while (nodes.size() < count)
            nodes.push_back({.id = {nodes.size() + 1}, .name = "one of many"});
          scene.setNodes(std::move(nodes));
        };
      },
      true);
  cases.counts(
      "labels", mostSceneLabels,
      [](std::size_t count) -> Put {
        return [count](Scene& scene) {
          std::vector<Annotation> labels = scene.annotations();
          while (labels.size() < count)
            labels.push_back({.id = {labels.size() + 5}, .anchors = {glm::vec3(0)}});
          scene.setAnnotations(std::move(labels));
        };
      },
      true);
  cases.counts(
      "sections", mostSceneSections,
      [](std::size_t count) -> Put {
        return [count](Scene& scene) {
          std::vector<Section> sections = scene.sections();
          while (sections.size() < count)
            sections.push_back({.id = {sections.size() + 5}});
          scene.setSections(std::move(sections));
        };
      },
      true);
  cases.counts(
      "views", mostSceneViews,
      [](std::size_t count) -> Put {
        return [count](Scene& scene) {
          std::vector<View> views = scene.views();
          views.resize(count, {.name = "one of many"});
          scene.setViews(std::move(views));
        };
      },
      true);
}

void addIds(Cases& cases) {
  for (const std::uint64_t id : {largestId, largestId + 1})
    cases.add("id of a structure", std::to_string(id), id <= largestId, [id](Scene& scene) {
      std::vector<Node> nodes = scene.nodes();
      nodes.back().id = {id};
      scene.setNodes(std::move(nodes));
    });
  cases.add("ids after the largest", "3", true, [](Scene& scene) {
    std::vector<Node> nodes = scene.nodes();
    nodes.back().id = {largestId};
    scene.setNodes(std::move(nodes));
    scene.append({.name = "next"});
    Section section = scene.sections()[0];
    section.id = {largestId};
    scene.setSections({section});
    scene.appendSection(section);
    Annotation label = scene.annotations()[0];
    label.id = {largestId};
    scene.setAnnotations({label});
    scene.appendAnnotation(label);
  });
}

}  // namespace

std::vector<LimitCase> limitCases() {
  Cases cases;
  addTexts(cases);
  addStyle(cases);
  addThresholds(cases);
  addOrigin(cases);
  addPlaces(cases);
  addScans(cases);
  addTraces(cases);
  addCounts(cases);
  addIds(cases);
  return std::move(cases.all);
}

}  // namespace sline::test
