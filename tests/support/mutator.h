// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <functional>
#include <random>
#include <vector>

namespace sline::test {

/// Spoils bytes as bad discs, cut transfers and attackers do: bits turned, pieces taken out,
/// written twice or cut off; the same seed gives the same changes.
class Mutator {
 public:
  /// Damages one format: changes the bytes from that place on.
  using Edit = std::function<void(Mutator& random, QByteArray& bytes, qsizetype at)>;

  /// Each of `own` comes as often as each of the common edits.
  Mutator(std::uint32_t seed, std::vector<Edit> own) : m_random(seed), m_own(std::move(own)) {}

  /// Returns the bytes after one to three edits.
  QByteArray operator()(QByteArray bytes);
  /// Returns a number in 0 … n−1.
  std::size_t below(std::size_t n) { return std::size_t(m_random()) % n; }

 private:
  void edit(QByteArray& bytes);

  std::mt19937 m_random;
  std::vector<Edit> m_own;
};

}  // namespace sline::test
