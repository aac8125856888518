// SPDX-License-Identifier: Apache-2.0
#include "model/look/drawing_styles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include "model/base/contrast.h"
#include "model/edit/locks.h"
#include "model/edit/look.h"
#include "model/focus/context.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

using Standing = DrawnPart::Standing;

constexpr Colour black{0, 0, 0};
constexpr Colour white{255, 255, 255};

/// Returns a style that answers every field of a pen as usual: nothing of an earlier style stays.
Style usualPen(float gamma, float pen) {
  const ResolvedStyle usual;
  Style style;
  style.gamma = Gamma::clamped(gamma);
  style.penWeight = pen;
  style.lineVariation = usual.lineVariation;
  style.lineSmoothing = usual.lineSmoothing;
  style.shortestLine = usual.shortestLine;
  style.lineScale = usual.lineScale;
  style.hatchDensity = usual.hatchDensity;
  style.hatchTone = usual.hatchTone;
  style.fill = Fill::paper;
  style.opacity = Opacity::clamped(1.0f);
  return style;
}

/// Lets the part hide as much as it does now; what stands before the subject hides nothing.
void keepCovering(Style& style, const DrawnPart& part) {
  if (part.standing == Standing::subject)
    return;
  const bool shaded = part.now.gamma.value() > 3.0f && part.now.opacity.value() >= 0.5f;
  if (part.standing == Standing::front)
    style.fill = Fill::none;
  else if (!shaded && part.now.fill != Fill::paper)
    style.fill = part.now.fill == Fill::none ? Fill::none : Fill::veil;
}

/// Returns the usual pen at that Γ and weight by the part's standing, covering what it does now.
/// The subject keeps the greatest Γ, so that the next style knows it.
Style penOf(const DrawnPart& part, std::array<float, 3> gammas, std::array<float, 3> pens) {
  const auto which = std::size_t(part.standing);
  Style style = usualPen(gammas[which], pens[which]);
  keepCovering(style, part);
  return style;
}

Style evenPen(const DrawnPart& part) {
  Style style = penOf(part, {2.0f, 1.0f, 0.0f}, {0.8f, 0.8f, 0.8f});
  style.lineVariation = 0.0f;
  style.inkColour = black;
  return style;
}

/// Returns the colour in its own hue with at least that saturation and value (HSV, 0 … 1); a grey
/// stays one.
Colour vivid(const Colour& colour, float saturation, float value) {
  const std::array<float, 3> old{float(colour.red), float(colour.green), float(colour.blue)};
  const auto [low, high] = std::minmax_element(old.begin(), old.end());
  if (*low == *high)
    return colour;
  const float most = 255.0f * std::max(value, *high / 255.0f);
  const float depth = most * std::max(saturation, (*high - *low) / *high);
  const auto channel = [&, low = *low, span = *high - *low](float from) {
    return std::uint8_t(std::lround(most - depth + depth * (from - low) / span));
  };
  return {channel(old[0]), channel(old[1]), channel(old[2])};
}

Style textbook(const DrawnPart& part) {
  Style style = penOf(part, {3.3f, 1.5f, 0.0f}, {1.0f, 0.6f, 0.45f});
  style.inkColour = black;
  if (part.standing == Standing::subject) {
    const Colour second = vivid(part.accent, 0.8f, 0.8f);
    style.hatchTone = HatchTone::clamped(0.0f);
    style.colour = second;
    style.inkColour = legibleOn(white, second, 7.0);
  }
  return style;
}

Style woodcut(const DrawnPart& part) {
  Style style = penOf(part, {3.0f, 2.7f, 0.0f}, {1.7f, 1.1f, 0.8f});
  style.hatchDensity = HatchDensity::clamped(1.6f);
  style.hatchTone = HatchTone::clamped(part.standing == Standing::subject ? 3.2f : 2.4f);
  style.colour = white;
  style.inkColour = black;
  return style;
}

Style pencil(const DrawnPart& part) {
  constexpr Colour graphite{70, 70, 76};
  constexpr Colour hard{120, 120, 126};
  const bool subject = part.standing == Standing::subject;
  Style style = penOf(part, {3.0f, 2.7f, 0.0f}, {0.7f, 0.5f, 0.4f});
  style.hatchDensity = HatchDensity::clamped(3.5f);
  style.hatchTone = HatchTone::clamped(subject ? 2.5f : 2.0f);
  style.inkColour = subject ? graphite : hard;
  style.grain = 0.8f;
  return style;
}

Style operatingNote(const DrawnPart& part) {
  constexpr Colour quiet{80, 80, 80};
  Style style = penOf(part, {2.0f, 1.0f, 0.0f}, {1.4f, 0.5f, 0.35f});
  style.shortestLine = 16.0f;
  style.lineScale = 2.0f;
  style.inkColour = quiet;
  if (part.standing == Standing::subject)
    style.inkColour = legibleOn(white, vivid(part.accent, 0.85f, 0.8f), 5.0);
  return style;
}

/// Returns the colour with at most that share of the light that a screen has; again, it is the
/// same.
Colour dimmed(const Colour& colour, float most) {
  const auto brightest = float(std::max({colour.red, colour.green, colour.blue}));
  const float share = std::min(std::round(most * 255.0f) / std::max(brightest, 1.0f), 1.0f);
  const auto channel = [share](std::uint8_t c) {
    return std::uint8_t(std::lround(share * float(c)));
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

/// Context has dim colours of its own: filled with the ground, vessels before what is bright would
/// be black bands.
Style lectureHall(const DrawnPart& part) {
  constexpr Colour ground{28, 30, 34};
  constexpr Colour chalk{214, 218, 226};
  constexpr float quiet = 0.42f;
  Style style = penOf(part, {4.3f, 3.9f, 0.0f}, {1.2f, 0.6f, 0.5f});
  style.hatchTone = HatchTone::clamped(0.0f);
  style.inkColour = chalk;
  if (part.standing == Standing::subject) {
    style.colour = vivid(part.now.colour, 0.55f, 0.96f);
    style.inkColour = legibleOn(ground, *style.colour, 9.0);
  } else if (part.standing == Standing::context) {
    style.colour = dimmed(part.now.colour, quiet);
    style.inkColour = legibleOn(ground, *style.colour, 4.5);
  }
  return style;
}

constexpr std::array styles{
    DrawingStyle{.id = "plate",
                 .name = "Plate",
                 .description =
                     "What the scene is about shaded in colour, everything else as quiet "
                     "context.",
                 .background = "white"},
    DrawingStyle{.id = "even-pen",
                 .name = "Even Pen",
                 .description =
                     "Outlines and folds in black, all by one pen that never changes its "
                     "width.",
                 .background = "white",
                 .styleOf = evenPen},
    DrawingStyle{.id = "textbook",
                 .name = "Textbook",
                 .description =
                     "Two colours: black lines, and one colour with a pale tint for what "
                     "the scene is about.",
                 .background = "white",
                 .styleOf = textbook},
    DrawingStyle{.id = "woodcut",
                 .name = "Woodcut",
                 .description = "Heavy black lines and dense hatching on white.",
                 .background = "white",
                 .styleOf = woodcut,
                 .hatchedSections = true},
    DrawingStyle{.id = "pencil",
                 .name = "Pencil",
                 .description = "Fine strokes of graphite on warm paper.",
                 .background = "paper",
                 .styleOf = pencil},
    DrawingStyle{.id = "operating-note",
                 .name = "Operating Note",
                 .description = "A few long lines as a surgeon would sketch them, what matters in "
                                "one colour.",
                 .background = "white",
                 .styleOf = operatingNote},
    DrawingStyle{.id = "lecture-hall",
                 .name = "Lecture Hall",
                 .description = "Bright colours on a dark ground, to be seen from the last row.",
                 .background = "dark",
                 .styleOf = lectureHall}};

using Structures = std::vector<VisibleStructure>;

std::vector<NodeId> structuresFrom(const Structures& visible, float gamma) {
  std::vector<NodeId> ids;
  for (const VisibleStructure& each : visible)
    if (each.style.gamma.value() >= gamma)
      ids.push_back(each.node->id);
  return ids;
}

/// Returns what looks in focus, if anything beside it is shaded as surroundings are: without any
/// hatching. A person may have given the same Γ without a focus.
std::vector<NodeId> inFocusAmong(const Structures& visible) {
  constexpr float modelled = 3.0f;
  const bool surrounded =
      std::any_of(visible.begin(), visible.end(), [](const VisibleStructure& each) {
        return !looksInFocus(each.style) && each.style.gamma.value() > modelled &&
               each.style.hatchTone.value() <= 0.0f;
      });
  std::vector<NodeId> ids;
  for (const VisibleStructure& each : visible)
    if (surrounded && looksInFocus(each.style))
      ids.push_back(each.node->id);
  return ids;
}

int saturationOf(const Colour& colour) {
  const auto [low, high] = std::minmax({colour.red, colour.green, colour.blue});
  return int(high) - int(low);
}

/// Returns the colour of the subject's largest structure that has one.
Colour accentOf(const Structures& visible, const std::unordered_set<std::uint64_t>& subject) {
  constexpr int colourful = 60;
  Colour accent{176, 44, 36};  // the red that printers have beside black
  float largest = 0.0f;
  for (const VisibleStructure& each : visible) {
    const glm::vec3 size = each.node->mesh->bounds().size();
    const float area = size.x * size.y + size.y * size.z + size.z * size.x;
    if (!subject.contains(each.node->id.value) || saturationOf(each.style.colour) < colourful ||
        area <= largest)
      continue;
    largest = area;
    accent = each.style.colour;
  }
  return accent;
}

/// Tells whether a focus hid the structure, which the next one may show again.
bool isFaded(const Style& style) {
  return style.visible == false && style.opacity && style.opacity->value() <= 0.0f;
}

/// Returns the scene without what its unlocked nodes say of a look, except colours and visibility.
Scene undressed(const Scene& scene) {
  Style which = wholeLook();
  which.colour.reset();
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    if (scene.isLocked(node.id))
      continue;
    const bool faded = isFaded(node.style);
    forget(node.style, which);
    if (faded)
      node.style.opacity = Opacity::clamped(0.0f);
  }
  Scene after = scene;
  after.setNodes(std::move(nodes));
  return after;
}

/// Draws the scene as a plate, about its own subject where it has a look.
std::optional<Scene> plateOf(const Scene& scene, FormIndex& forms, OpeningWishes wishes,
                             const std::stop_token& stop) {
  if (!hasNoLook(scene))
    wishes.about = emphasisedIn(scene);
  auto look = openingLook(undressed(scene), forms, wishes, stop);
  return look ? std::optional(std::move(look->scene)) : std::nullopt;
}

Scene restyled(const Scene& dressed, const DrawingStyle& style) {
  const Structures visible = visibleStructures(dressed);
  std::unordered_set<std::uint64_t> subject;
  for (const NodeId id : emphasisedIn(dressed))
    subject.insert(id.value);
  const Colour accent = accentOf(visible, subject);
  Scene after = undressed(dressed);
  std::vector<Node> nodes = after.nodes();
  const std::vector<ResolvedStyle> now = resolveAll(dressed);
  constexpr float outline = 0.5f;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].isGroup())
      continue;
    const Standing standing = subject.contains(nodes[i].id.value) ? Standing::subject
                              : now[i].gamma.value() < outline    ? Standing::front
                                                                  : Standing::context;
    const bool faded = isFaded(nodes[i].style);
    patch(nodes[i].style, style.styleOf({standing, now[i], accent}));
    if (faded)
      nodes[i].style.opacity = Opacity::clamped(0.0f);
  }
  after.setNodes(std::move(nodes));
  if (style.hatchedSections) {
    std::vector<Section> sections = after.sections();
    for (Section& section : sections)
      section.hatched = true;
    after.setSections(std::move(sections));
  }
  return after;
}

/// Notes of each structure whose colour the style has changed which one it had.
void noteColours(const Scene& before, Scene& after) {
  std::vector<Node> nodes = after.nodes();
  for (Node& node : nodes) {
    const Node* was = before.find(node.id);
    if (was && node.style.colour && node.style.colour != was->style.colour)
      node.drawn = DrawnColour{*node.style.colour, was->style.colour};
  }
  after.setNodes(std::move(nodes));
}

}  // namespace

std::span<const DrawingStyle> drawingStyles() {
  return styles;
}

const DrawingStyle* drawingStyleNamed(std::string_view id) {
  const auto found = std::find_if(styles.begin(), styles.end(),
                                  [id](const DrawingStyle& style) { return style.id == id; });
  return found == styles.end() ? nullptr : &*found;
}

std::vector<NodeId> emphasisedIn(const Scene& scene) {
  const Structures visible = visibleStructures(scene);
  if (visible.empty())
    return {};
  if (auto ids = inFocusAmong(visible); !ids.empty())
    return ids;
  constexpr float shaded = 3.95f;
  if (auto ids = structuresFrom(visible, shaded); !ids.empty())
    return ids;
  float most = 0.0f;
  for (const VisibleStructure& each : visible)
    most = std::max(most, each.style.gamma.value());
  constexpr float alike = 0.25f;  // less than styles keep between subject and context
  if (auto ids = structuresFrom(visible, most - alike); ids.size() < visible.size())
    return ids;
  return subjectsOf(scene).front().structures;
}

Scene withOwnColours(const Scene& scene) {
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    if (!node.drawn || scene.isLocked(node.id))
      continue;
    if (node.style.colour == node.drawn->given)
      node.style.colour = node.drawn->had;
    node.drawn.reset();
  }
  Scene own = scene;
  own.setNodes(std::move(nodes));
  return own;
}

Edited withDrawingStyle(const Scene& scene, const DrawingStyle& style, FormIndex& forms,
                        const OpeningWishes& wishes, const std::stop_token& stop) {
  const Scene own = withOwnColours(scene);
  std::optional<Scene> drawn = own;
  if (!style.styleOf || hasNoLook(scene))
    drawn = plateOf(own, forms, wishes, stop);
  if (!drawn || visibleStructures(*drawn).empty())
    return {scene, false};
  const Scene before = *drawn;
  if (style.styleOf)
    drawn = restyled(before, style);
  Edited edited = withLocksKept(own, std::move(*drawn));
  noteColours(before, edited.scene);
  edited.changed = !(edited.scene == scene);
  return edited;
}

}  // namespace sline::model
