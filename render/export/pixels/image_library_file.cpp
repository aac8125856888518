// SPDX-License-Identifier: Apache-2.0
// EXR and JPEG through OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <string_view>
#include <vector>

#include "model/files/whole_file.h"
#include "render/export/pixels/colour_profile.h"
#include "render/export/pixels/row_file.h"

namespace sline::render {

namespace {

class ImageLibraryFile : public RowFile {
 public:
  ImageLibraryFile(PixelKind kind, const PixelLayout& layout, std::filesystem::path file)
      : m_kind(kind), m_layout(layout), m_file(std::move(file)) {}

  Status open() {
    m_output = OIIO::ImageOutput::create(m_kind == PixelKind::exr ? "openexr" : "jpeg");
    if (!m_output)
      return failed(OIIO::geterror());
    if (m_kind == PixelKind::jpeg) {
      // Where the disk is full, libjpeg would end the program: it gets memory to write to.
      const Result<std::unique_ptr<model::GrowingFile>> file = model::GrowingFile::create(m_file);
      if (!file.ok())
        return file.error();
      if (!m_output->set_ioproxy(&m_memory))
        return failed(m_output->geterror());
    }
    return m_output->open(m_file.string(), spec()) ? Status(Unit{})
                                                   : Status(failed(m_output->geterror()));
  }

  Status add(std::span<const std::byte> rows) override {
    const std::size_t length = m_layout.rowBytes();
    const OIIO::TypeDesc type = m_layout.bits == 32 ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    for (std::size_t at = 0; at + length <= rows.size(); at += length)
      if (!m_output->write_scanline(m_row++, 0, type, rows.data() + at))
        return failed(m_output->geterror());
    return Unit{};
  }

  Status finish() override {
    if (!m_output->close())
      return failed(m_output->geterror());
    if (m_kind != PixelKind::jpeg)
      return Unit{};
    const Result<std::unique_ptr<model::GrowingFile>> file = model::GrowingFile::create(m_file);
    if (!file.ok())
      return file.error();
    const std::string_view bytes(reinterpret_cast<const char*>(m_bytes.data()), m_bytes.size());
    if (Status written = (*file)->add(bytes); !written.ok())
      return written;
    return (*file)->close();
  }

 private:
  Error failed(const std::string& reason) const {
    return {.file = m_file.string(),
            .reason = "the picture cannot be written: " + reason,
            .remedy = "Choose a folder with room that you may write to"};
  }

  OIIO::ImageSpec spec() const {
    const bool exr = m_kind == PixelKind::exr;
    OIIO::ImageSpec spec(m_layout.width, m_layout.height, m_layout.channels,
                         exr ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    if (m_layout.isGrey()) {
      spec.channelnames[0] = "Y";
      if (m_layout.hasAlpha())
        spec.channelnames[1] = "A";
    }
    if (m_layout.hasAlpha())
      spec.alpha_channel = m_layout.channels - 1;
    spec.attribute("oiio:ColorSpace", exr ? "Linear" : "sRGB");
    if (exr) {
      spec.attribute("compression", "zip");
    } else {
      // Thin coloured lines do not survive colours at half the resolution.
      spec.attribute("Compression", "jpeg:95");
      spec.attribute("jpeg:subsampling", "4:4:4");
      const std::string profile = m_layout.isGrey() ? greyProfile() : srgbProfile();
      spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(profile.size())),
                     profile.data());
    }
    if (m_layout.dpi > 0.0f) {
      spec.attribute("XResolution", m_layout.dpi);
      spec.attribute("YResolution", m_layout.dpi);
      spec.attribute("ResolutionUnit", "in");
    }
    spec.attribute("Software", "Sline " SLINE_VERSION);
    if (!m_layout.credit.author.empty())
      spec.attribute("Artist", m_layout.credit.author);
    if (!m_layout.credit.copyright.empty())
      spec.attribute("Copyright", m_layout.credit.copyright);
    // Left to itself the writer puts in the time of day; a picture is to carry no date.
    spec.attribute("DateTime", "");
    return spec;
  }

  PixelKind m_kind;
  PixelLayout m_layout;
  std::filesystem::path m_file;
  std::vector<unsigned char> m_bytes;  ///< of a JPEG
  OIIO::Filesystem::IOVecOutput m_memory{m_bytes};
  std::unique_ptr<OIIO::ImageOutput> m_output;
  int m_row = 0;
};

}  // namespace

Result<std::unique_ptr<RowFile>> imageLibraryRows(PixelKind kind, const PixelLayout& layout,
                                                  const std::filesystem::path& file) {
  auto rows = std::make_unique<ImageLibraryFile>(kind, layout, file);
  if (Status opened = rows->open(); !opened.ok())
    return opened.error();
  return std::unique_ptr<RowFile>(std::move(rows));
}

}  // namespace sline::render
