// Keeps the address and the form the same.

import { addressOf, readAddress } from "../address/address";
import { CALCULATOR, CHANGES, formOf } from "../forms/all";
import type { Session } from "../state/session";

/** Reads the address now and whenever it changes; gives what writes it. */
export function wireAddress(session: Session): () => void {
  const take = () => {
    const asked = readAddress(location.hash, CHANGES);
    if (!asked) return;
    session.setVerb(asked.verb, asked.values);
    if (asked.verb !== CALCULATOR.verb || session.models.value.length > 0) return;
    session.calculation.replace(asked.values);
    session.calculating.set(true);
  };
  take();
  addEventListener("hashchange", take);
  return () => {
    const alone = session.calculating.value && session.models.value.length === 0;
    const form = alone ? CALCULATOR : formOf(session.verb.value);
    if (!form) return;
    const presets = new Set(session.presets.value.filter(({ file }) => file === undefined).map(({ name }) => name));
    // Until they are known, a preset cannot be distinguished from a file.
    if (presets.size === 0) return;
    const address = `#${addressOf(form, alone ? session.calculation : session.values, (name) => presets.has(name))}`;
    if (address !== location.hash) history.replaceState(null, "", address);
  };
}
