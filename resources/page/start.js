// SPDX-License-Identifier: Apache-2.0
// The page's entry: starts it with the program that Emscripten makes and with the reporters. All that
// it imports is bundled into page.js (render/web/page_bundle.cmake).

import createEngineModule from "engine_module";

import { startEngine } from "../../render/web/engine.js";
import { startPage } from "./main.js";
import { createReporter } from "./report_kinds.js";

startPage({ startEngine: (options) => startEngine(createEngineModule, options), createReporter });
