// SPDX-License-Identifier: Apache-2.0
// Runs the loops of parallel_tbb.cpp in order, for the web.
#include "model/base/parallel.h"

namespace sline {

int threadCount() {
  return 1;
}

namespace detail {

void parallelChunksErased(std::size_t count, std::size_t /*grain*/, ChunkFunction function,
                          const void* context) {
  if (count != 0)
    function(context, 0, count);
}

void isolatedErased(TaskFunction function, const void* context) {
  function(context);
}

}  // namespace detail

}  // namespace sline
