// SPDX-License-Identifier: Apache-2.0
// Makes a picture from a scene and a camera. Each structure is a layer, shaded in its own screen
// rectangle of an atlas and kept until its style, its mesh or the camera changes; the resolve pass
// blends the layers per pixel by depth, exactly and independently of their order (METHOD §10).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/geometry/surface.h"
#include "model/scene/scene.h"
#include "render/drawn/picture_settings.h"
#include "render/raster/image.h"

namespace sline::render {

namespace gpu {
class Device;
class Target;
}  // namespace gpu

/// Tells where the time of the last picture went, in milliseconds; the GPU has finished where a
/// phase ends.
struct PictureTimings {
  double lines = 0.0;  ///< extraction on the CPU
  struct Pass {
    std::string name;
    double milliseconds = 0.0;
  };
  std::vector<Pass> passes;
  double total = 0.0;
  int layersDrawn = 0;  ///< the other layers were kept from the picture before
  /// The picture was hurried and lacks something that one without hurry has.
  bool makeshift = false;
};

/// Limits how much of the driver a picture may use; pictures that need more are drawn in pieces.
struct PictureOptions {
  int maximumSide = 0;  ///< of a piece, in pixels; 0: the driver's own limit
  /// Of all layers together, 13 bytes each. 0: 20 million, or 48 where a graphics card draws.
  std::size_t atlasPixels = 0;
  /// What draws: a graphics card as much as it can; a driver that draws on the processor, with what
  /// we do better; or the processor alone. Automatic: the card if there is one, else the processor.
  enum class Painter { automatic, card, driver, processor };
  Painter painter = Painter::automatic;
  /// Surfaces whose triangles are far smaller than pixels are drawn with fewer of them.
  bool levelsOfDetail = true;
  /// Intermediate colours have 16 bits per channel (17 bytes then); needs OpenGL, ES is not enough.
  bool deep = false;
};

/// Where a picture in a window goes: a texture, or pixels in memory. What it stands for must
/// outlive it.
class PictureTarget {
 public:
  /// The first colour texture of the target.
  PictureTarget(const gpu::Target& texture);  // NOLINT: wherever a target is expected
  /// Pixels of 8 bits, red in the lowest byte, with premultiplied alpha, in rows from the bottom.
  PictureTarget(int width, int height, std::span<std::uint32_t> pixels)
      : m_width(width), m_height(height), m_pixels(pixels) {}

  int width() const { return m_width; }
  int height() const { return m_height; }
  const gpu::Target* texture() const { return m_texture; }
  std::span<std::uint32_t> pixels() const { return m_pixels; }

 private:
  const gpu::Target* m_texture = nullptr;  ///< null: it is pixels
  int m_width = 0;
  int m_height = 0;
  std::span<std::uint32_t> m_pixels;
};

/// A line around structures of a picture in a window, such as those that are selected. It is no
/// part of the picture: nothing that is exported has one.
struct Outline {
  std::vector<model::NodeId> structures;  ///< sorted
  Colour ink;
  Colour casing{255, 255, 255};  ///< narrow lines beside the ink, to set it off
  float width = 2.0f;            ///< pixels, of the ink
  float casingWidth = 1.0f;      ///< pixels at each side
  float strength = 1.0f;         ///< 0 … 1
  bool operator==(const Outline&) const = default;
};

/// A part of a picture as it was drawn; lengths are in pixels, from the picture's upper left
/// corner.
struct PicturePiece {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  /// sRGB with premultiplied alpha, 16 bits per channel, rows from the top. Without
  /// `PictureOptions::deep` these are 8-bit values spread to 16.
  std::vector<std::uint16_t> rgba;
};

/// Tells how a picture is drawn piece by piece: in bands from the top down, each of one piece or
/// more.
struct PicturePieces {
  int bandRows = 1024;
  /// Pieces begin and end at multiples of this, from the upper left corner; width, height and band
  /// must also be multiples of it.
  int grid = 1;
  /// Receives each piece once; returns false where no more are wanted.
  std::function<bool(PicturePiece&&)> take;
};

/// Opens OpenGL where a picture needs it, and keeps it as long as itself lives.
using OpenDriver = std::function<Result<std::unique_ptr<gpu::Device>>()>;

class Picture {
 public:
  /// Creates a picture, which needs a current OpenGL 3.3 core or ES 3.0 context for its whole life.
  /// The error names the driver and what it lacks.
  static Result<std::unique_ptr<Picture>> create(const PictureOptions& options = {});
  /// Creates a picture that the processor draws. OpenGL is opened at the first structure that only
  /// a driver can draw; where it cannot be, that picture fails and its error says what needs it. It
  /// draws into pixels alone, not into textures.
  static std::unique_ptr<Picture> withoutDriver(const PictureOptions& options, OpenDriver open);
  ~Picture();
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  /// Prepares what the picture needs of the scene's visible structures and they lack; stops early
  /// where `unwanted` is set. Pictures do so by themselves.
  void prepare(const model::Scene& scene, const model::Camera& camera,
               const PictureSettings& settings, int samples = 1,
               const std::atomic<bool>* unwanted = nullptr);
  /// Draws the scene and reads the pixels back. Pictures larger than the driver's textures are
  /// drawn in tiles without seams. With `samples` the picture is drawn that many times as large
  /// both ways and averaged to the settings' size.
  Result<Image> render(const model::Scene& scene, const model::Camera& camera,
                       const PictureSettings& settings, int samples = 1);
  /// Returns `render` as a function, which this object must outlive.
  DrawPicture drawing();
  /// Draws piece by piece, so that a picture of any size needs little memory. Surfaces are prepared
  /// and lines found once for all pieces, and no seam shows between them. It returns false where
  /// `take` wanted no more.
  Result<bool> renderPieces(const model::Scene& scene, const model::Camera& camera,
                            const PictureSettings& settings, const PicturePieces& pieces);
  /// Draws without reading back, and waits for the GPU (the benchmark's frame).
  Status draw(const model::Scene& scene, const model::Camera& camera,
              const PictureSettings& settings);
  /// Draws into the job's target instead, which must have the picture's size, and waits for the
  /// GPU. It returns false where the job was given up.
  struct TargetJob {
    PictureTarget target;
    /// Set from another thread when the picture is no longer wanted; may be null.
    const std::atomic<bool>* unwanted = nullptr;
    std::span<const Outline> outlines = {};  ///< drawn over the picture, the last on top
  };
  Result<bool> drawInto(const TargetJob& job, const model::Scene& scene,
                        const model::Camera& camera, const PictureSettings& settings);
  /// Does the same with four samples for each pixel, where the picture was drawn before: what is
  /// kept for the next one stays, and nothing is made that takes long.
  Result<bool> refineInto(const TargetJob& job, const model::Scene& scene,
                          const model::Camera& camera, const PictureSettings& settings);
  /// Draws a small picture beside those that are drawn again and again: it shares their surfaces,
  /// and what they keep from one to the next stays good. It returns nothing where it was given up.
  Result<std::optional<Image>> preview(const model::Scene& scene, const model::Camera& camera,
                                       const PictureSettings& settings,
                                       const std::atomic<bool>* unwanted = nullptr);
  const PictureTimings& timings() const;

 private:
  Picture();
  struct Data;
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render
