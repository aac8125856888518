// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/vtk/vtp_blocks.h"

#include <vtkDataCompressor.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include "model/import/readers/vtk/vtk_messages.h"
#include "model/import/source/base64.h"

namespace sline::model {

namespace {
/// This is more than any of VTK's compressors reaches on its blocks (zlib ends near 1032, LZ4 at
/// 255).
constexpr std::uint64_t bestCompression = 2000;

vtkSmartPointer<vtkDataCompressor> compressorNamed(std::string_view name) {
  if (name == "vtkZLibDataCompressor")
    return vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (name == "vtkLZ4DataCompressor")
    return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (name == "vtkLZMADataCompressor")
    return vtkSmartPointer<vtkLZMADataCompressor>::New();
  return nullptr;
}

/// Returns the first `count` words of a block header.
std::optional<std::vector<std::uint64_t>> words(const VtpEncoding& encoding,
                                                const VtpContent& content, std::uint64_t count) {
  if (count > content.text.size() / sizeOf(encoding.word))
    return std::nullopt;
  const std::size_t bytes = std::size_t(count) * sizeOf(encoding.word);
  std::string_view source = content.text;
  std::optional<std::string> decoded;
  if (content.base64) {
    decoded = decodeBase64Prefix(source, bytes);
    if (!decoded)
      return std::nullopt;
    source = *decoded;
  }
  std::vector<std::uint64_t> result;
  BinaryValues values(source.data(), source.data() + bytes, encoding.order);
  for (std::uint64_t i = 0; i < count; ++i) {
    std::int64_t word = 0;
    values.integer(encoding.word, word);
    result.push_back(std::uint64_t(word));
  }
  return result;
}

std::optional<std::uint64_t> plainBytes(const VtpEncoding& encoding, const VtpContent& content) {
  const auto header = words(encoding, content, 1);
  const std::uint64_t left = content.base64 ? content.text.size() / 4 * 3 + 3 : content.text.size();
  if (!header || (*header)[0] > left)
    return std::nullopt;
  return (*header)[0];
}

/// Holds the header: number of blocks, bytes of a block, bytes of the last one (0: as the others),
/// and the compressed bytes of each block.
struct BlockHeader {
  std::uint64_t blocks = 0;
  std::uint64_t size = 0;
  std::uint64_t last = 0;
  std::vector<std::uint64_t> packed;

  std::uint64_t unpacked(std::uint64_t block) const {
    return block + 1 == blocks && last != 0 ? last : size;
  }
  std::uint64_t total() const {
    return blocks == 0 ? 0 : (blocks - 1) * size + unpacked(blocks - 1);
  }
};

std::optional<BlockHeader> blockHeader(const VtpEncoding& encoding, const VtpContent& content) {
  const auto start = words(encoding, content, 1);
  if (!start || (*start)[0] > content.text.size())
    return std::nullopt;
  BlockHeader header;
  header.blocks = (*start)[0];
  if (header.blocks == 0)
    return header;
  const auto all = words(encoding, content, 3 + header.blocks);
  if (!all)
    return std::nullopt;
  header.size = (*all)[1];
  header.last = (*all)[2];
  header.packed.assign(all->begin() + 3, all->end());
  std::uint64_t sum = 0;
  for (std::uint64_t i = 0; i < header.blocks; ++i) {
    const std::uint64_t bytes = header.packed[std::size_t(i)];
    if (bytes > content.text.size() || header.unpacked(i) > (bytes + 16) * bestCompression)
      return std::nullopt;
    sum += bytes;
  }
  if (sum > content.text.size() || header.last > header.size)
    return std::nullopt;
  return header;
}

/// Returns `count` stored bytes that begin `skip` bytes into the content, or `skip` characters into
/// base64.
std::optional<std::string> stored(const VtpContent& content, std::size_t skip,
                                  std::uint64_t count) {
  if (skip > content.text.size() || count > content.text.size())
    return std::nullopt;
  const std::string_view rest = content.text.substr(skip);
  if (content.base64)
    return decodeBase64Prefix(rest, std::size_t(count));
  return count <= rest.size() ? std::optional<std::string>(rest.substr(0, std::size_t(count)))
                              : std::nullopt;
}

/// Returns all blocks, decompressed.
std::optional<std::string> unpacked(const VtpEncoding& encoding, const VtpContent& content,
                                    const BlockHeader& header) {
  const std::size_t bytes = std::size_t(3 + header.blocks) * sizeOf(encoding.word);
  std::uint64_t sum = 0;
  for (const std::uint64_t size : header.packed)
    sum += size;
  // The header is encoded by itself, with its own padding.
  const std::optional<std::string> packed =
      stored(content, content.base64 ? (bytes + 2) / 3 * 4 : bytes, sum);
  const vtkSmartPointer<vtkDataCompressor> compressor = compressorNamed(encoding.compressor);
  if (!packed || !compressor)
    return std::nullopt;
  std::string result;
  std::string block;
  const VtkMessages messages;
  std::uint64_t at = 0;
  for (std::uint64_t i = 0; i < header.blocks; ++i) {
    const std::uint64_t size = header.packed[std::size_t(i)];
    block.resize(std::size_t(header.unpacked(i)));
    // The blocks are unpacked one by one, so that a false promise costs no more than one block.
    if (compressor->Uncompress(reinterpret_cast<const unsigned char*>(packed->data()) + at,
                               std::size_t(size), reinterpret_cast<unsigned char*>(block.data()),
                               block.size()) != block.size())
      return std::nullopt;
    result += block;
    at += size;
  }
  return result;
}
}  // namespace

bool isKnownCompressor(std::string_view name) {
  return compressorNamed(name) != nullptr;
}

std::optional<std::uint64_t> valuesIn(const VtpEncoding& encoding, const VtpContent& content) {
  if (content.ascii)
    return (content.text.size() + 1) / 2;
  // An array without values may have no header at all.
  if (content.text.empty())
    return 0;
  if (encoding.compressor.empty()) {
    const std::optional<std::uint64_t> bytes = plainBytes(encoding, content);
    return bytes ? std::optional(*bytes / sizeOf(content.type)) : std::nullopt;
  }
  const std::optional<BlockHeader> header = blockHeader(encoding, content);
  return header ? std::optional(header->total() / sizeOf(content.type)) : std::nullopt;
}

std::optional<std::string> bytesOf(const VtpEncoding& encoding, const VtpContent& content,
                                   std::uint64_t count) {
  const std::uint64_t wanted = count * sizeOf(content.type);
  if (wanted == 0)
    return std::string();
  if (encoding.compressor.empty()) {
    // Header and values are one base64 text.
    std::optional<std::string> all = stored(content, 0, sizeOf(encoding.word) + wanted);
    if (all)
      all->erase(0, sizeOf(encoding.word));
    return all;
  }
  const std::optional<BlockHeader> header = blockHeader(encoding, content);
  if (!header || header->total() < wanted)
    return std::nullopt;
  return unpacked(encoding, content, *header);
}

}  // namespace sline::model
