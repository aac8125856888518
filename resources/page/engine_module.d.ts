// SPDX-License-Identifier: Apache-2.0
// What Emscripten makes of render/web; the bundler is told where it lies.

declare module "engine_module" {
  const createEngineModule: (settings: { wasmBinary: Uint8Array }) => Promise<any>;
  export default createEngineModule;
}
