// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/colour_profile.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "render/export/pixels/byte_order.h"

namespace sline::render {

namespace {

using Tag = std::pair<std::string_view, std::string>;

std::string fixed(double value) {
  return bigEndian(std::uint64_t(std::int64_t(std::lround(value * 65536.0))), 4);
}

std::string xyz(double x, double y, double z) {
  return "XYZ " + bigEndian(0, 4) + fixed(x) + fixed(y) + fixed(z);
}

/// textDescriptionType with its ASCII part alone.
std::string description(std::string_view text) {
  return "desc" + bigEndian(0, 4) + bigEndian(text.size() + 1, 4) + std::string(text) + '\0' +
         std::string(8 + 3 + 67, '\0');
}

std::string toneCurve() {
  constexpr std::size_t steps = 1024;
  std::string curve = "curv" + bigEndian(0, 4) + bigEndian(steps, 4);
  for (std::size_t i = 0; i < steps; ++i)
    curve += bigEndian(
        std::uint64_t(std::lround(65535.0f * toLinearLight(float(i) / float(steps - 1)))), 2);
  return curve;
}

/// The header (ICC.1:2001-04, 6.1) without the size that comes first. The date is the same in every
/// file.
std::string header(std::string_view colourSpace) {
  std::string bytes = bigEndian(0, 4) + bigEndian(0x02100000, 4) + "mntr";
  bytes += colourSpace;
  bytes += "XYZ ";
  for (const unsigned part : {2000u, 1u, 1u, 0u, 0u, 0u})
    bytes += bigEndian(part, 2);
  bytes += "acsp" + std::string(28, '\0');
  return bytes + fixed(0.9642) + fixed(1.0) + fixed(0.8249) + std::string(48, '\0');
}

std::string profile(std::string_view colourSpace, const std::vector<Tag>& tags) {
  const std::size_t tableEnd = 128 + 4 + 12 * tags.size();
  std::string table = bigEndian(tags.size(), 4);
  std::string data;
  std::vector<std::pair<std::string, std::size_t>> placed;
  for (const auto& [name, content] : tags) {
    std::size_t offset = tableEnd + data.size();
    for (const auto& [other, place] : placed)
      if (other == content)
        offset = place;
    if (offset == tableEnd + data.size()) {
      placed.emplace_back(content, offset);
      data += content;
      data.append((4 - data.size() % 4) % 4, '\0');
    }
    table += std::string(name) + bigEndian(offset, 4) + bigEndian(content.size(), 4);
  }
  return bigEndian(tableEnd + data.size(), 4) + header(colourSpace) + table + data;
}

const std::string& publicDomain() {
  static const std::string text = "text" + bigEndian(0, 4) + "Public domain" + '\0';
  return text;
}

}  // namespace

float toLinearLight(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

float fromLinearLight(float light) {
  return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

std::string srgbProfile() {
  const std::string curve = toneCurve();
  // The primaries adapted to D50 (Bradford).
  return profile("RGB ", {{"desc", description("sRGB")},
                          {"cprt", publicDomain()},
                          {"wtpt", xyz(0.9642, 1.0, 0.8249)},
                          {"rXYZ", xyz(0.43607, 0.22249, 0.01392)},
                          {"gXYZ", xyz(0.38515, 0.71687, 0.09708)},
                          {"bXYZ", xyz(0.14307, 0.06061, 0.71410)},
                          {"rTRC", curve},
                          {"gTRC", curve},
                          {"bTRC", curve}});
}

std::string greyProfile() {
  return profile("GRAY", {{"desc", description("Grey with the tone curve of sRGB")},
                          {"cprt", publicDomain()},
                          {"wtpt", xyz(0.9642, 1.0, 0.8249)},
                          {"kTRC", toneCurve()}});
}

}  // namespace sline::render
