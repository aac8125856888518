// SPDX-License-Identifier: Apache-2.0
// Draws a region of a picture: it plans the layers, redraws those that changed and resolves all.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>

#include "render/gpu/draw_queue.h"
#include "render/passes/cap/cap_pass.h"
#include "render/passes/ink/ink_pass.h"
#include "render/passes/resolve/overlay_pass.h"
#include "render/passes/resolve/resolve_pass.h"
#include "render/passes/surface/enlarge_pass.h"
#include "render/passes/surface/surface_pass.h"
#include "render/passes/surface/wipe_pass.h"
#include "render/picture/atlas.h"
#include "render/picture/layer.h"
#include "render/picture/picture_canvas.h"
#include "render/picture/printed_hatching.h"
#include "render/picture/processor_outlines.h"
#include "render/picture/stopwatch.h"

namespace sline::render {

/// Holds the input for one picture.
struct PictureInput {
  const PictureView& view;
  std::span<const PreparedStructure> shown;  ///< sorted by id
  Background background = Background::white;
  glm::vec3 light{0.0f};
  bool keyLight = false;
  PictureContent parts;
  int surfaceStep = 1;     ///< see PictureSettings
  bool processor = false;  ///< what can be drawn on the processor is drawn there
  bool card = false;       ///< a graphics card draws: what it can do is left to it
  /// Keeps lines between the regions of one picture, by structure; null to keep none.
  std::map<model::NodeId, StructureLines>* lines = nullptr;
  /// Set from another thread when the picture is no longer wanted; may be null.
  const std::atomic<bool>* unwanted = nullptr;

  bool isUnwanted() const { return unwanted && *unwanted; }
};

class LayerPainter {
 public:
  /// Creates a painter that draws what the processor draws alone, and the rest once it is equipped.
  explicit LayerPainter(const AtlasLimits& limits) : m_atlas(limits) {}
  /// Makes the programs for what a driver draws.
  Status equip(const gpu::Device& device);

  /// Returns another painter with the same programs, which neither shares nor spoils what this one
  /// keeps.
  std::unique_ptr<LayerPainter> another(const AtlasLimits& limits) const;

  enum class Outcome { painted, tooLarge, givenUp, needsDriver };
  /// Draws the region (in picture pixels) so that it fills the canvas. Where the canvas still has
  /// what the last `paint` drew, only squares are drawn anew that a changed layer touches or
  /// touched. It returns `tooLarge`, with nothing drawn, where the layers exceed the atlas (a
  /// smaller region may do), and `givenUp` where the input asked to stop; the canvas' contents are
  /// then undefined. Without a device the canvas has no texture, and `blended` returns the pixels;
  /// it returns `needsDriver` where the processor cannot draw all.
  Result<Outcome> paint(gpu::Device* device, const PictureInput& input, const PixelRect& region,
                        const PictureCanvas& canvas, Stopwatch& stopwatch);
  /// Returns the pixels of the region that was painted last, 8-bit RGBA with premultiplied alpha in
  /// rows from the bottom, where the processor blended them; else none.
  std::span<const std::uint32_t> blended() const {
    return m_blended ? std::span<const std::uint32_t>(m_picture) : std::span<const std::uint32_t>();
  }
  /// A region of the picture in the target of all of it.
  struct OutlinePlace {
    PixelRect region;
    const gpu::Target& target;
  };
  /// Returns the line around structures, seen or not, as the processor draws it over the region of
  /// the last `paint`, which it blended; nothing where a driver must. It stays until the next one.
  std::optional<ProcessorOutlines::Drawn> outline(const PictureInput& input,
                                                  const PixelRect& region, const Outline& outline);
  /// Draws lines around structures, seen or not, over the region's place in the target. The region
  /// is the one of the last `paint`, whose layers hide what lies behind them.
  Status outline(gpu::Device& device, const PictureInput& input, const OutlinePlace& place,
                 const Outline& outline);
  /// Returns how many layers the last `paint` drew anew.
  int layersDrawn() const { return m_layersDrawn; }
  /// Has the next `paint` draw all layers anew.
  void forget();

 private:
  /// Holds what all layers of a region depend on.
  struct Key {
    model::Camera camera;
    model::Box bounds;
    glm::vec2 size{0.0f};
    Background background = Background::white;
    glm::vec3 light{0.0f};
    bool keyLight = false;
    PictureContent parts;
    int surfaceStep = 1;
    PixelRect region;
    bool operator==(const Key&) const = default;
  };

  std::vector<std::size_t> reuse(std::vector<Layer>& layers, const Key& key);
  Status makeRoom(gpu::Device& device);
  bool place(std::vector<Layer>& layers, std::vector<std::size_t>& changed);
  void letGo(gpu::Device& device);
  void emptyInk(gpu::Device& device, std::span<const Layer> layers,
                std::span<const std::size_t> changed) const;
  /// Says where and how the surface of a layer's member is drawn.
  struct MemberDraw {
    const gpu::Target& target;
    const Layer& layer;
    std::size_t index = 0;  ///< in the layer's members
    SurfacePlace place;     ///< in the target
    SurfaceFill fill;
    bool cullsBack = false;  ///< see coverage.h; of a layer without lists of triangles
  };
  void drawMember(gpu::Device& device, const MemberDraw& member, const passes::SurfaceView& view,
                  gpu::DrawQueue& queue) const;
  void drawSurface(gpu::Device& device, const PictureInput& input, const Layer& layer,
                   gpu::DrawQueue& queue) const;
  void drawCaps(gpu::Device& device, const PictureInput& input, const Layer& layer,
                const gpu::Target& target, const SurfacePlace& place) const;
  void enlargeSurfaces(gpu::Device& device, const PictureInput& input,
                       std::span<const Layer> layers, std::span<const std::size_t> changed,
                       gpu::DrawQueue& queue) const;
  Status drawSurfaces(gpu::Device& device, const PictureInput& input, std::span<const Layer> layers,
                      std::span<const std::size_t> changed) const;
  Status drawInk(gpu::Device& device, const PictureInput& input, std::vector<Layer>& layers,
                 std::span<const std::size_t> changed);
  /// Tells which part of a target is to be blended anew; the rest stays as it is.
  struct Canvas {
    const gpu::Target* target;  ///< null: the processor draws alone
    PixelRect region;
    TileMask wanted;
    bool keeps = false;  ///< the parts outside `wanted` are still good
  };
  Canvas canvas(const gpu::Target* target, const PixelRect& region, std::span<const Layer> layers,
                std::span<const std::size_t> changed, bool blends);
  Status resolve(gpu::Device& device, Background background, const Canvas& canvas,
                 std::span<const Layer> layers);
  /// Blends layers that the processor drew, and puts the region's pixels into the texture, if there
  /// is one.
  Status blendOnProcessor(Background background, const Canvas& canvas,
                          std::span<const Layer> layers, const gpu::Texture* pixels);
  /// Gives the atlas what only the processor has of the layers.
  Status upload(gpu::Device& device, std::span<Layer> layers);
  /// Draws the layers on the graphics card.
  Result<Outcome> drive(gpu::Device& device, const PictureInput& input, std::vector<Layer>& layers,
                        std::span<const std::size_t> driven, Stopwatch& stopwatch);
  void takeSpares(std::vector<Layer>& layers, std::span<const std::size_t> changed);
  Status lay(gpu::Device& device, const ProcessorOutlines::Drawn& drawn, const OutlinePlace& place);
  void drawNumbers(gpu::Device& device, const PictureInput& input, std::span<Layer> layers,
                   const OutlinedNumbers& numbers, const PixelRect& region) const;

  Atlas m_atlas;
  std::shared_ptr<passes::SurfacePass> m_surfacePass;
  std::shared_ptr<passes::WipePass> m_wipePass;
  std::shared_ptr<passes::EnlargePass> m_enlargePass;
  std::shared_ptr<passes::CapPass> m_capPass;
  std::shared_ptr<passes::InkPass> m_inkPass;
  std::shared_ptr<passes::ResolvePass> m_resolvePass;
  std::shared_ptr<passes::OverlayPass> m_overlayPass;
  PrintedHatching m_printedHatching;
  Key m_key;
  std::vector<Layer> m_kept;
  TileMask m_left;                    ///< squares touched by layers that have since changed or gone
  std::vector<LayerPixels> m_spares;  ///< of layers that have changed or gone
  std::vector<std::uint32_t> m_picture;  ///< the region's pixels, where the processor blends
  ProcessorOutlines m_outlines;
  std::uint64_t m_drawings = 0;  ///< how many layers were drawn
  PictureCanvas m_numbers;       ///< which marked structure is where, or the line around it
  const gpu::Target* m_target = nullptr;  ///< that of the last `paint`
  bool m_blended = false;                 ///< by the processor, in the last `paint`
  bool m_freshAtlas = true;
  int m_layersDrawn = 0;
};

}  // namespace sline::render
