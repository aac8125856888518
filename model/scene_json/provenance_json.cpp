// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/provenance_json.h"

#include <limits>
#include <string>
#include <utility>

#include "model/scene/known_frame.h"
#include "model/scene/scene_limits.h"

namespace sline::model {

namespace {
using Ordered = nlohmann::ordered_json;

constexpr auto largestCount = std::int64_t(largestId);

SourceCredit creditFrom(JsonObject& object) {
  SourceCredit credit;
  for (const auto& [key, target] :
       {std::pair("authors", &credit.authors), std::pair("source", &credit.source),
        std::pair("licence", &credit.licence)})
    readInto(object.take(key), *target, [](const JsonValue& value) {
      std::string line = value.text();
      if (line.size() > longestCredit)
        value.fail("a line of at most " + std::to_string(longestCredit) +
                   " bytes is expected here");
      return line;
    });
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

Evidence evidenceOf(const JsonValue& value) {
  const std::optional<Evidence> named = evidenceNamed(value.text());
  if (!named)
    value.fail("known, settled, voted, assumed or conflict is expected here");
  return named.value_or(Evidence::assumed);
}

std::optional<IntensityRange> rangeFrom(JsonObject& object) {
  const auto value = object.take("intensities");
  if (!value)
    return std::nullopt;
  IntensityRange range;
  JsonObject inner(*value);
  readInto(inner.take("low"), range.low, asNumber);
  readInto(inner.take("high"), range.high, asNumber);
  object.giveBack("intensities", inner.rest());
  return range;
}

std::optional<ReadExtent> extentFrom(JsonObject& object) {
  const auto value = object.take("as_read");
  if (!value)
    return std::nullopt;
  ReadExtent extent;
  JsonObject inner(*value);
  readInto(inner.take("area_mm2"), extent.areaMm2, asNumber);
  readInto(inner.take("volume_mm3"), extent.volumeMm3, asNumber);
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

SideEvidence evidenceFrom(JsonObject& object, SideEvidence unsaid) {
  for (const auto& [key, target] : {std::pair("sides", &unsaid.sides),
                                    std::pair("front", &unsaid.front), std::pair("up", &unsaid.up)})
    if (const auto value = object.take(key))
      *target = evidenceOf(*value);
  return unsaid;
}

void putEvidence(Ordered& json, const SideEvidence& evidence, const SideEvidence& unsaid) {
  if (evidence.sides != unsaid.sides)
    json["sides"] = evidenceNames[std::size_t(evidence.sides)];
  if (evidence.front != unsaid.front)
    json["front"] = evidenceNames[std::size_t(evidence.front)];
  if (evidence.up != unsaid.up)
    json["up"] = evidenceNames[std::size_t(evidence.up)];
}

Provenance provenanceFrom(JsonObject& object) {
  Provenance p;
  const auto text = [&object](std::string_view key, std::string& target) {
    readInto(object.take(key), target, asText);
  };
  const auto count = [&object](std::string_view key, int& target) {
    readInto(object.take(key), target, [](const JsonValue& value) {
      return int(value.whole(0, std::numeric_limits<std::int32_t>::max()));
    });
  };
  const auto number = [&object](std::string_view key, float& target) {
    readInto(object.take(key), target, asNumber);
  };
  text("file", p.file);
  text("frame", p.frame);
  text("frame_reason", p.frameReason);
  p.evidence = evidenceFrom(object, evidenceOfReason(p.frameReason));
  if (const auto value = object.take("name_evidence"))
    p.nameEvidence = evidenceOf(*value);
  number("mm_per_unit", p.mmPerUnit);
  text("unit_reason", p.unitReason);
  if (const auto value = object.take("unit_evidence"))
    p.unitEvidence = evidenceOf(*value);
  count("smoothing_steps", p.smoothingSteps);
  count("refinement_steps", p.refinementSteps);
  count("repaired_faces", p.repairedFaces);
  number("displacement_mm", p.displacementMm);
  number("slice_mm", p.sliceMm);
  count("decimated_from", p.decimatedFrom);
  number("decimation_mm", p.decimationMm);
  text("part", p.part);
  p.intensities = rangeFrom(object);
  readInto(object.take("fingerprint"), p.fingerprint, [&object](const JsonValue& value) {
    JsonObject inner(value);
    const Fingerprint print{std::uint64_t(inner.need("bytes").whole(0, largestCount)),
                            std::uint32_t(inner.need("crc32").whole(0, std::uint32_t(-1)))};
    object.giveBack("fingerprint", inner.rest());
    return print;
  });
  readInto(object.take("transform"), p.transform,
           [](const JsonValue& value) { return value.numbers<12>(); });
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
  putEvidence(json, p.evidence, evidenceOfReason(p.frameReason));
  if (p.nameEvidence != Evidence::known)
    json["name_evidence"] = evidenceNames[std::size_t(p.nameEvidence)];
  if (p.unitEvidence != Evidence::known)
    json["unit_evidence"] = evidenceNames[std::size_t(p.unitEvidence)];
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
