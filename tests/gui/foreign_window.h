// SPDX-License-Identifier: Apache-2.0
// Shows the window of another process on the same X display, and operates it.
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

  /// Returns the title in UTF-8; empty while the process shows no window.
  std::string title() const;
  /// Presses and releases the key that X calls by this name ("k", "Tab"). Returns false if there is
  /// no window.
  bool press(const char* key, bool control = false);

 private:
  struct Data;
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::test
