// The JSON Schema and the reader give the same verdict on every good and every bad model; what only the reader can know
// (names, physics, the text of expressions, other files) is listed in only_the_reader.txt.
//   node verdicts.mjs SOURCE MBGEN [--update]     --update writes the list anew: read the difference before committing it
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import Ajv2020 from "ajv/dist/2020.js";

const [source, mbgen, update] = process.argv.slice(2);
const list = join(source, "tests/system/schema/only_the_reader.txt");

/** JSON text without comments; texts in quotes stay as they are. */
function withoutComments(text) {
  return text.replace(/"(?:\\.|[^"\\])*"|\/\/[^\n]*|\/\*[\s\S]*?\*\//g, (found) => (found[0] === '"' ? found : " "));
}

/** All JSON files below a directory. */
function modelsIn(directory) {
  return readdirSync(directory, { recursive: true })
    .filter((name) => name.endsWith(".json"))
    .map((name) => join(directory, name))
    .sort();
}

function readerAccepts(file) {
  try {
    execFileSync(mbgen, ["inspect", file, "--dump=model"], { stdio: "ignore" });
    return true;
  } catch {
    return false;
  }
}

/** The check of a format by its schema. */
function validator(...options) {
  const schema = JSON.parse(execFileSync(mbgen, ["schema", ...options], { encoding: "utf8" }));
  return new Ajv2020({ allErrors: false, strict: true, allowUnionTypes: true, strictTypes: false, strictRequired: false }).compile(schema);
}
const validateModel = validator(), validateManoeuvre = validator("--manoeuvre");

/** Verdict of the schema on a file: "" when it accepts, else why not. */
function complaint(file, validate = validateModel) {
  let model;
  try {
    model = JSON.parse(withoutComments(readFileSync(file, "utf8").replace(/^\uFEFF/, "")));
  } catch (error) {
    return `no JSON: ${error.message}`;
  }
  if (validate(model)) return "";
  const [error] = validate.errors;
  return `${error.instancePath} ${error.message}`;
}

let faults = 0;
function fault(file, text) {
  console.error(`${relative(source, file)}: ${text}`);
  ++faults;
}

// Files that models include, and manoeuvres beside a vehicle, say so in their first line.
const opensWith = (file, words) => readFileSync(file, "utf8").startsWith(words);
const isManoeuvre = (file) => file.includes("/manoeuvres/") || opensWith(file, "// Manoeuvre");
const good = [...modelsIn(join(source, "models")), ...modelsIn(join(source, "tests/data/models"))].filter((file) => !isManoeuvre(file));
for (const file of modelsIn(join(source, "models")).filter(isManoeuvre)) {
  const why = complaint(file, validateManoeuvre);
  if (why) fault(file, `the schema refuses a good manoeuvre: ${why}`);
}
// Which fields a circle needs depends on its method, the speed that it asks for on its radius, and fields have no upper
// bounds in the schema: only the reader knows.
const onlyTheReaders = ["braking_speed.json", "circle_ends.json", "circle_radius.json", "circle_speed.json", "speeds.json"];
for (const file of modelsIn(join(source, "tests/errors/manoeuvres"))) {
  const isOnlyTheReaders = onlyTheReaders.some((name) => file.endsWith(`/${name}`));
  if (isOnlyTheReaders !== (complaint(file, validateManoeuvre) === "")) fault(file, "reader and schema do not agree as they should");
}
for (const file of good) {
  const why = complaint(file);
  if (why) fault(file, `the schema refuses a good model: ${why}`);
  const isPart = file.includes("/parts/") || file.includes("/tyres/") || opensWith(file, "// Part:");  // not models by themselves
  if (!isPart && !readerAccepts(file)) fault(file, "the reader refuses what should be a good model");
}

const bad = readdirSync(join(source, "tests/errors")).filter((name) => name.endsWith(".json")).sort();
const accepted = bad.filter((name) => complaint(join(source, "tests/errors", name)) === "");
if (update) writeFileSync(list, accepted.map((name) => name.replace(".json", "\n")).join(""));
const listed = new Set(readFileSync(list, "utf8").split("\n").filter((name) => name).map((name) => `${name}.json`));
for (const name of accepted) {
  if (!listed.has(name)) fault(join(source, "tests/errors", name), "the reader refuses it, the schema does not");
}
for (const name of listed) {
  if (!accepted.includes(name)) fault(list, `${name} is refused by the schema too, or is gone`);
}
// No rule of the schema is idle: it refuses a fair part of the bad models by itself.
if (bad.length - accepted.length < 60) fault(list, `the schema refuses only ${bad.length - accepted.length} bad models`);
console.log(`${good.length} good models, ${bad.length} bad ones, ${accepted.length} of them only the reader's`);
process.exit(faults === 0 ? 0 : 1);
