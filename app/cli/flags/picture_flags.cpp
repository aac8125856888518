// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/picture_flags.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <map>

#include "app/cli/files/camera_file.h"
#include "app/cli/files/interruption.h"
#include "app/cli/files/names.h"
#include "app/cli/flags/drawing_flags.h"
#include "app/cli/flags/style_flags.h"
#include "model/edit/look.h"
#include "model/edit/views.h"
#include "model/edit/visibility.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/visible_structures.h"
#include "render/export/order/view_orders.h"
#include "render/export/pixels/image_file.h"
#include "render/lines/techniques/technique_list.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::cli {

namespace {

/// Reads "VALUE" or "NAME=VALUE" from each text.
template <class T, class Parse>
Status parseAssignments(const std::vector<std::string>& texts, const Parse& parse,
                        std::vector<Assignment<T>>& assignments) {
  for (const std::string& text : texts) {
    const std::optional<NamedValue> named = splitNamed(text);
    const T value = TRY(parse(named ? named->value : text));
    if (named && model::normalisedName(named->name).empty())
      return Error{.reason = "\"" + text + "\" names no structure",
                   .remedy = "Write NAME=" + named->value};
    assignments.push_back({named ? std::optional<std::string>(named->name) : std::nullopt, value});
  }
  return Unit{};
}

std::size_t depthOf(const model::Scene& scene, model::NodeId id) {
  std::size_t depth = 0;
  for (const model::Node* node = scene.find(id); node; node = scene.find(node->parent))
    ++depth;
  return depth;
}

/// Holds what is said of one node and all below it.
struct Patch {
  model::NodeId node;
  model::Style style;
};
/// Lists patches by the depth of their node, the root's 0, those of one depth in the order in which
/// they were given.
using Patches = std::multimap<std::size_t, Patch>;

Status collect(const model::Scene& scene, const std::vector<Assignment<model::Style>>& assignments,
               Patches& patches) {
  for (const Assignment<model::Style>& assignment : assignments) {
    if (!assignment.name) {
      patches.insert({0, {model::rootId, assignment.value}});
      continue;
    }
    const auto ids = TRY(nodesNamed(scene, *assignment.name));
    for (const model::NodeId id : ids)
      patches.insert({depthOf(scene, id), {id, assignment.value}});
  }
  return Unit{};
}

template <class T>
Status collect(const model::Scene& scene, const std::vector<Assignment<T>>& assignments,
               std::optional<T> model::Style::*field, Patches& patches) {
  std::vector<Assignment<model::Style>> styles;
  for (const Assignment<T>& assignment : assignments) {
    styles.push_back({assignment.name, {}});
    styles.back().value.*field = assignment.value;
  }
  return collect(scene, styles, patches);
}

std::vector<model::NodeId> allBelow(const model::Scene& scene, model::NodeId id) {
  std::vector<model::NodeId> ids;
  for (const model::Node& node : scene.nodes())
    if (scene.isBelow(node.id, id))
      ids.push_back(node.id);
  return ids;
}

Result<model::Scene> withOnly(const model::Scene& scene, const std::vector<std::string>& names) {
  std::vector<model::NodeId> shown;
  for (const std::string& name : names) {
    const auto ids = TRY(nodesNamed(scene, name));
    shown.insert(shown.end(), ids.begin(), ids.end());
  }
  return model::withOnlyVisible(scene, shown).scene;
}

Error unknownView(const model::Scene& scene, const std::string& view) {
  std::vector<std::string> names(model::anatomicalViewNames.begin(),
                                 model::anatomicalViewNames.end());
  for (const model::View& saved : scene.views())
    names.push_back(saved.name);
  Error error = unknownName("view", view, names);
  std::string all;
  for (const std::string& name : names)
    all += (all.empty() ? "" : ", ") + name;
  error.remedy = "There are: " + all;
  return error;
}

/// Returns the anatomical view that the spec names, anterior where it names none; nothing for
/// another name.
std::optional<model::AnatomicalView> viewOf(const PictureSpec& spec) {
  return spec.view.empty() ? std::optional(model::AnatomicalView::anterior)
                           : model::anatomicalViewNamed(model::normalisedName(spec.view));
}

template <class T>
bool sayForAll(const std::vector<Assignment<T>>& assignments) {
  return std::any_of(assignments.begin(), assignments.end(),
                     [](const Assignment<T>& each) { return !each.name; });
}

}  // namespace

const model::View* savedView(const model::Scene& scene, const std::string& name) {
  if (name.empty())
    return nullptr;
  const std::string wanted = model::normalisedName(name);
  for (const model::View& saved : scene.views())
    if (model::normalisedName(saved.name) == wanted)
      return &saved;
  return nullptr;
}

namespace {

Result<int> parseSampleCount(const std::string& text, const Size& size) {
  const std::optional<int> samples = TRY(parseSamples(text));
  const int number = samples.value_or(render::samplesAtOnce({size.width, size.height}));
  if (samples && std::max(size.width, size.height) > render::pixelSideLimits.high / number)
    return Error{.reason = text + " samples across a pixel are too many for so large a picture",
                 .remedy = "Its longer side times the samples may reach " +
                           std::to_string(render::pixelSideLimits.high) + "; take fewer"};
  return number;
}

/// Reads the kind of hatching and the light that it is drawn for.
Status parseHatchingFlags(const PictureFlags& flags, PictureSpec& spec) {
  spec.hatching = TRY(parseHatching(flags.hatching));
  spec.environment.keyLight = flags.keyLight;
  if (flags.light.empty())
    return Unit{};
  spec.environment.light = TRY(parseLight(flags.light));
  return Unit{};
}

Status parseFillFlag(const PictureFlags& flags, PictureSpec& spec) {
  if (flags.fill.empty())
    return Unit{};
  spec.fill = TRY(parseFill(flags.fill));
  return Unit{};
}

Status parseStyleFlags(const PictureFlags& flags, PictureSpec& spec) {
  for (const StyleFlag& flag : styleFlags()) {
    const auto typed = flags.styles.find(flag.flag);
    if (typed == flags.styles.end())
      continue;
    const auto parse = [&flag](std::string_view text) { return flag.parse(flag.what, text); };
    TRY(parseAssignments(typed->second, parse, spec.styles));
  }
  for (const std::string& text : flags.lineThresholds) {
    const model::ThresholdValue value = TRY(render::parseThresholdValue(text));
    spec.lineThresholds.set(value.name, value.value);
  }
  return Unit{};
}

Status parseLabelFlags(const PictureFlags& flags, PictureSpec& spec) {
  spec.labels = TRY(parseFlags(flags.labels));
  spec.labels.style.ground = spec.environment.background;
  return Unit{};
}

}  // namespace

Result<PictureSpec> parseFlags(const PictureFlags& flags) {
  TRY(render::checkImageName(flags.output));
  return parseFlagsWithoutOutput(flags);
}

Result<PictureSpec> parseFlagsWithoutOutput(const PictureFlags& flags) {
  PictureSpec spec;
  spec.output = flags.output;
  spec.view = flags.view;
  if (flags.look != "auto" && flags.look != "plain")
    return Error{.reason = "--look " + flags.look + " is unknown",
                 .remedy = "Give --look auto or --look plain"};
  spec.choosesLook = flags.look == "auto";
  spec.only = flags.only;
  const Size size = TRY(parseSize(flags.size));
  spec.size = size;
  spec.samples = TRY(parseSampleCount(flags.samples, size));
  TRY(parseDrawing(flags, spec));
  TRY(parseHatchingFlags(flags, spec));
  spec.blackAndWhite = flags.blackAndWhite;
  TRY(parseFillFlag(flags, spec));
  TRY(parseAssignments(flags.gammas, parseGamma, spec.gammas));
  TRY(parseAssignments(flags.gammaMaps, parseGammaMap, spec.gammaMaps));
  TRY(parseAssignments(flags.colours, parseColour, spec.colours));
  TRY(parseAssignments(flags.inkColours, parseColour, spec.inkColours));
  TRY(parseStyleFlags(flags, spec));
  for (const Assignment<Colour>& assignment : spec.colours)
    if (!assignment.name)
      return Error{.reason = "a colour is given without the name of a structure or group",
                   .remedy = "Write NAME=#rrggbb"};
  spec.focus = TRY(parseFlags(flags.focus));
  TRY(parseLabelFlags(flags, spec));
  spec.sections = TRY(parseFlags(flags.sections));
  spec.sections.hatched = spec.sections.hatched || spec.blackAndWhite ||
                          (spec.drawing && spec.drawing->hatchedSections);
  TRY(takeCamera(flags.cameraFile, spec));
  return spec;
}

Status takeCamera(const std::string& file, PictureSpec& spec) {
  if (file.empty())
    return Unit{};
  spec.camera = TRY(readCamera(file));
  return Unit{};
}

std::string shownViewName(const model::Scene& scene, const PictureSpec& spec) {
  if (!spec.camera)
    if (const model::View* saved = savedView(scene, spec.view))
      return saved->name;
  const auto side = spec.camera   ? model::anatomicalViewOf(*spec.camera)
                    : spec.fitted ? spec.fitted->view
                                  : viewOf(spec);
  return side ? std::string(model::anatomicalViewNames[std::size_t(*side)]) : std::string();
}

model::ViewWords shownViewWords(const model::Scene& scene, const PictureSpec& spec) {
  const model::View* saved = spec.camera ? nullptr : savedView(scene, spec.view);
  return saved ? saved->words : model::ViewWords();
}

model::Scene withSavedView(const model::Scene& scene, const PictureSpec& spec) {
  const model::View* saved = spec.camera ? nullptr : savedView(scene, spec.view);
  if (!saved)
    return scene;
  model::AppliedView shown = model::withViewApplied(scene, *saved);
  if (!shown.absent.empty())
    warn("of what the view \"" + saved->name + "\" shows, " + std::to_string(shown.absent.size()) +
         (shown.absent.size() == 1 ? " structure or group is" : " structures or groups are") +
         " no longer in the scene");
  return std::move(shown.scene);
}

namespace {

/// Returns the scene with these thresholds set of all structures, beside those that they have.
model::Scene withThresholds(const model::Scene& scene, const model::ThresholdValues& values) {
  if (values.empty())
    return scene;
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  std::vector<model::Node> nodes = scene.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    model::ThresholdValues all = styles[i].lineThresholds;
    for (const model::ThresholdValue& value : values.all())
      all.set(value.name, value.value);
    nodes[i].style.lineThresholds = all;
  }
  model::Scene result = scene;
  result.setNodes(std::move(nodes));
  return result;
}

}  // namespace

Result<model::Scene> styled(const model::Scene& scene, const PictureSpec& spec) {
  Patches patches;
  if (spec.fill) {
    model::Style style;
    style.fill = spec.fill;
    patches.insert({0, {model::rootId, style}});
  }
  TRY(collect(scene, spec.gammas, &model::Style::gamma, patches));
  std::vector<Assignment<model::GammaMap>> maps;
  for (const Assignment<GammaMapWish>& wish : spec.gammaMaps) {
    model::GammaMap map = TRY(gammaMapIn(scene, wish.value));
    maps.push_back({wish.name, std::move(map)});
  }
  TRY(collect(scene, maps, &model::Style::gammaMap, patches));
  TRY(collect(scene, spec.colours, &model::Style::colour, patches));
  TRY(collect(scene, spec.inkColours, &model::Style::inkColour, patches));
  TRY(collect(scene, spec.styles, patches));
  model::Scene result = scene;
  for (const auto& [depth, patch] : patches)
    result = model::withLook(result, allBelow(scene, patch.node), patch.style).scene;
  result = withThresholds(result, spec.lineThresholds);
  if (spec.blackAndWhite)
    result = model::withInkAlone(result).scene;
  return spec.only.empty() ? result : withOnly(result, spec.only);
}

Result<model::Scene> withOpeningLook(const model::Scene& scene, PictureSpec& spec) {
  if (!model::hasNoLook(scene) || spec.focus.any())
    return scene;
  if (!spec.drawing && (!spec.choosesLook || spec.fill || sayForAll(spec.gammas)))
    return scene;
  const model::Scene some =
      TRY(spec.only.empty() ? Result<model::Scene>(scene) : withOnly(scene, spec.only));
  const model::Scene cut = TRY(cutOpen(some, spec));
  model::OpeningWishes wishes{.aspect = spec.size.aspect()};
  if (spec.camera)
    wishes.camera = spec.camera;
  else if (const model::View* saved = savedView(scene, spec.view))
    wishes.camera = saved->camera;
  else if (!spec.view.empty() && !viewOf(spec))
    return scene;  // `cameraFor` says what is wrong
  else if (!spec.view.empty())
    wishes.view = viewOf(spec);
  model::FormIndex forms;
  const std::optional<model::OpeningLook> look = model::openingLook(cut, forms, wishes);
  if (!look)
    return scene;
  if (look->view)
    spec.view = std::string(model::anatomicalViewNames[std::size_t(*look->view)]);
  if (!wishes.camera)
    spec.fitted = *look;
  model::Scene dressed = scene;
  dressed.setNodes(look->scene.nodes());
  if (spec.drawing && !spec.drawing->styleOf)
    spec.drawing = nullptr;  // it is a plate now
  return dressed;
}

Result<model::Scene> inFocus(const model::Scene& scene, const PictureSpec& spec) {
  if (!spec.focus.any())
    return scene;
  const model::Scene cut = TRY(cutOpen(scene, spec));
  const model::Camera camera = TRY(cameraFor(cut, spec));
  return focused(scene, spec.focus, cut, camera);
}

Result<model::Scene> cutOpen(const model::Scene& scene, const PictureSpec& spec) {
  if (spec.sections.sections.empty())
    return scene;
  // Which half faces the camera does not depend on how it is fitted.
  const model::Camera camera = TRY(cameraFor(scene, spec));
  return sectioned(scene, spec.sections, camera);
}

Result<model::Camera> cameraFor(const model::Scene& scene, const PictureSpec& spec) {
  if (spec.camera)
    return *spec.camera;
  const float aspect = spec.size.aspect();
  if (const model::View* saved = savedView(scene, spec.view))
    return render::fittedToPage(scene, saved->camera, aspect);
  if (spec.fitted)
    return model::framedCamera(*spec.fitted, aspect, spec.labels.sides);
  const auto view = viewOf(spec);
  if (!view)
    return unknownView(scene, spec.view);
  return model::fittedView(scene, *view, aspect, spec.labels.sides);
}

Status drawToFile(const model::Scene& scene, const model::Camera& camera, const PictureSpec& spec,
                  Progress& progress) {
  if (scene.visibleBounds().empty())
    warn("no structure is visible: the picture is empty");
  const auto picture = TRY(render::HeadlessPicture::create());
  progress.note("Drawing with " + picture.driver());
  progress.show(0.0, "preparing surfaces");
  const render::PictureSettings settings{.width = spec.size.width,
                                         .height = spec.size.height,
                                         .environment = spec.environment,
                                         .hatching = spec.hatching};
  picture->prepare(scene, camera, settings, spec.samples);
  progress.show(0.5, "drawing");
  render::Image image = TRY(picture->render(scene, camera, settings, spec.samples));
  drawLabels(image, scene, camera, spec.labels, spec.environment.background);
  progress.show(0.9, "writing " + spec.output);
  const Interruption interruption;  // what is written is soon whole
  return render::writeImage(image, spec.output);
}

}  // namespace sline::cli
