// SPDX-License-Identifier: Apache-2.0
// Computes what the line search reads, S's TEX_v and TEX_p in one texture: the direction of k in
// the picture, the smart seed at the pixel and the opacity of hatching (S §3.4.1, §3.4.2, §3.4.4 as
// printed).
in vec3 gridPosition;
in vec3 clipPosition;
in vec3 surfaceNormal;
in vec3 towardsEye;
in vec3 gradient;

uniform sampler2D surfaceDepth;
uniform ivec2 toAtlas;         // from this target's pixels to the atlas'
uniform mat4 viewProjection;
uniform vec2 pictureSize;
uniform vec3 weight;           // F/F_c, θ_c, share of the opacity that remains beyond Γ = 4
uniform int twoSided;

out ivec4 field;  // direction; colour and permeability; bits of the opacity; seed's identity or 0

const float quarterTurn = 1.5707963268;
const float haloColour = 0.6;
const float contactReach = 1.8;  // β

// Returns v with the component of that axis first.
vec3 axisFirst(vec3 v, int axis) {
  return axis == 0 ? v : axis == 1 ? v.yzx : v.zxy;
}

struct Seed {
  float colour;
  float permeability;
  int identity;
};

// Returns the seed; `n` and `k` face the eye's side. Lengths are in cells.
Seed seedAt(vec3 n, vec3 k, float nv) {
  vec3 m = abs(n);
  int axis = m.x >= m.y ? (m.x >= m.z ? 0 : 2) : (m.y >= m.z ? 1 : 2);
  vec3 p = axisFirst(gridPosition, axis);
  vec3 direction = axisFirst(n, axis);
  // Moves along the normal to the face of its own cell to which the surface turns; the point may
  // come to lie on that face's neighbour.
  float face = direction.x > 0.0 ? floor(p.x) + 1.0 : ceil(p.x) - 1.0;
  vec2 onFace = p.yz + direction.yz * ((face - p.x) / direction.x);
  vec2 cell = floor(onFace);
  vec2 toCentre = cell + 0.5 - onFace;
  float radius = 0.25 * (2.0 - nv);  // eq. 3
  vec2 along = axisFirst(k, axis).yz;
  float lengthAlong = length(along);
  along = lengthAlong > 1e-12 ? along / lengthAlong : vec2(0.0);
  Seed seed = Seed(1.0, 1.0, 0);
  float distance = length(toCentre);
  // Eq. 2: ⟨k′, q1 − p′⟩ and ⟨k′, q2 − p′⟩ have one sign.
  if (abs(dot(along, toCentre)) > 0.25 * radius || distance >= contactReach * radius)
    return seed;
  if (distance < radius) {
    seed.colour = distance < 0.5 * radius ? 0.0 : haloColour;
    seed.permeability = 0.0;
  } else {
    seed.permeability = (distance - radius) / (contactReach * radius - radius);  // eq. 4
  }
  ivec3 place = (ivec3(int(face), ivec2(cell)) + 256) & 511;
  int side = direction.x > 0.0 ? 1 : 0;
  seed.identity = 1 << 30 | axis << 28 | side << 27 | place.x << 18 | place.y << 9 | place.z;
  return seed;
}

void main() {
  // This pass leaves out the pixels that the surface pass left out.
  float depth = texelFetch(surfaceDepth, ivec2(gl_FragCoord.xy) + toAtlas, 0).r;
  if (abs(gl_FragCoord.z - depth) > 4e-6)
    discard;
  vec3 n = normalize(surfaceNormal);
  vec3 v = normalize(towardsEye);
  float nv = dot(n, v);
  float side = twoSided != 0 && nv < 0.0 ? -1.0 : 1.0;
  vec3 k = side * gradient;
  nv = clamp(side * nv, 0.0, 1.0);

  vec4 moved = viewProjection * vec4(k, 0.0);
  vec2 direction = (moved.xy * clipPosition.z - clipPosition.xy * moved.w) * pictureSize;
  float pixels = length(direction);
  direction = pixels > 1e-20 ? direction / pixels : vec2(0.0);

  // Eq. 6, with v̂ towards the eye. θ_c = π/2 means w_a = 0.
  float byAngle = weight.y < quarterTurn
      ? clamp((acos(nv) - weight.y) / max(quarterTurn - weight.y, 1e-4), 0.0, 1.0) : 0.0;
  float opacity = clamp(byAngle * -dot(k, v) * weight.x, 0.0, 1.0) * weight.z;

  Seed seed = seedAt(side * n, k, nv);
  ivec2 d = ivec2(round(direction * 32767.0));
  ivec2 c = ivec2(round(vec2(seed.colour, seed.permeability) * 32767.0));
  field = ivec4((d.x & 0xffff) | d.y << 16, c.x | c.y << 16, floatBitsToInt(opacity),
                seed.identity);
}
