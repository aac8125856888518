// SPDX-License-Identifier: Apache-2.0
// Implements `sline lines`: writes the line segments and strokes of a mesh for one camera as JSON.
#include <algorithm>

#include "app/cli/commands/command.h"
#include "app/cli/files/camera_file.h"
#include "app/cli/files/json_values.h"
#include "app/cli/files/targets.h"
#include "app/cli/flags/section_options.h"
#include "app/cli/flags/values.h"
#include "model/disk/whole_file.h"
#include "model/geometry/mesh_trees.h"
#include "render/lines/ground/stages.h"
#include "render/lines/ground/view_scale.h"
#include "render/lines/hatching/clipping.h"
#include "render/lines/patterns/cut_faces.h"
#include "render/lines/techniques/line_technique.h"
#include "render/lines/techniques/visibility.h"
#include "render/strokes/structure_lines.h"

namespace sline::cli {

namespace {

struct LinesFlags {
  InputFlags input;
  std::string camera;
  std::string size;
  std::string output;
  std::string gamma;  ///< empty: the value by which all of the kinds have entered
  std::vector<std::string> kinds{"contour", "suggestive"};
  SectionFlags sections;
};

/// Returns the techniques and what else is written: the contours that no surface lies behind, and
/// strokes.
std::vector<std::string> lineKindNames() {
  std::vector<std::string> names;
  for (const render::LineTechnique& technique : render::lineTechniques())
    names.emplace_back(technique.id);
  names.insert(names.end(), {"silhouette", "hatching"});
  return names;
}

struct LinesSpec {
  model::ImportOptions import;
  model::Camera camera;
  Size size;
  Gamma gamma;
  std::vector<std::string> kinds;
  SectionsSpec sections;

  bool wants(std::string_view kind) const {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  }
};

Result<LinesSpec> parseLinesFlags(const LinesFlags& flags) {
  LinesSpec spec;
  InputFlags input = flags.input;
  if (input.smooth.empty())
    input.smooth = "off";
  spec.import = TRY(importOptions(input));
  spec.size = TRY(parseSize(flags.size));
  spec.kinds = flags.kinds;
  const std::string allEntered = spec.wants("hatching") ? "3" : "2";
  spec.gamma = TRY(parseGamma(flags.gamma.empty() ? allEntered : flags.gamma));
  spec.camera = TRY(readCamera(flags.camera));
  spec.sections = TRY(parseFlags(flags.sections));
  return spec;
}

Json jsonSeed(const render::HatchSeed& seed) {
  return {{"axis", seed.axis}, {"level", seed.level}, {"i", seed.i}, {"j", seed.j}};
}

/// Collects the segments and strokes of all structures, kind by kind.
class LinesDocument {
 public:
  explicit LinesDocument(const LinesSpec& spec)
      : m_order(spec), m_thresholds(render::thresholdsAt(spec.gamma)) {
    for (const std::string& kind : spec.kinds)
      m_kinds[kind] = {{kind == "hatching" ? "strokes" : "segments", Json::array()},
                       {"thresholds", Json::object()}};
  }

  void add(const model::MeshPtr& mesh, std::span<const model::Plane> planes) {
    const model::SurfacePtr surface = model::prepareSurface(mesh);
    const model::BvhPtr tree = model::treeOf(mesh);
    const model::Bvh& bvh = *tree;
    render::LineRequest request;
    request.kinds = {};
    for (const render::LineTechnique& technique : render::lineTechniques())
      if (m_order.wants(technique.id))
        request.kinds.add(technique.kind);
    if (m_order.wants("silhouette"))
      request.kinds.add(render::LineKind::contour);
    request.thresholds = m_thresholds;
    request.aspect = float(m_order.size.width) / float(m_order.size.height);
    request.twoSided = render::needsTwoSides(*surface, m_order.camera);
    render::LineSet lines = render::extractLines(*surface, m_order.camera, request);
    for (const render::LineTechnique& technique : render::lineTechniques())
      render::clip(lines[technique.kind], planes);
    const std::vector<render::CutFace> faces = render::cutFaces(*surface, planes);
    std::vector<render::Segment>& outlines = lines[render::LineKind::section];
    for (const render::CutFace& face : faces)
      outlines.insert(outlines.end(), face.outline.begin(), face.outline.end());
    m_featureSize.push_back(surface->featureSize);

    const auto visible = [&](const std::vector<render::Segment>& segments) {
      return render::visibleSegments(*surface, bvh, m_order.camera, segments, faces);
    };
    if (m_order.wants("hatching"))
      addHatching(surface, bvh, planes, faces);
    for (const render::LineTechnique& technique : render::lineTechniques())
      if (m_order.wants(technique.id))
        append(technique.id, lines[technique.kind], visible(lines[technique.kind]));
    const std::vector<render::Segment>& contours = lines[render::LineKind::contour];
    if (m_order.wants("silhouette")) {
      const std::vector<bool> outline =
          render::silhouetteSegments(*surface, bvh, m_order.camera, contours, faces);
      std::vector<render::Segment> segments;
      for (std::size_t i = 0; i < outline.size(); ++i)
        if (outline[i])
          segments.push_back(contours[i]);
      append("silhouette", segments, visible(segments));
    }
  }

  std::string text() {
    Json sizes = Json::array();
    for (const float size : m_featureSize)
      sizes.push_back(jsonNumber(size));
    const Json featureSize = sizes.size() == 1 ? sizes.front() : sizes;
    for (auto& [name, kind] : m_kinds.items()) {
      Json& used = kind["thresholds"];
      used["gamma"] = jsonNumber(m_order.gamma.value());
      for (const render::LineTechnique& technique : render::lineTechniques())
        if (name == technique.id)
          for (std::size_t i = 0; i < technique.thresholds.size(); ++i)
            used[technique.thresholds[i].id] = jsonNumber(m_thresholds.of(technique.kind, i));
      if (name == "hatching")
        used["t_h"] = jsonNumber(render::transitions(m_order.gamma).hatching);
      used["feature_size_mm"] = featureSize;
    }
    return jsonText(Json{{"kinds", m_kinds}}) + "\n";
  }

 private:
  void addHatching(const model::SurfacePtr& surface, const model::Bvh& bvh,
                   std::span<const model::Plane> planes,
                   const std::vector<render::CutFace>& faces) {
    const render::PictureView view(m_order.camera, surface->mesh->bounds(), m_order.size.width,
                                   m_order.size.height);
    render::PreparedSurface prepared;
    prepared.surface = surface;
    prepared.strokes = std::make_unique<render::StrokeLayout>(
        surface, render::longestHatchStroke / render::hatchSpacing);
    const render::DrawnStructure shown{.style = {.gamma = m_order.gamma}, .prepared = &prepared};
    render::Hatching hatching = render::styledHatching(shown, view, render::upperLeftLight);
    render::clip(hatching, planes);
    const std::vector<bool> visible =
        render::visiblePoints(*surface, bvh, m_order.camera, hatching, faces);
    for (const render::HatchStroke& stroke : hatching.strokes)
      append(stroke, hatching.points, visible);
  }

  void append(const render::HatchStroke& stroke, const std::vector<render::HatchPoint>& points,
              const std::vector<bool>& visible) {
    const render::ViewScale scale(m_order.camera);
    Json positions = Json::array();
    Json millimetres = Json::array();
    Json units = Json::array();
    Json seen = Json::array();
    for (std::size_t i = stroke.first; i < stroke.first + stroke.count; ++i) {
      const render::HatchPoint& point = points[i];
      const float perMm = scale.project(point.position).perMm;
      positions.push_back(jsonPoint(point.position));
      millimetres.push_back(jsonNumber(perMm > 0.0f ? point.halfWidth / perMm : 0.0f));
      units.push_back(jsonNumber(point.halfWidth));
      seen.push_back(bool(visible[i]));
    }
    m_kinds["hatching"]["strokes"].push_back({{"seed", jsonSeed(stroke.seed)},
                                              {"points", std::move(positions)},
                                              {"half_widths_mm", std::move(millimetres)},
                                              {"half_widths", std::move(units)},
                                              {"visible", std::move(seen)}});
  }

  void append(const char* kind, const std::vector<render::Segment>& segments,
              const std::vector<bool>& visible) {
    Json& list = m_kinds[kind]["segments"];
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const render::Segment& s = segments[i];
      list.push_back({{"a", jsonPoint(s.a)},
                      {"b", jsonPoint(s.b)},
                      {"opacity", jsonNumber(0.5f * (s.opacityA + s.opacityB))},
                      {"visible", bool(visible[i])}});
    }
  }

  const LinesSpec& m_order;
  render::LineThresholds m_thresholds;
  Json m_kinds = Json::object();
  std::vector<float> m_featureSize;
};

Exit runLines(const LinesFlags& flags) {
  const Result<LinesSpec> spec = parseLinesFlags(flags);
  if (!spec.ok())
    return complain(spec.error(), Exit::wrongUse);
  std::vector<std::string> read = flags.input.inputs;
  read.push_back(flags.camera);
  const Target lines{.flag = "--output", .name = flags.output, .endings = {"json"}};
  if (const Status fine = checkTargets({&lines, 1}, read); !fine.ok())
    return complain(fine.error(), Exit::wrongUse);
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input, spec->import, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  const Result<model::Scene> scene = sectioned(imported->scene, spec->sections, spec->camera);
  if (!scene.ok())
    return complain(scene.error(), Exit::wrongUse);
  LinesDocument document(*spec);
  for (const model::Node& node : scene->nodes())
    if (!node.isGroup())
      document.add(node.mesh, model::planesOf(scene->sectionsOf(node.id)));
  const Status written = model::writeText(flags.output, document.text());
  return written.ok() ? Exit::done : complain(written.error(), Exit::failed);
}

void declareLines(CLI::App& command, LinesFlags& flags) {
  command.add_option("MESH", flags.input.inputs, inputHelp)->required()->expected(1);
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  command.add_option("--camera", flags.camera, "A camera as in `sline render --camera`")
      ->required()
      ->type_name("FILE.json");
  command
      .add_option("--size", flags.size,
                  "The picture's width and height in pixels: hatching far outside of it is "
                  "left out, other lines are not")
      ->required()
      ->type_name("WxH");
  command.add_option("-o,--output", flags.output, "Where to write the JSON")
      ->required()
      ->type_name("FILE.json");
  command.add_option("--kinds", flags.kinds, "Which lines")
      ->delimiter(',')
      ->check(CLI::IsMember(lineKindNames()))
      ->type_name(CLI::detail::join(lineKindNames(), ","))
      ->default_str("contour,suggestive");
  command
      .add_option("--gamma", flags.gamma,
                  "Sets the thresholds of suggestive contours, above 1, and how much hatching has "
                  "entered, above 2")
      ->type_name("G")
      ->default_str("2; with hatching 3");
  addSectionOptions(command, flags.sections);
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("off");
  addFrame(command, flags.input);
  addTogether(command, flags.input);
  addThreshold(command, flags.input);
  command.footer(
      "Writes {\"kinds\":{\"contour\":{\"segments\":[{\"a\":[x,y,z],\"b\":[x,y,z],\"opacity\":1,\n"
      "\"visible\":true}, …],\"thresholds\":{…}}, …}}. `visible` tells whether the middle of the\n"
      "segment can be seen past its own structure. Thresholds: t_d and theta_c (radians) with\n"
      "which suggestive contours were kept, and F, the radius of the bounding sphere, that makes\n"
      "them dimensionless (a list where the file holds several structures). Lines end at the\n"
      "planes of --section; kind `section` is the line of the cut. With `--frame file`\n"
      "the camera is in the file's coordinates too.\n\n"
      "Kind `hatching` is {\"strokes\":[{\"seed\":{\"axis\":1,\"level\":4,\"i\":3,\"j\":-2},\n"
      "\"points\":[[x,y,z], …],\"half_widths_mm\":[…],\"half_widths\":[…],\"visible\":[…]}, …],\n"
      "\"thresholds\":{…}}: curves over the surface, with an entry per point in each list. A seed\n"
      "names a point of the structure's own lattice, so that a stroke can be found again from\n"
      "another camera; parts of one that is interrupted share its name. Half widths lie\n"
      "across the view, in mm at the point's depth and in output units of 1/720 of the picture's\n"
      "height; `visible` is told for each point. t_h is the share of hatching that has entered.");
}

}  // namespace

void addLines(CLI::App& program, Exit& exit) {
  addCommand<LinesFlags>(program, exit, {"lines", "Write the lines and hatching of a mesh as JSON"},
                         declareLines, runLines);
}

}  // namespace sline::cli
