// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/trace_json.h"

#include <utility>

namespace sline::model {

namespace {

SourceTrace traceFrom(const JsonValue& value) {
  JsonObject object(value);
  const FaultWatch watch(value.fault());
  SourceTrace trace;
  trace.salt = object.need("salt").text();
  if (const auto study = object.take("study"))
    trace.study = study->text();
  if (const auto frame = object.take("frame"))
    trace.frame = frame->text();
  trace.unread = object.unread();
  if (const auto fault = traceFault(trace); fault && watch.clean())
    value.fail(*fault);
  return trace;
}

}  // namespace

nlohmann::ordered_json traceJson(const SourceTrace& trace) {
  nlohmann::ordered_json json = {{"salt", trace.salt}};
  if (!trace.study.empty())
    json["study"] = trace.study;
  if (!trace.frame.empty())
    json["frame"] = trace.frame;
  return json;
}

std::vector<SourceTrace> tracesFrom(const JsonValue& list) {
  std::vector<SourceTrace> traces;
  list.forEach([&traces](const JsonValue& value) {
    if (auto trace = sound(value, traceFrom))
      traces.push_back(std::move(*trace));
  });
  return traces;
}

}  // namespace sline::model
