// SPDX-License-Identifier: Apache-2.0
// Keeps what techniques that find lines compute once for a surface, whatever the view.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>

#include "model/geometry/surface.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

/// What one technique has computed of one surface.
class PreparedLines {
 public:
  virtual ~PreparedLines() = default;
  /// Returns how many lines are kept, and what they take.
  virtual std::size_t count() const = 0;
  virtual std::size_t bytes() const = 0;
};

/// Belongs to one surface; may be used from threads.
class LinePreparations {
 public:
  /// Returns what the technique of the kind, which must have a `prepare`, has computed of the
  /// surface; it computes that at the first call.
  std::shared_ptr<const PreparedLines> of(LineKind kind, const model::Surface& surface);
  /// Computes what the techniques of these kinds need, where they need anything.
  void make(LineKinds kinds, const model::Surface& surface);

 private:
  std::mutex m_mutex;  ///< guards the pointers
  std::array<std::shared_ptr<const PreparedLines>, lineKindCount> m_kept;
};

}  // namespace sline::render
