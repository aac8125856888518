// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/picture_screen.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "render/gpu/device.h"
#include "render/gpu/headless/context.h"
#include "widgets/viewport/driver_screen.h"
#include "widgets/viewport/plain_screen.h"

namespace sline::widgets {

namespace {

ScreenKind& chosen() {
  static ScreenKind kind = ScreenKind::automatic;
  return kind;
}

/// Returns the driver's name where it draws on the processor; without one that may draw elsewhere
/// none is opened.
std::optional<QString> softwareDriver() {
  if (!render::gpu::HeadlessContext::mayBeOnCard())
    return QCoreApplication::translate("sline::widgets::PictureScreen",
                                       "none, as the processor draws");
  QOffscreenSurface surface;
  surface.setFormat(pictureFormat());
  surface.create();
  QOpenGLContext context;
  context.setFormat(pictureFormat());
  if (!context.create() || !context.makeCurrent(&surface))
    return std::nullopt;
  std::optional<QString> name;
  if (const auto device = render::gpu::Device::create(); device.ok() && (*device)->software())
    name = QString::fromStdString((*device)->driver());
  context.doneCurrent();
  return name;
}

}  // namespace

render::gpu::TextureSize pixelsOf(const QWidget& screen) {
  const double ratio = screen.devicePixelRatioF();
  return {.width = std::max(1, int(std::lround(screen.width() * ratio))),
          .height = std::max(1, int(std::lround(screen.height() * ratio)))};
}

QSurfaceFormat pictureFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

void chooseScreens(ScreenKind kind) {
  chosen() = kind;
}

std::unique_ptr<PictureScreen> makePictureScreen(QWidget& parent, PictureScreen::Told told) {
  if (chosen() != ScreenKind::driver) {
    static const std::optional<QString> software = softwareDriver();
    if (software || chosen() == ScreenKind::plain)
      return std::make_unique<PlainScreen>(parent, std::move(told), software.value_or(QString()));
  }
  return std::make_unique<DriverScreen>(parent, std::move(told));
}

}  // namespace sline::widgets
