// SPDX-License-Identifier: Apache-2.0
#define ONE_LAYER
#include "resolve.frag.glsl"
