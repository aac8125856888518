// SPDX-License-Identifier: Apache-2.0
// Enlarges surfaces that were drawn with one pixel for several. They reach a little farther than
// they should, so that no gap shows beside an outline, and are mended along outlines (ink pass).
uniform sampler2D colours;  // premultiplied
uniform sampler2D depths;   // 1 where a layer has nothing
uniform float pixelStep;    // pixels of the picture for one of these

struct Enlarged {
  vec4 colour;
  float depth;  // 1 where there is nothing
};

Enlarged enlargedAt(vec2 place) {
  vec2 at = place / pixelStep - 0.5;
  vec2 corner = floor(at);
  vec2 t = at - corner;
  ivec2 low = max(ivec2(corner), ivec2(0));
  ivec2 high = min(ivec2(corner) + 1, textureSize(depths, 0) - 1);
  vec4 depth = vec4(texelFetch(depths, low, 0).r, texelFetch(depths, ivec2(high.x, low.y), 0).r,
                    texelFetch(depths, ivec2(low.x, high.y), 0).r, texelFetch(depths, high, 0).r);
  vec4 weight = vec4((1.0 - t.x) * (1.0 - t.y), t.x * (1.0 - t.y), (1.0 - t.x) * t.y, t.x * t.y);
  weight *= vec4(lessThan(depth, vec4(1.0)));
  float covered = dot(weight, vec4(1.0));
  // It fades over one pixel of the picture, outside the line between pixels that have the surface
  // and those that have not.
  float share = covered > 0.0 ? clamp((covered - 0.5) * pixelStep + 1.5, 0.0, 1.0) : 0.0;
  weight /= max(covered, 1e-6);
  vec4 colour = weight.x * texelFetch(colours, low, 0) +
      weight.y * texelFetch(colours, ivec2(high.x, low.y), 0) +
      weight.z * texelFetch(colours, ivec2(low.x, high.y), 0) +
      weight.w * texelFetch(colours, high, 0);
  return Enlarged(colour * share, share > 0.0 ? dot(weight, depth) : 1.0);
}
