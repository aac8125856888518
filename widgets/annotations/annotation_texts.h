// SPDX-License-Identifier: Apache-2.0
// What annotations say and what they are called, for people; plain text all of it.
#pragma once

#include <QString>

#include "widgets/session/session.h"

namespace sline::widgets {

QString kindText(model::AnnotationKind kind);
/// In one line; an annotation without words goes by its kind, a distance by its length.
QString shownText(const model::Scene& scene, const model::Annotation& annotation,
                  const std::string& language);
/// What it points at, as people read it: a structure's name, of a distance both, or "a place".
QString placeText(Session& session, const model::Annotation& annotation);

/// What the structure is called in that language; empty: as people see it in the list.
QString offeredText(Session& session, model::NodeId structure, const std::string& language);
/// What it says in that language; where it has no words there, in the scene's own. As it is
/// written: a callout's markers included.
QString wordsIn(const model::Annotation& annotation, const std::string& language);
/// The same in one line, without markers.
QString plainWordsIn(const model::Annotation& annotation, const std::string& language);
/// With other words in the language. One without any words of the scene's own gets these, too; no
/// words in another language: the scene's own hold there again.
model::Annotation withText(model::Annotation annotation, const std::string& language,
                           const QString& text);
/// The words of a new one on that structure; what it is called there was left as offered: it is
/// called so in every language that the table of names knows.
model::Annotation withFirstText(Session& session, model::Annotation annotation,
                                const std::string& language, const QString& text);
/// What it is on; the first, of a distance.
std::optional<model::NodeId> structureOf(const model::Annotation& annotation);

}  // namespace sline::widgets
