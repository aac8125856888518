// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sline::model {

/// Keeps, while an object of it lives, the messages that VTK reports from this thread instead of
/// letting them be printed. It lives on the stack and does not nest.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any() const { return !m_first.empty(); }
  /// Returns the first message without VTK's own source file, class and address.
  std::string first() const;
  void add(const char* text);

 private:
  std::string m_first;
};

}  // namespace sline::model
