// Saves what was made: the changed files, the model as it is now, the report.

import { failureOf } from "../engine/failure";
import type { Failure, Request } from "../engine/types";
import { save } from "../download/save";
import { fileOf, type OpenModel, stepOf } from "../state/model";
import type { Session } from "../state/session";

/** Saves the files that `request` makes. */
export async function downloadResult(session: Session, request: Request): Promise<Failure | undefined> {
  return attempt(async () => {
    const { change, files } = await session.engine.files(request);
    for (const { name, bytes } of files) save(name, bytes, "application/xml");
    const names = files.map(({ name }) => name).join(" and ");
    session.announce(change.unchanged ? "Nothing to change: no file was made." : `Downloaded ${names}.`);
  });
}

/** Saves the model as it is now, with the files that were made along with it. */
export async function downloadModel(session: Session, model: OpenModel): Promise<Failure | undefined> {
  const names = stepOf(model)?.names ?? [fileOf(model)];
  return attempt(async () => {
    for (const name of names) {
      save(name, (await session.engine.file(name)).bytes, "application/xml");
      session.saved.add(name);
    }
    session.announce(`Downloaded ${names.join(" and ")}.`);
  });
}

/** Saves the report about a change, or about a model. */
export async function downloadReport(session: Session, request: Request): Promise<Failure | undefined> {
  return attempt(async () => {
    const { name, html } = await session.engine.report(request);
    save(name, html, "text/html");
    session.announce(`Downloaded ${name}.`);
  });
}

async function attempt(act: () => Promise<void>): Promise<Failure | undefined> {
  try {
    await act();
    return undefined;
  } catch (error) {
    return failureOf(error);
  }
}
