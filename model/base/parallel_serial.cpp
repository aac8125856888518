// SPDX-License-Identifier: Apache-2.0
// The web's version of parallel_tbb.cpp: the same loops, in order.
#include "model/base/parallel.h"

namespace sline::detail {

void parallelChunksErased(std::size_t count, std::size_t /*grain*/, ChunkFunction function,
                          const void* context) {
  if (count != 0)
    function(context, 0, count);
}

}  // namespace sline::detail
