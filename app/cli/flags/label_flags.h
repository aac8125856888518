// SPDX-License-Identifier: Apache-2.0
// Declares the flags that write labels and marks into pictures.
#pragma once

#include <memory>
#include <string>

#include "app/cli/flags/typed_options.h"
#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/plate/plate_image.h"

namespace sline::cli {

/// Holds the flags as typed.
struct LabelFlags {
  TypedOptions options;  ///< --labels, --language, --label-size, --legend
  std::string marks = "off";
  render::LabelMode mode = render::LabelMode::off;  ///< where --labels is not typed
};

/// Holds the flags as understood; the typesetting is made before anything is drawn.
struct LabelSpec {
  render::LabelStyle style{.mode = render::LabelMode::off, .language = {}};
  render::ExportMarks marks = render::ExportMarks::none();
  render::LegendList legend = render::LegendList::onSheets;
  render::SourceCredits sources = render::SourceCredits::off;  ///< of whose room the sides know
  std::string viewName;                                        ///< of the camera; may be empty
  model::ViewWords words;                                      ///< of the saved view
  std::shared_ptr<const render::Typesetting> typesetting;
  model::FreeSides sides;  ///< of the picture, for views that are fitted

  /// Gives the order what was said of labels, marks and legend.
  void writeTo(render::ExportOrder& order) const;
};

/// Declares the flags on a sub-command.
void declareLabels(CLI::App& command, LabelFlags& flags);
/// Reads the flags. An error counts as wrong use.
Result<LabelSpec> parseFlags(const LabelFlags& flags);
/// Warns where labels were asked for and the scene has none.
void warnOfNoLabels(const LabelFlags& flags, const model::Scene& scene);
/// Makes the order ready for the scene, given as it is drawn, on a page of that size.
Status prepareLabels(LabelSpec& spec, const model::Scene& scene, const glm::vec2& pageMm);
/// Prints the number and text of each label in the picture, one per line.
void printKey(const render::LabelReport& report);
/// Draws labels and marks, prints the key of numbers and warns of labels that find no room.
void drawLabels(render::Image& image, const model::Scene& scene, const model::Camera& camera,
                const LabelSpec& spec, render::Background background);

}  // namespace sline::cli
