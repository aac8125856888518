// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sline::model {

/// While one lives, what VTK reports from this thread is kept here instead of being printed. Lives
/// on the stack and does not nest.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any() const { return !m_first.empty(); }
  /// The first message without VTK's own source file, class and address.
  std::string first() const;
  void add(const char* text);

 private:
  std::string m_first;
};

}  // namespace sline::model
