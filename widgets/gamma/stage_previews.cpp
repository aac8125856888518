// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/stage_previews.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "model/scene/resolved_styles.h"
#include "model/scene/style_fields.h"
#include "render/lines/hatching/hatching.h"
#include "widgets/gamma/stage_strip.h"

namespace sline::widgets {

namespace {

/// Milliseconds after the last change, because small pictures can wait while something moves.
constexpr int previewsRestAfter = 300;
// These limit the structures that are shown together.
constexpr std::size_t mostTriangles = 250'000;
constexpr std::size_t mostStructures = 24;
// Small pictures are drawn twice as large and averaged, because they consist of little but edges.
constexpr int samples = 2;
constexpr int mostStages = 16;
// These are readable sizes in pixels of the window; a picture's own units would make lines too
// thin.
constexpr double penWidth = 1.1;
constexpr double strokeSpacing = 3.0;

/// Returns the pixels that make one λ in a picture of that height.
double outputUnit(int height) {
  return double(height) / 720.0;
}

std::vector<glm::vec3> somePoints(const model::Scene& subject) {
  constexpr std::size_t enough = 4000;
  std::vector<glm::vec3> points;
  for (const model::Node& node : subject.nodes()) {
    const auto positions = node.mesh->positions();
    const std::size_t stride = std::max<std::size_t>(1, positions.size() / enough);
    for (std::size_t i = 0; i < positions.size(); i += stride)
      points.push_back(positions[i]);
  }
  return points;
}

}  // namespace

model::Scene previewSubject(const model::Scene& scene, const NodeIds& ids) {
  std::vector<model::ResolvedStructure> structures = model::resolvedBelow(scene, ids);
  std::erase_if(structures, [](const model::ResolvedStructure& structure) {
    return structure.node->mesh->triangleCount() == 0;
  });
  std::size_t triangles = 0;
  for (const model::ResolvedStructure& structure : structures)
    triangles += structure.node->mesh->triangleCount();
  const auto size = [](const model::ResolvedStructure& structure) {
    return glm::length(structure.node->mesh->bounds().size());
  };
  if (structures.size() > mostStructures || (structures.size() > 1 && triangles > mostTriangles))
    structures = {
        *std::max_element(structures.begin(), structures.end(),
                          [&size](const auto& a, const auto& b) { return size(a) < size(b); })};
  model::Scene subject;
  for (const auto& [node, style] : structures) {
    model::Style look = model::answersOf(style);
    look.gamma.reset();
    look.visible = true;
    subject.append(
        {.style = look, .mesh = node->mesh, .paint = node->paint, .provenance = node->provenance});
  }
  return subject;
}

SmallLines smallLines(int height, double ratio, double pen) {
  constexpr double standardPen = 2.0;  // λ
  const double unit = outputUnit(height);
  const double closer = double(render::hatchSpacing) * unit / (strokeSpacing * ratio);
  return {.pen = float(pen * ratio / (standardPen * unit)), .hatchDensity = float(closer * closer)};
}

model::Scene withSmallLines(const model::Scene& scene, const SmallLines& lines) {
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  std::vector<model::Node> nodes = scene.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].isGroup())
      continue;
    nodes[i].style.penWeight = lines.pen * styles[i].penWeight;
    nodes[i].style.hatchDensity =
        HatchDensity::clamped(lines.hatchDensity * styles[i].hatchDensity.value());
  }
  model::Scene coarser = scene;
  coarser.setNodes(std::move(nodes));
  return coarser;
}

model::Scene previewScene(const model::Scene& subject, Gamma gamma, int height, double ratio) {
  const SmallLines lines = smallLines(height, ratio * double(samples), penWidth);
  model::Scene result = subject;
  std::vector<model::Node> nodes = subject.nodes();
  for (model::Node& node : nodes) {
    node.style.gamma = gamma;
    node.style.penWeight = lines.pen * node.style.penWeight.value_or(1.0f);
    const float density = node.style.hatchDensity ? node.style.hatchDensity->value() : 1.0f;
    node.style.hatchDensity = HatchDensity::clamped(density * lines.hatchDensity);
  }
  result.setNodes(std::move(nodes));
  return result;
}

model::Camera previewCamera(const model::Scene& subject, const model::Camera& camera,
                            float aspect) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  const model::Box bounds = subject.visibleBounds();
  model::Camera fitting = camera;
  fitting.target = bounds.centre();
  fitting.eye = fitting.target + 4.0f * std::max(glm::length(bounds.size()), 1e-3f) * frame.back;
  fitting.up = frame.up;
  return model::fitted(fitting, somePoints(subject), aspect);
}

bool StagePreviews::Key::operator==(const Key& other) const {
  return subject == other.subject && frame.right == other.frame.right &&
         frame.up == other.frame.up && projection == other.projection &&
         environment == other.environment && size == other.size;
}

StagePreviews::StagePreviews(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport) {
  m_rest.setSingleShot(true);
  m_rest.setInterval(previewsRestAfter);
  connect(&m_rest, &QTimer::timeout, this, &StagePreviews::ask);
  connect(&session, &Session::selectionChanged, this, &StagePreviews::restart);
  connect(&session, &Session::documentChanged, this, &StagePreviews::restart);
  connect(&viewport, &Viewport::cameraChanged, this, &StagePreviews::restart);
  connect(&viewport, &Viewport::backgroundChanged, this, &StagePreviews::restart);
  connect(&viewport, &Viewport::previewed, this, &StagePreviews::took);
}

void StagePreviews::want(std::vector<Gamma> stages, QSize size, double ratio) {
  m_stages = std::move(stages);
  m_size = size;
  m_ratio = ratio;
  restart();
}

StagePreviews::Key StagePreviews::keyNow() const {
  return {.subject = previewSubject(m_session.scene(), m_session.selection()),
          .frame = model::cameraFrame(m_viewport.camera()),
          .projection = m_viewport.camera().projection,
          .environment = m_viewport.environment(),
          .size = m_size};
}

void StagePreviews::restart() {
  if (m_session.selection() != m_ids) {
    m_ids = m_session.selection();
    m_asked = {};
    m_viewport.askPreviews({});
    ++m_round;
    emit cleared();
  }
  m_rest.start();
}

void StagePreviews::took(PreviewsOf asker, int id, const QImage& image) {
  if (asker == PreviewsOf::stages && id / mostStages == m_round)
    emit made(id % mostStages, image);
}

void StagePreviews::ask() {
  Key key = keyNow();
  if (key == m_asked || m_size.isEmpty() || key.subject.nodes().empty())
    return;
  const int width = samples * m_size.width();
  const int height = samples * m_size.height();
  PreviewRequest request;
  ++m_round;
  const model::Camera camera =
      previewCamera(key.subject, m_viewport.camera(), float(width) / float(height));
  for (std::size_t i = 0; i < m_stages.size(); ++i)
    request.previews.push_back(
        {.id = m_round * mostStages + int(i),
         .scene = previewScene(key.subject, m_stages[i], height, m_ratio),
         .camera = camera,
         .settings = {.width = width, .height = height, .environment = key.environment},
         .samples = samples});
  m_asked = std::move(key);
  m_viewport.askPreviews(std::move(request));
}

void drawStages(Session& session, Viewport& viewport, StageStrip& stages) {
  auto* previews = new StagePreviews(session, viewport, &stages);
  QObject::connect(&stages, &StageStrip::picturesWanted, previews,
                   [previews, &stages](QSize size, double ratio) {
                     previews->want(stages.stages(), size, ratio);
                   });
  QObject::connect(previews, &StagePreviews::made, &stages, &StageStrip::showPicture);
  QObject::connect(previews, &StagePreviews::cleared, &stages, &StageStrip::clearPictures);
}

}  // namespace sline::widgets

#include "moc_stage_previews.cpp"
