// SPDX-License-Identifier: Apache-2.0
uniform vec4 colour;

out vec4 fragment;

void main() {
  fragment = colour;
}
