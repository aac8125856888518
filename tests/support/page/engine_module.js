// SPDX-License-Identifier: Apache-2.0
// Stands in for what Emscripten makes.
const createEngineModule = () => Promise.reject(new Error("a stand-in"));
