// SPDX-License-Identifier: Apache-2.0
// Wraps OpenGL thinly: it offers what passes may use, in the subset that OpenGL 3.3 core and ES 3.0
// share. It needs a current context from any source (a window, EGL, a browser) and assumes nothing
// about that context's state.
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

class Device {
 public:
  /// Creates the device. The error names the driver and the version that it lacks.
  static Result<std::unique_ptr<Device>> create();

  const Limits& limits() const { return m_limits; }
  /// Returns "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
  const std::string& driver() const { return m_driver; }
  Dialect dialect() const { return m_dialect; }
  /// Tells whether the driver draws on the processor, as far as its name says.
  bool software() const { return m_software; }

  struct Clear {
    std::optional<glm::vec4> colour;  ///< that of every colour texture
    std::optional<float> depth;
    std::optional<PixelRect> area;  ///< absent: all
  };
  void clear(const Target& target, const Clear& what);

  /// Describes what a draw call reads and where it draws to.
  struct Draw {
    const Target& target;
    const Program& program;
    const Geometry& geometry;
    const DrawState& state;
  };
  /// Draws triangles of the first `count` indices or, without an index buffer, vertices.
  void triangles(const Draw& draw, std::size_t count);
  /// Draws a four-cornered strip per instance, corners told apart by gl_VertexID.
  void quads(const Draw& draw, std::size_t instances);

  /// Copies depth to the same place of another target.
  void copyDepth(const Target& from, const Target& to, const PixelRect& area);
  /// Copies the first colour texture's area to another target: to an area as large, or half as
  /// large each way, of which each pixel is the mean of four.
  void copyColour(const Target& from, const PixelRect& area, const Target& to,
                  const PixelRect& place);
  /// Reads the first colour texture as 8-bit RGBA rows from the bottom, tightly packed. Where there
  /// is no room for them nothing is read, and the error says so.
  Status read(const Target& target, const PixelRect& area, std::span<std::byte> rgba);
  /// Reads it with 16 bits per channel, whatever the texture has. Not available in ES.
  Status read(const Target& target, const PixelRect& area, std::span<std::uint16_t> rgba);
  /// Waits until all requested work is done.
  void finish();

 private:
  Device() = default;
  static void apply(const Draw& draw);

  Limits m_limits;
  std::string m_driver;
  Dialect m_dialect = Dialect::desktop330;
  bool m_software = false;
};

}  // namespace sline::render::gpu
