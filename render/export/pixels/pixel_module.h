// SPDX-License-Identifier: Apache-2.0
// Declares what the program's module for pictures offers: it writes TIFF, EXR, JPEG and JPEG 2000,
// and reads all kinds. It is built on OpenImageIO. The many libraries of that take ten times longer
// to load than the whole program, so they are loaded only when a picture needs them, and exports of
// vectors start without.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "render/export/pixels/pixel_kind.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

/// Receives a file's bytes, in any order.
class ByteTarget {
 public:
  virtual ~ByteTarget() = default;
  virtual Status write(std::uint64_t at, std::string_view bytes) = 0;
  virtual Status close() = 0;
};

/// Holds what is stored in a file beside its pixels.
struct PixelMarks {
  std::string software;
  std::string profile;  ///< ICC
  std::string xmp;  ///< used where the kind of file has no other place for the credit; may be empty
};

/// Limits how much reading a picture may take.
struct PictureLimits {
  std::uint64_t pixels = 100'000'000;
  std::uint64_t fileBytes = 1'000'000'000;
};

class PixelModule {
 public:
  virtual ~PixelModule() = default;
  /// Returns a file of TIFF, EXR, JPEG or JPEG 2000; see `rowFile`.
  virtual Result<std::unique_ptr<RowFile>> rows(PixelKind kind, const PixelLayout& layout,
                                                const PixelMarks& marks,
                                                std::unique_ptr<ByteTarget> target) const = 0;
  /// Returns the picture that the file's bytes hold, whatever the file is called. Errors name no
  /// file.
  virtual Result<PixelRows> read(std::string_view bytes, const PictureLimits& limits) const = 0;
};

/// Returns the module, which is loaded at the first call. It lies beside the program, or in
/// ../lib/sline from there. If it or something that it needs is absent, the error says what to
/// install.
Result<const PixelModule*> pixelModule();

/// The function that the module exports under this name; it returns null for a program of another
/// version.
using PixelModuleEntry = const PixelModule* (*)(const char* programVersion);
inline constexpr const char* pixelModuleEntryName = "slinePixelModule";

}  // namespace sline::render
