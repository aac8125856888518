// SPDX-License-Identifier: Apache-2.0
// The entry of pages for tests: the page's own modules with an engine and a reporter that tell the tests
// what is asked of them.

import { startPage } from "../../resources/page/main.js";
import { startEngine } from "./fake_engine.js";
import { createReporter } from "./fake_report.js";

startPage({ startEngine, createReporter });
