// SPDX-License-Identifier: Apache-2.0
// Keeps the options of writers by their types: a writer declares its own, and an order carries
// those of all writers without knowing any.
#pragma once

#include <any>
#include <map>
#include <typeindex>

namespace sline::render {

class WriterOptions {
 public:
  /// Returns the options of type `T`; the defaults of `T()` where none were set.
  template <class T>
  const T& of() const {
    static const T standard{};
    const auto found = m_options.find(typeid(T));
    return found == m_options.end() ? standard : *std::any_cast<T>(&found->second);
  }
  template <class T>
  T& of() {
    std::any& held = m_options[typeid(T)];
    if (!held.has_value())
      held = T{};
    return *std::any_cast<T>(&held);
  }

 private:
  std::map<std::type_index, std::any> m_options;
};

}  // namespace sline::render
