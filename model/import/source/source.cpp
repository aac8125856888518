// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/source.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>

#include "model/base/letters.h"
#include "model/import/source/packed_bytes.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {
struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

constexpr const char* exportAgain = "Export the mesh again from the program that made it";

std::optional<Error> refusal(const std::filesystem::path& file) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(file, code);
  if (status.type() == std::filesystem::file_type::not_found)
    return Error{file.string(), {}, "there is no such file", "Check the name"};
  if (status.type() == std::filesystem::file_type::directory)
    return Error{file.string(), {}, "is a folder, not a mesh file", "Name a file inside it"};
  if (status.type() == std::filesystem::file_type::none)
    return Error{file.string(), {}, "cannot be opened: " + code.message(), "Check its permissions"};
  if (status.type() != std::filesystem::file_type::regular)
    return Error{file.string(), {}, "is a device or pipe, not a file", "Copy the data to a file"};
  return std::nullopt;
}
}  // namespace

Result<Source> Source::read(const std::filesystem::path& file, const ReadLimits& limits) {
  Result<Source> source = readStored(file, limits);
  if (!source || !beginsLikeGzip(source->text()) ||
      !equalsIgnoringCase(file.extension().string(), ".gz"))
    return source;
  TRY(source->unpack());
  return source;
}

Status Source::unpack() {
  const std::size_t most =
      std::size_t(std::min<std::uint64_t>(m_limits.fileBytes, mostOfSurface(m_size)));
  PackedBytes packed(text(), Packing::deflated);
  std::unique_ptr<char[]> bytes;
  std::size_t size = 0;
  // One byte more than is allowed shows that there is more.
  for (std::size_t room = std::min(most + 1, 8 * m_size + 4096); true;
       room = std::min(most + 1, 2 * room)) {
    std::unique_ptr<char[]> larger(new (std::nothrow) char[room]);
    if (!larger)
      return whole("needs " + std::to_string(room) + " bytes of memory when unpacked",
                   "Close other programs");
    std::copy_n(bytes.get(), size, larger.get());
    bytes = std::move(larger);
    size += packed.read(bytes.get() + size, room - size);
    if (packed.broken() || packed.cutOff())
      return whole(packed.broken() ? "its packed bytes are damaged: they cannot be unpacked beyond "
                                     "byte " +
                                         std::to_string(size)
                                   : "its packed bytes end in the middle",
                   "Copy the file again");
    if (size > most)
      return whole("unpacks to more than " + std::to_string(most) + " bytes, the limit for " +
                       std::to_string(m_size) + " packed ones",
                   "Unpack it with another program first, or reduce the mesh");
    if (size < room)
      break;
  }
  if (size == 0)
    return whole("holds nothing when unpacked");
  m_bytes = std::move(bytes);
  m_size = size;
  return Unit{};
}

Result<Source> Source::readStored(const std::filesystem::path& file, const ReadLimits& limits,
                                  std::size_t most) {
  if (std::optional<Error> error = refusal(file))
    return *error;
  const std::string name = file.string();
  const std::unique_ptr<std::FILE, Closer> handle(std::fopen(name.c_str(), "rb"));
  if (!handle)
    return Error{name,
                 {},
                 std::string("cannot be opened: ") + std::strerror(errno),
                 "Check its permissions"};
  std::error_code code;
  const std::uintmax_t fileSize = std::filesystem::file_size(file, code);
  if (code)
    return Error{name, {}, "its size cannot be found: " + code.message(), "Check the disk"};
  if (fileSize == 0)
    return Error{name, {}, "is empty", exportAgain};
  const std::uintmax_t size = std::min<std::uintmax_t>(fileSize, most);
  if (size > limits.fileBytes)
    return Error{
        name,
        {},
        "has " + std::to_string(size) + " bytes, the limit is " + std::to_string(limits.fileBytes),
        "Reduce the mesh"};
  Source source;
  source.m_bytes.reset(new (std::nothrow) char[std::size_t(size)]);
  if (!source.m_bytes)
    return Error{
        name, {}, "needs " + std::to_string(size) + " bytes of memory", "Close other programs"};
  source.m_size = std::fread(source.m_bytes.get(), 1, std::size_t(size), handle.get());
  if (source.m_size != size)
    return Error{name, "byte " + std::to_string(source.m_size), "cannot be read any further",
                 "Check the disk or copy the file again"};
  source.m_file = name;
  source.m_limits = limits;
  return source;
}

Error Source::whole(std::string reason, std::string remedy) const {
  return at({}, std::move(reason), std::move(remedy));
}

Error Source::atLine(const char* place, std::string reason, std::string remedy) const {
  const char* stop = std::clamp(place, begin(), end());
  auto line = std::count(begin(), stop, '\n');
  if (line == 0)  // old Macintosh files end their lines with a carriage return alone
    line = std::count(begin(), stop, '\r');
  return at("line " + std::to_string(line + 1), std::move(reason), std::move(remedy));
}

Error Source::atByte(const char* place, std::string reason, std::string remedy) const {
  return at("byte " + std::to_string(std::clamp(place, begin(), end()) - begin()),
            std::move(reason), std::move(remedy));
}

Error Source::at(std::string where, std::string reason, std::string remedy) const {
  return Error{m_file, std::move(where), std::move(reason),
               remedy.empty() ? exportAgain : std::move(remedy)};
}

std::optional<Frame> frameInText(std::string_view text) {
  constexpr std::string_view key = "SPACE=";
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    const std::string_view name = text.substr(at + key.size(), 3);
    if (name == "LPS")
      return Frame::lps;
    if (name == "RAS")
      return Frame::ras;
  }
  return std::nullopt;
}

std::string inQuotes(std::string_view word) {
  std::string line = "'";
  for (const char c : word.substr(0, 40))
    line += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  return line + (word.size() > 40 ? "…'" : "'");
}

}  // namespace sline::model
