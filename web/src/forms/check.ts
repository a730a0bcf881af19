// Checks the values of fields while the user types, to show problems beside the field. The engine checks them again.

import type { Value } from "./values";
import type { Field, Limits } from "./declaration";

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
const FACTOR_PATTERN = /^[xX×](.+)$/;

/** The number in `text`; undefined if it is not a number. */
export function numberIn(text: string): number | undefined {
  const trimmed = text.trim();
  // JSON has no infinity: a number that is too large would be lost.
  return NUMBER.test(trimmed) && Number.isFinite(Number(trimmed)) ? Number(trimmed) : undefined;
}

/** The problem of a value, as a sentence. */
export function valueProblem(field: Field, value: Value): string | undefined {
  switch (field.kind) {
    case "number":
    case "integer":
      return typeof value === "string" ? numberProblem(value, field) : undefined;
    case "rule":
      return typeof value === "string" ? ruleProblem(value, field) : undefined;
    case "map":
      return typeof value === "object" ? mapProblem(value as Readonly<Record<string, string>>) : undefined;
    default:
      return undefined;
  }
}

function numberProblem(text: string, { kind, limits = {} }: Field): string | undefined {
  const number = numberIn(text);
  if (number === undefined) return notANumber(text);
  if (kind === "integer" && !Number.isInteger(number)) return "Write a whole number.";
  return limitProblem(number, limits);
}

function notANumber(text: string): string {
  // A comma before three digits can separate thousands or decimals.
  if (/^[+-]?\d{1,3}(,\d{3})+$/.test(text.trim())) return `Write ${text.trim().replaceAll(",", "")}, or ${text.trim().replace(",", ".").replaceAll(",", "")} with a decimal point: the comma can mean either.`;
  const pointed = text.trim().replace(",", ".");
  return numberIn(pointed) !== undefined ? `Write ${pointed}, with a decimal point.` : "Write a number, such as 0.5 or 2e6, without a unit.";
}

function limitProblem(number: number, { least, most, above, below }: Limits): string | undefined {
  if (least !== undefined && number < least) return `Write a number of at least ${least}.`;
  if (above !== undefined && number <= above) return `Write a number above ${above}.`;
  if (most !== undefined && number > most) return `Write a number of at most ${most}.`;
  if (below !== undefined && number >= below) return `Write a number below ${below}.`;
  return undefined;
}

function ruleProblem(text: string, field: Field): string | undefined {
  if (field.choices?.some(({ value }) => value === text.trim())) return undefined;
  const factor = field.factor ? FACTOR_PATTERN.exec(text.trim())?.[1] : undefined;
  return factor === undefined ? numberProblem(text, field) : factorProblem(factor);
}

function factorProblem(text: string): string | undefined {
  const number = numberIn(text);
  return number === undefined ? notANumber(text) : limitProblem(number, { above: 0 });
}

function mapProblem(entries: Readonly<Record<string, string>>): string | undefined {
  const problems = Object.entries(entries).map(([name, text]) => {
    const problem = factorOrNumberProblem(text.trim());
    return problem && `${name}: ${problem}`;
  });
  return problems.find(Boolean);
}

function factorOrNumberProblem(text: string): string | undefined {
  const factor = FACTOR_PATTERN.exec(text)?.[1];
  if (factor !== undefined) return factorProblem(factor);
  const number = numberIn(text);
  return number === undefined ? notANumber(text) : limitProblem(number, { least: 0 });
}
