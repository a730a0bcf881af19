// Downloads changed files, the current model, or a report.

import { toFailure } from "../engine/failure";
import type { Failure, Request } from "../engine/types";
import { save } from "../download/save";
import { currentFile, type OpenModel, currentStep } from "../state/model";
import type { Session } from "../state/session";

/** Downloads the files that result from `request`. */
export async function downloadResult(session: Session, request: Request): Promise<Failure | undefined> {
  return attempt(async () => {
    const { change, files } = await session.engine.files(request);
    for (const { name, bytes } of files) save(name, bytes, "application/xml");
    const names = files.map(({ name }) => name).join(" and ");
    session.announce(change.unchanged ? "Nothing to change: no file was made." : `Downloaded ${names}.`);
  });
}

/** Downloads the current model, with the other files of its last step. */
export async function downloadModel(session: Session, model: OpenModel): Promise<Failure | undefined> {
  const names = currentStep(model)?.names ?? [currentFile(model)];
  return attempt(async () => {
    for (const name of names) {
      save(name, (await session.engine.file(name)).bytes, "application/xml");
      session.saved.add(name);
    }
    session.announce(`Downloaded ${names.join(" and ")}.`);
  });
}

/** Downloads the report about a change or a model. */
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
    return toFailure(error);
  }
}
