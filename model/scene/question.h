// SPDX-License-Identifier: Apache-2.0
// Says what a question about a picture is: what labels name, and which answers are right. Quizzes,
// self-tests on paper and on slides, and cards all ask these.
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Asks what something is, or where. To point at any of the structures is right, and so are the
/// words at any of the labels.
struct Question {
  std::string words;               ///< plain text
  std::vector<NodeId> structures;  ///< none: the label stands in space
  std::vector<AnnotationId> labels;
  bool operator==(const Question&) const = default;
};

/// Chooses among what could be asked for.
struct QuestionChoice {
  bool focusAlone = false;  ///< only what is in focus
  /// Of structures and groups, as `Scene::named` finds them: only those are asked for. None: all.
  std::vector<std::string> names;
  bool callouts = false;  ///< callouts, which are sentences, are asked for, too
  bool inSpace = false;   ///< so are labels on no structure, where all are asked for
};

/// Returns the text without a number at its end where a structure is called so without it: import
/// counts so what several files call the same ("portal vein", "portal vein 2").
std::string sharedName(const Scene& scene, const std::string& text);

/// Returns a question for each thing that visible labels and pins name on visible structures, in
/// the order of the annotations and in that language, or those ("de+la"). Things of one name are
/// one question (`sharedName`). What has a name that is in doubt is not asked for. Callouts
/// explain, so they are not asked for unless they are chosen; distances never are.
std::vector<Question> questionsOf(const Scene& scene, const std::string& language,
                                  const QuestionChoice& choice = {});

/// Returns the scene with the labels of the questions as its only visible annotations.
Scene withQuestionsAlone(const Scene& scene, const std::vector<Question>& questions);

}  // namespace sline::model
