// SPDX-License-Identifier: Apache-2.0
#include "phong.glsl"
#ifdef SECTIONED
#include "sections.glsl"
in vec3 place;
#endif
in vec3 surfaceNormal;
in vec3 towardsEye;
in float gradient;

uniform vec3 colour;
uniform vec4 wash;           // premultiplied, lies under the shading
uniform vec3 transition;     // T_P, clamp01(Γ − 4), the style's opacity
#ifdef GAMMA_VARIES
in float offset;
uniform float gamma;
uniform vec4 stages[33];     // FillStages, which stagePlace finds its way in

float stagePlace(float g) {
  return g < 4.0 ? 16.0 * sqrt(max(g - 3.0, 0.0)) : 16.0 + 16.0 * (g - 4.0);
}

vec2 stageOf(float g) {
  float at = stagePlace(g);
  int low = min(int(at), 31);
  return mix(stages[low].xy, stages[low + 1].xy, at - float(low));
}
#endif
uniform int twoSided;
uniform int darkGround;      // 1: drawn as with chalk, 0: as with ink and glazes on paper
uniform float leastFacing;   // what is seen more aslant is shaded like this
uniform vec3 key;            // unit, towards the key light; 0: there is none

out vec4 fragment;

const float quarterTurn = 1.5707963268;

void main() {
#ifdef SECTIONED
  if (cutAway(place))
    discard;
#endif
  float nv = dot(normalize(surfaceNormal), normalize(towardsEye));
  float side = twoSided != 0 && nv < 0.0 ? -1.0 : 1.0;
  nv = clamp(nv * side, leastFacing, 1.0);
#ifdef GAMMA_VARIES
  vec2 stage = stageOf(clamp(gamma + offset, 0.0, 5.0));
#else
  vec2 stage = transition.xy;
#endif
  // S eq. 11 with the last term's sign as METHOD §7 reads it; θ_c = π/2 at T_P = 0 means w_a = 0.
  float shading = stage.x;
  float threshold = quarterTurn * (1.0 - shading);
  // Paper is light by itself and shading enters from the dark rim; on a dark ground light enters,
  // from the parts that face the eye.
  float angle = darkGround != 0 ? asin(nv) : acos(nv);
  float byAngle = shading > 0.0
      ? clamp((angle - threshold) / max(quarterTurn - threshold, 1e-4), 0.0, 1.0) : 0.0;
  float byLight = clamp(gradient * side, 0.0, 1.0) * (1.0 - shading) + shading;
  float entered = mix(byAngle * byLight, 1.0, stage.y);
  float opacity = entered * transition.z;
  vec3 shaded;
  if (key != vec3(0.0)) {
    vec3 n = normalize(surfaceNormal) * side;
    vec3 h = normalize(key + normalize(towardsEye));
    shaded = phongWithKey(colour, nv, dot(n, key), dot(n, h));
  } else {
    shaded = phong(colour, nv);
  }
  // A thin glaze shows the colour itself; its shadows, which would grey the paper, deepen as it
  // closes.
  if (darkGround == 0)
    shaded = mix(shaded, max(shaded, colour), 1.0 - entered);
  fragment = vec4(min(shaded, 1.0) * opacity, opacity) + wash * (1.0 - opacity);
}
