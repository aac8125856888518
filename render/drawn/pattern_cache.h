// SPDX-License-Identifier: Apache-2.0
// Keeps the patterns of a structure's cut faces while its planes stay where they are.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "render/lines/patterns/tissue_pattern.h"

namespace sline::render {

/// May be used from several threads at a time.
class PatternCache {
 public:
  /// Returns the marks on the face of that index as `make()`, which is called where they are not
  /// at hand, returns them for the request.
  template <class Make>
  std::shared_ptr<const Hatching> at(std::size_t face, const TissuePatternRequest& request,
                                     const Make& make) {
    const std::scoped_lock lock(m_mutex);
    if (auto kept = find(face, request))
      return kept;
    auto made = std::make_shared<const Hatching>(make());
    keep({face, request, made});
    return made;
  }

 private:
  struct Entry {
    std::size_t face = 0;
    TissuePatternRequest request;
    std::shared_ptr<const Hatching> marks;
  };
  std::shared_ptr<const Hatching> find(std::size_t face, const TissuePatternRequest& request) const;
  void keep(Entry entry);

  std::mutex m_mutex;
  std::vector<Entry> m_entries;  ///< the newest last
};

}  // namespace sline::render
