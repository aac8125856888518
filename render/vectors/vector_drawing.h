// SPDX-License-Identifier: Apache-2.0
// Draws a scene as shapes: the picture's own lines as smooth paths, cut where they are hidden, and
// the fills that lie behind them. No OpenGL is called: depth is found on the CPU, pixel by pixel at
// a few pixels to the pen's width, and a line is hidden by the same rules as in the picture.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/drawn/picture_settings.h"
#include "render/raster/image.h"
#include "render/vectors/path.h"

namespace sline::render {

/// A shape is filled, even-odd where regions have holes, or drawn with a round pen of that width.
struct VectorShape {
  Path path;
  Colour colour;
  float opacity = 1.0f;   ///< 0 … 1
  float penWidth = 0.0f;  ///< mm; 0: filled
  /// What fills in front of a line leave of its light, in steps: below 1 the line is painted before
  /// all that more is left of.
  float light = 1.0f;
};

/// The kinds of lines that are tones: their strokes fade by getting thinner.
inline constexpr const char* hatchingLayer = "Hatching";
inline constexpr const char* cutTissueLayer = "Cut tissue";

/// One kind of line that a pen draws of a structure.
struct VectorLines {
  const char* kind = "";            ///< `hatchingLayer` …, or a technique's layer
  float opacity = 1.0f;             ///< of all the lines together
  bool hidden = false;              ///< by other structures
  std::vector<VectorShape> shapes;  ///< of one colour, except where they are veiled; by light
};

/// Smooth tones of a fill that lets something through, as pixels behind an edge.
struct VectorTones {
  Image image;
  glm::vec2 at{0.0f};      ///< the image's upper left corner
  glm::vec2 sizeMm{0.0f};  ///< of the whole image
  Path edge;               ///< nothing is drawn outside it; even-odd
};

struct VectorStructure {
  model::NodeId id;
  float depth = 0.0f;         ///< mean depth, 0 … 1: the farthest structure has the largest
  std::size_t paintRank = 0;  ///< of its fills among those of other structures
  std::optional<VectorTones> tones;  ///< painted first
  std::vector<VectorShape> fills;    ///< painted one over the other
  float fillOpacity = 1.0f;          ///< of all the fills together

  bool filled() const { return tones || !fills.empty(); }
  std::vector<VectorLines> lines;  ///< in drawing order
  float grain = 0.0f;              ///< how much of the paper shows in the lines, 0 … 1
};

/// A drawing in millimetres from the page's upper left corner, y downwards.
struct VectorDrawing {
  glm::vec2 sizeMm{160.0f, 90.0f};
  std::optional<Colour> background;
  std::vector<VectorStructure> structures;  ///< those that show anything, in order of their fills
};

/// Lines of one kind that lie behind fills and are left the same light.
struct VeiledLines {
  const VectorStructure* structure = nullptr;
  const VectorLines* lines = nullptr;
  std::span<const VectorShape> shapes;  ///< never empty

  float light() const { return shapes.front().light; }
};

/// Returns the veiled lines of a drawing in the order in which they are painted, before all other
/// lines. Wherever two lines cross, the nearer one has the more light, as whatever lies before it
/// lies before the other, too: so each covers what it covers in the picture.
std::vector<VeiledLines> veiledLines(const VectorDrawing& drawing);
/// Returns the other shapes of the lines.
std::span<const VectorShape> plainShapes(const VectorLines& lines);

struct VectorSettings {
  glm::vec2 sizeMm{160.0f, 90.0f};
  Environment environment;
};

/// The largest distance of curves from the lines that they stand for, in λ (1/720 of the page's
/// height): on a page of 90 mm, 0.01 mm.
inline constexpr float vectorTolerance = 0.08f;

/// Is told what is being done and what share of the whole is complete.
using VectorProgress = std::function<void(double share, std::string_view what)>;

/// Returns the scene as shapes. The error says what is wrong with the size or the camera. The
/// result depends on the arguments alone.
Result<VectorDrawing> drawVectors(const model::Scene& scene, const model::Camera& camera,
                                  const VectorSettings& settings,
                                  const VectorProgress& progress = {});

/// Limits of either side of a page.
inline constexpr Limits<float> pageLimitsMm{10.0f, 5000.0f};

}  // namespace sline::render
