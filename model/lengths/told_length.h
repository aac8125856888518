// SPDX-License-Identifier: Apache-2.0
// Says in which unit lengths are told and with how many digits: the one place that decides it for
// scale bars, sizes, lists and what programs remark.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>

#include "model/scene/known_frame.h"

namespace sline::model {

/// A unit that lengths are told in.
struct ToldUnit {
  double millimetres = 1.0;  ///< its length; of molecules what an ångström is drawn as
  std::string_view symbol = "mm";
  bool doubted = false;  ///< a question mark follows
  /// Returns the symbol with its mark: "mm?".
  std::string mark() const { return std::string(symbol) + (doubted ? "?" : ""); }
};

/// Returns the unit for what is at most so long: micrometres below a tenth of a millimetre,
/// nanometres below a ten-thousandth, else millimetres; of molecules ångströms.
inline ToldUnit toldUnit(double longest, DrawnUnit unit = DrawnUnit::millimetre) {
  if (unit == DrawnUnit::angstrom)
    return {.symbol = symbolOf(unit)};
  ToldUnit told{.doubted = unit == DrawnUnit::doubtedMillimetre};
  // What was computed in single precision lies a little beside the bound.
  constexpr double bound = 0.1 * (1.0 - 1e-6);
  if (longest > 0.0 && longest < bound) {
    const bool tiny = longest < 1e-3 * bound;
    told.millimetres = tiny ? 1e-6 : 1e-3;
    told.symbol = tiny ? "nm" : "µm";
  }
  return told;
}

/// Returns how many places after the point three significant digits of the value have; none from
/// 100 on.
inline int toldDecimals(double value) {
  const double size = std::abs(value);
  if (!(size > 0.0) || size >= 100.0)
    return 0;
  return std::clamp(2 - int(std::floor(std::log10(size) + 1e-9)), 0, 9);
}
/// Returns the value with them, without zeros at the end: "0.05", "12.3", "44719".
inline std::string toldNumber(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(toldDecimals(value)) << value;
  std::string number = text.str();
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.')
      number.pop_back();
  }
  return number == "-0" ? "0" : number;
}

/// Returns "12.3 mm", "50 µm" or "6 Å", with a question mark where the unit is doubted.
inline std::string toldLength(double millimetres, DrawnUnit unit = DrawnUnit::millimetre) {
  const ToldUnit told = toldUnit(std::abs(millimetres), unit);
  return toldNumber(millimetres / told.millimetres) + " " + told.mark();
}
/// Returns "140 × 60 × 60 mm", all in the unit of the largest.
inline std::string toldSize(const glm::dvec3& millimetres, DrawnUnit unit = DrawnUnit::millimetre) {
  const ToldUnit told = toldUnit(std::max({millimetres.x, millimetres.y, millimetres.z}), unit);
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    text += (axis > 0 ? " × " : "") + toldNumber(millimetres[axis] / told.millimetres);
  return text + " " + told.mark();
}

/// A length between surfaces as they are drawn.
struct DrawnLength {
  float mm = 0.0f;     ///< 0: they touch
  float offMm = 0.0f;  ///< by how much it differs at most from that of the surfaces that were read
  bool operator==(const DrawnLength&) const = default;
};

/// What is told of a length: a sign, a number and a unit.
struct ToldDistance {
  std::string_view sign;  ///< "", "≈" or "<"
  double value = 0.0;
  int decimals = 0;
  std::string unit;
};

/// Returns "88 mm" or, below 10, "3.4 mm". What may be off by more than half of the last place is
/// told as "≈ 3 mm", and without places where it may be off by half a unit; what may be none at all
/// as "< 2 mm". That surfaces touch is no number: of these the length is not told by this.
inline ToldDistance toldDistance(const DrawnLength& length,
                                 DrawnUnit unit = DrawnUnit::millimetre) {
  const double most = double(length.mm) + double(length.offMm);
  const ToldUnit in = toldUnit(length.mm > length.offMm ? double(length.mm) : most, unit);
  const double off = double(length.offMm) / in.millimetres;
  ToldDistance told{.sign = "", .value = double(length.mm) / in.millimetres, .unit = in.mark()};
  if (off > 0.0 && length.mm <= length.offMm) {
    told.sign = "<";
    told.decimals = most < in.millimetres ? 1 : 0;
    const double step = told.decimals > 0 ? 0.1 : 1.0;
    told.value = step * std::ceil(most / in.millimetres / step - 1e-6);
    return told;
  }
  told.decimals = told.value < 10.0 && off < 0.5 ? 1 : 0;
  if (off > (told.decimals > 0 ? 0.05 : 0.5))
    told.sign = "≈";
  return told;
}

}  // namespace sline::model
