// SPDX-License-Identifier: Apache-2.0
#include "render/picture/headless/headless_picture.h"

#include "render/gpu/headless/context.h"

namespace sline::render {

HeadlessPicture::HeadlessPicture() = default;
HeadlessPicture::~HeadlessPicture() = default;
HeadlessPicture::HeadlessPicture(HeadlessPicture&& other) noexcept = default;

Result<HeadlessPicture> HeadlessPicture::create(const PictureOptions& options) {
  HeadlessPicture made;
  auto context = gpu::HeadlessContext::create();
  if (!context.ok())
    return context.error();
  made.m_context = std::move(*context);
  auto picture = Picture::create(options);
  if (!picture.ok())
    return picture.error();
  made.m_picture = std::move(*picture);
  return made;
}

const std::string& HeadlessPicture::driver() const {
  return m_context->driver();
}

}  // namespace sline::render
