// SPDX-License-Identifier: Apache-2.0
// Returns F_c·k = F_c·(S w + (nv/d)·w), the gradient over the surface of a headlight's brightness
// (METHOD §3). `a` and `b` hold F_c·S as symmetric matrix: xx, yy, zz, xy and xz, yz. `convergence`
// is F_c·nv/d, 0 for a parallel projection.
vec3 lightGradient(vec4 a, vec2 b, vec3 w, float convergence) {
  vec3 sw = vec3(a.x * w.x + a.w * w.y + b.x * w.z,
                 a.w * w.x + a.y * w.y + b.y * w.z,
                 b.x * w.x + b.y * w.y + a.z * w.z);
  return sw + convergence * w;
}
