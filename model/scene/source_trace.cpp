// SPDX-License-Identifier: Apache-2.0
#include "model/scene/source_trace.h"

#include <algorithm>

namespace sline::model {

namespace {

bool isTrace(std::string_view text) {
  return text.size() == traceDigits && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

}  // namespace

std::optional<std::string_view> traceFault(const SourceTrace& trace) {
  for (const std::string* text : {&trace.salt, &trace.study, &trace.frame})
    if (!isTrace(*text) && !(text->empty() && text != &trace.salt))
      return "a trace of where it came from is not of 32 hexadecimal digits";
  if (trace.study.empty() && trace.frame.empty())
    return "a trace of where it came from says nothing";
  return std::nullopt;
}

void addTraces(std::vector<SourceTrace>& to, const std::vector<SourceTrace>& more) {
  for (const SourceTrace& trace : more)
    if (to.size() < mostSourceTraces && std::find(to.begin(), to.end(), trace) == to.end())
      to.push_back(trace);
}

}  // namespace sline::model
