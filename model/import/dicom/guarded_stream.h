// SPDX-License-Identifier: Apache-2.0
// Bytes in memory as DCMTK reads them, with bounds that its parser lacks.
#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcerror.h>
#include <dcmtk/dcmdata/dcistrma.h>

#include <string_view>

namespace sline::model {

/// DCMTK descends into sequences by recursion, as deep as a file says, and makes objects of a few
/// hundred bytes from elements of eight. This producer watches the stack from whose frames it is
/// called and counts how often it is, and ends the reading with an error where either grows beyond
/// what any sound file needs.
class GuardedBytes : public DcmProducer {
 public:
  enum class Fault { none, nestedTooDeep, tooManyElements, putBackTooFar };

  explicit GuardedBytes(std::string_view bytes);

  OFBool good() const override { return m_fault == Fault::none; }
  OFCondition status() const override { return good() ? EC_Normal : EC_CorruptedData; }
  OFBool eos() override { return m_at == m_bytes.size(); }
  offile_off_t avail() override { return good() ? offile_off_t(m_bytes.size() - m_at) : 0; }
  offile_off_t read(void* buffer, offile_off_t size) override;
  offile_off_t skip(offile_off_t size) override;
  void putback(offile_off_t size) override;

  Fault fault() const { return m_fault; }
  /// How many bytes have been read.
  std::size_t position() const { return m_at; }

 private:
  void watch();

  std::string_view m_bytes;
  std::size_t m_at = 0;
  const char* m_stack;
  std::size_t m_reads = 0;
  Fault m_fault = Fault::none;
};

/// A stream of them; the producer must outlive it. Values are read at once.
class GuardedStream : public DcmInputStream {
 public:
  explicit GuardedStream(GuardedBytes& bytes) : DcmInputStream(&bytes) {}
  DcmInputStreamFactory* newFactory() const override { return nullptr; }
};

}  // namespace sline::model
