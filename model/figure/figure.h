// SPDX-License-Identifier: Apache-2.0
// A figure of several panels on one page, as journals print it: which views of which scenes it
// shows, how they are laid out, and what is written over them. Nothing here draws.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/units.h"

namespace sline::model {

/// The most panels of a figure: as many as there are letters.
inline constexpr std::size_t mostPanels = 26;
/// The most columns and the most rows of its grid.
inline constexpr std::size_t mostTracks = 12;

// Millimetres.
inline constexpr Limits<float> figureWidthLimits{20.0f, 1000.0f};
inline constexpr Limits<float> figureHeightLimits{20.0f, 1500.0f};
inline constexpr Limits<float> figureGapLimits{0.0f, 50.0f};
/// The least side of a panel.
inline constexpr float leastPanelMm = 10.0f;
/// The least side of what an inset enlarges.
inline constexpr float leastPartMm = 1.0f;

inline constexpr Limits<float> trackWeightLimits{0.05f, 20.0f};
inline constexpr Limits<float> figureLetterLimits{4.0f, 48.0f};  ///< points
inline constexpr Limits<float> figurePenLimits{0.1f, 4.0f};      ///< points
inline constexpr Limits<float> figureLeastLimits{0.0f, 48.0f};   ///< points, of what is refused

/// A width that journals print.
struct FigureWidth {
  std::string_view name;
  float mm = 0.0f;
};
inline constexpr std::array<FigureWidth, 3> figureWidths{
    FigureWidth{"single", 85.0f}, FigureWidth{"middle", 114.0f}, FigureWidth{"double", 174.0f}};

enum class PanelLetters { lower, upper, none };
inline constexpr std::array<std::string_view, 3> panelLetterNames{"lower", "upper", "none"};
/// Which structures the figure's legend lists: none, all that any panel shows, those that its
/// labels point at, or those in focus.
enum class FigureLegend { none, all, labelled, focus };
inline constexpr std::array<std::string_view, 4> figureLegendNames{"none", "all", "labelled",
                                                                   "focus"};
/// How panels see: as each view was saved, or all without perspective.
enum class FigureProjection { saved, parallel };
inline constexpr std::array<std::string_view, 2> figureProjectionNames{"saved", "parallel"};

/// What becomes of lines that are thinner than the figure allows: they are drawn wider, the figure
/// is refused, or they stay. Strokes of hatching make tones and stay.
enum class ThinLines { raised, refused, kept };
inline constexpr std::array<std::string_view, 3> thinLineNames{"raised", "refused", "kept"};

/// A rectangle in millimetres, from the upper left corner of what it lies on, y downwards.
struct FigureBox {
  glm::vec2 at{0.0f};
  glm::vec2 size{0.0f};
  glm::vec2 end() const { return at + size; }
  bool operator==(const FigureBox&) const = default;
};

struct PanelCamera {
  /// The letter of a panel whose direction and scale this one has, too; empty: none.
  std::string like;
  bool centred =
      false;         ///< beside that: on what this panel shows, as scenes differ in their places
  bool fit = false;  ///< moved so that all that is visible fills the panel
  bool operator==(const PanelCamera&) const = default;
};

/// A panel that shows a part of another one enlarged.
struct PanelInset {
  std::string of;                   ///< that panel's letter
  FigureBox part;                   ///< what is shown, on that panel
  std::optional<FigureBox> inside;  ///< where the inset lies on that panel; absent: beside it
  bool lines = false;               ///< join the part's frame with the inset
  bool operator==(const PanelInset&) const = default;
};

/// What a panel does not say is as the figure says.
struct FigurePanel {
  std::string scene;  ///< file, relative to the figure's; empty: the figure's
  std::string
      view;  ///< a saved view or a side of the body; empty: the scene as it is, from the front
  std::optional<std::string> letter;  ///< absent: the next one; empty: none
  std::optional<PanelCamera> camera;
  std::optional<PanelInset> inset;
  std::optional<FigureBox> at;  ///< on the page; absent: the next free place of the grid
  int columns = 1;              ///< how many it spans
  int rows = 1;
  std::optional<bool> labels;
  std::optional<bool> scaleBar;
  std::optional<bool> sides;
  bool operator==(const FigurePanel&) const = default;
};

struct Figure {
  float widthMm = 174.0f;
  std::optional<float> heightMm;           ///< absent: as the panels need, those of the grid 4 by 3
  float gapMm = 3.0f;                      ///< between panels
  std::vector<float> columns{1.0f, 1.0f};  ///< weights of their widths
  std::vector<float> rows;                 ///< of their heights; others have weight 1
  std::string scene;
  FigureProjection projection = FigureProjection::saved;
  /// All panels but insets have one scale, the smallest that any would have by itself, and one of
  /// them shows it.
  bool sameScale = false;
  PanelLetters letters = PanelLetters::lower;
  float letterPoints = 10.0f;
  float points = 7.5f;  ///< of labels; scale bars and legend have 0.8 of it
  std::string language;
  bool labels = true;
  bool scaleBars = true;
  bool sides = true;  ///< R and L
  FigureLegend legend = FigureLegend::none;
  float penPoints = 0.6f;  ///< of contours at a pen weight of 1, the same in all panels
  bool blackAndWhite = false;
  float leastPoints = 6.0f;  ///< smaller letters are refused
  float leastLine = 0.25f;   ///< points
  ThinLines thinLines = ThinLines::raised;
  std::vector<FigurePanel> panels;
  bool operator==(const Figure&) const = default;
};

/// Returns the letter of each panel as the page shows it: its own, else the next of a, b, c …,
/// except for insets inside others, which have none unless they say one.
std::vector<std::string> lettersOf(const Figure& figure);

/// Returns the panel of that letter, whichever way it is written; absent where there is none.
std::optional<std::size_t> panelOfLetter(const Figure& figure, std::string_view letter);

/// Returns the panel's file of a scene, relative to the figure's.
const std::string& sceneOf(const Figure& figure, const FigurePanel& panel);

/// What a panel has that does not say whether it has labels, a scale bar, R and L: as the figure
/// says, but where all have the same scale the first panel's bar is that of all that enlarge
/// nothing, and insets have no sides.
bool usualLabels(const Figure& figure, std::size_t index);
bool usualScaleBar(const Figure& figure, std::size_t index);
bool usualSides(const Figure& figure, std::size_t index);

/// Returns how errors name the panel: "panel b", or "panel 3" where it has no letter.
std::string panelName(const Figure& figure, std::size_t index);

}  // namespace sline::model
