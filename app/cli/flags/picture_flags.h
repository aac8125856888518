// SPDX-License-Identifier: Apache-2.0
// Declares the flags that say how a scene is drawn, shared by `render` and `demo`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/files/progress.h"
#include "app/cli/flags/focus_flags.h"
#include "app/cli/flags/gamma_flags.h"
#include "app/cli/flags/label_flags.h"
#include "app/cli/flags/section_flags.h"
#include "app/cli/flags/values.h"
#include "model/base/result.h"
#include "model/look/drawing_styles.h"
#include "model/look/opening_look.h"
#include "model/scene/scene.h"
#include "render/drawn/picture_settings.h"

namespace sline::cli {

/// Holds the flags as typed.
struct PictureFlags {
  std::string output;
  std::string size = "1280x720";
  std::string samples = "auto";
  std::string view;            ///< empty: the look's choice, else anterior
  std::string look = "plain";  ///< auto where `addLookOption` declares it
  std::string cameraFile;
  std::string fill;
  std::string background;  ///< empty: the drawing style's, else white
  std::string drawing;     ///< empty: none
  std::string hatching = "strokes";
  std::string light;
  std::optional<bool> keyLight;
  bool blackAndWhite = false;
  std::vector<std::string> gammas;
  std::vector<std::string> gammaMaps;
  std::vector<std::string> colours;
  std::vector<std::string> inkColours;
  /// Holds what was typed after each of the flags of style_flags.h that were given.
  std::map<std::string, std::vector<std::string>> styles;
  std::vector<std::string> lineThresholds;
  std::vector<std::string> only;
  SectionFlags sections;
  FocusFlags focus;
  LabelFlags labels;
};

/// Holds a value for all structures (no name) or for those of that name.
template <class T>
struct Assignment {
  std::optional<std::string> name;
  T value;
};

/// Holds the flags as understood, but not yet checked against a scene.
struct PictureSpec {
  std::string output;
  Size size;
  int samples = 1;  ///< across a pixel
  render::Environment environment;
  render::HatchingMethod hatching = render::HatchingMethod::strokes;
  bool blackAndWhite = false;
  std::optional<model::Camera> camera;           ///< from a file; else `view`
  std::string view;                              ///< empty: not given
  const model::DrawingStyle* drawing = nullptr;  ///< given to the scene before single styles are
  bool choosesLook = false;                  ///< gives one to a scene that has no look of its own
  std::optional<model::OpeningLook> fitted;  ///< the look that views are fitted to
  std::optional<model::Fill> fill;
  std::vector<Assignment<Gamma>> gammas;
  std::vector<Assignment<GammaMapWish>> gammaMaps;
  std::vector<Assignment<Colour>> colours;
  std::vector<Assignment<Colour>> inkColours;
  std::vector<Assignment<model::Style>> styles;  ///< each sets one field
  model::ThresholdValues lineThresholds;         ///< of all structures
  std::vector<std::string> only;
  SectionsSpec sections;
  FocusSpec focus;
  LabelSpec labels;
};

/// Reads the flags. An error counts as wrong use, here and below.
Result<PictureSpec> parseFlags(const PictureFlags& flags);
/// Reads the flags in the same way when no picture is to be written.
Result<PictureSpec> parseFlagsWithoutOutput(const PictureFlags& flags);
/// Returns the scene as shown by the saved view that the order names; unchanged if there is none.
/// Warns of what is absent.
model::Scene withSavedView(const model::Scene& scene, const PictureSpec& spec);
/// Returns the name of the picture's camera: that of the saved view, "anterior" and so on where it
/// looks along an axis of the body, else nothing.
std::string shownViewName(const model::Scene& scene, const PictureSpec& spec);
/// Returns what the saved view says that the order names; nothing where there is none.
model::ViewWords shownViewWords(const model::Scene& scene, const PictureSpec& spec);
/// Returns the scene with styles and visibility as ordered. A group's value holds for all in it; a
/// value for a structure or an inner group wins over one for a group around it, whatever the order
/// of the flags.
Result<model::Scene> styled(const model::Scene& scene, const PictureSpec& spec);
/// Takes the camera of a file, if there is one.
Status takeCamera(const std::string& file, PictureSpec& spec);
/// Returns the scene with the focus of the order, if it has one; sections of the order count.
Result<model::Scene> inFocus(const model::Scene& scene, const PictureSpec& spec);
/// Returns the scene with the sections of the order, if it has any.
Result<model::Scene> cutOpen(const model::Scene& scene, const PictureSpec& spec);
/// Returns the scene with the opening look (model/look) where the spec wants one, and the scene,
/// the focus and Γ or fill for all structures say nothing of how it looks; a drawing style always
/// wants one for a scene without a look. Then `spec` looks from where that look does, unless it
/// says another view. Labels have room at the spec's free sides.
Result<model::Scene> withOpeningLook(const model::Scene& scene, PictureSpec& spec);
/// Returns the saved view of that name, or null if there is none.
const model::View* savedView(const model::Scene& scene, const std::string& name);
/// Returns the camera of the file; else that of the saved view of that name, else the anatomical
/// view fitted to what sections leave of the visible structures, beside the room that labels need.
Result<model::Camera> cameraFor(const model::Scene& scene, const PictureSpec& spec);

/// Draws without a display and writes the file.
Status drawToFile(const model::Scene& scene, const model::Camera& camera, const PictureSpec& spec,
                  Progress& progress);

}  // namespace sline::cli
