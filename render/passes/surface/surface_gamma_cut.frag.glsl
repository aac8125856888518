// SPDX-License-Identifier: Apache-2.0
#define GAMMA_VARIES
#define SECTIONED
#include "surface.frag.glsl"
