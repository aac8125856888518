// SPDX-License-Identifier: Apache-2.0
#define SECTIONED
#include "surface.frag.glsl"
