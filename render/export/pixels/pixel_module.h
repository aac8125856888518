// SPDX-License-Identifier: Apache-2.0
// What the program's module for pictures offers: TIFF, EXR, JPEG and JPEG 2000 are written, and all
// kinds read. It stands on OpenImageIO, whose many libraries take ten times longer to load than the
// whole program: so they are loaded when a picture needs them, and whoever draws vectors starts
// without.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "render/export/pixels/pixel_rows.h"
#include "render/export/pixels/pixel_kind.h"

namespace sline::render {

/// Takes a file's bytes, in any order.
class ByteTarget {
 public:
  virtual ~ByteTarget() = default;
  virtual Status write(std::uint64_t at, std::string_view bytes) = 0;
  virtual Status close() = 0;
};

/// What stands in a file beside its pixels.
struct PixelMarks {
  std::string software;
  std::string profile;  ///< ICC
  std::string xmp;      ///< where the kind of file has no other place for the credit; may be empty
};

/// How much reading a picture may take.
struct PictureLimits {
  std::uint64_t pixels = 100'000'000;
  std::uint64_t fileBytes = 1'000'000'000;
};

class PixelModule {
 public:
  virtual ~PixelModule() = default;
  /// A file of TIFF, EXR, JPEG or JPEG 2000; see `rowFile`.
  virtual Result<std::unique_ptr<RowFile>> rows(PixelKind kind, const PixelLayout& layout,
                                                const PixelMarks& marks,
                                                std::unique_ptr<ByteTarget> target) const = 0;
  /// The picture that the file's bytes are, whatever the file is called. Errors say no file.
  virtual Result<PixelRows> read(std::string_view bytes, const PictureLimits& limits) const = 0;
};

/// The module, loaded at the first call. It lies beside the program, or in ../lib/sline from there.
/// Where it is absent, or what it needs, the error says what to install.
Result<const PixelModule*> pixelModule();

/// What the module exports under this name; null for a program of another version.
using PixelModuleEntry = const PixelModule* (*)(const char* programVersion);
inline constexpr const char* pixelModuleEntryName = "slinePixelModule";

}  // namespace sline::render
