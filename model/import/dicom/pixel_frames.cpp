// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/pixel_frames.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdatset.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "model/import/dicom/jpeg_2000.h"
#include "model/import/dicom/packed_pixels.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {

constexpr Tag samplesPerPixel{0x0028, 0x0002};
constexpr Tag frameCount{0x0028, 0x0008};
constexpr Tag rowCount{0x0028, 0x0010};
constexpr Tag columnCount{0x0028, 0x0011};
constexpr Tag bitsAllocated{0x0028, 0x0100};
/// No scanner makes larger slices; a packed file could ask for them.
constexpr std::uint64_t largestFrame = std::uint64_t(64) << 20;
/// Blank frames pack a thousandfold: any file may have so many pixels, and so many more for each
/// byte.
constexpr std::uint64_t packedPixelsOfAny = std::uint64_t(256) << 20;
constexpr std::uint64_t packedPixelsPerByte = 64;
constexpr const char* exportPixelsAgain =
    "Copy or export the file again; it is incomplete or damaged";

DcmPixelData* pixelElement(const DicomFile& file) {
  DcmElement* element = nullptr;
  if (file.dataset().findAndGetElement({pixelData.group, pixelData.element}, element).bad())
    return nullptr;
  return dynamic_cast<DcmPixelData*>(element);
}

/// Returns the pieces of encapsulated pixel data (PS3.5 §A.4), the offset table first.
std::vector<std::string_view> fragmentsOf(DcmPixelData& pixels) {
  std::vector<std::string_view> fragments;
  E_TransferSyntax syntax = EXS_Unknown;
  const DcmRepresentationParameter* parameter = nullptr;
  pixels.getOriginalRepresentationKey(syntax, parameter);
  DcmPixelSequence* sequence = nullptr;
  if (pixels.getEncapsulatedRepresentation(syntax, parameter, sequence).bad() || !sequence)
    return fragments;
  for (DcmObject* object = sequence->nextInContainer(nullptr); object;
       object = sequence->nextInContainer(object)) {
    auto* item = dynamic_cast<DcmPixelItem*>(object);
    Uint8* bytes = nullptr;
    if (item && item->getUint8Array(bytes).good() && bytes)
      fragments.emplace_back(reinterpret_cast<const char*>(bytes), item->getLength());
    else
      fragments.emplace_back();
  }
  return fragments;
}

}  // namespace

Result<PixelFrames> PixelFrames::open(const DicomFile& file) {
  PixelFrames pixels(file);
  TRY(pixels.readSizes());
  if (!file.data().has(pixelData))
    return file.source().whole("it has no pixel data", "Export it again");
  TRY(file.pixelCoding() == PixelCoding::native ? pixels.openNative() : pixels.openPacked());
  return pixels;
}

Status PixelFrames::readSizes() {
  const DataSet& data = m_file->data();
  const auto columns = data.number(columnCount);
  const auto rows = data.number(rowCount);
  if (!columns || !rows || *columns == 0 || *rows == 0 || *columns > 0xffff || *rows > 0xffff)
    return m_file->source().whole("it does not say how many rows and columns it has",
                                  "Export it again");
  if (std::uint64_t(*columns) * *rows > largestFrame)
    return m_file->source().whole("its frames have " + std::to_string(*columns) + " × " +
                                      std::to_string(*rows) + " pixels, too many for a slice",
                                  "Export it at the images' own resolution");
  m_columns = int(*columns);
  m_rows = int(*rows);
  m_frames = std::size_t(std::max<std::int64_t>(data.integer(frameCount).value_or(1), 0));
  if (data.number(samplesPerPixel).value_or(1) != 1)
    return m_file->source().whole("its pixels are colours, not single values",
                                  "Export the images in grey values");
  m_bits = int(std::min(data.number(bitsAllocated).value_or(0), 0xffffu));
  if (m_bits != 1 && m_bits != 8 && m_bits != 16)
    return m_file->source().whole(
        "its pixels have " + std::to_string(m_bits) + " bits; 1, 8 and 16 are read",
        "Export it with pixels of 8 or 16 bits");
  return Unit{};
}

std::size_t PixelFrames::frameBytes() const {
  return m_bits == 1 ? (frameSize() + 7) / 8 : frameSize() * std::size_t(m_bits / 8);
}

Status PixelFrames::openNative() {
  DcmPixelData* pixels = pixelElement(*m_file);
  Uint8* bytes = nullptr;
  if (pixels && pixels->getUint8Array(bytes).good() && bytes)
    m_native = {reinterpret_cast<const char*>(bytes), pixels->getLength()};
  // No product of sizes can overflow: each is below 2^32, and their count below what fits the file.
  const std::size_t pixelsThere = m_native.size() * 8 / std::size_t(m_bits);
  if (m_frames > pixelsThere / frameSize())
    return m_file->source().whole("the pixel data has " + std::to_string(m_native.size()) +
                                      " bytes, too few for " + std::to_string(m_frames) +
                                      " frames of " + std::to_string(m_columns) + " × " +
                                      std::to_string(m_rows) + " pixels",
                                  exportPixelsAgain);
  return Unit{};
}

Status PixelFrames::openPacked() {
  if (m_file->pixelCoding() == PixelCoding::other)
    return m_file->source().whole("its pixel data is compressed in a way that is not read",
                                  "Export it uncompressed, or as JPEG, JPEG-LS or JPEG 2000");
  if (m_frames > (packedPixelsOfAny + packedPixelsPerByte * m_file->source().size()) / frameSize())
    return m_file->source().whole(
        "its " + std::to_string(m_frames) + " packed frames have more pixels than are read",
        "Export it in parts, or uncompressed");
  DcmPixelData* pixels = pixelElement(*m_file);
  return groupFragments(pixels ? fragmentsOf(*pixels) : std::vector<std::string_view>());
}

/// Groups the fragments into frames. A frame may be cut into several fragments; then the offset
/// table says where each frame begins.
Status PixelFrames::groupFragments(const std::vector<std::string_view>& fragments) {
  if (fragments.size() == m_frames + 1) {
    for (std::size_t i = 1; i < fragments.size(); ++i)
      m_coded.push_back({fragments[i]});
  } else if (fragments.size() > 1 && m_frames == 1) {
    m_coded.emplace_back(fragments.begin() + 1, fragments.end());
  } else if (fragments.size() > m_frames && fragments[0].size() == 4 * m_frames) {
    std::uint64_t offset = 0;
    for (std::size_t i = 1; i < fragments.size(); ++i) {
      const std::size_t next = m_coded.size();
      if (next < m_frames &&
          offset == loadAs<std::uint32_t>(&fragments[0][4 * next],
                                          std::endian::native != std::endian::little))
        m_coded.emplace_back();
      if (!m_coded.empty())
        m_coded.back().push_back(fragments[i]);
      offset += 8 + fragments[i].size();
    }
  }
  if (m_coded.size() != m_frames)
    return m_file->source().whole("there are not as many pieces of packed pixel data as frames",
                                  exportPixelsAgain);
  return Unit{};
}

Error PixelFrames::damaged(std::size_t index, const std::string& why) const {
  return m_file->source().at(
      "frame " + std::to_string(index + 1),
      "its packed pixel data is damaged" + (why.empty() ? "" : " (" + why + ")"),
      exportPixelsAgain);
}

void PixelFrames::unpack(std::string_view bytes, std::size_t firstPixel,
                         std::vector<std::uint16_t>& values) const {
  if (m_bits == 1) {
    unpackBits(bytes, firstPixel, values);
  } else if (m_bits == 8) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<unsigned char>(bytes[firstPixel + i]);
  } else {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = loadAs<std::uint16_t>(&bytes[2 * (firstPixel + i)],
                                        std::endian::native != std::endian::little);
  }
}

Status PixelFrames::byRuns(std::size_t index, std::vector<std::uint16_t>& values) const {
  const std::string all = joined(m_coded[index]);
  const std::size_t planes = m_bits == 16 ? 2 : 1;
  std::string bytes;
  for (std::size_t plane = 0; plane < planes; ++plane) {
    const std::optional<std::string> one = unpackedRuns(all, plane, frameBytes() / planes);
    if (!one)
      return damaged(index);
    if (planes == 1)
      unpack(*one, 0, values);
    for (std::size_t i = 0; planes == 2 && i < values.size(); ++i)
      values[i] =
          std::uint16_t((plane == 0 ? 0 : values[i] << 8) | static_cast<unsigned char>((*one)[i]));
  }
  return Unit{};
}

/// Unpacks JPEG and JPEG-LS.
Status PixelFrames::byLibrary(std::size_t index, std::vector<std::uint16_t>& values) const {
  if (!hasJpegSize(m_coded[index].front(), {m_columns, m_rows}))
    return damaged(index, "it does not hold the frame's rows and columns");
  DcmPixelData* pixels = pixelElement(*m_file);
  std::vector<std::uint16_t> buffer((frameBytes() + 1) / 2);
  OFString colours;
  Uint32 firstFragment = 0;
  const OFCondition done =
      pixels->getUncompressedFrame(&m_file->dataset(), Uint32(index), firstFragment, buffer.data(),
                                   Uint32(2 * buffer.size()), colours);
  if (done.bad())
    return damaged(index, done.text());
  const std::string_view bytes(reinterpret_cast<const char*>(buffer.data()), 2 * buffer.size());
  if (m_bits == 16)
    values = std::move(buffer);
  else
    unpack(bytes, 0, values);
  return Unit{};
}

Status PixelFrames::frame(std::size_t index, std::vector<std::uint16_t>& values) const {
  values.resize(frameSize());
  switch (m_file->pixelCoding()) {
    case PixelCoding::jpeg2000:
      if (const std::optional<std::string> why =
              decodeJpeg2000(joined(m_coded[index]), {m_columns, m_rows}, values))
        return damaged(index, *why);
      return Unit{};
    case PixelCoding::runLength:
      return byRuns(index, values);
    case PixelCoding::jpeg:
      return byLibrary(index, values);
    default:
      unpack(m_native, index * frameSize(), values);
      return Unit{};
  }
}

}  // namespace sline::model
