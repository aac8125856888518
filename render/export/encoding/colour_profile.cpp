// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/colour_profile.h"

#include <lcms2.h>

#include <array>
#include <cmath>
#include <memory>
#include <string_view>

#include "model/base/srgb.h"

namespace sline::render {

namespace {

struct IccProfileEnd {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using IccProfile = std::unique_ptr<void, IccProfileEnd>;

struct ToneCurveEnd {
  void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};
using ToneCurve = std::unique_ptr<cmsToneCurve, ToneCurveEnd>;

ToneCurve toneCurve() {
  std::array<cmsUInt16Number, 1024> steps{};
  for (std::size_t i = 0; i < steps.size(); ++i)
    steps[i] =
        cmsUInt16Number(std::lround(65535.0f * lightFromSrgb(float(i) / float(steps.size() - 1))));
  return ToneCurve(cmsBuildTabulatedToneCurve16(nullptr, steps.size(), steps.data()));
}

void write(const IccProfile& profile, cmsTagSignature tag, const char* text) {
  const std::unique_ptr<cmsMLU, decltype(&cmsMLUfree)> words(cmsMLUalloc(nullptr, 1), &cmsMLUfree);
  cmsMLUsetASCII(words.get(), "en", "US", text);
  cmsWriteTag(profile.get(), tag, words.get());
}

/// Returns the profile's bytes, in a version (2.1) that every reader knows.
std::string bytesOf(const IccProfile& profile, const char* description) {
  cmsSetProfileVersion(profile.get(), 2.1);
  write(profile, cmsSigProfileDescriptionTag, description);
  write(profile, cmsSigCopyrightTag, "Public domain");
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile.get(), nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile.get(), bytes.data(), &size);
  // The date (ICC.1:2001-04, 6.1.6), which the library takes from the clock, is the same in every
  // profile.
  constexpr std::string_view date("\x07\xD0\0\x01\0\x01\0\0\0\0\0\0", 12);
  return bytes.replace(24, date.size(), date);
}

}  // namespace

std::string srgbProfile() {
  constexpr cmsCIExyY white{0.3127, 0.3290, 1.0};
  constexpr cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
  const ToneCurve curve = toneCurve();
  const std::array<cmsToneCurve*, 3> curves{curve.get(), curve.get(), curve.get()};
  return bytesOf(IccProfile(cmsCreateRGBProfile(&white, &primaries, curves.data())), "sRGB");
}

std::string greyProfile() {
  return bytesOf(IccProfile(cmsCreateGrayProfile(cmsD50_xyY(), toneCurve().get())),
                 "Grey with the tone curve of sRGB");
}

}  // namespace sline::render
