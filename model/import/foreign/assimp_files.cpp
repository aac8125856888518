// SPDX-License-Identifier: Apache-2.0
#include "model/import/foreign/assimp_files.h"

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstring>
#include <memory>
#include <optional>

#include "model/import/source/file_in_folder.h"

namespace sline::model {

namespace {

/// Reads from bytes in memory, which it may own.
class BytesStream : public Assimp::IOStream {
 public:
  explicit BytesStream(std::string_view bytes) : m_bytes(bytes) {}
  explicit BytesStream(Source source) : m_owned(std::move(source)), m_bytes(m_owned->text()) {}

  std::size_t Read(void* to, std::size_t size, std::size_t count) override {
    if (size == 0)
      return 0;
    const std::size_t whole = std::min(count, (m_bytes.size() - m_at) / size);
    std::memcpy(to, m_bytes.data() + m_at, whole * size);
    m_at += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t from = origin == aiOrigin_SET ? 0 : m_at;
    if (offset > m_bytes.size() || (origin == aiOrigin_CUR && offset > m_bytes.size() - from))
      return aiReturn_FAILURE;
    m_at = origin == aiOrigin_END ? m_bytes.size() - offset : from + offset;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return m_at; }
  std::size_t FileSize() const override { return m_bytes.size(); }
  void Flush() override {}

 private:
  std::optional<Source> m_owned;
  std::string_view m_bytes;
  std::size_t m_at = 0;
};

/// Returns the file of the name as the file has it: assimp puts the folder in front of some.
std::optional<std::filesystem::path> allowed(const Source& source, const char* name) {
  const std::filesystem::path folder = std::filesystem::path(source.file()).parent_path();
  const std::filesystem::path path(name);
  const std::filesystem::path below =
      folder.empty() ? path.lexically_normal() : path.lexically_proximate(folder);
  return fileInFolder(source.file(), below.string());
}

}  // namespace

bool AssimpFiles::Exists(const char* name) const {
  if (m_source.file() == name)
    return true;
  const std::optional<std::filesystem::path> path = allowed(m_source, name);
  std::error_code code;
  return path && std::filesystem::is_regular_file(*path, code);
}

Assimp::IOStream* AssimpFiles::Open(const char* name, const char* mode) {
  if (std::strchr(mode, 'r') == nullptr)
    return nullptr;
  if (m_source.file() == name)
    return std::make_unique<BytesStream>(m_source.text()).release();
  const std::optional<std::filesystem::path> path = allowed(m_source, name);
  if (!path)
    return nullptr;
  Result<Source> read = Source::read(*path, m_source.limits());
  return read ? std::make_unique<BytesStream>(std::move(*read)).release() : nullptr;
}

void AssimpFiles::Close(Assimp::IOStream* stream) {
  const std::unique_ptr<Assimp::IOStream> taken(stream);
}

}  // namespace sline::model
