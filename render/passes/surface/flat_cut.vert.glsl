// SPDX-License-Identifier: Apache-2.0
#define SECTIONED
#include "flat.vert.glsl"
