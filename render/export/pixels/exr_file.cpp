// SPDX-License-Identifier: Apache-2.0
// EXR through the OpenEXR library: halves, deflated, of which no decoder is without.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "model/files/whole_file.h"
#include "render/export/pixels/row_file.h"

namespace sline::render {

namespace {

/// Where the library writes to, here and there. It knows only exceptions; what was in the way stays
/// known.
class ExrStream : public Imf::OStream {
 public:
  ExrStream(model::GrowingFile& file, const std::string& name)
      : Imf::OStream(name.c_str()), m_file(file) {}

  void write(const char bytes[], int count) override {
    const std::string_view all(bytes, std::size_t(count));
    const std::size_t over = std::min<std::size_t>(all.size(), m_file.size() - m_at);
    if (over > 0)
      check(m_file.replace(m_at, all.substr(0, over)));
    if (over < all.size())
      check(m_file.add(all.substr(over)));
    m_at += all.size();
  }
  std::uint64_t tellp() override { return m_at; }
  void seekp(std::uint64_t at) override {
    if (at > m_file.size())
      throw std::out_of_range("a place behind the end");
    m_at = at;
  }

  const std::optional<Error>& failure() const { return m_failure; }

 private:
  void check(const Status& done) {
    if (done.ok())
      return;
    if (!m_failure)
      m_failure = done.error();
    throw std::runtime_error(done.error().reason);
  }

  model::GrowingFile& m_file;
  std::uint64_t m_at = 0;
  std::optional<Error> m_failure;
};

class ExrFile : public RowFile {
 public:
  ExrFile(const PixelLayout& layout, std::filesystem::path path,
          std::unique_ptr<model::GrowingFile> file)
      : m_layout(layout),
        m_path(std::move(path)),
        m_file(std::move(file)),
        m_stream(*m_file, m_path.string()) {}

  Status open() {
    return translated([this] {
      // The library's threads are the program's: whoever comes first has them made.
      const auto cores = int(std::max(1u, std::thread::hardware_concurrency()));
      if (Imf::globalThreadCount() == 0)
        Imf::setGlobalThreadCount(cores);
      m_output = std::make_unique<Imf::OutputFile>(m_stream, header(), cores);
    });
  }

  Status add(std::span<const std::byte> rows) override {
    const std::size_t length = m_layout.rowBytes();
    const auto count = int(rows.size() / length);
    if (count == 0)
      return Unit{};
    const auto channels = std::size_t(m_layout.channels);
    m_halves.resize(std::size_t(count) * std::size_t(m_layout.width) * channels);
    for (std::size_t i = 0; i < m_halves.size(); ++i) {
      float value = 0.0f;
      std::memcpy(&value, rows.data() + i * sizeof value, sizeof value);
      m_halves[i] = half(value);
    }
    return translated([&] {
      const std::size_t pixel = channels * sizeof(half);
      Imf::FrameBuffer buffer;
      for (std::size_t i = 0; i < channels; ++i)
        buffer.insert(channelNames()[i],
                      Imf::Slice::Make(Imf::HALF, m_halves.data() + i, {0, m_row}, m_layout.width,
                                       count, pixel, pixel * std::size_t(m_layout.width)));
      m_output->setFrameBuffer(buffer);
      m_output->writePixels(count);
      m_row += count;
    });
  }

  Status finish() override {
    // Writes the table of where its blocks are, and says nothing where that fails.
    m_output.reset();
    if (m_stream.failure())
      return *m_stream.failure();
    return m_file->close();
  }

 private:
  std::array<const char*, 4> channelNames() const {
    if (m_layout.isGrey())
      return {"Y", "A", "", ""};
    return {"R", "G", "B", "A"};
  }

  Imf::Header header() const {
    Imf::Header header(m_layout.width, m_layout.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (std::size_t i = 0; i < std::size_t(m_layout.channels); ++i)
      header.channels().insert(channelNames()[i], Imf::Channel(Imf::HALF));
    Imf::addChromaticities(header, Imf::Chromaticities());  // those of sRGB
    if (m_layout.dpi > 0.0f)
      Imf::addXDensity(header, m_layout.dpi);
    header.insert("Software", Imf::StringAttribute("Sline " SLINE_VERSION));
    if (!m_layout.credit.author.empty())
      header.insert("Artist", Imf::StringAttribute(m_layout.credit.author));
    if (!m_layout.credit.copyright.empty())
      Imf::addOwner(header, m_layout.credit.copyright);
    return header;
  }

  template <class Call>
  Status translated(const Call& call) {
    try {
      call();
      return Unit{};
    } catch (const std::exception& exception) {
      if (m_stream.failure())
        return *m_stream.failure();
      return Error{.file = m_path.string(),
                   .reason = std::string("the picture cannot be written: ") + exception.what(),
                   .remedy = "Choose a folder with room that you may write to"};
    }
  }

  PixelLayout m_layout;
  std::filesystem::path m_path;
  std::unique_ptr<model::GrowingFile> m_file;
  ExrStream m_stream;
  std::unique_ptr<Imf::OutputFile> m_output;  ///< goes before the stream does
  std::vector<half> m_halves;
  int m_row = 0;
};

}  // namespace

Result<std::unique_ptr<RowFile>> exrRows(const PixelLayout& layout,
                                         const std::filesystem::path& file) {
  Result<std::unique_ptr<model::GrowingFile>> growing = model::GrowingFile::create(file);
  if (!growing.ok())
    return growing.error();
  auto rows = std::make_unique<ExrFile>(layout, file, std::move(*growing));
  if (Status opened = rows->open(); !opened.ok())
    return opened.error();
  return std::unique_ptr<RowFile>(std::move(rows));
}

}  // namespace sline::render
