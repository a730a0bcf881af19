// Compares refusals of page and command. They may name options and fields differently; the rest of the messages must be equal.

// Shorter than that, two messages have only an article in common.
const LEAST_LETTERS = 20;

/** The fault in the JSON of a command that refused a model; undefined if the command did not refuse it. */
export function refusal({ stdout }) {
  return JSON.parse(stdout.trim().split("\n").pop()).error ?? undefined;
}

/** Whether the messages are the same up to the first name of an option or a verb. */
export function sameReason(command, page) {
  const [one, other] = [command, page].map(plainMessage);
  if (one === other) return true;
  // What begins with an option is compared from its verb on.
  if (one.startsWith("--")) return sameReason(fromVerb(one), fromVerb(other));
  let at = 0;
  while (one[at] === other[at]) at += 1;
  const beforeName = /^(the field )?“/.test(other.slice(at)) || /^(the field )?“/.test(other.slice(other.lastIndexOf(" ", at) + 1));
  return beforeName && at >= LEAST_LETTERS;
}

function plainMessage(message) {
  const words = message.replace(/^error /, "").replace(/\.$/, "").trim();
  return words.charAt(0).toLowerCase() + words.slice(1);
}

function fromVerb(text) {
  return text.slice(text.indexOf(" is "));
}
