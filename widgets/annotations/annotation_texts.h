// SPDX-License-Identifier: Apache-2.0
// Puts annotations, and what they are called, into plain text for the user.
#pragma once

#include <QString>

#include "widgets/session/session.h"

namespace sline::widgets {

QString kindText(model::AnnotationKind kind);
/// Returns the annotation in one line; one without words goes by its kind, a distance by its
/// length.
QString shownText(const model::Scene& scene, const model::Annotation& annotation,
                  const std::string& language);
/// Returns what the annotation points at as the user reads it: a structure's name, both names for a
/// distance, or "a place".
QString placeText(Session& session, const model::Annotation& annotation);

/// Returns the structure's name in that language; with an empty language, its name in the list.
QString offeredText(Session& session, model::NodeId structure, const std::string& language);
/// Returns the annotation's words in that language, or in the scene's own where it has none there,
/// as they are written: with a callout's markers.
QString wordsIn(const model::Annotation& annotation, const std::string& language);
/// Returns the words that `wordsIn` returns, in one line and without markers.
QString plainWordsIn(const model::Annotation& annotation, const std::string& language);
/// Returns the annotation with these words in the language. An annotation without words in the
/// scene's own language gets them there too; empty words in another language bring back the scene's
/// own.
model::Annotation withText(model::Annotation annotation, const std::string& language,
                           const QString& text);
/// Returns a new annotation of that structure with its first words. Where the text was left as
/// offered, the annotation gets the structure's name in every language that the table of names
/// knows.
model::Annotation withFirstText(Session& session, model::Annotation annotation,
                                const std::string& language, const QString& text);
/// Returns the structure that the annotation is on; the first one for a distance.
std::optional<model::NodeId> structureOf(const model::Annotation& annotation);

}  // namespace sline::widgets
