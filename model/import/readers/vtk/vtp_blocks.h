// SPDX-License-Identifier: Apache-2.0
// Reads the stored form of one array in VTK's XML formats: text, or blocks behind a header,
// compressed or not, as bytes or base64 ("VTK File Formats", vtk.org).
#pragma once

#include <bit>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/source/values.h"

namespace sline::model {

/// Holds what the file says of all its arrays.
struct VtpEncoding {
  std::endian order = std::endian::little;
  ScalarType word = ScalarType::uint32;  ///< type of numbers in block headers
  std::string compressor;                ///< VTK's class name, empty for none
};

/// Describes one array. `text` may reach beyond its end: headers tell how long it is.
struct VtpContent {
  std::string_view text;
  ScalarType type = ScalarType::int8;
  bool ascii = false;
  bool base64 = false;
};

bool isKnownCompressor(std::string_view name);

/// Returns how many values the array holds at most, or nothing where its block header is broken or
/// promises more than `text` can hold, by the best ratio the compressors reach.
std::optional<std::uint64_t> valuesIn(const VtpEncoding& encoding, const VtpContent& content);

/// Returns the first `count` values of an array that is not text, as stored, or nothing where they
/// cannot be decoded.
std::optional<std::string> bytesOf(const VtpEncoding& encoding, const VtpContent& content,
                                   std::uint64_t count);

}  // namespace sline::model
