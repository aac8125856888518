// SPDX-License-Identifier: Apache-2.0
// Reads the header of an NRRD file ("Definition of NRRD File Format", teem.sourceforge.net/nrrd):
// lines of "field: value" and "key:=value" up to an empty line or the end.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/source/source.h"

namespace sline::model {

struct NrrdHeader {
  std::map<std::string, std::string, std::less<>> fields;  ///< lower case, one name per meaning
  std::map<std::string, std::string, std::less<>> keys;
  std::string_view data;  ///< the bytes behind the header

  /// Returns the field's text, or an empty one.
  std::string_view field(std::string_view name) const;
  std::string_view key(std::string_view name) const;
};

/// Reads the header; the error names a line that does not belong in one.
Result<NrrdHeader> nrrdHeader(const Source& source);

/// Returns a vector "(a,b,c)" per axis, and no vector for "none". The result is empty where the
/// text is something else.
std::vector<std::optional<glm::dvec3>> nrrdVectors(std::string_view text);

}  // namespace sline::model
