// Prints what gltf-validator says about files, one JSON line each.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(folder + "/package.json")("gltf-validator");
for (const file of files) {
    const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 20 });
    console.log(JSON.stringify({ file, ...issues }));
}
