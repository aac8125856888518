// SPDX-License-Identifier: Apache-2.0
// Reads the header of a file in netCDF's classic format (Unidata, "NetCDF Classic Format
// Specification"), versions 1, 2 and 5: names, sizes, attributes, and where the values of each
// variable begin.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/source/source.h"
#include "model/import/source/values.h"

namespace sline::model {

/// Holds values of one type as big-endian bytes; text where the type is char.
struct NetcdfValues {
  bool isText = false;
  ScalarType type = ScalarType::uint8;
  std::size_t count = 0;
  std::string_view bytes;

  /// Returns the i-th number; 0 behind the end.
  double number(std::size_t i) const;
};
using NetcdfAttributes = std::map<std::string, NetcdfValues, std::less<>>;

struct NetcdfDimension {
  std::string name;
  std::uint64_t size = 0;  ///< 0: grows by records
};

struct NetcdfVariable {
  std::vector<std::size_t> dimensions;  ///< into NetcdfHeader::dimensions, the fastest one last
  NetcdfAttributes attributes;
  NetcdfValues values;  ///< reach to the end of the file

  /// Returns an attribute's text, or an empty one.
  std::string_view text(std::string_view attribute) const;
  /// Returns an attribute's numbers, or `otherwise` where there are none.
  std::vector<double> numbers(std::string_view attribute, std::vector<double> otherwise) const;
};

struct NetcdfHeader {
  std::vector<NetcdfDimension> dimensions;
  std::map<std::string, NetcdfVariable, std::less<>> variables;
};

/// Reads the header; refuses a file that is no netCDF, and lists and places for which the file is
/// too short. Its views point into `source`.
Result<NetcdfHeader> readNetcdfHeader(const Source& source);

}  // namespace sline::model
