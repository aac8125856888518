// SPDX-License-Identifier: Apache-2.0
// Declares the options of self-tests, on paper, slides and cards, and makes their questions.
#pragma once

#include <string>
#include <vector>

#include "model/scene/question.h"
#include "render/export/order/export_option.h"

namespace sline::render {

/// Tells what a test asks for.
enum class AskedOf { labelled, focus };
/// Tells where keys of tests stand: each on the page after its test, or all at the end.
enum class KeyPlace { next, end };

struct TestOptions {
  AskedOf of = AskedOf::labelled;
  std::string names;      ///< of structures and groups, with commas; empty: all
  bool callouts = false;  ///< callouts, which are sentences, are questions, too
  bool wordBank = false;  ///< the test has the answers, in another order
  KeyPlace key = KeyPlace::next;
};

extern const ExportOption askedOption;
extern const ExportOption askedNamesOption;
extern const ExportOption askCalloutsOption;

/// Returns the names that the order's test is about, one by one.
std::vector<std::string> askedNames(const ExportOrder& order);
/// Returns the questions of the order's test, as they are asked of the scene that it shows.
std::vector<model::Question> questionsOf(const ExportOrder& order);
/// Returns the order with the labels of those questions alone.
ExportOrder askedAlone(const ExportOrder& order, const std::vector<model::Question>& questions);

/// Returns the answers in an order by chance, which is the same each time, for people to choose
/// from. It is not the order in which they were given, unless all are the same.
std::vector<std::string> shuffledWords(const std::vector<std::string>& answers);

}  // namespace sline::render
