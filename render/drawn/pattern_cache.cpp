// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/pattern_cache.h"

#include <algorithm>

namespace sline::render {

namespace {

/// Per face: a picture, its preview at another size, and what each of them was before a zoom.
constexpr std::ptrdiff_t mostKept = 4;

}  // namespace

std::shared_ptr<const Hatching> PatternCache::find(std::size_t face,
                                                   const TissuePatternRequest& request) const {
  const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
    return entry.face == face && entry.request == request;
  });
  return found == m_entries.end() ? nullptr : found->marks;
}

void PatternCache::keep(Entry entry) {
  const auto isOfFace = [&](const Entry& other) { return other.face == entry.face; };
  if (std::count_if(m_entries.begin(), m_entries.end(), isOfFace) >= mostKept)
    m_entries.erase(std::find_if(m_entries.begin(), m_entries.end(), isOfFace));
  m_entries.push_back(std::move(entry));
}

}  // namespace sline::render
