// SPDX-License-Identifier: Apache-2.0
#include "shaded_colour.glsl"
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
  float entered = enteredAt(enteringAngle(nv, darkGround != 0 ? 1.0 : 0.0), gradient * side,
                            stage.x, stage.y);
  float opacity = entered * transition.z;
  float light = headlight(nv);
  float glint = highlight(nv);
  if (key != vec3(0.0)) {
    vec3 n = normalize(surfaceNormal) * side;
    vec3 h = normalize(key + normalize(towardsEye));
    light = keyLight(nv, dot(n, key));
    glint = highlight(max(dot(n, h), 0.0));
  }
  vec3 shade = shadedColour(colour, light, glint);
  vec3 least = darkGround != 0 ? vec3(-1e30) : colour;
  vec3 glaze = vec3(glazed(shade.r, least.r, entered), glazed(shade.g, least.g, entered),
                    glazed(shade.b, least.b, entered));
  fragment = vec4(glaze * opacity, opacity) + wash * (1.0 - opacity);
}
