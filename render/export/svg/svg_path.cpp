// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_path.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace sline::render {

namespace {

std::int64_t scaleOf(int decimals) {
  std::int64_t scale = 1;
  for (int i = 0; i < decimals; ++i)
    scale *= 10;
  return scale;
}

/// Appends a number given in steps of 10^-decimals.
void appendSteps(std::string& text, std::int64_t steps, int decimals) {
  const std::int64_t scale = scaleOf(decimals);
  if (steps < 0)
    text += '-';
  const std::int64_t size = std::abs(steps);
  const std::int64_t whole = size / scale;
  std::int64_t rest = size % scale;
  if (whole > 0 || rest == 0)
    text += std::to_string(whole);
  if (rest == 0)
    return;
  std::string digits(std::size_t(decimals), '0');
  for (std::size_t i = digits.size(); i-- > 0; rest /= 10)
    digits[i] = char('0' + rest % 10);
  digits.erase(digits.find_last_not_of('0') + 1);
  text += '.' + digits;
}

struct Steps {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

class PathText {
 public:
  explicit PathText(int decimals) : m_decimals(decimals), m_scale(scaleOf(decimals)) {}

  void add(const Curve& curve) {
    const Steps start = rounded(curve.start);
    command('M');
    point(start);
    m_at = start;
    for (const Cubic& piece : curve.pieces)
      add(piece);
    if (curve.pieces.empty() && !curve.closed) {
      command('l');
      offset(start);
    }
    if (curve.closed)
      command('z');
  }
  std::string take() { return std::move(m_text); }

 private:
  void add(const Cubic& piece) {
    const Steps a = rounded(piece.control1);
    const Steps b = rounded(piece.control2);
    const Steps end = rounded(piece.end);
    if (isLine(a, end) && isLine(b, end)) {
      if (end.x == m_at.x && end.y == m_at.y)
        return;
      command('l');
      offset(end);
    } else {
      command('c');
      offset(a);
      offset(b);
      offset(end);
    }
    m_at = end;
  }

  /// Tells whether the control lies on the way to the end, within rounding.
  bool isLine(const Steps& control, const Steps& end) const {
    const double dx = double(end.x - m_at.x);
    const double dy = double(end.y - m_at.y);
    const double px = double(control.x - m_at.x);
    const double py = double(control.y - m_at.y);
    const double length = std::hypot(dx, dy);
    const double along = dx * px + dy * py;
    return length < 0.5 ? std::hypot(px, py) < 1.0
                        : std::abs(dx * py - dy * px) <= 0.75 * length && along >= 0.0 &&
                              along <= 1.000001 * length * length;
  }

  Steps rounded(const glm::vec2& p) const {
    return {std::llround(double(p.x) * double(m_scale)),
            std::llround(double(p.y) * double(m_scale))};
  }
  /// Writes a command's letter, once for a run of equal ones.
  void command(char letter) {
    if (letter != m_letter || letter == 'M' || letter == 'z') {
      m_text += letter;
      m_fresh = true;
    }
    m_letter = letter;
  }
  void number(std::int64_t steps) {
    if (!m_fresh && steps >= 0)
      m_text += ' ';
    appendSteps(m_text, steps, m_decimals);
    m_fresh = false;
  }
  void point(const Steps& p) {
    number(p.x);
    number(p.y);
  }
  void offset(const Steps& p) { point({p.x - m_at.x, p.y - m_at.y}); }

  int m_decimals;
  std::int64_t m_scale;
  std::string m_text;
  Steps m_at;
  char m_letter = 0;
  bool m_fresh = true;
};

}  // namespace

void appendNumber(std::string& text, double value, int decimals) {
  appendSteps(text, std::llround(value * double(scaleOf(decimals))), decimals);
}

std::string svgPath(const Path& path, int decimals) {
  PathText text(decimals);
  for (const Curve& curve : path)
    text.add(curve);
  return text.take();
}

}  // namespace sline::render
