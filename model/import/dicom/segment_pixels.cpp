// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/segment_pixels.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/import/readers/values.h"

namespace sline::model {

namespace {

constexpr Tag frameCount{0x0028, 0x0008};
constexpr Tag rowCount{0x0028, 0x0010};
constexpr Tag columnCount{0x0028, 0x0011};
constexpr Tag bitsAllocated{0x0028, 0x0100};
constexpr Tag segmentationType{0x0062, 0x0001};
constexpr Tag greatestFraction{0x0062, 0x000e};
constexpr Tag pixelData{0x7fe0, 0x0010};
constexpr std::size_t runHeader = 64;
/// No scanner makes larger slices; a packed file could ask for them.
constexpr std::uint64_t largestFrame = std::uint64_t(64) << 20;

/// Bits from `first` on, the lowest of a byte first; most bytes of a mask are 0.
void unpackBits(std::string_view bytes, std::size_t first, std::vector<std::uint8_t>& inside) {
  for (std::size_t i = 0; i < inside.size();) {
    const std::size_t at = first + i;
    const auto byte = static_cast<unsigned char>(bytes[at / 8]);
    const std::size_t count = std::min(8 - at % 8, inside.size() - i);
    for (std::size_t k = 0; byte != 0 && k < count; ++k)
      inside[i + k] = (byte >> (at % 8 + k)) & 1u;
    if (byte == 0)
      std::fill_n(inside.begin() + std::ptrdiff_t(i), count, std::uint8_t(0));
    i += count;
  }
}

}  // namespace

Result<SegmentPixels> SegmentPixels::open(const DicomFile& file) {
  SegmentPixels pixels(file);
  if (const std::optional<Error> error = pixels.readSizes())
    return *error;
  const DataElement* data = file.data().find(pixelData);
  if (!data)
    return file.source().whole("the segmentation has no pixel data", "Export it again");
  if (file.pixelCoding() == PixelCoding::other)
    return file.source().whole("its pixel data is compressed in a way that is not read",
                               "Export it uncompressed, deflated or run-length coded");
  if (file.pixelCoding() == PixelCoding::runLength) {
    if (const std::optional<Error> error = pixels.readCoded(*data))
      return *error;
    return pixels;
  }
  pixels.m_native = data->value;
  const std::size_t perByte = pixels.m_bits ? 8 : 1;
  // No product of sizes can run over: each is below 2^32, and their count below what fits the file.
  if (pixels.m_frames > data->value.size() * perByte / pixels.frameSize())
    return file.data().bytes().at(data->value.data(),
                                  "the pixel data has " + std::to_string(data->value.size()) +
                                      " bytes, too few for " + std::to_string(pixels.m_frames) +
                                      " frames of " + std::to_string(pixels.m_columns) + " × " +
                                      std::to_string(pixels.m_rows) + " pixels");
  return pixels;
}

std::optional<Error> SegmentPixels::readSizes() {
  const DataSet& data = m_file->data();
  const auto columns = data.number(columnCount);
  const auto rows = data.number(rowCount);
  const auto frames = data.integer(frameCount);
  if (!columns || !rows || *columns == 0 || *rows == 0 || *columns > 0xffff || *rows > 0xffff)
    return m_file->source().whole("the segmentation does not say how many rows and columns it has",
                                  "Export it again");
  if (std::uint64_t(*columns) * *rows > largestFrame)
    return m_file->source().whole("its frames have " + std::to_string(*columns) + " × " +
                                      std::to_string(*rows) + " pixels, too many for a slice",
                                  "Export it at the images' own resolution");
  m_columns = int(*columns);
  m_rows = int(*rows);
  m_frames = std::size_t(std::max<std::int64_t>(frames.value_or(1), 0));
  const std::uint32_t bits = data.number(bitsAllocated).value_or(0);
  const bool fractional = data.text(segmentationType) == "FRACTIONAL";
  if (bits != 8 && (bits != 1 || fractional))
    return m_file->source().whole(
        "its pixels have " + std::to_string(bits) + " bits; masks have 1 or 8",
        "Export it as a binary segmentation");
  m_bits = bits == 1;
  const std::uint32_t greatest = data.number(greatestFraction).value_or(255);
  m_inside = fractional ? std::uint8_t(std::clamp((greatest + 1) / 2, 1u, 255u)) : 1;
  return std::nullopt;
}

std::optional<Error> SegmentPixels::readCoded(const DataElement& data) {
  Result<std::vector<std::string_view>> fragments = fragmentsOf(m_file->data().bytes(), data);
  if (!fragments)
    return fragments.error();
  if (!data.undefined || fragments->size() != m_frames + 1)
    return m_file->data().bytes().at(data.value.data(),
                                     "there are not as many pieces of run-length data as frames");
  fragments->erase(fragments->begin());
  m_coded = std::move(*fragments);
  return std::nullopt;
}

/// PS3.5 §G.3: a count n below 128 means n + 1 bytes as they are, one above 128 the next byte
/// 257 − n times.
Result<std::string> SegmentPixels::unpacked(std::string_view fragment) const {
  const auto damaged = [&] {
    return m_file->data().bytes().at(fragment.data(), "the run-length data of a frame is damaged");
  };
  if (fragment.size() < runHeader || loadAs<std::uint32_t>(fragment.data(), false) != 1)
    return damaged();
  const auto begin = loadAs<std::uint32_t>(fragment.data() + 4, false);
  if (begin < runHeader || begin > fragment.size())
    return damaged();
  const std::size_t wanted = m_bits ? (frameSize() + 7) / 8 : frameSize();
  // One pair of bytes stands for 128 at most.
  if (wanted / 128 > fragment.size())
    return damaged();
  std::string result;
  result.reserve(wanted);
  for (std::size_t at = begin; at + 1 < fragment.size() && result.size() < wanted;) {
    const auto count = static_cast<unsigned char>(fragment[at++]);
    const std::size_t room = wanted - result.size();
    if (count < 128) {
      const std::size_t bytes = std::min<std::size_t>(count + 1u, fragment.size() - at);
      result.append(fragment.substr(at, std::min(bytes, room)));
      at += bytes;
    } else if (count > 128) {
      result.append(std::min<std::size_t>(257u - count, room), fragment[at++]);
    }
  }
  if (result.size() < wanted)
    return damaged();
  return result;
}

Status SegmentPixels::mask(std::size_t frame, std::vector<std::uint8_t>& inside) const {
  inside.resize(frameSize());
  std::string_view bytes = m_native;
  std::size_t first = frame * frameSize();
  std::string buffer;
  if (!m_coded.empty()) {
    Result<std::string> frameBytes = unpacked(m_coded[frame]);
    if (!frameBytes)
      return frameBytes.error();
    buffer = std::move(*frameBytes);
    bytes = buffer;
    first = 0;
  }
  if (m_bits)
    unpackBits(bytes, first, inside);
  else
    for (std::size_t i = 0; i < inside.size(); ++i)
      inside[i] = static_cast<unsigned char>(bytes[first + i]) >= m_inside ? 1 : 0;
  return Unit{};
}

}  // namespace sline::model
