// Keeps the address and the form equal; opens the example for an address that asks for it.

import { toAddress, readAddress } from "../address/address";
import { CALCULATOR, CHANGES, findForm } from "../forms/all";
import type { Session } from "../state/session";

/** The address of the page with its example open. */
const EXAMPLE = "#example";

/** Reads the address now and whenever it changes; returns a function that writes it. */
export function wireAddress(session: Session, openExample: () => void): () => void {
  const applyAddress = () => {
    if (location.hash === EXAMPLE) return openExample();
    const parsed = readAddress(location.hash, CHANGES);
    if (!parsed) return;
    session.setVerb(parsed.verb, parsed.values);
    if (parsed.verb !== CALCULATOR.verb || session.models.value.length > 0) return;
    session.calculation.replace(parsed.values);
    session.calculating.set(true);
  };
  applyAddress();
  addEventListener("hashchange", applyAddress);
  return () => {
    const isCalculator = session.calculating.value && session.models.value.length === 0;
    const form = isCalculator ? CALCULATOR : findForm(session.verb.value);
    if (!form) return;
    const presets = new Set(session.presets.value.filter(({ file }) => file === undefined).map(({ name }) => name));
    // Before presets are loaded, their names cannot be distinguished from names of files.
    if (presets.size === 0) return;
    const address = `#${toAddress(form, isCalculator ? session.calculation : session.values, (name) => presets.has(name))}`;
    if (address !== location.hash) history.replaceState(null, "", address);
  };
}
