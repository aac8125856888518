// SPDX-License-Identifier: Apache-2.0
// For programs without a window and without Qt's headers.
#pragma once

#include <memory>

#include "model/base/result.h"

namespace sline::render {

/// What setting text needs, made where the program has none. Made on the main thread; hold one as
/// long as text is set, on whatever thread.
class Typesetting {
 public:
  static Result<std::unique_ptr<Typesetting>> create();
  ~Typesetting();
  Typesetting(const Typesetting&) = delete;
  Typesetting& operator=(const Typesetting&) = delete;

 private:
  struct Data;
  explicit Typesetting(std::unique_ptr<Data> data);
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render
