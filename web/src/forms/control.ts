// Creates the control of a field for its kind.

import type { Context, Control } from "./context";
import type { Field, Kind } from "./declaration";
import { fileControl } from "./file";
import { mapControl } from "./map";
import { numberControl } from "./number";
import { ruleControl } from "./rule";
import { choiceControl, flagControl, linesControl, textControl } from "./simple";
import { textsControl } from "./texts";

const CONTROLS: Readonly<Record<Kind, (field: Field, context: Context) => Control>> = {
  number: numberControl, integer: numberControl, flag: flagControl, choice: choiceControl, text: textControl,
  texts: textsControl, lines: linesControl, codes: linesControl, map: mapControl, rule: ruleControl, file: fileControl,
};

export function control(field: Field, context: Context): Control {
  return CONTROLS[field.kind](field, context);
}
