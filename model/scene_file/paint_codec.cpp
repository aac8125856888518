// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/paint_codec.h"

namespace sline::model {

namespace {
constexpr std::string_view paintMagic = "SlinePa1";
}  // namespace

std::string encodedPaint(const Paint& paint) {
  std::string bytes(paintMagic);
  bytes.append(paint.begin(), paint.end());
  return bytes;
}

Result<Paint> decodedPaint(std::string_view bytes) {
  if (!bytes.starts_with(paintMagic))
    return Error{.reason = "it does not begin like what is painted on a mesh"};
  bytes.remove_prefix(paintMagic.size());
  return Paint(bytes.begin(), bytes.end());
}

}  // namespace sline::model
