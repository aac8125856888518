// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/character_sets.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcspchrs.h>
#include <iconv.h>

#include <array>
#include <optional>

namespace sline::model {

namespace {

constexpr unsigned char firstKana = 0xa1;
constexpr unsigned char lastKana = 0xdf;

/// Returns the number of bytes of the UTF-8 character at `at`; 0 where there is none.
std::size_t characterAt(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t size = first >= 0xf5   ? 0
                           : first >= 0xf0 ? 4
                           : first >= 0xe0 ? 3
                           : first >= 0xc2 ? 2
                           : first < 0x80  ? 1
                                           : 0;
  if (at + size > text.size())
    return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80)
      return 0;
  return size;
}

/// Returns sound UTF-8 without control characters.
std::string cleaned(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t size = characterAt(text, i);
    const bool control = c < 0x20 || c == 0x7f;
    const bool lateControl =
        c == 0xc2 && size == 2 && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (control)
      result += ' ';
    else if (size == 0 || lateControl)
      result += '?';
    else
      result += text.substr(i, size);
    i += size > 0 ? size : 1;
  }
  return result;
}

/// Converts Japanese with escape sequences. DCMTK asks glibc for sets that it knows by other names
/// only.
class Japanese {
 public:
  Japanese() : m_state(iconv_open("UTF-8", "ISO-2022-JP-2")) {}
  ~Japanese() {
    if (isOpen())
      iconv_close(m_state);
  }
  Japanese(const Japanese&) = delete;
  Japanese& operator=(const Japanese&) = delete;

  std::optional<std::string> converted(std::string_view text) {
    if (!isOpen())
      return std::nullopt;
    // Half-width katakana stand in the upper half (ISO-IR 13) and need no escape there.
    constexpr std::string_view katakanaAbove = "\x1b)I";
    std::string result;
    std::string run;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto c = static_cast<unsigned char>(text[i]);
      if (text.substr(i).starts_with(katakanaAbove)) {
        i += katakanaAbove.size() - 1;
      } else if (c < 0x80) {
        run += text[i];
      } else if (c < firstKana || c > lastKana || !flush(run, result)) {
        return std::nullopt;
      } else {
        // U+FF61 …
        const unsigned code = 0xff61u + (c - firstKana);
        result += {char(0xe0 | code >> 12), char(0x80 | ((code >> 6) & 0x3f)),
                   char(0x80 | (code & 0x3f))};
      }
    }
    return flush(run, result) ? std::optional(result) : std::nullopt;
  }

 private:
  // NOLINTNEXTLINE(performance-no-int-to-ptr): POSIX tells of a failure so.
  bool isOpen() const { return m_state != iconv_t(-1); }
  bool flush(std::string& run, std::string& result) {
    char* from = run.data();
    std::size_t left = run.size();
    while (left > 0) {
      std::array<char, 256> buffer{};
      char* to = buffer.data();
      std::size_t room = buffer.size();
      const std::size_t done = iconv(m_state, &from, &left, &to, &room);
      result.append(buffer.data(), buffer.size() - room);
      if (done == std::size_t(-1) && room == buffer.size())
        return false;
    }
    run.clear();
    return true;
  }

  iconv_t m_state;
};

std::optional<std::string> converted(std::string_view text, const std::string& charset) {
  if (charset.find("ISO 2022 IR 87") != std::string::npos ||
      charset.find("ISO 2022 IR 159") != std::string::npos)
    return Japanese().converted(text);
  DcmSpecificCharacterSet set;
  OFString result;
  if (set.selectCharacterSet(charset).bad() ||
      set.convertString(text.data(), text.size(), result, "\\").bad())
    return std::nullopt;
  return std::string(result.data(), result.size());
}

}  // namespace

std::string inUtf8(std::string_view text, const std::string& charset) {
  // Most names are ASCII, and broken UTF-8 is mended letter by letter.
  if (!charset.empty() && !charset.ends_with("ISO_IR 192"))
    if (const std::optional<std::string> known = converted(text, charset))
      return cleaned(*known);
  std::string plain(text);
  if (!charset.ends_with("ISO_IR 192"))
    for (char& c : plain)
      if (static_cast<unsigned char>(c) >= 0x80)
        c = '?';
  return cleaned(plain);
}

}  // namespace sline::model
