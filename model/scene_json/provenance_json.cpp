// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/provenance_json.h"

#include <limits>
#include <string>
#include <utility>

namespace sline::model {

namespace {
using Ordered = nlohmann::ordered_json;

/// Counts stay exact in programs that have no other numbers than doubles.
constexpr std::int64_t largestCount = std::int64_t(1) << 53;

SourceCredit creditFrom(JsonObject& object) {
  SourceCredit credit;
  for (const auto& [key, target] :
       {std::pair("authors", &credit.authors), std::pair("source", &credit.source),
        std::pair("licence", &credit.licence)})
    if (const auto text = object.take(key)) {
      *target = text->text();
      if (target->size() > longestCredit)
        text->fail("a line of at most " + std::to_string(longestCredit) +
                   " bytes is expected here");
    }
  return credit;
}

Ordered creditJson(const SourceCredit& credit) {
  Ordered json = Ordered::object();
  for (const auto& [key, text] :
       {std::pair("authors", &credit.authors), std::pair("source", &credit.source),
        std::pair("licence", &credit.licence)})
    if (!text->empty())
      json[key] = *text;
  return json;
}

std::optional<IntensityRange> rangeFrom(JsonObject& object) {
  const auto value = object.take("intensities");
  if (!value)
    return std::nullopt;
  IntensityRange range;
  JsonObject inner(*value);
  if (const auto low = inner.take("low"))
    range.low = low->number();
  if (const auto high = inner.take("high"))
    range.high = high->number();
  object.giveBack("intensities", inner.rest());
  return range;
}

std::optional<ReadExtent> extentFrom(JsonObject& object) {
  const auto value = object.take("as_read");
  if (!value)
    return std::nullopt;
  ReadExtent extent;
  JsonObject inner(*value);
  if (const auto area = inner.take("area_mm2"))
    extent.areaMm2 = area->number();
  if (const auto volume = inner.take("volume_mm3"))
    extent.volumeMm3 = volume->number();
  object.giveBack("as_read", inner.rest());
  return extent;
}

Ordered extentJson(const ReadExtent& extent) {
  Ordered json = Ordered::object();
  if (extent.areaMm2)
    json["area_mm2"] = jsonNumber(*extent.areaMm2);
  if (extent.volumeMm3)
    json["volume_mm3"] = jsonNumber(*extent.volumeMm3);
  return json;
}
}  // namespace

Provenance provenanceFrom(JsonObject& object) {
  Provenance p;
  const auto text = [&object](std::string_view key, std::string& target) {
    if (const auto value = object.take(key))
      target = value->text();
  };
  const auto count = [&object](std::string_view key, int& target) {
    constexpr auto most = std::numeric_limits<std::int32_t>::max();
    if (const auto value = object.take(key))
      target = int(value->whole(0, most));
  };
  const auto number = [&object](std::string_view key, float& target) {
    if (const auto value = object.take(key))
      target = value->number();
  };
  text("file", p.file);
  text("frame", p.frame);
  text("frame_reason", p.frameReason);
  number("mm_per_unit", p.mmPerUnit);
  text("unit_reason", p.unitReason);
  count("smoothing_steps", p.smoothingSteps);
  count("refinement_steps", p.refinementSteps);
  count("repaired_faces", p.repairedFaces);
  number("displacement_mm", p.displacementMm);
  number("slice_mm", p.sliceMm);
  count("decimated_from", p.decimatedFrom);
  number("decimation_mm", p.decimationMm);
  text("part", p.part);
  p.intensities = rangeFrom(object);
  if (const auto print = object.take("fingerprint")) {
    JsonObject inner(*print);
    p.fingerprint = Fingerprint{std::uint64_t(inner.need("bytes").whole(0, largestCount)),
                                std::uint32_t(inner.need("crc32").whole(0, std::uint32_t(-1)))};
    object.giveBack("fingerprint", inner.rest());
  }
  if (const auto transform = object.take("transform"))
    p.transform = transform->numbers<12>();
  if (const auto credit = object.take("credit")) {
    JsonObject inner(*credit);
    p.credit = creditFrom(inner);
    object.giveBack("credit", inner.rest());
  }
  p.asRead = extentFrom(object);
  return p;
}

Ordered provenanceJson(const Provenance& p) {
  Ordered json = {{"file", p.file},
                  {"frame", p.frame},
                  {"frame_reason", p.frameReason},
                  {"mm_per_unit", jsonNumber(p.mmPerUnit)},
                  {"unit_reason", p.unitReason},
                  {"smoothing_steps", p.smoothingSteps},
                  {"refinement_steps", p.refinementSteps},
                  {"repaired_faces", p.repairedFaces},
                  {"displacement_mm", jsonNumber(p.displacementMm)}};
  if (p.sliceMm > 0.0f)
    json["slice_mm"] = jsonNumber(p.sliceMm);
  if (p.decimatedFrom != 0) {
    json["decimated_from"] = p.decimatedFrom;
    json["decimation_mm"] = jsonNumber(p.decimationMm);
  }
  if (!p.part.empty())
    json["part"] = p.part;
  if (p.fingerprint)
    json["fingerprint"] = {{"bytes", p.fingerprint->bytes}, {"crc32", p.fingerprint->crc}};
  if (p.intensities) {
    json["intensities"] = Ordered::object();
    if (p.intensities->low)
      json["intensities"]["low"] = jsonNumber(*p.intensities->low);
    if (p.intensities->high)
      json["intensities"]["high"] = jsonNumber(*p.intensities->high);
  }
  if (p.transform) {
    json["transform"] = Ordered::array();
    for (const float number : *p.transform)
      json["transform"].push_back(jsonNumber(number));
  }
  if (!p.credit.empty())
    json["credit"] = creditJson(p.credit);
  if (p.asRead)
    json["as_read"] = extentJson(*p.asRead);
  return json;
}

}  // namespace sline::model
