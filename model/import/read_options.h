// SPDX-License-Identifier: Apache-2.0
// What a reader is told besides the file.
#pragma once

#include <cstdint>
#include <functional>

namespace sline::model {

/// Limits every reader keeps, so that a small file cannot ask for a large machine.
struct ReadLimits {
  std::uint64_t fileBytes = std::uint64_t(4) << 30;
  std::uint64_t vertices = 100'000'000;
  std::uint64_t triangles = 200'000'000;
  /// Of a reader in a process of its own (worker/reading_child.h). 0: half of the machine's memory,
  /// and a minute with a second for each megabyte of the file.
  std::uint64_t childBytes = 0;
  std::uint64_t childSeconds = 0;
};

/// `automatic` smooths what shows the steps of a label map and refines what is too coarse to draw;
/// `off` leaves every vertex where the file has it; `steps` smooths everything that many times.
struct Smoothing {
  enum class Mode { automatic, off, steps } mode = Mode::automatic;
  int steps = 0;
  bool operator==(const Smoothing&) const = default;
};

struct ReadOptions {
  ReadLimits limits;
  Smoothing smoothing;  ///< for readers that make their surfaces themselves (RawMesh::smooth)
  /// Asked now and then in a long piece of work, from any thread; false to give up, with an error
  /// that nobody will see.
  std::function<bool()> goesOn = [] { return true; };
};

}  // namespace sline::model
