// SPDX-License-Identifier: Apache-2.0
#include "render/export/description/picture_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "model/scene/markup.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/legend.h"
#include "render/export/plate/marks.h"
#include "render/labels/seen/seen_map.h"

namespace sline::render {

namespace {

/// The least cells of a structure that one can see at all: what a dot of a pen covers.
constexpr float leastCells = 6.0f;
/// The least share of a structure that is hidden by another where that is told.
constexpr float leastCover = 0.12f;
/// Names of files may be of any length.
constexpr qsizetype longestName = 60;

QString shortLine(const std::string& text, qsizetype longest = longestName) {
  QString line;
  for (const QChar letter : QString::fromStdString(text))
    line += letter.isPrint() || letter.isSurrogate() ? letter : QChar(u' ');
  line = line.simplified();
  return line.size() <= longest ? line : line.left(longest - 1).trimmed() + QChar(0x2026);
}

/// Returns the side of the body that a direction (LPS) points to, with how much it does.
struct Towards {
  model::AnatomicalView side;
  float share;
};
std::vector<Towards> towards(const glm::vec3& direction) {
  using enum model::AnatomicalView;
  std::vector<Towards> all{{direction.x > 0.0f ? left : right, std::abs(direction.x)},
                           {direction.y > 0.0f ? posterior : anterior, std::abs(direction.y)},
                           {direction.z > 0.0f ? superior : inferior, std::abs(direction.z)}};
  std::stable_sort(all.begin(), all.end(),
                   [](const Towards& a, const Towards& b) { return a.share > b.share; });
  return all;
}

void findSides(PictureFacts& facts, const model::Camera& camera) {
  constexpr float told = 0.35f;    // a view from there to a third
  constexpr float clearly = 0.8f;  // an edge that is of that side
  const model::CameraFrame frame = model::cameraFrame(camera);
  for (const Towards& one : towards(frame.back))
    if (one.share >= told)
      facts.from.push_back(one.side);
  if (const Towards left = towards(-frame.right).front(); left.share >= clearly)
    facts.left = left.side;
  if (const Towards top = towards(frame.up).front();
      top.share >= clearly && top.side != model::AnatomicalView::superior)
    facts.top = top.side;
}

/// Tells whether a side is told of which nobody is sure.
bool saysWhatIsInDoubt(const PictureFacts& facts, const model::KnownSides& sides) {
  std::vector<model::AnatomicalView> told = facts.from;
  for (const auto& edge : {facts.left, facts.top})
    if (edge)
      told.push_back(*edge);
  return std::any_of(told.begin(), told.end(), [&sides](model::AnatomicalView side) {
    return sides.inDoubt(model::axisOf(side));
  });
}

/// Returns what labels that the picture shows call the structures they point at.
std::map<model::NodeId, QString> labelNames(const ExportOrder& order) {
  std::map<model::NodeId, QString> names;
  for (const model::Annotation& annotation : order.scene.annotations()) {
    const auto* point = annotation.anchors.empty()
                            ? nullptr
                            : std::get_if<model::SurfacePoint>(&annotation.anchors.front());
    if (!annotation.visible || annotation.kind == model::AnnotationKind::distance || !point)
      continue;
    // What a callout says is a sentence: its structure has a name.
    const QString text =
        annotation.kind == model::AnnotationKind::callout
            ? QString()
            : shortLine(model::writtenIn(order.scene, annotation,
                                         model::firstLanguage(order.labels.language)));
    QString& name = names[point->structure];
    if (!text.isEmpty() && !name.split(QStringLiteral(", ")).contains(text))
      name += (name.isEmpty() ? QString() : QStringLiteral(", ")) + text;
  }
  return names;
}

/// Returns what distances that the picture shows say.
QStringList distancesIn(const ExportOrder& order, const Screen& screen, model::MeshTrees& trees) {
  const std::string language = model::firstLanguage(order.labels.language);
  std::vector<model::Annotation> annotations = order.scene.annotations();
  std::erase_if(annotations, [](const model::Annotation& annotation) {
    return !annotation.visible || annotation.kind != model::AnnotationKind::distance;
  });
  QStringList distances;
  if (annotations.empty())
    return distances;
  model::Scene scene = order.scene;
  scene.setAnnotations(std::move(annotations));
  for (const ShownLabel& label : shownLabels(scene, screen, language, trees))
    if (label.length)
      distances << shortLine(keyLine(scene, label, {.language = language}), 3 * longestName);
  return distances;
}

void findBefore(PictureFacts& facts, const std::vector<SeenCover>& covers) {
  const auto seen = [&facts](model::NodeId id) {
    return std::any_of(facts.structures.begin(), facts.structures.end(),
                       [id](const SeenStructure& one) { return one.id == id; });
  };
  std::map<std::pair<model::NodeId, model::NodeId>, float> shares;
  for (const SeenCover& cover : covers)
    shares[{cover.before, cover.behind}] = cover.share;
  for (const SeenCover& cover : covers) {
    const auto back = shares.find({cover.behind, cover.before});
    const bool clear = back == shares.end() || back->second < 0.1f * cover.share;
    if (cover.share < leastCover || !clear || !seen(cover.before) || !seen(cover.behind))
      continue;
    auto known =
        std::find_if(facts.before.begin(), facts.before.end(),
                     [&cover](const SeenBefore& one) { return one.before == cover.before; });
    if (known == facts.before.end())
      known = facts.before.insert(known, {cover.before, {}});
    known->behind.push_back(cover.behind);
  }
}

}  // namespace

PictureFacts pictureFacts(const ExportOrder& order) {
  PictureFacts facts;
  model::MeshTrees trees;
  const Screen screen = screenSeen(order, trees);
  const SeenMap map(order.scene, screen, &trees);
  const std::map<model::NodeId, QString> labels = labelNames(order);
  const std::string language = model::firstLanguage(order.labels.language);
  for (const SeenShare& share : map.shares()) {
    if (share.cells < leastCells)
      continue;
    const auto label = labels.find(share.structure);
    SeenStructure one{.id = share.structure,
                      .name = label == labels.end() ? QString() : label->second,
                      .labelled = label != labels.end(),
                      .across = share.middle.x / screen.size().x};
    if (one.name.isEmpty())
      one.name = shortLine(structureName(*order.scene.find(share.structure), language));
    facts.structures.push_back(std::move(one));
  }
  findBefore(facts, map.covers());
  facts.distances = distancesIn(order, screen, trees);
  if (const model::KnownSides sides = knownSides(order.scene); sides.any) {
    findSides(facts, order.camera);
    facts.sidesInDoubt = saysWhatIsInDoubt(facts, sides);
  }
  return facts;
}

}  // namespace sline::render
