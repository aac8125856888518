// SPDX-License-Identifier: Apache-2.0
// Places pixels of the whole picture (y upwards) in a layer's own rectangle, which the viewport
// shows. `layer` is the rectangle: x, y, width, height in picture pixels.
vec2 layerPosition(vec2 pixel, vec4 layer) {
  return (pixel - layer.xy) / layer.zw * 2.0 - 1.0;
}

// Places a clip-space position of the whole picture in the same way. Pixel positions are rounded to
// 1/256, as the rasteriser does anyway, before the layer's own offset enters: so a surface covers
// the same pixels wherever its rectangle lies in the atlas, and tiles of a large picture have no
// seams.
vec4 layerClip(vec4 clip, vec2 pictureSize, vec4 layer) {
  if (clip.w < 1e-6)
    return vec4(clip.xy * pictureSize / layer.zw, clip.zw);
  vec2 pixel = (clip.xy / clip.w * 0.5 + 0.5) * pictureSize;
  pixel = floor(pixel * 256.0 + 0.5) / 256.0;
  return vec4(layerPosition(pixel, layer) * clip.w, clip.zw);
}
