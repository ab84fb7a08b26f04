// Khronos' glTF validator on files: prints errors and warnings, one a line; fails if there are any.
//   node validate.mjs FILE...
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";

const { validateBytes } = createRequire(import.meta.url)("gltf-validator");
let faults = 0;
for (const file of process.argv.slice(2)) {
  const report = await validateBytes(new Uint8Array(readFileSync(file)), {
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
  });
  for (const { severity, code, message, pointer } of report.issues.messages) {
    if (severity > 1) continue; // information and hints, as of materials that nothing uses
    console.log(`${file}${pointer}: ${code}: ${message}`);
    ++faults;
  }
}
process.exitCode = faults ? 1 : 0;
