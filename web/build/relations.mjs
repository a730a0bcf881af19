// Which fields need, or exclude, which others: read from the conditions of a schema.

/** The relations between the fields that `known` has. */
export function relations(conditions, known) {
  const excludes = [];
  const needs = [];
  const either = [];
  for (const condition of conditions) {
    const both = bothGiven(condition);
    const need = needed(condition);
    if (both) excludes.push(both);
    else if (need) needs.push(need);
    else if (oneGiven(condition)) either.push(oneGiven(condition));
    else if (!given(condition)) throw new Error(`a condition that forms do not know: ${JSON.stringify(condition)}`);
  }
  return {
    excludes: excludes.filter((pair) => pair.every((name) => known.has(name))),
    either: either.filter((pair) => pair.every((name) => known.has(name))),
    needs: needs.filter(([name, others]) => known.has(name) && others.every((other) => known.has(other))),
  };
}

/** The field that must be given: `{$ref: "#/$defs/NAME_given"}`. */
function given({ $ref }) {
  return /^#\/\$defs\/(\w+)_given$/.exec($ref)?.[1];
}

/** The two fields that exclude each other: not both given. */
function bothGiven(schema) {
  const names = schema.not?.allOf?.map(given);
  return names?.length === 2 && names.every(Boolean) ? names : undefined;
}

/** Two fields, if one or the other must be given. */
function oneGiven(schema) {
  const names = schema.anyOf?.map(given);
  return names?.length === 2 && names.every(Boolean) ? names : undefined;
}

/** A field, and the others; if it is given, one of the others must be, too. */
function needed(schema) {
  const [first, ...others] = schema.anyOf ?? [];
  const name = first?.not && given(first.not);
  const names = others.map(given);
  return name && names.length > 0 && names.every(Boolean) ? [name, names] : undefined;
}
