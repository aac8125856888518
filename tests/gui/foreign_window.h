// SPDX-License-Identifier: Apache-2.0
// The window of another process on the same X display, and hands for it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace sline::test {

class ForeignWindow {
 public:
  explicit ForeignWindow(std::int64_t process);
  ~ForeignWindow();
  ForeignWindow(const ForeignWindow&) = delete;
  ForeignWindow& operator=(const ForeignWindow&) = delete;

  /// UTF-8; empty while the process shows no window.
  std::string title() const;
  /// Presses and lets go of the key that X calls by this name ("k", "Tab"). False where there is no
  /// window.
  bool press(const char* key, bool control = false);

 private:
  struct Data;
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::test
