// SPDX-License-Identifier: Apache-2.0
// Asks Khronos's glTF validator about files: one line of JSON each. Run where `npm ci` was.
'use strict';

const fs = require('fs');
const {createRequire} = require('module');
const path = require('path');

const validator =
    createRequire(path.join(process.cwd(), 'package.json'))('gltf-validator');

async function main() {
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(
        new Uint8Array(fs.readFileSync(file)), {maxIssues: 20});
    const {numErrors, numWarnings, messages} = report.issues;
    console.log(JSON.stringify({
      errors: numErrors,
      warnings: numWarnings,
      messages: messages.filter((message) => message.severity < 2)
                    .map((message) => `${message.pointer}: ${message.code}: ${message.message}`),
      triangles: report.info.totalTriangleCount,
    }));
  }
}

main();
