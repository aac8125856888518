// SPDX-License-Identifier: Apache-2.0
#define GRAINED
#include "contour.frag.glsl"
