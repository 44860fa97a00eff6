// SPDX-License-Identifier: MIT
// One script that is edited: its text in the editor and on the disk, the findings of the check, and saving. Several
// editors may have the same file: the robot saves only the text of one that began with what is on the disk.

const CHECK_DELAY = 300; // ms after the last key
const RETRY = 500; // ms, while another check is running
const BUSY = "another check is running";

export class EditedScript {
  /// `call(service, request)`: a promise of the answer; `onChange()`: something that is shown has changed;
  /// `replace(text)`: puts a text into the editor.
  constructor(file, text, { call, onChange, replace }) {
    Object.assign(this, { file, text, call, onChange, replace });
    this.base = text; // on the disk, as far as this editor knows
    this.disk = null; // another text on the disk, until the user chooses
    this.findings = []; // of the check
    this.notice = ""; // what was done without a choice
    this.failure = ""; // of the last call
    this.checkFailure = "";
    this.isSaving = false;
    this.isChecking = false;
    this.isClosed = false;
    this.checkAgain = false;
    this.timer = 0;
  }

  get isChanged() {
    return this.text !== this.base;
  }

  close() {
    this.isClosed = true;
    clearTimeout(this.timer);
  }

  /// The user has changed the text.
  typed(text) {
    this.text = text;
    this.notice = "";
    this.checkIn(CHECK_DELAY);
    this.onChange();
  }

  checkIn(delay) {
    clearTimeout(this.timer);
    if (!this.isClosed) this.timer = setTimeout(() => this.check(), delay);
  }

  async check() {
    if (this.isChecking) {
      this.checkAgain = true;
      return;
    }
    this.isChecking = true;
    this.checkAgain = false;
    const { text } = this;
    try {
      const { findings } = await this.call("check_script", { file: this.file, text });
      if (text === this.text) this.findings = findings;
      this.checkFailure = "";
    } catch (error) {
      if (error.message.includes(BUSY)) this.checkIn(RETRY);
      else this.checkFailure = error.message;
    }
    this.isChecking = false;
    if (this.checkAgain) this.checkIn(0);
    this.onChange();
  }

  /// Returns whether the file was written.
  async save() {
    if (this.isSaving) return false;
    this.isSaving = true;
    this.failure = "";
    this.onChange();
    const { text, base: expected } = this;
    let isSaved = false;
    try {
      const answer = await this.call("save_script", { file: this.file, text, expected });
      isSaved = answer.saved;
      if (isSaved) {
        this.base = text;
        this.disk = null;
        this.notice = "";
      } else {
        this.noticeDisk(answer.text);
      }
    } catch (error) {
      this.failure = `The script was not saved: ${error.message}`;
    }
    this.isSaving = false;
    this.onChange();
    return isSaved;
  }

  /// Compares with the disk.
  async look() {
    if (this.isSaving) return;
    const { base } = this;
    try {
      const { text } = await this.call("script", { file: this.file });
      if (this.isSaving || base !== this.base) return; // the answer is older than the last save
      this.noticeDisk(text);
    } catch {
      // The next look may succeed; a lost connection is shown elsewhere.
    }
  }

  noticeDisk(text) {
    const wasShown = this.disk;
    if (text === this.base) {
      this.disk = null;
    } else if (text === this.text) {
      this.base = text;
      this.disk = null;
    } else if (!this.isChanged) {
      this.take(text);
      this.notice = "The file has changed on the disk. The editor shows the new text.";
    } else {
      this.disk = text;
    }
    if (this.disk !== wasShown || this.notice) this.onChange();
  }

  /// Shows a text of the disk in place of the edited one.
  take(text) {
    this.base = text;
    this.disk = null;
    this.failure = "";
    this.replace(text);
    this.text = text;
    this.notice = "";
    this.checkIn(0);
    this.onChange();
  }

  /// Keeps the edited text: the next save replaces what is on the disk.
  keepMine() {
    this.base = this.disk;
    this.disk = null;
    this.onChange();
  }

  async revert() {
    this.failure = "";
    try {
      this.take((await this.call("script", { file: this.file })).text);
    } catch (error) {
      this.failure = `The text of the disk cannot be read: ${error.message}`;
      this.onChange();
    }
  }
}
