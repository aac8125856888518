// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

#include "render/export/formats/export_formats.h"

namespace sline::widgets {

/// Returns the picture as sRGB with straight alpha.
render::Image straightImage(const QImage& picture);

}  // namespace sline::widgets
