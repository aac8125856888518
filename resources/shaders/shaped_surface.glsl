// SPDX-License-Identifier: Apache-2.0
// Declares what every vertex program reads that draws a surface with its curvature.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 shapeA;  // F_c·S as symmetric matrix: xx, yy, zz, xy
layout(location = 3) in vec2 shapeB;  // xz, yz

uniform mat4 viewProjection;
uniform vec2 pictureSize;
uniform vec4 layer;
uniform vec4 eye;          // position and 1, or for a parallel projection direction and 0
uniform float shapeScale;  // the value that a stored 1 stands for
uniform float filigree;    // F_c in mm
