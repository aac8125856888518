// SPDX-License-Identifier: Apache-2.0
// Packages that the program has made, against the schemas of those who set the standards. run.sh has
// the packages made and fetches the schemas: PAGE_PACKAGES and PAGE_SCHEMAS are their folders.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { inflateRawSync } from "node:zlib";
import { modules } from "./browser.mjs";

const packages = process.env.PAGE_PACKAGES ?? "";
const schemas = process.env.PAGE_SCHEMAS ?? "";
const skip = !packages && "no packages were made";
let folder = "";
before(() => (folder = mkdtempSync(join(tmpdir(), "sline-schema-"))));
after(() => rmSync(folder, { recursive: true }));

/** The members of a ZIP file, by name. @param {string} file */
function membersOf(file) {
  const bytes = readFileSync(file);
  const end = bytes.lastIndexOf("PK\x05\x06", bytes.length, "latin1");
  const members = new Map();
  let at = bytes.readUInt32LE(end + 16);
  for (let left = bytes.readUInt16LE(end + 10); left > 0; --left) {
    const [method, size, , name, extra, comment] = [
      bytes.readUInt16LE(at + 10),
      bytes.readUInt32LE(at + 20),
      0,
      bytes.readUInt16LE(at + 28),
      bytes.readUInt16LE(at + 30),
      bytes.readUInt16LE(at + 32),
    ];
    const local = bytes.readUInt32LE(at + 42);
    const begin = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
    const packed = bytes.subarray(begin, begin + size);
    members.set(bytes.toString("utf8", at + 46, at + 46 + name), method === 0 ? packed : inflateRawSync(packed));
    at += 46 + name + extra + comment;
  }
  return members;
}

/**
 * What xmllint says of a document by schemas of several namespaces; empty where it is valid.
 * @param {Uint8Array | string} xml @param {string} edition @param {[string, string][]} parts namespaces and their files
 */
function faults(xml, edition, parts) {
  const home = join(schemas, "scorm", "lib", "schemas", "definitionFiles", edition);
  const wrapper = join(folder, `${edition}.xsd`);
  writeFileSync(
    wrapper,
    `<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">${parts
      .map(([space, file]) => `<xs:import namespace="${space}" schemaLocation="${join(home, file)}"/>`)
      .join("")}</xs:schema>`,
  );
  const document = join(folder, "document.xml");
  writeFileSync(document, xml);
  try {
    execFileSync("xmllint", ["--nonet", "--noout", "--schema", wrapper, document], { stdio: "pipe" });
    return "";
  } catch (error) {
    return String(error.stderr ?? error);
  }
}

/** @type {{[kind: string]: [string, [string, string][]]}} */
const scorm = {
  scorm12: [
    "scorm12edition",
    [
      ["http://www.imsproject.org/xsd/imscp_rootv1p1p2", "imscp_rootv1p1p2.xsd"],
      ["http://www.adlnet.org/xsd/adlcp_rootv1p2", "adlcp_rootv1p2.xsd"],
      ["http://www.imsglobal.org/xsd/imsmd_rootv1p2p1", "imsmd_rootv1p2p1.xsd"],
    ],
  ],
  scorm2004: [
    "scorm20044thedition",
    [
      ["http://www.imsglobal.org/xsd/imscp_v1p1", "imscp_v1p1.xsd"],
      ["http://www.adlnet.org/xsd/adlcp_v1p3", "adlcp_v1p3.xsd"],
      ["http://www.adlnet.org/xsd/adlseq_v1p3", "adlseq_v1p3.xsd"],
      ["http://www.adlnet.org/xsd/adlnav_v1p3", "adlnav_v1p3.xsd"],
      ["http://www.imsglobal.org/xsd/imsss", "imsss_v1p0.xsd"],
    ],
  ],
};

for (const [kind, [edition, parts]] of Object.entries(scorm))
  test(`the manifest of ${kind} is valid, and names what is there`, { skip }, () => {
    const members = membersOf(join(packages, `${kind}.zip`));
    const manifest = String(members.get("imsmanifest.xml"));
    assert.equal(faults(manifest, edition, parts), "");
    const named = [...manifest.matchAll(/<file href="([^"]*)"/g)].map((match) => match[1]).sort();
    assert.deepEqual(named, [...members.keys()].filter((name) => name !== "imsmanifest.xml").sort());
    // Schemas that accept everything would say nothing.
    for (const spoilt of [
      manifest.replace("<organizations", "<organisations").replace("</organizations", "</organisations"),
      manifest.replace(/<item identifier="[^"]*"/, "<item"),
      manifest.replace(/<resources>[^]*<\/resources>/, ""),
    ])
      assert.notEqual(faults(spoilt, edition, parts), "", "a spoilt manifest is refused");
  });

test("h5p.json is valid", { skip }, () => {
  const Ajv = modules("ajv");
  const home = join(schemas, "h5p", "build", "src", "schemas");
  const read = (name) => JSON.parse(readFileSync(join(home, name), "utf8"));
  const ajv = new (Ajv.default ?? Ajv)({ strict: false, allErrors: true });
  ajv.addSchema(read("library-name-schema.json"));
  const check = ajv.compile(read("h5p-schema.json"));
  const h5p = JSON.parse(String(membersOf(join(packages, "h5p.h5p")).get("h5p.json")));
  assert.ok(check(h5p), JSON.stringify(check.errors));
  assert.ok(
    h5p.preloadedDependencies.some((one) => one.machineName === h5p.mainLibrary),
    "its main library is there",
  );
  for (const field of ["title", "mainLibrary", "preloadedDependencies"])
    assert.ok(!check({ ...h5p, [field]: undefined }), `without ${field} it is refused`);
});
