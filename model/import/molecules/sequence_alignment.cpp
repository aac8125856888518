// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "model/import/molecules/superposition.h"

namespace sline::model {

namespace {

constexpr std::string_view order = "ARNDCQEGHILKMFPSTWYV";

// This is the lower triangle in the order above.
constexpr int blosum62[20][20] = {
    {4},
    {-1, 5},
    {-2, 0, 6},
    {-2, -2, 1, 6},
    {0, -3, -3, -3, 9},
    {-1, 1, 0, 0, -3, 5},
    {-1, 0, 0, 2, -4, 2, 5},
    {0, -2, 0, -1, -3, -2, -2, 6},
    {-2, 0, 1, -1, -3, 0, 0, -2, 8},
    {-1, -3, -3, -3, -1, -3, -3, -4, -3, 4},
    {-1, -2, -3, -4, -1, -2, -3, -4, -3, 2, 4},
    {-1, 2, 0, -1, -3, 1, 1, -2, -1, -3, -2, 5},
    {-1, -1, -2, -3, -1, 0, -2, -3, -2, 1, 2, -1, 5},
    {-2, -3, -3, -3, -2, -3, -3, -3, -1, 0, 0, -3, 0, 6},
    {-1, -2, -2, -1, -3, -1, -1, -2, -2, -3, -3, -1, -2, -4, 7},
    {1, -1, 1, 0, -1, 0, 0, 0, -1, -2, -2, 0, -1, -2, -1, 4},
    {0, -1, 0, -1, -1, -1, -1, -2, -2, -1, -1, -1, -1, -2, -1, 1, 5},
    {-3, -3, -4, -4, -2, -2, -3, -2, -2, -3, -2, -3, -1, 1, -4, -3, -2, 11},
    {-2, -2, -2, -3, -2, -1, -2, -3, 2, -1, -1, -2, -1, 3, -3, -2, -2, 2, 7},
    {0, -3, -3, -3, -1, -2, -2, -3, -3, 3, 1, -2, 1, -1, -2, -2, 0, -3, -1, 4}};

constexpr int gapOpens = 11;
constexpr int gapGoesOn = 1;
constexpr std::size_t mostPairs = 150'000'000;

/// Holds scores by letter, in one table for speed.
class Scores {
 public:
  explicit Scores(bool nucleic) {
    for (std::size_t a = 0; a < 128; ++a)
      for (std::size_t b = 0; b < 128; ++b)
        m_table[a * 128 + b] = std::int8_t(score(char(a), char(b), nucleic));
  }
  int operator()(char a, char b) const {
    return m_table[(std::size_t(a) & 127u) * 128 + (std::size_t(b) & 127u)];
  }

 private:
  static int score(char a, char b, bool nucleic) {
    if (nucleic)
      return a == b && a != 'X' ? 5 : -4;
    const std::size_t i = order.find(a);
    const std::size_t k = order.find(b);
    if (i == std::string_view::npos || k == std::string_view::npos)
      return -1;
    return blosum62[std::max(i, k)][std::min(i, k)];
  }
  std::array<std::int8_t, std::size_t(128) * 128> m_table{};
};

// These bits say where the best way to a cell came from.
constexpr std::uint8_t fromGapInB = 1;  ///< the best way ends with a letter of a alone
constexpr std::uint8_t fromGapInA = 2;  ///< the best way ends with a letter of b alone
constexpr std::uint8_t gapInBGoesOn = 4;
constexpr std::uint8_t gapInAGoesOn = 8;

class Aligner {
 public:
  Aligner(std::string_view a, std::string_view b, bool nucleic)
      : m_a(a), m_b(b), m_scores(nucleic), m_ways((a.size() + 1) * (b.size() + 1), 0) {}

  Alignment align() {
    fill();
    return trace();
  }

 private:
  std::uint8_t& way(std::size_t i, std::size_t k) { return m_ways[i * (m_b.size() + 1) + k]; }

  void fill() {
    constexpr int never = -1'000'000'000;
    std::vector<int> best(m_b.size() + 1, 0);
    std::vector<int> gapInB(m_b.size() + 1, never);
    for (std::size_t i = 1; i <= m_a.size(); ++i) {
      int diagonal = 0;
      int gapInA = never;
      best[0] = 0;
      for (std::size_t k = 1; k <= m_b.size(); ++k) {
        std::uint8_t& from = way(i, k);
        const int openB = best[k] - gapOpens;
        const int longerB = gapInB[k] - gapGoesOn;
        gapInB[k] = std::max(openB, longerB);
        from |= longerB > openB ? gapInBGoesOn : 0;
        const int openA = best[k - 1] - gapOpens;
        const int longerA = gapInA - gapGoesOn;
        gapInA = std::max(openA, longerA);
        from |= longerA > openA ? gapInAGoesOn : 0;
        int top = diagonal + m_scores(m_a[i - 1], m_b[k - 1]);
        if (gapInB[k] > top) {
          top = gapInB[k];
          from |= fromGapInB;
        }
        if (gapInA > top) {
          top = gapInA;
          from = std::uint8_t((from & ~fromGapInB) | fromGapInA);
        }
        diagonal = best[k];
        best[k] = top;
      }
      keepEnd(i, m_b.size(), best[m_b.size()]);
    }
    for (std::size_t k = 1; k <= m_b.size(); ++k)
      keepEnd(m_a.size(), k, best[k]);
  }

  /// Keeps the best end: gaps at the ends are free, so the way may end anywhere on the last row or
  /// column.
  void keepEnd(std::size_t i, std::size_t k, int score) {
    if (score <= m_score && m_endA != 0)
      return;
    m_score = score;
    m_endA = i;
    m_endB = k;
  }

  Alignment trace() {
    Alignment alignment;
    alignment.score = m_score;
    std::size_t i = m_endA;
    std::size_t k = m_endB;
    while (i > 0 && k > 0) {
      const std::uint8_t from = way(i, k);
      if ((from & fromGapInB) != 0) {
        while (i > 1 && (way(i, k) & gapInBGoesOn) != 0)
          --i;
        --i;
      } else if ((from & fromGapInA) != 0) {
        while (k > 1 && (way(i, k) & gapInAGoesOn) != 0)
          --k;
        --k;
      } else {
        --i;
        --k;
        alignment.pairs.emplace_back(i, k);
        alignment.identical += m_a[i] == m_b[k] && m_a[i] != 'X' ? 1 : 0;
      }
    }
    std::reverse(alignment.pairs.begin(), alignment.pairs.end());
    return alignment;
  }

  std::string_view m_a;
  std::string_view m_b;
  Scores m_scores;
  std::vector<std::uint8_t> m_ways;
  int m_score = 0;
  std::size_t m_endA = 0;
  std::size_t m_endB = 0;
};

}  // namespace

std::optional<Alignment> aligned(std::string_view a, std::string_view b, bool nucleic) {
  if (a.empty() || b.empty())
    return std::nullopt;
  if (a == b) {
    const Scores scores(nucleic);
    Alignment alignment;
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      alignment.pairs.emplace_back(i, i);
      alignment.identical += a[i] != 'X' ? 1 : 0;
      alignment.score += scores(a[i], a[i]);
    }
    return alignment;
  }
  if (a.size() > mostPairs / b.size())
    return std::nullopt;
  return Aligner(a, b, nucleic).align();
}

}  // namespace sline::model
