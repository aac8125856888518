// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/plan_texts.h"

#include <QLocale>
#include <algorithm>
#include <map>

#include "model/import/naming/laterality.h"
#include "model/scene/told_length.h"
#include "widgets/import_dialog/choice_rows.h"
#include "widgets/import_dialog/import_draft.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

QString number(std::size_t value) {
  return QLocale().toString(qulonglong(value));
}

/// Returns "LPS (vote: 20 of 22 left/right names)", or how many different answers there are. The
/// fields of the provenance are what was decided and why; each different pair is told once, however
/// many structures have it.
template <class Decided, class Decide>
QString decisions(const model::ImportPlan& plan, Decided model::Provenance::*field,
                  std::string model::Provenance::*reason, const Decide& decide) {
  std::map<std::pair<Decided, std::string>, std::size_t> counts;
  for (const model::Node& node : plan.scene.nodes())
    if (plan.parts.contains(node.id))
      ++counts[{node.provenance.*field, node.provenance.*reason}];
  std::map<QString, std::size_t> answers;
  for (const auto& [decided, count] : counts)
    answers[decide(decided.first, decided.second)] += count;
  if (answers.empty())
    return ImportDraft::tr("as the scene file has it");
  if (answers.size() == 1)
    return answers.begin()->first;
  QStringList lines;
  for (const auto& [answer, count] : answers)
    lines << ImportDraft::tr("%1: %2").arg(number(count), answer);
  constexpr qsizetype shown = 2;
  const auto more = int(lines.size() - shown);
  QString text = QStringList(lines.mid(0, shown)).join(QStringLiteral("; "));
  if (more > 0)
    text += ImportDraft::tr("; and %n more", nullptr, more);
  return text;
}

QString because(const QString& answer, const std::string& reason) {
  return reason.empty() ? answer : ImportDraft::tr("%1 – %2").arg(answer, told(reason));
}

QString frameDecision(const std::string& frame, const std::string& reason) {
  return because(frame == model::Provenance().frame ? ImportDraft::tr("unknown")
                 : frame == "file"                  ? ImportDraft::tr("as in the file")
                                                    : QString::fromStdString(frame),
                 reason);
}

QString unitDecision(float millimetres, const std::string& reason) {
  return because(unitText(millimetres), reason);
}

/// Returns the names of a few of them.
QString someNames(const model::Scene& scene, const std::vector<model::NodeId>& ids) {
  constexpr std::size_t shown = 4;
  QStringList names;
  for (std::size_t i = 0; i < std::min(ids.size(), shown); ++i)
    names << ImportDraft::tr("“%1”").arg(QString::fromStdString(scene.find(ids[i])->name));
  if (ids.size() > shown)
    names << QStringLiteral("…");
  return names.join(QStringLiteral(", "));
}

}  // namespace

QString millimetresText(float millimetres) {
  return QLocale().toString(double(millimetres), 'f', model::toldDecimals(double(millimetres)));
}

QString boxText(const model::Box& box) {
  if (box.empty())
    return {};
  const glm::vec3 size = box.size();
  const model::ToldUnit unit = model::toldUnit(double(std::max({size.x, size.y, size.z})));
  const auto part = [&](int axis) { return millimetresText(size[axis] / float(unit.millimetres)); };
  return ImportDraft::tr("%1 × %2 × %3 %4")
      .arg(part(0), part(1), part(2), QString::fromStdString(unit.mark()));
}

QString summaryText(const model::ImportPlan& plan, const PlanFigures& figures) {
  int groups = 0;
  int structures = 0;
  std::size_t triangles = 0;
  int skipped = 0;
  for (const model::Node& node : plan.scene.nodes())
    if (node.isGroup()) {
      ++groups;
    } else if (plan.choiceOf(node.id).include) {
      ++structures;
      triangles += figures.nodes.at(node.id.value).triangles;
    } else {
      ++skipped;
    }
  QStringList parts{ImportDraft::tr("%n structures", nullptr, structures)};
  if (groups > 0)
    parts << ImportDraft::tr("%n groups", nullptr, groups);
  parts << ImportDraft::tr("%1 triangles").arg(number(triangles));
  if (skipped > 0)
    parts << ImportDraft::tr("%n skipped", nullptr, skipped);
  if (!figures.all.box.empty())
    parts << boxText(figures.all.box);
  return parts.join(QStringLiteral("  ·  "));
}

QString sizeDoubt(const model::ImportPlan& plan, const PlanFigures& figures) {
  constexpr float smallest = 20.0f;
  constexpr float largest = 3000.0f;
  constexpr float likelyLow = 50.0f;
  constexpr float likelyHigh = 2300.0f;
  const float size = extent(figures.all.box);
  // Names tell sizes better than the whole does.
  if (!plan.report.unitDoubts.empty())
    return {};
  if (figures.molecules || plan.parts.empty() || size <= 0.0f ||
      (size >= smallest && size <= largest))
    return {};
  const model::Provenance& first = plan.scene.find(plan.parts.begin()->first)->provenance;
  const float now = first.mmPerUnit;
  const QString whole =
      ImportDraft::tr("Everything together is %1 mm large").arg(millimetresText(size));
  for (const ChoiceOf<float>& row : unitRows()) {
    if (model::isUnitStated(first.unitReason))
      break;
    const float then = size / now * row.value;
    if (row.value != now && then >= likelyLow && then <= likelyHigh)
      return ImportDraft::tr("%1. If the files are in %2, it is %3 mm.")
          .arg(whole, row.text.section(QLatin1Char(' '), -1), millimetresText(then));
  }
  return size < smallest ? ImportDraft::tr("%1, which is small for anatomy.").arg(whole)
                         : ImportDraft::tr("%1, which is large for anatomy.").arg(whole);
}

QString sideDoubt(const model::ImportPlan& plan, const PlanFigures& figures) {
  if (figures.otherSide.empty())
    return {};
  const QString names = someNames(plan.scene, figures.otherSide);
  const int others = int(figures.otherSide.size());
  if (figures.sidesAgree > 0)
    return ImportDraft::tr("%n structures lie on the other side than their names say: %1.", nullptr,
                           others)
        .arg(names);
  const QString swapped =
      ImportDraft::tr(
          "Left and right look swapped: all %n structures with a side in their names lie on the "
          "other side (%1).",
          nullptr, others)
          .arg(names);
  if (!figures.sidesRight)
    return swapped;
  const QString frame = QString::fromStdString(model::frameName(*figures.sidesRight));
  return swapped + QLatin1Char(' ') +
         (figures.mirrors
              ? ImportDraft::tr("Front and back are right: if the files are mirrored, choose %1.")
              : ImportDraft::tr("Choose %1."))
             .arg(frame);
}

QString frameText(const model::ImportPlan& plan) {
  return decisions(plan, &model::Provenance::frame, &model::Provenance::frameReason, frameDecision);
}

QString unitReasonText(const model::ImportPlan& plan) {
  return decisions(plan, &model::Provenance::mmPerUnit, &model::Provenance::unitReason,
                   unitDecision);
}

QString detailsText(const model::ImportPlan& plan, const PlanFigures& figures, model::NodeId id) {
  const model::Node* node = plan.scene.find(id);
  if (!node)
    return {};
  const StructureFigures& of = figures.nodes.at(id.value);
  QStringList lines;
  const QString name = QString::fromStdString(node->name);
  if (node->isGroup())
    return ImportDraft::tr("%1: %2, %3 triangles, %4")
        .arg(name, ImportDraft::tr("%n structures", nullptr, int(of.structures)),
             number(of.triangles), boxText(of.box));
  const model::Provenance& from = node->provenance;
  const QString file = QString::fromStdString(from.file);
  lines << (file.isEmpty() ? name : ImportDraft::tr("%1, from %2").arg(name, file)) +
               QStringLiteral("  ·  ") + boxText(of.box) + QStringLiteral("  ·  ") +
               ImportDraft::tr("%1 triangles").arg(number(of.triangles));
  if (!plan.parts.contains(id))
    return (lines << ImportDraft::tr("From a scene file: it keeps its place, size and triangles."))
        .join('\n');
  lines << ImportDraft::tr("Frame: %1").arg(frameDecision(from.frame, from.frameReason))
        << ImportDraft::tr("Unit: %1").arg(unitDecision(from.mmPerUnit, from.unitReason));
  if (from.repairedFaces > 0)
    lines << ImportDraft::tr("%n faces mended", nullptr, from.repairedFaces);
  if (of.otherSide)
    lines << ImportDraft::tr("Its name says the other side than it lies on.");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace sline::widgets
