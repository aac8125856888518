// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/image_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "model/base/letters.h"
#include "model/disk/whole_file.h"
#include "render/export/encoding/colour_profile.h"
#include "render/export/encoding/xmp_packet.h"
#include "render/export/pixels/pixel_module.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<std::string_view, PixelKind>, 8> extensions{
    {{".png", PixelKind::png},
     {".tiff", PixelKind::tiff},
     {".tif", PixelKind::tiff},
     {".exr", PixelKind::exr},
     {".jpg", PixelKind::jpeg},
     {".jpeg", PixelKind::jpeg},
     {".webp", PixelKind::webp},
     {".jp2", PixelKind::jp2}}};

std::optional<PixelKind> kindOf(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  const auto found = std::find_if(extensions.begin(), extensions.end(),
                                  [&](const auto& known) { return known.first == extension; });
  return found == extensions.end() ? std::nullopt : std::optional(found->second);
}

bool opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255)
      return false;
  return true;
}

PixelLayout layoutFor(const Image& image, PixelKind kind) {
  return {.width = image.width,
          .height = image.height,
          .channels = !traitsOf(kind).alpha || opaque(image) ? 3 : 4,
          .bits = kind == PixelKind::exr ? 32 : 8};
}

Status addAll(RowFile& file, const Image& image, const PixelLayout& layout) {
  const int most = std::max(1, 4'000'000 / std::max(image.width, 1));
  for (int top = 0; top < image.height; top += most) {
    const PixelRows rows = rowsOf(image, top, std::min(most, image.height - top));
    TRY(file.add(packed(rows, layout)));
  }
  return file.finish();
}

/// A PNG that grows in a file, which it closes.
class PngRowFile : public RowFile {
 public:
  PngRowFile(const PixelLayout& layout, std::unique_ptr<model::GrowingFile> file)
      : m_file(std::move(file)),
        m_png(pngRows(layout, [this](std::string_view bytes) { return m_file->add(bytes); })) {}

  Status add(std::span<const std::byte> rows) override { return m_png->add(rows); }
  Status finish() override {
    TRY(m_png->finish());
    return m_file->close();
  }

 private:
  std::unique_ptr<model::GrowingFile> m_file;
  std::unique_ptr<RowFile> m_png;
};

/// A file that the module writes to.
class GrowingTarget : public ByteTarget {
 public:
  explicit GrowingTarget(std::unique_ptr<model::GrowingFile> file) : m_file(std::move(file)) {}

  Status write(std::uint64_t at, std::string_view bytes) override {
    // Writers go back to write what they know only in the end, and leave a byte out so that the
    // next part begins at an even place.
    if (at > m_file->size())
      TRY(m_file->add(std::string(at - m_file->size(), '\0')));
    const std::size_t over = std::min<std::uint64_t>(bytes.size(), m_file->size() - at);
    if (over > 0)
      TRY(m_file->replace(at, bytes.substr(0, over)));
    return over < bytes.size() ? m_file->add(bytes.substr(over)) : Status(Unit{});
  }
  Status close() override { return m_file->close(); }

 private:
  std::unique_ptr<model::GrowingFile> m_file;
};

/// Writes through the module; its errors name the file.
class ModuleRowFile : public RowFile {
 public:
  ModuleRowFile(std::unique_ptr<RowFile> rows, fs::path file)
      : m_rows(std::move(rows)), m_file(std::move(file)) {}

  Status add(std::span<const std::byte> rows) override { return named(m_rows->add(rows)); }
  Status finish() override { return named(m_rows->finish()); }

 private:
  Status named(Status status) const {
    if (status.ok())
      return status;
    Error error = status.error();
    error.file = m_file.string();
    return error;
  }

  std::unique_ptr<RowFile> m_rows;
  fs::path m_file;
};

Result<std::unique_ptr<RowFile>> moduleRows(PixelKind kind, const PixelLayout& layout,
                                            const fs::path& file) {
  const PixelModule* const module = TRY(pixelModule());
  std::unique_ptr<model::GrowingFile> growing = TRY(model::GrowingFile::create(file));
  Result<std::unique_ptr<RowFile>> rows =
      module->rows(kind, layout,
                   {.software = "Sline " SLINE_VERSION,
                    .profile = layout.isGrey() ? greyProfile() : srgbProfile(),
                    .xmp = xmpPacket(layout.credit)},
                   std::make_unique<GrowingTarget>(std::move(growing)));
  if (!rows.ok()) {
    Error error = rows.error();
    error.file = file.string();
    return error;
  }
  return std::unique_ptr<RowFile>(std::make_unique<ModuleRowFile>(std::move(*rows), file));
}

}  // namespace

PixelTraits traitsOf(PixelKind kind) {
  // Pixels of kinds that are packed as a whole, which takes up to 35 bytes for each.
  constexpr double mostPacked = 100e6;
  switch (kind) {
    case PixelKind::png:
    case PixelKind::tiff:
      return {.ink = true, .deep = true};
    case PixelKind::exr:
      return {};
    case PixelKind::jpeg:
      return {.alpha = false};
    case PixelKind::webp:
      return {.grey = false, .largestSide = 16383, .mostPixels = mostPacked};
    case PixelKind::jp2:
      return {.deep = true, .mostPixels = mostPacked};
  }
  return {};
}

Status checkImageName(const fs::path& file) {
  if (kindOf(file))
    return Unit{};
  std::string known;
  for (const auto& [extension, kind] : extensions)
    known += (known.empty() ? "" : ", ") + std::string(extension.substr(1));
  return Error{.file = file.string(),
               .reason = file.has_extension()
                             ? "no picture is written as \"" + file.extension().string() + "\""
                             : "the name has no extension, which decides the kind of picture",
               .remedy = "Give one of " + known};
}

Result<std::unique_ptr<RowFile>> rowFile(PixelKind kind, const PixelLayout& layout,
                                         const fs::path& file) {
  if (kind == PixelKind::webp)
    return webpRows(layout, file);
  if (kind != PixelKind::png)
    return moduleRows(kind, layout, file);
  std::unique_ptr<model::GrowingFile> growing = TRY(model::GrowingFile::create(file));
  return std::unique_ptr<RowFile>(std::make_unique<PngRowFile>(layout, std::move(growing)));
}

Status writeImage(const Image& image, const fs::path& file) {
  TRY(checkImageName(file));
  const PixelKind kind = *kindOf(file);
  const PixelLayout layout = layoutFor(image, kind);
  return model::writeBeside(file, [&](const fs::path& target) -> Status {
    const Result<std::unique_ptr<RowFile>> rows = rowFile(kind, layout, target);
    return rows.ok() ? addAll(**rows, image, layout) : Status(rows.error());
  });
}

}  // namespace sline::render
