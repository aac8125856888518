// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "model/base/parallel.h"

namespace sline {

int threadCount() {
  return oneapi::tbb::this_task_arena::max_concurrency();
}

namespace detail {

void parallelChunksErased(std::size_t count, std::size_t grain, ChunkFunction function,
                          const void* context) {
  if (count == 0)
    return;
  if (count <= grain) {
    function(context, 0, count);
    return;
  }
  oneapi::tbb::parallel_for(
      oneapi::tbb::blocked_range<std::size_t>(0, count, grain),
      [function, context](const auto& range) { function(context, range.begin(), range.end()); });
}

void isolatedErased(TaskFunction function, const void* context) {
  oneapi::tbb::this_task_arena::isolate([=] { function(context); });
}

}  // namespace detail

}  // namespace sline
