// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>

#include "model/base/srgb.h"
#include "render/export/pixels/module/pixel_module_parts.h"

namespace sline::render {

namespace {

using namespace std::string_view_literals;

/// Tells how a kind of file begins.
struct Signature {
  std::string_view start;
  const char* format;  ///< the library's name of it
};

constexpr std::array signatures{
    Signature{"\x89PNG\r\n\x1a\n"sv, "png"},
    Signature{"II*\0"sv, "tiff"},
    Signature{"MM\0*"sv, "tiff"},
    Signature{"II+\0"sv, "tiff"},
    Signature{"MM\0+"sv, "tiff"},
    Signature{"\x76\x2f\x31\x01"sv, "openexr"},
    Signature{"\xFF\xD8\xFF"sv, "jpeg"},
    Signature{"RIFF"sv, "webp"},
    Signature{"\0\0\0\x0CjP  \r\n\x87\n"sv, "jpeg2000"},
    Signature{"\xFF\x4F\xFF\x51"sv, "jpeg2000"},
};

/// Returns the library's name of the format. Only its reader is used: the library would try all
/// that it has, and some of those crash.
const char* formatOf(std::string_view bytes) {
  const auto* found =
      std::find_if(signatures.begin(), signatures.end(),
                   [&](const Signature& known) { return bytes.starts_with(known.start); });
  return found == signatures.end() ? nullptr : found->format;
}

Error refused(const std::string& reason) {
  return {.reason = reason, .remedy = "Save the picture again, as PNG or TIFF"};
}

Error tooLarge(std::uint64_t width, std::uint64_t height, const PictureLimits& limits) {
  return {.reason = "the picture says that it has " + std::to_string(width) + "×" +
                    std::to_string(height) + " pixels, more than the " +
                    std::to_string(limits.pixels) + " that are read",
          .remedy = "Save a smaller one"};
}

std::uint32_t bigEndianAt(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | std::uint8_t(bytes[at + i]);
  return value;
}

/// Returns width and height of a JPEG 2000 codestream, as its reader takes memory for the whole
/// picture before it reports them (ISO/IEC 15444-1, A.5.1).
std::optional<std::array<std::uint64_t, 2>> codestreamSize(std::string_view bytes) {
  const std::size_t at = bytes.find("\xFF\x4F\xFF\x51"sv);
  if (at == std::string_view::npos || at + 24 > bytes.size())
    return std::nullopt;
  const std::uint64_t right = bigEndianAt(bytes, at + 8);
  const std::uint64_t bottom = bigEndianAt(bytes, at + 12);
  const std::uint64_t left = bigEndianAt(bytes, at + 16);
  const std::uint64_t top = bigEndianAt(bytes, at + 20);
  if (right <= left || bottom <= top)
    return std::nullopt;
  return std::array{right - left, bottom - top};
}

bool within(std::uint64_t width, std::uint64_t height, const PictureLimits& limits) {
  return width > 0 && height > 0 && width <= limits.pixels / height;
}

/// Converts channels as they are read to red, green, blue and alpha, with alpha multiplied in.
class Spreader {
 public:
  Spreader(const OIIO::ImageSpec& spec, bool straight)
      : m_channels(std::size_t(spec.nchannels)),
        m_alpha(spec.alpha_channel),
        m_grey(spec.nchannels < 3),
        m_linear(spec.format.is_floating_point()),
        m_straight(straight) {}

  void operator()(const std::uint16_t* from, std::uint16_t* to) const {
    const std::uint16_t alpha = m_alpha < 0 ? std::uint16_t(65535) : from[std::size_t(m_alpha)];
    for (std::size_t c = 0; c < 3; ++c)
      to[c] = encoded(from[m_grey ? 0 : c], alpha);
    to[3] = alpha;
  }
  std::size_t channels() const { return m_channels; }

 private:
  /// Encodes a value: floats are linear light; others are already as they are to be shown.
  std::uint16_t encoded(std::uint16_t value, std::uint16_t alpha) const {
    if (m_straight)
      return std::uint16_t((std::uint32_t(value) * alpha + 32767) / 65535);
    if (!m_linear || value == 0 || alpha == 0)
      return std::min(value, alpha);
    const float light = std::min(float(value) / float(alpha), 1.0f);
    return std::uint16_t(std::lround(srgbFromLight(light) * float(alpha)));
  }

  std::size_t m_channels;
  int m_alpha;
  bool m_grey;
  bool m_linear;
  bool m_straight;
};

Result<PixelRows> pixelsOf(OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
  // The reader of JPEG 2000 does not report straight alpha, as it always has that.
  const Spreader spreader(spec, spec.get_int_attribute("oiio:UnassociatedAlpha") != 0 ||
                                    input.format_name() == "jpeg2000"sv);
  PixelRows rows{.width = spec.width, .height = spec.height, .rgba = {}};
  const auto width = std::size_t(spec.width);
  rows.rgba.resize(width * std::size_t(spec.height) * 4);
  // Files in tiles are read tile row by tile row.
  const int step =
      spec.tile_height > 0 ? spec.tile_height : std::max(1, 1'000'000 / std::max(spec.width, 1));
  std::vector<std::uint16_t> band(width * std::size_t(std::min(step, spec.height)) *
                                  spreader.channels());
  for (int top = 0; top < spec.height; top += step) {
    const int bottom = std::min(top + step, spec.height);
    const bool read =
        spec.tile_width > 0
            ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + top, spec.y + bottom,
                               spec.z, spec.z + 1, 0, spec.nchannels, OIIO::TypeDesc::UINT16,
                               band.data())
            : input.read_scanlines(0, 0, spec.y + top, spec.y + bottom, spec.z, 0, spec.nchannels,
                                   OIIO::TypeDesc::UINT16, band.data());
    if (!read)
      return refused("the picture is damaged: " + input.geterror());
    for (std::size_t i = 0; i < width * std::size_t(bottom - top); ++i)
      spreader(band.data() + i * spreader.channels(),
               rows.rgba.data() + (std::size_t(top) * width + i) * 4);
  }
  return rows;
}

/// Reads the pixels; may throw where memory is lacking.
Result<PixelRows> readPixels(std::string_view bytes, const char* format,
                             const PictureLimits& limits) {
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input)
    return refused("no reader of " + std::string(format) + ": " + OIIO::geterror());
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
  OIIO::ImageSpec spec;
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // as it is in the file
  if (!input->set_ioproxy(&memory) || !input->open(format, spec, wishes))
    return refused("the picture cannot be read: " + input->geterror());
  if (spec.width <= 0 || spec.height <= 0 ||
      !within(std::uint64_t(spec.width), std::uint64_t(spec.height), limits))
    return tooLarge(std::uint64_t(std::max(spec.width, 0)), std::uint64_t(std::max(spec.height, 0)),
                    limits);
  if (spec.nchannels < 1 || spec.nchannels > 16 || spec.depth > 1)
    return refused("the picture has " + std::to_string(spec.nchannels) + " channels in " +
                   std::to_string(spec.depth) + " layers, which nothing here can show");
  return pixelsOf(*input, spec);
}

}  // namespace

Result<PixelRows> inputPicture(std::string_view bytes, const PictureLimits& limits) {
  const char* format = formatOf(bytes);
  if (!format)
    return refused("this is no picture of a kind that is read");
  if (format == "jpeg2000"sv) {
    const auto size = codestreamSize(bytes);
    if (!size)
      return refused("the picture has no size");
    if (!within((*size)[0], (*size)[1], limits))
      return tooLarge((*size)[0], (*size)[1], limits);
  }
  // Files that promise more than this are refused before memory is taken for them.
  OIIO::attribute("limits:channels", 16);
  OIIO::attribute("limits:imagesize_MB", int(limits.pixels * 16 / 1'000'000) + 1);
  try {
    return readPixels(bytes, format, limits);
  } catch (const std::exception& exception) {
    return refused(std::string("the picture cannot be read: ") + exception.what());
  }
}

}  // namespace sline::render
