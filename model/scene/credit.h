// SPDX-License-Identifier: Apache-2.0
// Says whose work a surface is, so that pictures of it can say so.
#pragma once

#include <cstddef>
#include <string>

namespace sline::model {

/// Holds who made a surface, of what it is a part and under what terms it may be used. Each is one
/// line of UTF-8 and may be empty; none is taken from the name of a file or folder.
struct SourceCredit {
  std::string authors;
  std::string source;   ///< the collection or its address
  std::string licence;  ///< or the copyright line: "CC BY 4.0"

  bool empty() const { return authors.empty() && source.empty() && licence.empty(); }
  /// Returns them as one sentence shows them: "BodyParts3D, DBCLS, CC BY 4.0".
  std::string line() const {
    std::string all;
    for (const std::string* part : {&source, &authors, &licence})
      if (!part->empty())
        all += (all.empty() ? "" : ", ") + *part;
    return all;
  }
  bool operator==(const SourceCredit&) const = default;
};
/// The most bytes that each of them may have.
inline constexpr std::size_t longestCredit = 300;

}  // namespace sline::model
