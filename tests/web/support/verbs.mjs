// One request for each verb: the actions that fill the form, and the arguments of the same command.

export const VERBS = [
  { title: "Rescale", fill: (user) => user.field("Target mass (kg)").fill("100"), words: ["--target-mass", "100"] },
  { title: "Transfer", fill: preset, words: ["--from", "falisse2022"] },
  { title: "Add", fill: preset, words: ["--from", "falisse2022"] },
  {
    title: "Convert",
    fill: (user) => user.field("Class that forces get").selectOption({ label: "HuntCrossleyForce" }),
    words: ["--to", "hunt-crossley"],
  },
  { title: "Remove", fill: () => undefined, words: [] },
  { title: "Set", fill: (user) => user.field("stiffness").fill("x2"), words: ["stiffness=x2"] },
  { title: "Design", fill: (user) => user.field("Relative indentation").fill("0.16"), words: ["--indentation", "0.16"] },
].map((verb) => ({ ...verb, name: verb.title.toLowerCase() }));

function preset(user) {
  return user.field("Source of the contacts").selectOption("falisse2022");
}

/** Empties the form and fills it in again, for another model or a second use of the verb. */
export async function fillIn(user, { title, fill }) {
  await user.verb(title);
  const clear = user.button("Clear the form", user.form);
  // There is no such button while nothing is typed.
  if (await clear.isVisible()) await clear.click();
  await fill(user);
}
