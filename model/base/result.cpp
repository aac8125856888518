// SPDX-License-Identifier: Apache-2.0
#include "model/base/result.h"

namespace sline {

namespace {
void append(std::string& line, const std::string& part, const char* separator) {
  if (part.empty())
    return;
  if (!line.empty())
    line += separator;
  line += part;
}
}  // namespace

Error handedOn(Error&& error) {
  return std::move(error);
}

std::string Error::text() const {
  std::string line = file;
  append(line, where, ": ");
  append(line, reason, ": ");
  if (!line.empty() && line.back() != '.')
    line += '.';
  append(line, remedy, " ");
  if (!line.empty() && line.back() != '.')
    line += '.';
  return line;
}

}  // namespace sline
