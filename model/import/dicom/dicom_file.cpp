// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdatset.h>
#include <dcmtk/dcmdata/dcistrma.h>
#include <dcmtk/dcmdata/dcmetinf.h>
#include <dcmtk/dcmdata/dcxfer.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "model/import/dicom/toolkit.h"

namespace sline::model {

namespace {

constexpr std::string_view deflated = "1.2.840.10008.1.2.1.99";
constexpr Tag sopClassUid{0x0008, 0x0016};
constexpr Tag metaSopClass{0x0002, 0x0002};
constexpr Tag transferSyntax{0x0002, 0x0010};
/// The elements before this one say which scanner's series it is: they nearly always lie within the
/// first kilobytes.
constexpr Tag behindSeries{0x0020, 0x0010};
constexpr std::size_t beginningRead = std::size_t(1) << 16;
constexpr const char* sendAgain = "Copy or export the file again; it is incomplete or damaged";

PixelCoding codingOf(const std::string& syntax) {
  struct Row {
    std::string_view syntax;  ///< or the beginning of one
    PixelCoding coding;
  };
  constexpr std::array rows{Row{"1.2.840.10008.1.2.5", PixelCoding::runLength},
                            Row{"1.2.840.10008.1.2.4.5", PixelCoding::jpeg},
                            Row{"1.2.840.10008.1.2.4.70", PixelCoding::jpeg},
                            Row{"1.2.840.10008.1.2.4.8", PixelCoding::jpeg},
                            Row{"1.2.840.10008.1.2.4.90", PixelCoding::jpeg2000},
                            Row{"1.2.840.10008.1.2.4.91", PixelCoding::jpeg2000},
                            Row{"1.2.840.10008.1.2.4.20", PixelCoding::jpeg2000},
                            Row{"1.2.840.10008.1.2.4.", PixelCoding::other},
                            Row{"1.2.840.10008.1.2.1.98", PixelCoding::other}};
  for (const Row& row : rows)
    if (syntax.starts_with(row.syntax))
      return row.coding;
  return PixelCoding::native;
}

/// Standard objects nest six deep; this is room for a few hundred levels, and an eighth of a
/// thread's stack.
constexpr std::size_t mostStack = std::size_t(1) << 20;
/// About five million elements: the largest plans have a tenth of that.
constexpr std::size_t mostReads = 20'000'000;

/// Returns an address in the caller's frame.
[[gnu::noinline]] const char* stackHere() {
  return static_cast<const char*>(__builtin_frame_address(0));
}

/// Guards DCMTK's reading. DCMTK descends into sequences by recursion, as deep as a file says, and
/// makes objects of a few hundred bytes from elements of eight. This producer watches the stack of
/// its callers and counts how often it is called, and ends the reading with an error where either
/// grows beyond what any sound file needs.
class GuardedBytes : public DcmProducer {
 public:
  enum class Fault { none, nestedTooDeep, tooManyElements, putBackTooFar };

  explicit GuardedBytes(std::string_view bytes);

  OFBool good() const override { return m_fault == Fault::none; }
  OFCondition status() const override { return good() ? EC_Normal : EC_CorruptedData; }
  OFBool eos() override { return isAtEnd(); }
  offile_off_t avail() override { return good() ? offile_off_t(m_bytes.size() - m_at) : 0; }
  offile_off_t read(void* buffer, offile_off_t size) override;
  offile_off_t skip(offile_off_t size) override;
  void putback(offile_off_t size) override;

  Fault fault() const { return m_fault; }
  /// Returns how many bytes have been read.
  std::size_t position() const { return m_at; }
  std::string_view rest() const { return m_bytes.substr(m_at); }
  bool isAtEnd() const { return m_at == m_bytes.size(); }

 private:
  void watch();

  std::string_view m_bytes;
  std::size_t m_at = 0;
  const char* m_stack;
  std::size_t m_reads = 0;
  Fault m_fault = Fault::none;
};

/// Opens the bytes again where a long value stands, once that value is asked for. They must outlive
/// the elements.
class BytesFrom : public DcmInputStreamFactory {
 public:
  explicit BytesFrom(std::string_view rest) : m_rest(rest) {}
  DcmInputStream* create() const override;
  DcmInputStreamFactory* clone() const override { return new BytesFrom(*this); }
  DcmInputStreamFactoryType ident() const override { return DFT_DcmInputFileStreamFactory; }

 private:
  std::string_view m_rest;
};

/// Is a stream of guarded bytes. Long values are passed over and read when they are asked for: a
/// stream that cannot be opened again would have their memory allocated by the length that the file
/// promises, up to 4 GB, before the bytes are found missing.
class GuardedStream : public DcmInputStream {
 public:
  explicit GuardedStream(std::string_view bytes) : DcmInputStream(&m_bytes), m_bytes(bytes) {}
  DcmInputStreamFactory* newFactory() const override { return new BytesFrom(m_bytes.rest()); }
  const GuardedBytes& bytes() const { return m_bytes; }

 private:
  GuardedBytes m_bytes;
};

DcmInputStream* BytesFrom::create() const {
  return new GuardedStream(m_rest);
}

GuardedBytes::GuardedBytes(std::string_view bytes) : m_bytes(bytes), m_stack(stackHere()) {}

void GuardedBytes::watch() {
  const char* here = stackHere();
  const auto used = std::size_t(here < m_stack ? m_stack - here : here - m_stack);
  if (used > mostStack)
    m_fault = Fault::nestedTooDeep;
  else if (++m_reads > mostReads)
    m_fault = Fault::tooManyElements;
}

offile_off_t GuardedBytes::read(void* buffer, offile_off_t size) {
  watch();
  const offile_off_t count = std::clamp<offile_off_t>(size, 0, avail());
  if (count > 0)
    std::memcpy(buffer, m_bytes.data() + m_at, std::size_t(count));
  m_at += std::size_t(count);
  return count;
}

offile_off_t GuardedBytes::skip(offile_off_t size) {
  watch();
  const offile_off_t count = std::clamp<offile_off_t>(size, 0, avail());
  m_at += std::size_t(count);
  return count;
}

void GuardedBytes::putback(offile_off_t size) {
  if (size < 0 || std::size_t(size) > m_at)
    m_fault = Fault::putBackTooFar;
  else
    m_at -= std::size_t(size);
}

/// Returns in words what went wrong in reading; `end` says that all bytes had been read.
std::string reasonFor(const GuardedBytes& bytes, const OFCondition& condition, bool end) {
  switch (bytes.fault()) {
    case GuardedBytes::Fault::nestedTooDeep:
      return "its sequences are nested too deep";
    case GuardedBytes::Fault::tooManyElements:
      return "it has more elements than any sound file";
    default:
      break;
  }
  if (end || condition == EC_StreamNotifyClient || condition == EC_EndOfStream)
    return "the file ends within an element, or an element promises more bytes than are left";
  return std::string("its elements are damaged (") + condition.text() + ")";
}

}  // namespace

Result<std::string> DicomFile::unpacked(std::string_view packed) const {
  // Masks deflate to little, but no file may ask for a large machine.
  const std::size_t limit = (std::size_t(128) << 20) + 32 * packed.size();
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
    return m_source.whole("cannot be unpacked: out of memory", "Close other programs");
  std::string result;
  std::vector<char> block(std::size_t(1) << 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  int state = Z_OK;
  std::size_t rest = packed.size();
  while (state == Z_OK && result.size() <= limit) {
    const auto portion = uInt(std::min<std::size_t>(rest, std::size_t(1) << 30));
    stream.avail_in = portion;
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = uInt(block.size());
    state = inflate(&stream, Z_NO_FLUSH);
    rest -= portion - stream.avail_in;
    result.append(block.data(), block.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (result.size() > limit)
    return m_source.whole("its deflated data grows beyond " + std::to_string(limit) + " bytes",
                          "Export it without compression");
  if (state != Z_STREAM_END)
    return m_source.at("byte " + std::to_string(m_source.size() - rest),
                       "the deflated data ends early or is damaged", "Copy the file again");
  return result;
}

Status DicomFile::parseData(std::string_view text, const std::string& syntax, Extent extent) {
  // Kinds that are younger than the library pack their pixels, and all of those are written in this
  // syntax.
  E_TransferSyntax kind = EXS_LittleEndianExplicit;
  if (syntax.empty())
    kind = EXS_Unknown;
  else if (const DcmXfer known(syntax.c_str());
           syntax != deflated && known.getXfer() != EXS_Unknown)
    kind = known.getXfer();
  m_dataset = std::make_shared<DcmDataset>();
  GuardedStream stream(text);
  const GuardedBytes& bytes = stream.bytes();
  const DcmTagKey end = extent == Extent::beginning
                            ? DcmTagKey(behindSeries.group, behindSeries.element)
                            : DCM_UndefinedTagKey;
  m_dataset->transferInit();
  const OFCondition done =
      m_dataset->readUntilTag(stream, kind, EGL_noChange, DCM_MaxReadLength, end);
  m_dataset->transferEnd();
  const bool whole = extent == Extent::beginning || bytes.isAtEnd();
  if (done.bad() || !bytes.good() || !whole) {
    const std::size_t at = text.data() >= m_source.begin() && text.data() <= m_source.end()
                               ? std::size_t(text.data() - m_source.begin()) + bytes.position()
                               : bytes.position();
    return m_source.at(
        "byte " + std::to_string(at) + (syntax == deflated ? " of the unpacked data" : ""),
        reasonFor(bytes, done, bytes.isAtEnd()), sendAgain);
  }
  m_data = DataSet(*m_dataset);
  return Unit{};
}

Result<DicomFile> DicomFile::parsed(Source source, Extent extent) {
  setUpToolkit();
  DicomFile file(std::move(source));
  const std::string_view text = file.m_source.text();
  if (!beginsLikeDicom(text))
    return file.m_source.whole(
        "is not a DICOM file: neither 'DICM' nor an element stands where it should",
        "Give the file the extension of its kind");
  GuardedStream stream(text);
  const GuardedBytes& bytes = stream.bytes();
  DcmMetaInfo meta;
  meta.transferInit();
  const OFCondition done = meta.read(stream, EXS_Unknown, EGL_noChange, DCM_MaxReadLength);
  meta.transferEnd();
  if ((done.bad() && done != EC_EndOfStream) || !bytes.good())
    return file.m_source.at("byte " + std::to_string(bytes.position()),
                            reasonFor(bytes, done, bytes.isAtEnd()), sendAgain);
  const DataSet header(meta);
  const std::string syntax = header.text(transferSyntax);
  std::string_view rest = text.substr(bytes.position());
  if (syntax == deflated) {
    std::string data = TRY(file.unpacked(rest));
    file.m_inflated = std::make_unique<const std::string>(std::move(data));
    rest = *file.m_inflated;
  }
  TRY(file.parseData(rest, syntax, extent));
  file.m_sopClass = file.m_data.text(sopClassUid);
  if (file.m_sopClass.empty())
    file.m_sopClass = header.text(metaSopClass);
  file.m_pixelCoding = codingOf(syntax);
  return file;
}

Result<DicomFile> DicomFile::read(const std::filesystem::path& file, const ReadLimits& limits) {
  Source source = TRY(Source::readStored(file, limits));
  return parsed(std::move(source), Extent::whole);
}

Result<DicomFile> DicomFile::readBeginning(const std::filesystem::path& file,
                                           const ReadLimits& limits) {
  Source source = TRY(Source::readStored(file, limits, beginningRead));
  Result<DicomFile> beginning = parsed(std::move(source), Extent::beginning);
  return beginning ? std::move(beginning) : read(file, limits);
}

}  // namespace sline::model
