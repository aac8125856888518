// SPDX-License-Identifier: Apache-2.0
#include "app/cli/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/text_file.h"

namespace sline::cli {

namespace fs = std::filesystem;

namespace {

enum class Alpha { straight, multiplied, onWhite };

struct Format {
  std::string_view extension;
  const char* writer;  ///< OpenImageIO's name
  Alpha alpha;
  bool linearHalf;  ///< else 8 bit sRGB
};

constexpr std::array<Format, 6> formats{{{".png", "png", Alpha::straight, false},
                                         {".tiff", "tiff", Alpha::straight, false},
                                         {".tif", "tiff", Alpha::straight, false},
                                         {".exr", "openexr", Alpha::multiplied, true},
                                         {".jpg", "jpeg", Alpha::onWhite, false},
                                         {".jpeg", "jpeg", Alpha::onWhite, false}}};

const Format* formatOf(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const Format& format) {
    return format.extension == extension;
  });
  return found == formats.end() ? nullptr : &*found;
}

/// IEC 61966-2-1.
float linearLight(std::uint8_t srgb) {
  const float value = float(srgb) / 255.0f;
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

std::array<float, 256> linearLightTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = linearLight(std::uint8_t(i));
  return table;
}

bool opaque(const render::Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255)
      return false;
  return true;
}

/// One row of 8-bit pixels with 3 or 4 channels.
void packRow(std::span<const std::uint8_t> rgba, bool onWhite, int channels,
             std::vector<std::uint8_t>& row) {
  row.clear();
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const int alpha = onWhite ? rgba[i + 3] : 255;
    for (std::size_t c = 0; c < 3; ++c)
      row.push_back(std::uint8_t((rgba[i + c] * alpha + 255 * (255 - alpha) + 127) / 255));
    if (channels == 4)
      row.push_back(rgba[i + 3]);
  }
}

/// One row in linear light with alpha multiplied in.
void packLinearRow(std::span<const std::uint8_t> rgba, const std::array<float, 256>& light,
                   int channels, std::vector<float>& row) {
  row.clear();
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const float alpha = float(rgba[i + 3]) / 255.0f;
    for (std::size_t c = 0; c < 3; ++c)
      row.push_back(light[rgba[i + c]] * alpha);
    if (channels == 4)
      row.push_back(alpha);
  }
}

OIIO::ImageSpec specFor(const render::Image& image, const Format& format) {
  const bool alpha = format.alpha != Alpha::onWhite && !opaque(image);
  OIIO::ImageSpec spec(image.width, image.height, alpha ? 4 : 3,
                       format.linearHalf ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", format.linearHalf ? "Linear" : "sRGB");
  if (alpha && format.alpha == Alpha::straight)
    spec.attribute("oiio:UnassociatedAlpha", 1);
  if (format.alpha == Alpha::onWhite)
    spec.attribute("Compression", "jpeg:95");
  spec.attribute("Software", "Sline " SLINE_VERSION);
  // Left to itself the TIFF writer puts in the time of day; a picture is to carry no date.
  spec.attribute("DateTime", "");
  return spec;
}

bool writeRows(OIIO::ImageOutput& output, const render::Image& image, const Format& format) {
  const int channels = output.spec().nchannels;
  const std::size_t stride = std::size_t(image.width) * 4;
  const auto light = linearLightTable();
  std::vector<std::uint8_t> bytes;
  std::vector<float> floats;
  for (int y = 0; y < image.height; ++y) {
    const std::span rgba(image.rgba.data() + std::size_t(y) * stride, stride);
    bool written = false;
    if (format.linearHalf) {
      packLinearRow(rgba, light, channels, floats);
      written = output.write_scanline(y, 0, OIIO::TypeDesc::FLOAT, floats.data());
    } else {
      packRow(rgba, format.alpha == Alpha::onWhite, channels, bytes);
      written = output.write_scanline(y, 0, OIIO::TypeDesc::UINT8, bytes.data());
    }
    if (!written)
      return false;
  }
  return true;
}

}  // namespace

Status checkImageName(const fs::path& file) {
  if (formatOf(file))
    return Unit{};
  std::string known;
  for (const Format& format : formats)
    known += (known.empty() ? "" : ", ") + std::string(format.extension.substr(1));
  return Error{.file = file.string(),
               .reason = file.has_extension()
                             ? "no picture is written as \"" + file.extension().string() + "\""
                             : "the name has no extension, which decides the kind of picture",
               .remedy = "Give one of " + known};
}

Status writeImage(const render::Image& image, const fs::path& file) {
  if (Status named = checkImageName(file); !named.ok())
    return named;
  const Format& format = *formatOf(file);
  return writeBeside(file, [&](const fs::path& target) -> Status {
    const auto failed = [&target](const std::string& reason) {
      return Error{.file = target.string(),
                   .reason = "the picture cannot be written: " + reason,
                   .remedy = "Choose a folder with room that you may write to"};
    };
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format.writer);
    if (!output)
      return failed(OIIO::geterror());
    if (!output->open(target.string(), specFor(image, format)) ||
        !writeRows(*output, image, format) || !output->close())
      return failed(output->geterror());
    return Unit{};
  });
}

Result<std::string> pngBytes(const render::Image& image) {
  const Format& format = *formatOf("thumbnail.png");
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format.writer);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput target(bytes);
  if (!output || !output->set_ioproxy(&target) ||
      !output->open("thumbnail.png", specFor(image, format)) ||
      !writeRows(*output, image, format) || !output->close())
    return Error{.reason =
                     "the PNG cannot be made: " + (output ? output->geterror() : OIIO::geterror())};
  return std::string(bytes.begin(), bytes.end());
}

}  // namespace sline::cli
