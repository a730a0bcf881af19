// Runs the command in its own folder, with the same files as the page.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, relative } from "node:path";

import { PROGRAM } from "./places.mjs";

const NAME = "osim-contact-scale";

/** A folder with these files, in which commands run. */
export class Folder {
  constructor(...files) {
    this.path = mkdtempSync(join(tmpdir(), "osim-web-"));
    for (const { name, bytes } of files) this.write(name, bytes);
    this.given = this.names();
  }

  write(name, bytes) {
    mkdirSync(dirname(join(this.path, name)), { recursive: true });
    writeFileSync(join(this.path, name), bytes);
  }

  read(name) {
    return readFileSync(join(this.path, name));
  }

  /** The names of all files, with their folders. */
  names(folder = this.path) {
    const inside = readdirSync(folder).map((name) => join(folder, name));
    const files = inside.flatMap((path) => (statSync(path).isDirectory() ? this.names(path) : [relative(this.path, path)]));
    return files.sort();
  }

  /** The names of files that commands made. */
  made() {
    return this.names().filter((name) => !this.given.includes(name));
  }

  /** Removes the files that commands made. */
  clear() {
    for (const name of this.made()) rmSync(join(this.path, name));
  }

  /** Runs the program with these arguments. */
  run(...words) {
    return endOfChild(spawn(PROGRAM, words, { cwd: this.path }));
  }

  /** Runs a line as it would be typed into a shell. */
  type(line) {
    const programs = mkdtempSync(join(tmpdir(), "osim-web-program-"));
    symlinkSync(PROGRAM, join(programs, NAME));
    const env = { ...process.env, PATH: `${programs}:${process.env.PATH}` };
    return endOfChild(spawn("bash", ["-c", line], { cwd: this.path, env })).finally(() => rmSync(programs, { recursive: true }));
  }

  end() {
    rmSync(this.path, { recursive: true });
  }
}

function endOfChild(child) {
  const output = { stdout: "", stderr: "" };
  for (const stream of ["stdout", "stderr"]) child[stream].setEncoding("utf8").on("data", (text) => (output[stream] += text));
  return new Promise((resolve, reject) => {
    child.on("error", reject);
    child.on("close", (status) => resolve({ status, ...output }));
  });
}

/** Asserts that the command `line`, typed in a folder with the same files, makes files with the names and bytes of the downloads. */
export async function makesTheSame(line, files, downloads) {
  const folder = new Folder(...files);
  try {
    const { status, stderr } = await folder.type(line);
    assert.equal(status, 0, `${line}\n${stderr}`);
    assert.deepEqual(folder.made(), downloads.map(({ name }) => name).sort(), line);
    for (const { name, bytes } of downloads) assert.ok(folder.read(name).equals(bytes), `${name} differs from what makes\n${line}`);
  } finally {
    folder.end();
  }
}
