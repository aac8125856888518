// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/scan_json.h"

#include "model/scene/scene_limits.h"
#include "model/scene_json/provenance_json.h"

namespace sline::model {

namespace {
Scan scanFrom(const JsonValue& value, const VoxelsByName& voxels, const DamagedByName& damaged) {
  JsonObject object(value);
  const FaultWatch watch(value.fault());
  Scan scan;
  scan.name = object.need("name").text();
  if (const auto file = object.take("file"))
    scan.file = file->text();
  const auto list = [](const JsonValue& numbers, std::size_t count, const auto& each) {
    if (!numbers.json().is_array() || numbers.json().size() != count)
      return numbers.fail("a list of " + std::to_string(count) + " numbers is expected here");
    for (std::size_t i = 0; i < count; ++i)
      each(i, JsonValue(numbers.json()[i], numbers, i));
  };
  list(object.need("size"), 3, [&](std::size_t i, const JsonValue& number) {
    scan.size[int(i)] = int(number.whole(1, longestScanSide));
  });
  list(object.need("to_lps"), 12, [&](std::size_t i, const JsonValue& number) {
    scan.toLps[int(i % 4)][int(i / 4)] = number.real();
  });
  if (const auto slope = object.take("slope"))
    scan.slope = slope->real();
  if (const auto intercept = object.take("intercept"))
    scan.intercept = intercept->real();
  if (const auto hounsfield = object.take("hounsfield"))
    scan.hounsfield = hounsfield->flag();
  scan.evidence = evidenceFrom(object, {});
  const JsonValue member = object.need("voxels");
  const auto found = voxels.find(member.text());
  if (found == voxels.end())
    member.fail(absenceOf(member.text(), damaged, "there is no such member in the file"));
  else
    scan.voxels = found->second;
  scan.unread = object.unread();
  if (const std::string fault = scanFault(scan); !fault.empty() && watch.clean())
    value.fail(fault);
  return scan;
}
}  // namespace

std::string absenceOf(const std::string& name, const DamagedByName& damaged,
                      std::string_view otherwise) {
  const auto found = damaged.find(name);
  return found == damaged.end() ? std::string(otherwise) : name + ": " + found->second;
}

std::string voxelsName(std::size_t n) {
  return "scans/" + std::to_string(n + 1) + ".scan";
}

nlohmann::ordered_json scanJson(const Scan& scan, const std::string& voxels) {
  nlohmann::ordered_json json = {{"name", scan.name}};
  if (!scan.file.empty())
    json["file"] = scan.file;
  json["size"] = {scan.size.x, scan.size.y, scan.size.z};
  json["to_lps"] = nlohmann::ordered_json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      json["to_lps"].push_back(scan.toLps[column][row]);
  json["slope"] = scan.slope;
  json["intercept"] = scan.intercept;
  json["hounsfield"] = scan.hounsfield;
  putEvidence(json, scan.evidence, {});
  json["voxels"] = voxels;
  return json;
}

std::vector<std::string> voxelsCalledFor(const Json& root) {
  std::vector<std::string> names;
  const auto scans = root.is_object() ? root.find("scans") : root.end();
  if (scans == root.end() || !scans->is_array())
    return names;
  for (const Json& scan : *scans) {
    const auto member = scan.is_object() ? scan.find("voxels") : scan.end();
    if (member != scan.end() && member->is_string() && names.size() < mostSceneScans)
      names.push_back(member->get<std::string>());
  }
  return names;
}

std::vector<Scan> scansFrom(const JsonValue& list, const VoxelsByName& voxels,
                            const DamagedByName& damaged) {
  std::vector<Scan> scans;
  const auto read = [&](const JsonValue& each) { return scanFrom(each, voxels, damaged); };
  list.forEach([&](const JsonValue& value) {
    if (auto scan = sound(value, read))
      scans.push_back(std::move(*scan));
  });
  return scans;
}

}  // namespace sline::model
