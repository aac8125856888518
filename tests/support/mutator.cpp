// SPDX-License-Identifier: Apache-2.0
#include "tests/support/mutator.h"

namespace sline::test {

QByteArray Mutator::operator()(QByteArray bytes) {
  for (std::size_t edits = 1 + below(3); edits > 0 && !bytes.isEmpty(); --edits)
    edit(bytes);
  return bytes;
}

void Mutator::edit(QByteArray& bytes) {
  constexpr std::size_t common = 5;
  const auto place = [&] { return qsizetype(below(std::size_t(bytes.size()))); };
  const qsizetype at = place();
  const auto length = qsizetype(below(16)) + 1;
  switch (const std::size_t kind = below(common + m_own.size())) {
    case 0:
      bytes[at] = char(bytes[at] ^ (1 << below(8)));
      break;
    case 1:
      bytes[at] = char(below(256));
      break;
    case 2:
      bytes.truncate(at);
      break;
    case 3:
      bytes.remove(at, length);
      break;
    case 4:
      bytes.insert(at, bytes.mid(place(), length));
      break;
    default:
      m_own[kind - common](*this, bytes, at);
  }
}

}  // namespace sline::test
