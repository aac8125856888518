// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace sline {

/// Describes what went wrong outside the program (in a file, a driver, a disk) so that a person can
/// act on it. Bugs assert instead. Every part but `reason` may be empty.
struct Error {
  std::string file;    ///< the file's name as the user gave it
  std::string where;   ///< the place in the file: "line 12", "byte 84", "node vtkMRMLModelNode4"
  std::string reason;  ///< what is wrong: "the header promises 400 points, the file ends after 12"
  std::string remedy;  ///< what to do: "export the mesh again"

  /// Returns the error as one line: "FILE: WHERE: REASON. REMEDY."
  std::string text() const;
  bool operator==(const Error&) const = default;
};

/// Holds a value or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return m_state.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & {
    assert(ok());
    return *std::get_if<0>(&m_state);
  }
  const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&m_state);
  }
  T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&m_state));
  }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }

  const Error& error() const& {
    assert(!ok());
    return *std::get_if<1>(&m_state);
  }
  Error&& error() && {
    assert(!ok());
    return std::move(*std::get_if<1>(&m_state));
  }

 private:
  std::variant<T, Error> m_state;
};

struct Unit {};
/// Tells of success without a value, or holds the reason of the failure.
using Status = Result<Unit>;

/// Returns the error; out of line, as it is rare.
Error handedOn(Error&& error);
/// Returns what the result holds.
template <class T>
T taken(Result<T>&& result) {
  return std::move(result).value();
}

}  // namespace sline

/// Is the value of the expression, a `Result`; where there is none, the function that this stands
/// in returns the error. Of a `Status` it is a statement: `TRY(written(file));`. (A statement in an
/// expression is an extension that g++ and clang share.)
#define TRY(...)                                        \
  __extension__({                                       \
    auto tried = (__VA_ARGS__);                         \
    if (!tried.ok())                                    \
      return sline::handedOn(std::move(tried).error()); \
    sline::taken(std::move(tried));                     \
  })
