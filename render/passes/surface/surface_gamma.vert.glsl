// SPDX-License-Identifier: Apache-2.0
#define GAMMA_VARIES
#include "surface.vert.glsl"
