// The facts of a model in a few lines.

import { type Child, el } from "../dom/element";
import { counted, digits, kilograms } from "../dom/number";
import type { Inspection, Inspected } from "../engine/types";

const SOURCES: Readonly<Record<string, string>> = { note: "note in the file", bodies: "not recorded; taken from the bodies", "known-contacts": "as published" };

/** The summary as a list of terms. */
export function summary({ inspection }: Inspected): HTMLElement {
  const rows: [string, Child[]][] = [
    ["Mass", massOfModel(inspection)],
    ["Contacts made for", massOfContacts(inspection)],
    ["Limbs", limbsWithSpheres(inspection)],
    ["Spheres", [String(inspection.spheres.length)]],
    ["Forces", [forcesText(inspection)]],
    ["Gravity", [inspection.gravity_m_s2 == null ? "unknown" : `${digits(inspection.gravity_m_s2)} m/s²`]],
  ];
  return el("dl", { class: "summary" }, ...rows.flatMap(([term, content]) => [el("dt", {}, term), el("dd", {}, ...content)]));
}

function quietText(text: string): HTMLElement {
  return el("span", { class: "quiet" }, text);
}

function massOfModel({ mass_kg: bodyMass, bodies }: Inspection): Child[] {
  const text = bodyMass === null ? "unknown" : kilograms(bodyMass);
  return bodies.length === 0 ? [text] : [text, quietText(` sum of ${counted(bodies.length, "body", "bodies")}`)];
}

function massOfContacts({ contacts_mass_kg: contactsMass, known_contacts: knownContacts, forces: all }: Inspection): Child[] {
  if (all.length === 0) return ["there are no contacts"];
  const text = contactsMass ? [kilograms(contactsMass.value), quietText(` ${SOURCES[contactsMass.source] ?? contactsMass.source}`)] : ["unknown"];
  return knownContacts ? [...text, el("br"), quietText(`parameters of ${knownContacts.title}`)] : text;
}

function limbsWithSpheres({ limbs: all }: Inspection): Child[] {
  if (!all || all.length === 0) return ["none found"];
  const texts = all.map(({ name, side, spheres }) => `${name}${side ? ` (${side})` : ""}: ${counted(spheres.length, "sphere")}`);
  return texts.flatMap((text, index) => (index === 0 ? [text] : [el("br"), text]));
}

function forcesText({ forces: all }: Inspection): string {
  if (all.length === 0) return "none";
  const counts = new Map<string, number>();
  for (const { type } of all) counts.set(type, (counts.get(type) ?? 0) + 1);
  return [...counts].map(([type, count]) => `${count} × ${type}`).join(", ");
}

/** A sentence about the masses of a model. */
export function describeModel({ mass_kg: bodyMass, contacts_mass_kg: contactsMass, forces, known_contacts: knownContacts }: Inspection): string {
  const weighs = bodyMass === null ? "Its mass is not known" : `Weighs ${kilograms(bodyMass)}`;
  if (forces.length === 0) return `${weighs}; it has no contacts.`;
  if (knownContacts && contactsMass?.source !== "note") return `${weighs}; its contacts are those of ${knownContacts.title}, made for ${kilograms(knownContacts.made_for_kg)}.`;
  const words = contactsMass ? `its contacts were made for ${kilograms(contactsMass.value)}` : "nobody wrote down which mass its contacts were made for";
  return `${weighs}; ${words}.`;
}
