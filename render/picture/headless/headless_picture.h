// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "model/base/result.h"
#include "render/picture/picture.h"

namespace sline::render {

namespace gpu {
class HeadlessContext;
}

/// A picture that needs no display. Where there is a graphics card, or a driver is asked for, it
/// has an OpenGL context of its own, current on the thread that made it; else the processor draws,
/// and OpenGL is opened, on the thread that draws, only for what needs it
/// (`Picture::withoutDriver`).
class HeadlessPicture {
 public:
  /// Makes the picture. The error says what was tried and what to install; there is none where the
  /// processor may draw.
  static Result<HeadlessPicture> create(const PictureOptions& options = {});
  ~HeadlessPicture();
  HeadlessPicture(HeadlessPicture&& other) noexcept;
  HeadlessPicture& operator=(HeadlessPicture&&) = delete;

  Picture& operator*() const { return *m_picture; }
  Picture* operator->() const { return m_picture.get(); }
  /// Returns the driver's own name, as `gpu::HeadlessContext::driver` has it, or "the processor".
  const std::string& driver() const;

 private:
  HeadlessPicture();
  std::shared_ptr<std::unique_ptr<gpu::HeadlessContext>> m_context;
  std::unique_ptr<Picture> m_picture;  ///< is destroyed before its context
};

}  // namespace sline::render
