// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/packed_pixels.h"

#include <algorithm>
#include <utility>

#include "model/import/source/values.h"

namespace sline::model {

namespace {

constexpr std::size_t runHeader = 64;
constexpr std::size_t mostPlanes = 15;
constexpr bool littleSwapped = std::endian::native != std::endian::little;

}  // namespace

std::string joined(Fragments fragments) {
  std::string all;
  for (const std::string_view fragment : fragments)
    all += fragment;
  return all;
}

void unpackBits(std::string_view bytes, std::size_t first, std::vector<std::uint16_t>& values) {
  for (std::size_t i = 0; i < values.size();) {
    const std::size_t at = first + i;
    const auto byte = static_cast<unsigned char>(bytes[at / 8]);
    const std::size_t count = std::min(8 - at % 8, values.size() - i);
    // Most bytes of a mask are 0.
    for (std::size_t k = 0; byte != 0 && k < count; ++k)
      values[i + k] = (byte >> (at % 8 + k)) & 1u;
    if (byte == 0)
      std::fill_n(values.begin() + std::ptrdiff_t(i), count, std::uint16_t(0));
    i += count;
  }
}

std::optional<std::string> unpackedRuns(std::string_view frame, std::size_t plane,
                                        std::size_t wanted) {
  // The header holds the number of planes, and where each begins; a pair of bytes stands for 128 at
  // most.
  const auto word = [&](std::size_t at) {
    return loadAs<std::uint32_t>(&frame[4 * at], littleSwapped);
  };
  if (frame.size() < runHeader || plane >= mostPlanes || plane >= word(0) ||
      wanted / 128 > frame.size())
    return std::nullopt;
  const std::size_t begin = word(1 + plane);
  if (begin < runHeader || begin > frame.size())
    return std::nullopt;
  std::string result;
  result.reserve(wanted);
  // PS3.5 §G.3: a count n below 128 means n + 1 bytes as they are, one above 128 the next byte
  // 257 − n times.
  for (std::size_t at = begin; at + 1 < frame.size() && result.size() < wanted;) {
    const auto count = static_cast<unsigned char>(frame[at++]);
    const std::size_t room = wanted - result.size();
    if (count < 128) {
      const std::size_t bytes = std::min<std::size_t>(count + 1u, frame.size() - at);
      result.append(frame.substr(at, std::min(bytes, room)));
      at += bytes;
    } else if (count > 128) {
      result.append(std::min<std::size_t>(257u - count, room), frame[at++]);
    }
  }
  return result.size() == wanted ? std::optional(std::move(result)) : std::nullopt;
}

bool hasJpegSize(std::string_view stream, const glm::ivec2& size) {
  const auto byte = [&](std::size_t at) { return int(static_cast<unsigned char>(stream[at])); };
  // Marker segments (ITU T.81 §B.1.1.4) up to the frame header, SOF: 0xC0 … 0xCF without the
  // tables among them; 0xF7 in JPEG-LS.
  for (std::size_t at = 2; at + 9 <= stream.size();) {
    const int marker = byte(at + 1);
    if (byte(at) != 0xff)
      return false;
    if (marker == 0xff) {
      ++at;
      continue;
    }
    const bool table = marker == 0xc4 || marker == 0xc8 || marker == 0xcc;
    if ((marker >= 0xc0 && marker <= 0xcf && !table) || marker == 0xf7)
      return size ==
             glm::ivec2(256 * byte(at + 7) + byte(at + 8), 256 * byte(at + 5) + byte(at + 6));
    at += 2 + std::size_t(256 * byte(at + 2) + byte(at + 3));
  }
  return false;
}

}  // namespace sline::model
