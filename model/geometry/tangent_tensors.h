// SPDX-License-Identifier: Apache-2.0
// Turns tensors from one plane that touches a surface into another one (S. Rusinkiewicz,
// "Estimating Curvatures and Their Derivatives on Triangle Meshes", 2004, §3.2). All of it works on
// lanes of four (model/base/lanes.h) as well as on single numbers.
#pragma once

#include "model/base/lanes.h"

namespace sline::model {

/// Two unit vectors span a plane with the normal u × v.
template <class Number>
struct TangentFrame {
  Vector<Number> u;
  Vector<Number> v;
};

/// Holds a symmetric 2×2 tensor in some frame.
template <class Number>
struct TangentTensor {
  Number uu, uv, vv;
};

/// Holds a symmetric 2×2×2 tensor in some frame.
template <class Number>
struct TangentDerivative {
  Number uuu, uuv, uvv, vvv;
};

/// The angle by which one frame of a plane is turned against another one: u = (cosine, sine) there.
template <class Number>
struct Turn {
  Number cosine;
  Number sine;
  Turn back() const { return {cosine, -sine}; }
};

/// Returns a tangent frame of a unit normal, without branches that jump nearby (Duff et al.,
/// "Building an Orthonormal Basis, Revisited", JCGT 2017).
template <class Number>
[[gnu::always_inline]] inline TangentFrame<Number> tangentFrame(const Vector<Number>& n) {
  const Number sign = signOf(n.z);
  const Number a = -1.0f / (sign + n.z);
  const Number b = n.x * n.y * a;
  return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

/// Returns the vector of one tangent plane after the smallest rotation that takes its normal `from`
/// to `to` (Rodrigues; unit normals).
template <class Number>
[[gnu::always_inline]] inline Vector<Number> turned(const Vector<Number>& u,
                                                    const Vector<Number>& from,
                                                    const Vector<Number>& to) {
  const Number cosine = dot(from, to);
  const Vector<Number> across = to - from * cosine;
  const Vector<Number> along = (from + to) / (1.0f + cosine);
  const Vector<Number> after = u - along * dot(u, across);
  const auto opposite = cosine <= -0.99999f;
  return {opposite ? -u.x : after.x, opposite ? -u.y : after.y, opposite ? -u.z : after.z};
}

/// Returns how the frame that begins with `u` is turned against `in`, a frame of the same plane.
template <class Number>
[[gnu::always_inline]] inline Turn<Number> turnOf(const Vector<Number>& u,
                                                  const TangentFrame<Number>& in) {
  return {dot(u, in.u), dot(u, in.v)};
}

/// Returns the tensor in a frame that is turned like that.
template <class Number>
[[gnu::always_inline]] inline TangentTensor<Number> changed(const TangentTensor<Number>& t,
                                                            const Turn<Number>& x) {
  const Number mean = 0.5f * (t.uu + t.vv);
  const Number half = 0.5f * (t.uu - t.vv);
  const Number cosine2 = x.cosine * x.cosine - x.sine * x.sine;
  const Number sine2 = 2.0f * x.cosine * x.sine;
  const Number turnedHalf = cosine2 * half + sine2 * t.uv;
  return {mean + turnedHalf, cosine2 * t.uv - sine2 * half, mean - turnedHalf};
}

template <class Number>
[[gnu::always_inline]] inline TangentDerivative<Number> changed(const TangentDerivative<Number>& t,
                                                                const Turn<Number>& x) {
  const Number c = x.cosine;
  const Number s = x.sine;
  // These are the tensor's matrices with one index along u = (c, s) or v = (−s, c).
  const TangentTensor<Number> alongU{c * t.uuu + s * t.uuv, c * t.uuv + s * t.uvv,
                                     c * t.uvv + s * t.vvv};
  const TangentTensor<Number> alongV{c * t.uuv - s * t.uuu, c * t.uvv - s * t.uuv,
                                     c * t.vvv - s * t.uvv};
  const Number cc = c * c;
  const Number cs = c * s;
  const Number ss = s * s;
  return {cc * alongU.uu + 2.0f * cs * alongU.uv + ss * alongU.vv,
          cc * alongV.uu + 2.0f * cs * alongV.uv + ss * alongV.vv,
          ss * alongU.uu - 2.0f * cs * alongU.uv + cc * alongU.vv,
          ss * alongV.uu - 2.0f * cs * alongV.uv + cc * alongV.vv};
}

}  // namespace sline::model
