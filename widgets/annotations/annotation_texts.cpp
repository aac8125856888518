// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/annotation_texts.h"

#include "model/lengths/shortest_distance.h"
#include "model/scene/markup.h"
#include "render/lettering/label_texts.h"
#include "widgets/session/names_by_language.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

std::optional<model::NodeId> structureAt(const model::Anchor& anchor) {
  const auto* point = std::get_if<model::SurfacePoint>(&anchor);
  return point ? std::optional(point->structure) : std::nullopt;
}

QString anchorText(Session& session, const model::Anchor& anchor) {
  const std::optional<model::NodeId> id = structureAt(anchor);
  if (!id)
    return tr("a place");
  const model::Node* node = session.scene().find(*id);
  return node ? session.names().shown(node->name) : tr("nothing that is there");
}

/// Returns the length as the picture writes it.
QString lengthText(const model::DrawnLength& length, model::DrawnUnit unit,
                   const std::string& language) {
  render::ShownLabel label;
  label.item.kind = model::AnnotationKind::distance;
  label.length = length;
  label.unit = unit;
  return QString::fromStdString(render::keyText(label, {.language = language})).simplified();
}

}  // namespace

QString kindText(model::AnnotationKind kind) {
  switch (kind) {
    case model::AnnotationKind::callout:
      return tr("Callout");
    case model::AnnotationKind::pin:
      return tr("Pin");
    case model::AnnotationKind::distance:
      return tr("Distance");
    default:
      return tr("Label");
  }
}

QString wordsIn(const model::Annotation& annotation, const std::string& language) {
  return QString::fromStdString(model::textIn(annotation, language));
}

QString plainWordsIn(const model::Annotation& annotation, const std::string& language) {
  return QString::fromStdString(model::plainTextIn(annotation, language)).simplified();
}

QString shownText(const model::Scene& scene, const model::Annotation& annotation,
                  const std::string& language) {
  const QString text = plainWordsIn(annotation, language);
  if (text.isEmpty() && annotation.kind == model::AnnotationKind::distance) {
    if (const std::optional<model::DrawnLength> length = drawnLength(scene, annotation))
      return lengthText(*length, drawnUnit(scene), language);
  }
  return text.isEmpty() ? kindText(annotation.kind) : text;
}

QString placeText(Session& session, const model::Annotation& annotation) {
  const QString first = anchorText(session, annotation.anchors.front());
  if (annotation.kind != model::AnnotationKind::distance)
    return first;
  const QString last = anchorText(session, annotation.anchors.back());
  return first == last ? first : tr("%1 – %2").arg(first, last);
}

std::optional<model::NodeId> structureOf(const model::Annotation& annotation) {
  return structureAt(annotation.anchors.front());
}

QString offeredText(Session& session, model::NodeId structure, const std::string& language) {
  const model::Node* node = session.scene().find(structure);
  return node ? session.names().calledIn(node->name, language) : QString();
}

model::Annotation withText(model::Annotation annotation, const std::string& language,
                           const QString& text) {
  const std::string words = text.toStdString();
  if (language.empty()) {
    annotation.text = words;
  } else if (words.empty()) {
    annotation.texts.erase(language);
  } else {
    annotation.texts[language] = words;
    if (annotation.text.empty())
      annotation.text = words;
  }
  return annotation;
}

model::Annotation withFirstText(Session& session, model::Annotation annotation,
                                const std::string& language, const QString& text) {
  const std::optional<model::NodeId> structure = structureOf(annotation);
  const model::Node* node = structure ? session.scene().find(*structure) : nullptr;
  if (!node || text != offeredText(session, *structure, language))
    return withText(std::move(annotation), language, text);
  annotation.text = node->name;
  for (const auto& [tag, name] : namesByLanguage(session.names(), node->name))
    annotation.texts[tag] = name;
  return annotation;
}

}  // namespace sline::widgets
