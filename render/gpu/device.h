// SPDX-License-Identifier: Apache-2.0
// The thin device: what passes may ask of OpenGL, in the subset that OpenGL 3.3 core and ES 3.0
// share. It needs a current context, whoever made it (a window, EGL, a browser), and takes nothing
// for granted about that context's state.
#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>

#include "render/gpu/geometry.h"
#include "render/gpu/program.h"
#include "render/gpu/state.h"
#include "render/gpu/target.h"

namespace sline::render::gpu {

struct Limits {
  int textureSide = 0;   ///< largest width and height of a texture
  int viewportSide = 0;  ///< largest width and height of a viewport
};

/// Indices (or, without an index buffer, vertices) first … first + count − 1.
struct DrawRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

class Device {
 public:
  /// The error names the driver and the version that it lacks.
  static Result<std::unique_ptr<Device>> create();

  const Limits& limits() const { return m_limits; }
  /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
  const std::string& driver() const { return m_driver; }
  Dialect dialect() const { return m_dialect; }

  struct Clear {
    std::optional<glm::vec4> colour;  ///< of every colour texture
    std::optional<float> depth;
    std::optional<PixelRect> area;  ///< absent: all
  };
  void clear(const Target& target, const Clear& what);

  /// What a draw call reads and where it draws to.
  struct Draw {
    const Target& target;
    const Program& program;
    const Geometry& geometry;
    const DrawState& state;
  };
  /// Triangles.
  void triangles(const Draw& draw, std::span<const DrawRange> ranges);
  /// A four-cornered strip per instance, corners told apart by gl_VertexID.
  void quads(const Draw& draw, std::size_t instances);

  /// Copies depth to the same place of another target.
  void copyDepth(const Target& from, const Target& to, const PixelRect& area);
  /// Copies the first colour texture's area to another target; both areas have one size.
  void copyColour(const Target& from, const PixelRect& area, const Target& to,
                  const PixelRect& place);
  /// 8-bit RGBA rows from the bottom, tightly packed, of the first colour texture.
  void read(const Target& target, const PixelRect& area, std::span<std::byte> rgba);
  /// The same with 16 bits a channel, whatever the texture has. Not in ES.
  void read(const Target& target, const PixelRect& area, std::span<std::uint16_t> rgba);
  /// Waits until everything asked for is done.
  void finish();

 private:
  Device() = default;
  static void apply(const Draw& draw);

  Limits m_limits;
  std::string m_driver;
  Dialect m_dialect = Dialect::desktop330;
};

}  // namespace sline::render::gpu
