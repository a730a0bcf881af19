// A sentence about the model, and buttons for the most likely changes.

import { button, el } from "../dom/element";
import { kilograms } from "../dom/number";
import type { Inspection } from "../engine/types";
import { currentFile, hasMisplacedSpheres, isSameMass, type OpenModel } from "../state/model";
import type { Session } from "../state/session";

/** The sentence and the buttons. */
export function questionView(session: Session, model: OpenModel, inspection: Inspection): HTMLElement[] {
  return [el("p", { class: "says" }, describeModel(inspection)), ...offers(session, model, inspection)];
}

function describeModel({ mass_kg: bodyMass, contacts_mass_kg: contactsMass, forces, known_contacts: knownContacts }: Inspection): string {
  const weighs = bodyMass === null ? "It is not known what it weighs" : `Weighs ${kilograms(bodyMass)}`;
  if (forces.length === 0) return `${weighs}; it has no contacts.`;
  if (knownContacts && contactsMass?.source !== "note") return `${weighs}; its contacts are those of ${knownContacts.title}, made for ${kilograms(knownContacts.made_for_kg)}.`;
  const words = contactsMass ? `its contacts were made for ${kilograms(contactsMass.value)}` : "nobody wrote down which mass its contacts were made for";
  return `${weighs}; ${words}.`;
}

function offers(session: Session, model: OpenModel, inspection: Inspection): HTMLElement[] {
  const follow = followOffers(session, model);
  const all = [...(follow.length > 0 ? follow : massOffer(session, model, inspection)), ...addOffers(session, inspection)];
  return all.length > 0 ? [el("div", { class: "offers", role: "group", "aria-label": "Most likely" }, ...all)] : [];
}

/** A button if the contacts were made for another mass than the body's, and the spheres are where the bones are. */
function massOffer(session: Session, model: OpenModel, { mass_kg: bodyMass, contacts_mass_kg: contactsMass, forces }: Inspection): HTMLElement[] {
  if (bodyMass === null || !contactsMass || forces.length === 0 || isSameMass(contactsMass.value, bodyMass)) return [];
  if (model.inspected && hasMisplacedSpheres(model.inspected)) return [];
  const confirmed = contactsMass.source === "known-contacts" ? [["contacts_mass", massText(contactsMass.value)] as const] : [];
  const values = new Map([["target_mass", massText(bodyMass)], ...confirmed]);
  return [button(`Make them fit this body: ${kilograms(bodyMass)}`, () => session.setVerb("rescale", values), { class: "offer" })];
}

/** A mass without the rounding error of a sum. */
function massText(kg: number): string {
  return String(Number(kg.toPrecision(8)));
}

/** A button for each open model from which this one was scaled: the change that `check` proposes. */
function followOffers(session: Session, model: OpenModel): HTMLElement[] {
  const open = new Set(session.models.value.filter(({ id }) => id !== model.id).map(currentFile));
  return model.originals.filter(({ file }) => open.has(file)).map(({ file, request }) => {
    const isValue = (entry: [string, unknown]): entry is [string, string | boolean] => ["string", "boolean"].includes(typeof entry[1]);
    const values = new Map(Object.entries(request).filter(isValue).filter(([name]) => name !== "verb"));
    return button(`Scaled from ${file}? Let its contacts follow the bones`, () => session.setVerb("transfer", values), { class: "offer" });
  });
}

const WAYS: readonly [title: string, about: string, field: string][] = [
  ["From a reference", "spheres of another model or a preset", "from"],
  ["Under its own bones", "spheres below the meshes of the feet", "count"],
  ["From a table", "places of your own", "contacts"],
];

/** Buttons for three ways to add contacts to a model that has none. */
function addOffers(session: Session, { forces }: Inspection): HTMLElement[] {
  if (forces.length > 0) return [];
  return WAYS.map(([title, about, field]) => {
    const act = () => {
      session.setVerb("add");
      focusField(field);
    };
    const offer = button("", act, { class: "offer way" });
    offer.append(wayPicture(field), el("strong", {}, title), " ", el("span", { class: "quiet" }, about));
    return offer;
  });
}

/** Moves the focus to the field that the user has to fill first. */
function focusField(name: string): void {
  const field = document.getElementById(`form-${name}`);
  field?.scrollIntoView({ block: "center" });
  field?.focus({ preventScroll: true });
}

const SVG = "http://www.w3.org/2000/svg";
const SOLE = "M4 20 Q6 8 14 9 Q30 12 44 19 L44 22 L6 22 Z";
/** Drawings: a foot with spheres from another foot; spheres below a bone; a table. */
const PICTURES: Readonly<Record<string, readonly [shape: string, kind: "line" | "ball"][]>> = {
  from: [[SOLE, "line"], ["M9 22 a4 4 0 1 0 8 0 a4 4 0 1 0 -8 0", "ball"], ["M32 22 a4 4 0 1 0 8 0 a4 4 0 1 0 -8 0", "ball"], ["M22 3 L22 14 M18 10 L22 14 L26 10", "line"]],
  count: [[SOLE, "line"], ["M7 26 a3 3 0 1 0 6 0 a3 3 0 1 0 -6 0", "ball"], ["M21 26 a3 3 0 1 0 6 0 a3 3 0 1 0 -6 0", "ball"], ["M36 26 a3 3 0 1 0 6 0 a3 3 0 1 0 -6 0", "ball"]],
  contacts: [["M6 4 H42 V28 H6 Z M6 12 H42 M6 20 H42 M18 4 V28 M30 4 V28", "line"]],
};

function wayPicture(way: string): SVGSVGElement {
  const picture = document.createElementNS(SVG, "svg");
  for (const [name, value] of [["viewBox", "0 0 48 32"], ["class", "way-picture"], ["aria-hidden", "true"]] as const) picture.setAttribute(name, value);
  for (const [shape, kind] of PICTURES[way] ?? []) {
    const path = document.createElementNS(SVG, "path");
    path.setAttribute("d", shape);
    path.setAttribute("class", kind);
    picture.append(path);
  }
  return picture;
}
