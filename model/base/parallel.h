// SPDX-License-Identifier: Apache-2.0
// Gives the one access to threads: loops run in parallel on the desktop (oneTBB, in
// parallel_tbb.cpp) and in order on the web (parallel_serial.cpp). No thread is assumed anywhere
// else.
#pragma once

#include <cstddef>
#include <type_traits>

namespace sline {

namespace detail {
using ChunkFunction = void (*)(const void* context, std::size_t begin, std::size_t end);
void parallelChunksErased(std::size_t count, std::size_t grain, ChunkFunction function,
                          const void* context);
using TaskFunction = void (*)(const void* context);
void isolatedErased(TaskFunction function, const void* context);
}  // namespace detail

/// Returns how many threads share a loop's work at most.
int threadCount();

/// Calls body(begin, end) for disjoint ranges that together cover [0, count); ranges hold about
/// `grain` items or more. Ranges may run at the same time and in any order; returns when all ran.
template <class Body>
void parallelChunks(std::size_t count, std::size_t grain, const Body& body) {
  detail::parallelChunksErased(
      count, grain,
      [](const void* context, std::size_t begin, std::size_t end) {
        (*static_cast<const Body*>(context))(begin, end);
      },
      &body);
}

/// Calls body(i) for every i in [0, count), in parallel.
template <class Body>
void parallelFor(std::size_t count, std::size_t grain, const Body& body) {
  parallelChunks(count, grain, [&body](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      body(i);
  });
}

/// Runs the body. While a thread waits for the loops in it, it takes up nothing from outside, as it
/// may elsewhere: a lock that is held over a loop would be locked again by the same thread.
template <class Body>
void isolated(const Body& body) {
  detail::isolatedErased([](const void* context) { (*static_cast<const Body*>(context))(); },
                         &body);
}

}  // namespace sline
