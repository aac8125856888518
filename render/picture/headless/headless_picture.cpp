// SPDX-License-Identifier: Apache-2.0
#include "render/picture/headless/headless_picture.h"

#include "render/gpu/device.h"
#include "render/gpu/headless/context.h"

namespace sline::render {

namespace {

using Context = std::unique_ptr<gpu::HeadlessContext>;

Status open(Context& place) {
  place = TRY(gpu::HeadlessContext::create());
  return Unit{};
}

}  // namespace

HeadlessPicture::HeadlessPicture() : m_context(std::make_shared<Context>()) {}
HeadlessPicture::~HeadlessPicture() = default;
HeadlessPicture::HeadlessPicture(HeadlessPicture&& other) noexcept = default;

Result<HeadlessPicture> HeadlessPicture::create(const PictureOptions& options) {
  using Painter = PictureOptions::Painter;
  HeadlessPicture made;
  const bool asked =
      options.deep || options.painter == Painter::card || options.painter == Painter::driver;
  if (asked || (options.painter == Painter::automatic && gpu::HeadlessContext::mayBeOnCard())) {
    const Status opened = open(*made.m_context);
    if (!opened.ok() && asked)
      return opened.error();
    if (opened.ok()) {
      made.m_picture = TRY(Picture::create(options));
      return made;
    }
  }
  made.m_picture = Picture::withoutDriver(
      options, [place = made.m_context]() -> Result<std::unique_ptr<gpu::Device>> {
        TRY(open(*place));
        return gpu::Device::create();
      });
  return made;
}

const std::string& HeadlessPicture::driver() const {
  static const std::string processor = "the processor";
  return *m_context ? (*m_context)->driver() : processor;
}

}  // namespace sline::render
