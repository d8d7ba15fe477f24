// The sources of a scene in tabs. What is changed is drawn after a short pause, and messages stand at their lines.

/** @typedef {import("./types.js").Message} Message */
import { make } from "./dom.js";

const kPause = 350;  // milliseconds without a key

export class Editor {
    /**
     * @param {(name: string, text: string) => void} changed
     * @param {(name: string, text: string) => string} colour
     * @param {(name: string, text: string) => void} save
     */
    constructor(changed, colour, save) {
        this.changed = changed;
        this.colour = colour;
        /** @type {Map<string, { text: string, original: string, saved: string, tab: HTMLButtonElement }>} */
        this.sources = new Map();
        this.open = "";
        /** @type {Message[]} */
        this.messages = [];
        this.timer = 0;
        this.tabs = make("div", { class: "tabs", role: "tablist", "aria-label": "Sources", keydown: (/** @type {KeyboardEvent} */ event) => this.nextTab(event) });
        this.lines = make("div", { class: "lines", "aria-hidden": "true" });
        this.area = make("textarea", { spellcheck: "false", autocapitalize: "off", autocomplete: "off", wrap: "off", rows: 1,
            input: () => this.type(), keydown: (/** @type {KeyboardEvent} */ event) => this.key(event) });
        this.restoreButton = make("button", { type: "button", text: "Restore", title: "The text as the page has it", click: () => this.restore() });
        this.saveButton = make("button", { type: "button", text: "Save", title: "Save the text as a file",
            click: () => save(this.open.slice(this.open.lastIndexOf("/") + 1), /** @type {any} */ (this.sources.get(this.open)).saved = this.area.value) });
        this.code = make("div", { class: "code", role: "tabpanel" }, this.lines, this.area);
        this.element = make("section", { class: "sources", "aria-label": "Sources" }, 
            make("div", { class: "tabrow" }, this.tabs, this.restoreButton, this.saveButton), this.code);
    }

    /** Shows texts that cannot be changed. */
    fix() {
        this.area.readOnly = this.restoreButton.hidden = this.saveButton.hidden = true;
    }

    get isChanged() {
        return [...this.sources.values()].some((each) => each.text !== each.original && each.text !== each.saved);
    }

    /**
     * Shows a tab for each text. A text that is known keeps what was typed.
     * @param {{ name: string, text: string }[]} texts
     */
    fill(texts) {
        for (const name of [...this.sources.keys()].filter((each) => texts.every((one) => one.name !== each))) this.sources.delete(name);
        for (const { name, text } of texts)
            if (!this.sources.has(name)) {
                const tab = make("button", { type: "button", role: "tab", text: name.slice(name.lastIndexOf("/") + 1), title: name, click: () => this.show(name) });
                this.sources.set(name, { text, original: text, saved: text, tab });
            }
        this.tabs.replaceChildren(...texts.map((each) => /** @type {any} */ (this.sources.get(each.name)).tab));
        this.element.hidden ||= texts.length === 0;
        if (!this.sources.has(this.open) && texts.length > 0) this.show(texts[0].name);
    }

    /** @param {string} name */
    show(name) {
        const source = this.sources.get(name);
        if (!source) return;
        this.open = name;
        this.area.value = source.text;
        this.area.setAttribute("aria-label", name);
        this.paint();
    }

    /**
     * The line of a message, chosen.
     * @param {Message} message
     */
    goTo(message) {
        this.show(message.file ?? "");
        const lines = this.area.value.split("\n"), line = (message.line ?? 1) - 1;
        const begin = lines.slice(0, line).join("\n").length + (line > 0 ? 1 : 0);
        this.area.focus({ preventScroll: true });
        this.area.setSelectionRange(begin, begin + (lines[line]?.length ?? 0));
        this.lines.querySelectorAll("li")[line]?.scrollIntoView({ block: "center" });
    }

    /** Draws the open text, and which texts have been changed. */
    paint() {
        const source = this.sources.get(this.open);
        if (!source) return;
        for (const [name, { text, original, tab }] of this.sources) {
            tab.setAttribute("aria-selected", String(name === this.open));
            tab.tabIndex = name === this.open ? 0 : -1;
            tab.classList.toggle("changed", text !== original);
            tab.classList.toggle("wrong", this.messages.some((each) => each.file === name && each.severity === "error"));
        }
        this.restoreButton.disabled = source.text === source.original;
        this.lines.innerHTML = this.colour(this.open, source.text);  // all of the text is escaped
        const rows = this.lines.querySelectorAll("li");
        for (const each of this.messages) {
            const row = each.file === this.open ? rows[(each.line ?? 1) - 1] : undefined;
            if (!row || row.classList.contains("error")) continue;
            row.classList.add(each.severity);
            row.title = each.text;
        }
        this.area.style.height = `${this.lines.scrollHeight}px`;
        this.area.style.width = "0";
        this.area.style.width = `${Math.max(this.area.scrollWidth, this.code.clientWidth - this.area.offsetLeft)}px`;
    }

    /** @param {Message[]} messages */
    mark(messages) {
        this.messages = messages;
        this.paint();
    }

    type() {
        const source = this.sources.get(this.open), name = this.open;
        if (!source) return;
        source.text = this.area.value;
        this.messages = this.messages.filter((each) => each.file !== name);  // their lines have moved
        this.paint();
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.changed(name, source.text), kPause);
    }

    /** @param {KeyboardEvent} event */
    key(event) {
        if (event.key === "Escape") this.area.blur();
        if (event.key !== "Enter" || event.isComposing || this.area.readOnly) return;
        // A new line is indented as the one before.
        const line = this.area.value.slice(0, this.area.selectionStart).split("\n").at(-1) ?? "";
        event.preventDefault();
        this.area.setRangeText("\n" + (line.match(/^\s*/)?.[0] ?? ""), this.area.selectionStart, this.area.selectionEnd, "end");
        this.type();
    }

    /** @param {KeyboardEvent} event */
    nextTab(event) {
        const names = [...this.sources.keys()], step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (step === 0) return;
        this.show(names[(names.indexOf(this.open) + step + names.length) % names.length]);
        this.sources.get(this.open)?.tab.focus();
    }

    restore() {
        this.area.value = this.sources.get(this.open)?.original ?? "";
        this.type();
    }
}
