// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace sline::render {

std::string gzipped(std::string_view bytes) {
  constexpr int level = 9;
  constexpr int gzipWindow = 15 + 16;  // zlib's way to say gzip
  constexpr std::size_t step = std::size_t(1) << 30;
  z_stream stream{};
  deflateInit2(&stream, level, Z_DEFLATED, gzipWindow, 9, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, uLong(bytes.size())) + 64, '\0');
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  std::size_t room = out.size();
  int state = Z_OK;
  while (state == Z_OK) {
    const std::size_t given = std::min(bytes.size(), step);
    const std::size_t taken = std::min(room, step);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = uInt(given);
    stream.avail_out = uInt(taken);
    state = deflate(&stream, given == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    bytes.remove_prefix(given - stream.avail_in);
    room -= taken - stream.avail_out;
  }
  deflateEnd(&stream);
  out.resize(out.size() - room);
  return out;
}

}  // namespace sline::render
