// SPDX-License-Identifier: Apache-2.0
#define GRAINED
#include "surface_line.frag.glsl"
