// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/jpeg_2000.h"

#include <openjpeg.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>

#include "model/import/source/values.h"

namespace sline::model {

namespace {

struct CodestreamBytes {
  std::string_view bytes;
  std::size_t at = 0;
};

OPJ_SIZE_T readStream(void* buffer, OPJ_SIZE_T size, void* user) {
  auto& from = *static_cast<CodestreamBytes*>(user);
  const std::size_t count = std::min<std::size_t>(size, from.bytes.size() - from.at);
  if (count == 0)
    return OPJ_SIZE_T(-1);
  std::memcpy(buffer, from.bytes.data() + from.at, count);
  from.at += count;
  return count;
}

OPJ_OFF_T skipStream(OPJ_OFF_T size, void* user) {
  auto& from = *static_cast<CodestreamBytes*>(user);
  if (size < 0 || std::uint64_t(size) > from.bytes.size() - from.at)
    return -1;
  from.at += std::size_t(size);
  return size;
}

OPJ_BOOL seekStream(OPJ_OFF_T place, void* user) {
  auto& from = *static_cast<CodestreamBytes*>(user);
  if (place < 0 || std::uint64_t(place) > from.bytes.size())
    return OPJ_FALSE;
  from.at = std::size_t(place);
  return OPJ_TRUE;
}

struct DestroyCodec {
  void operator()(opj_codec_t* codec) const { opj_destroy_codec(codec); }
};
struct DestroyStream {
  void operator()(opj_stream_t* stream) const { opj_stream_destroy(stream); }
};
struct DestroyImage {
  void operator()(opj_image_t* image) const { opj_image_destroy(image); }
};

/// A bare codestream begins with SOC and SIZ, as DICOM prescribes; some are in a JP2 file.
constexpr std::string_view codestreamBegins = "\xff\x4f\xff\x51";

OPJ_CODEC_FORMAT formatOf(std::string_view stream) {
  return stream.starts_with(codestreamBegins) ? OPJ_CODEC_J2K : OPJ_CODEC_JP2;
}

/// Tells whether the number of tiles suits the image. The head (SIZ, §A.5.1) may promise 65,535 of
/// them, and OpenJPEG takes some kilobytes for each before it can be asked anything; an image of
/// this size has no use for so many.
bool hasFewTiles(std::string_view stream, const glm::ivec2& size) {
  constexpr std::size_t ends = 8;    // two numbers, from the codestream's beginning
  constexpr std::size_t tiles = 24;  // two more
  const std::size_t begin = stream.find(codestreamBegins);
  if (begin == std::string_view::npos || stream.size() - begin < tiles + 8)
    return false;
  const auto number = [&](std::size_t at) {
    return std::uint64_t(
        loadAs<std::uint32_t>(&stream[begin + at], std::endian::native != std::endian::big));
  };
  const std::uint64_t across = number(ends) / std::max<std::uint64_t>(number(tiles), 1) + 1;
  const std::uint64_t down = number(ends + 4) / std::max<std::uint64_t>(number(tiles + 4), 1) + 1;
  const std::uint64_t most = 16 + std::uint64_t(size.x) * std::uint64_t(size.y) / 256;
  return across <= most && down <= most / across;
}

bool isOneGreyPlane(const opj_image_t& image, const glm::ivec2& size) {
  if (image.numcomps != 1)
    return false;
  const opj_image_comp_t& plane = image.comps[0];
  return plane.w == OPJ_UINT32(size.x) && plane.h == OPJ_UINT32(size.y) && plane.prec >= 1 &&
         plane.prec <= 16;
}

}  // namespace

std::optional<std::string> decodeJpeg2000(std::string_view stream, const glm::ivec2& size,
                                          std::vector<std::uint16_t>& values) {
  if (!hasFewTiles(stream, size))
    return "it has no head of an image of this size";
  CodestreamBytes bytes{stream};
  const std::unique_ptr<opj_codec_t, DestroyCodec> codec(opj_create_decompress(formatOf(stream)));
  const std::unique_ptr<opj_stream_t, DestroyStream> input(opj_stream_default_create(OPJ_TRUE));
  if (!codec || !input)
    return "out of memory";
  opj_stream_set_user_data(input.get(), &bytes, nullptr);
  opj_stream_set_user_data_length(input.get(), stream.size());
  opj_stream_set_read_function(input.get(), readStream);
  opj_stream_set_skip_function(input.get(), skipStream);
  opj_stream_set_seek_function(input.get(), seekStream);
  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  opj_image_t* made = nullptr;
  if (!opj_setup_decoder(codec.get(), &parameters) ||
      !opj_read_header(input.get(), codec.get(), &made))
    return "its header cannot be read";
  const std::unique_ptr<opj_image_t, DestroyImage> image(made);
  if (!isOneGreyPlane(*image, size))
    return "it does not hold the frame's rows and columns in grey values";
  if (!opj_decode(codec.get(), input.get(), image.get()) ||
      !opj_end_decompress(codec.get(), input.get()))
    return "it ends early or is broken";
  const opj_image_comp_t& plane = image->comps[0];
  if (!isOneGreyPlane(*image, size) || !plane.data)
    return "it has no pixels";
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::uint16_t(plane.data[i]);
  return std::nullopt;
}

}  // namespace sline::model
