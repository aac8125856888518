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

/// A picture with an OpenGL context of its own that needs no display. The context is current on the
/// thread that made it.
class HeadlessPicture {
 public:
  /// Opens the context and makes the picture. The error says what was tried and what to install.
  static Result<HeadlessPicture> create(const PictureOptions& options = {});
  ~HeadlessPicture();
  HeadlessPicture(HeadlessPicture&& other) noexcept;
  HeadlessPicture& operator=(HeadlessPicture&&) = delete;

  Picture& operator*() const { return *m_picture; }
  Picture* operator->() const { return m_picture.get(); }
  /// Returns the driver's own name, as `gpu::HeadlessContext::driver` has it.
  const std::string& driver() const;

 private:
  HeadlessPicture();
  std::unique_ptr<gpu::HeadlessContext> m_context;
  std::unique_ptr<Picture> m_picture;  ///< is destroyed before its context
};

}  // namespace sline::render
