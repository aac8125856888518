// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/image_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "model/files/whole_file.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<std::string_view, PixelKind>, 6> extensions{
    {{".png", PixelKind::png},
     {".tiff", PixelKind::tiff},
     {".tif", PixelKind::tiff},
     {".exr", PixelKind::exr},
     {".jpg", PixelKind::jpeg},
     {".jpeg", PixelKind::jpeg}}};

std::optional<PixelKind> kindOf(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
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
          .channels = kind == PixelKind::jpeg || opaque(image) ? 3 : 4,
          .bits = kind == PixelKind::exr ? 32 : 8};
}

Status addAll(RowFile& file, const Image& image, const PixelLayout& layout) {
  const int most = std::max(1, 4'000'000 / std::max(image.width, 1));
  for (int top = 0; top < image.height; top += most) {
    const PixelRows rows = rowsOf(image, top, std::min(most, image.height - top));
    if (Status added = file.add(packed(rows, layout)); !added.ok())
      return added;
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
    if (Status finished = m_png->finish(); !finished.ok())
      return finished;
    return m_file->close();
  }

 private:
  std::unique_ptr<model::GrowingFile> m_file;
  std::unique_ptr<RowFile> m_png;
};

}  // namespace

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
  if (kind == PixelKind::tiff)
    return tiffRows(layout, file);
  if (kind == PixelKind::exr)
    return exrRows(layout, file);
  if (kind == PixelKind::jpeg)
    return jpegRows(layout, file);
  Result<std::unique_ptr<model::GrowingFile>> growing = model::GrowingFile::create(file);
  if (!growing.ok())
    return growing.error();
  return std::unique_ptr<RowFile>(std::make_unique<PngRowFile>(layout, std::move(*growing)));
}

Status writeImage(const Image& image, const fs::path& file) {
  if (Status named = checkImageName(file); !named.ok())
    return named;
  const PixelKind kind = *kindOf(file);
  const PixelLayout layout = layoutFor(image, kind);
  return model::writeBeside(file, [&](const fs::path& target) -> Status {
    const Result<std::unique_ptr<RowFile>> rows = rowFile(kind, layout, target);
    return rows.ok() ? addAll(**rows, image, layout) : Status(rows.error());
  });
}

Result<std::string> pngBytes(const Image& image) {
  std::string bytes;
  const PixelLayout layout = layoutFor(image, PixelKind::png);
  const std::unique_ptr<RowFile> rows = pngRows(layout, [&bytes](std::string_view more) -> Status {
    bytes += more;
    return Unit{};
  });
  if (Status made = addAll(*rows, image, layout); !made.ok())
    return made.error();
  return bytes;
}

}  // namespace sline::render
