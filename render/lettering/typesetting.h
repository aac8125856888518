// SPDX-License-Identifier: Apache-2.0
// Sets text for programs without a window and without Qt's headers.
#pragma once

#include <memory>

#include "model/base/result.h"

namespace sline::render {

/// Creates what setting text needs, if the program does not have it. It must be made on the main
/// thread and held as long as text is set, on any thread.
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
