// SPDX-License-Identifier: MIT
// The parameters of the robot: values, what is known about them, changes from this page, and undo.

const isSame = (some, other) =>
  some === other || (typeof some === "number" && Math.abs(some - other) <= 1e-6 * Math.abs(some)); // stored as a float

export class Parameters {
  constructor(onChange = () => {}, onEdit = onChange) {
    this.onChange = onChange;
    this.onEdit = onEdit;
    this.all = new Map(); // name: {name, value, default, min, max, unit, description, origin}
    this.start = new Map(); // name: value when the run was first seen
    this.undos = []; // {name, value}: values before changes of this page
    this.pending = new Map(); // name: {id, value}: sent last, and not yet answered
    this.refusals = new Map(); // name: text
    this.file = null; // {name, values: Map of texts}: with which the values are compared
    this.session = null;
  }

  /// Another session is another run: its values are the new start.
  begin(session) {
    if (session === this.session) return;
    this.session = session;
    this.all.clear();
    this.start.clear();
    this.undos = [];
    this.refusals.clear();
    this.pending.clear();
    this.onChange();
  }

  /// The connection is closed: nothing that was sent is answered.
  forgetSent() {
    this.pending.clear();
    this.onChange();
  }

  /// Takes descriptions and values, from the service parameter_list or from parameterValues. `id`: that of the message
  /// that they answer. An answer to an older message than the last one does not move a slider back.
  take(list, id) {
    for (const parameter of list) {
      if (typeof parameter?.name !== "string") continue;
      const sent = this.pending.get(parameter.name);
      if (sent && sent.id !== id) continue;
      const known = this.all.get(parameter.name) ?? { name: parameter.name };
      this.all.set(parameter.name, { ...known, ...parameter });
      if (!this.start.has(parameter.name)) this.start.set(parameter.name, parameter.value);
      if (!sent) continue;
      this.pending.delete(parameter.name);
      if (isSame(sent.value, parameter.value)) {
        this.refusals.delete(parameter.name);
        this.all.get(parameter.name).origin = "this page";
      } else {
        this.refusals.set(parameter.name, `The robot uses ${parameter.value} instead of ${sent.value}.`);
      }
    }
    this.onChange();
  }

  /// Takes a message of the topic /parameters, whose values are texts.
  takeTexts(list) {
    for (const { name, value, unit } of list) {
      const known = this.all.get(name);
      if (known && known.unit !== undefined) continue;
      const number = Number(value);
      const typed =
        value === "true" ? true : value === "false" ? false : value !== "" && Number.isFinite(number) ? number : value;
      this.all.set(name, { name, unit, ...(known ?? { value: typed }) });
      if (!this.start.has(name)) this.start.set(name, typed);
    }
    this.onChange();
  }

  /// The message that sets a value. `undo`: whether the value before is kept for undo.
  change(name, value, id, undo = true) {
    const before = this.all.get(name)?.value;
    const last = this.undos.at(-1);
    if (undo && before !== value) {
      // A slider sends many values; undo returns to the one before it was moved.
      if (!(last && last.name === name && last.open)) this.undos.push({ name, value: before, open: true });
    }
    this.all.set(name, { ...this.all.get(name), value });
    this.pending.set(name, { id, value });
    this.onEdit();
    return { op: "setParameters", parameters: [{ name, value }], id };
  }

  /// Ends a movement of a slider: the next change is undone separately.
  settle() {
    const last = this.undos.at(-1);
    if (last) last.open = false;
  }

  takeUndo() {
    const undo = this.undos.pop();
    this.onEdit();
    return undo;
  }

  /// Takes the answer of the service file_parameters.
  takeFile({ file, parameters }) {
    this.file = { name: file, values: new Map(parameters.map(({ name, value }) => [name, value])) };
    this.onEdit();
  }

  /// The value in the compared file, of the type of the present one; without an entry the default.
  inFile({ name, value, default: standard }) {
    const text = this.file?.values.get(name);
    if (text === undefined) return this.file ? standard : undefined;
    if (typeof value === "number") return Number(text);
    return typeof value === "boolean" ? text === "true" : text;
  }

  /// Names whose value differs from `key`: "default", "start" of the run, or "file".
  differing(key) {
    return [...this.all.values()].filter((it) => this.differs(it, key));
  }

  differs(parameter, key) {
    const other =
      key === "default"
        ? parameter.default
        : key === "file"
          ? this.inFile(parameter)
          : this.start.get(parameter.name);
    return other !== undefined && !isSame(other, parameter.value);
  }
}
