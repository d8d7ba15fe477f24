// A scene on a page: it draws only while something moves, and only while it can be seen.

/** @typedef {import("./types.js").Scene} Scene */
/** @typedef {import("./types.js").Module} Module */
/** @typedef {import("./types.js").Opened} Opened */
/** @typedef {import("./types.js").Changed} Changed */
/** @typedef {import("./types.js").Message} Message */
import { Controls } from "./controls.js";
import { iconButton, make, unpacked } from "./dom.js";
import { Editor } from "./editor.js";
import { Keys } from "./keys.js";
import { hashOf, restore } from "./link.js";
import { showMessages, sorted } from "./messages.js";
import { Clock } from "./time.js";
import { ViewControl } from "./view.js";

const kGap = 16;  // CSS pixels between the picture and the values
const kWide = 22 * 16 + 30 * 16;  // CSS pixels that values and sources take beside the picture

/** @typedef {(canvas: HTMLCanvasElement) => Promise<Module>} Start compiles the module, or starts it once more */

export class App {
    /**
     * @param {HTMLElement} element which holds the picture that stands there first
     * @param {Scene} data
     * @param {Start} start
     */
    constructor(element, data, start) {
        this.element = element;
        this.data = data;
        this.start = start;
        this.title = document.title;
        this.poster = element.querySelector("img");
        this.canvas = make("canvas", { tabindex: 0, "aria-label": "the scene" });
        this.note = make("div", { class: "note", role: "status", hidden: true });
        /** @type {Module | undefined} */
        this.module = undefined;
        /** @type {Opened | undefined} */
        this.opened = undefined;
        /** @type {Map<string, Uint8Array>} */
        this.files = new Map();
        this.isStale = true;
        this.isSeen = true;
        this.frame = 0;  // that is asked for
        this.linkTimer = 0;
        /** @type {Message[]} of the last reading, and of frames since then */
        this.messages = [];
        this.clock = new Clock(() => this.change());
        this.view = new ViewControl(() => this.change());
        this.panel = make("aside", { class: "panel", "aria-label": "Values", hidden: true });
        this.controls = new Controls(this.panel, (knob, values) => this.setKnob(knob, values));
        this.keys = new Keys(this);
        this.list = make("ul", { class: "messages", "aria-label": "Messages", "aria-live": "polite", hidden: true });
        this.editor = new Editor((name, text) => this.edit(name, text), (source) => this.module?.colour(source) ?? "");
        this.sourceButton = iconButton("code", "Sources (E)", () => this.showSources(this.editor.element.hidden));
        this.bar = make("div", { class: "bar", role: "toolbar", "aria-label": "Scene" }, this.clock.element, this.view.element,
            make("span", { class: "tools" }, iconButton("save", "Save the picture", () => this.hardcopy()),
                iconButton("link", "Copy a link to what is shown", () => this.copyLink()), this.sourceButton,
                ...(document.fullscreenEnabled ? [iconButton("screen", "Full screen", () => this.fullScreen())] : [])));
        this.bar.hidden = true;  // until there is a scene
        this.stage = make("div", { class: "stage" }, ...(this.poster ? [this.poster] : []), this.note, this.bar, this.keys.element);
        element.prepend(this.stage);
        if (data.poster) this.showNote("Start the scene", () => this.run());
        else this.run();
    }

    async run() {
        this.hideNote();
        try {
            if (this.files.size === 0) await this.unpack();
            this.module = await this.start(this.canvas);
        } catch (failure) {
            return this.fail(failure);
        }
        for (const [name, content] of this.files) this.module.file(name, content);
        const isFirst = this.opened === undefined;
        if (!this.read(true) || !this.opened) return;
        if (isFirst) this.build();
        else this.putBack();
        this.poster?.remove();
        this.stage.prepend(this.canvas);
        this.resize();
        this.change();
    }

    async unpack() {
        const bytes = await unpacked(this.data.content);
        let at = 0;
        for (const each of this.data.files) {
            this.files.set(each.name, bytes.slice(at, at + each.bytes));
            at += each.bytes;
        }
    }

    /** What the page has only once: listeners, and what stands beside the picture. */
    build() {
        this.bar.hidden = false;
        this.element.append(this.panel, this.list, this.editor.element);
        this.showSources(!this.data.embed && this.element.clientWidth > 700);
        this.listen(this.canvas);
        this.keys.listen();
        new IntersectionObserver(([entry]) => this.see(entry.isIntersecting)).observe(this.stage);
        new ResizeObserver(() => this.resize()).observe(this.element);
        document.addEventListener("visibilitychange", () => this.change());
        document.addEventListener("fullscreenchange", () => this.resize());
        window.addEventListener("hashchange", () => this.restoreLink());
        this.clock.seconds = this.data.time;
        for (const each of this.data.set) this.preset(each);
        this.restoreLink();
    }

    /** @param {HTMLCanvasElement} canvas */
    listen(canvas) {
        this.view.listen(canvas);
        canvas.addEventListener("webglcontextlost", (event) => {
            event.preventDefault();
            this.module = undefined;
            this.showNote("The browser took the graphics away. Continue", () => this.begin());
        });
        canvas.addEventListener("webglcontextrestored", () => this.run());
    }

    /** Begins with a new canvas, after the module or its context has ended. */
    begin() {
        const canvas = make("canvas", { tabindex: 0, "aria-label": "the scene" });
        this.canvas.replaceWith(canvas);
        this.canvas = canvas;
        this.listen(canvas);
        return this.run();
    }

    /** @param {unknown} failure why nothing more can be drawn */
    fail(failure) {
        this.module = undefined;
        const why = failure instanceof Error ? failure.message : String(failure);
        console.warn("glibra:", failure);
        if (this.opened) this.showNote("The scene has stopped. Start it again", () => this.begin());
        else this.showNote(`This is a picture: ${why}`);
        this.note.title = why;
    }

    /**
     * Lets the module do something.
     * @template Result
     * @param {(module: Module) => Result} work
     * @returns {Result | undefined} nothing if there is no module, or it has ended
     */
    call(work) {
        if (!this.module) return undefined;
        try {
            return work(this.module);
        } catch (failure) {
            this.fail(failure);
            return undefined;
        }
    }

    /**
     * Reads the scene with what the files have now.
     * @param {boolean} isFirst
     */
    read(isFirst = false) {
        const opened = this.call((module) => module.open(this.data.scene));
        if (!opened) return false;
        this.opened = { ...opened, files: opened.files ?? this.opened?.files ?? [] };
        if (isFirst) this.clock.last = undefined;
        this.messages = opened.messages ?? [];
        this.fill(this.opened);
        return true;
    }

    /** @param {Opened} opened */
    fill(opened) {
        this.clock.fill(opened);
        this.view.fill(opened.cameras);
        this.controls.fill(opened.knobs);
        this.keys.fill(opened.keys ?? []);
        const text = new TextDecoder();
        this.editor.fill(opened.files.filter((each) => each.language && this.files.has(each.name))
            .map((each) => ({ name: each.name, text: text.decode(this.files.get(each.name)) })));
        this.showMessages();
        this.resize();
    }

    showMessages() {
        const converted = this.data.files.filter((each) => each.converted).map((each) => each.name.slice(each.name.lastIndexOf("/") + 1));
        // A picture that the page has in another format than its name says is none of the reader's business.
        const isOfPage = (/** @type {Message} */ each) => each.id === "file-W03" && converted.some((name) => each.text.includes(name));
        const messages = sorted(this.messages.filter((each) => !isOfPage(each)));
        showMessages(this.list, messages, (each) => {
            this.showSources(true);
            this.editor.goTo(each);
        });
        this.editor.mark(messages);
    }

    /** @param {Changed | undefined} changed what the module answers */
    take(changed) {
        if (!changed || !this.opened) return;
        if (changed.opened) {
            this.opened = { ...this.opened, ...changed.opened };
            this.fill(this.opened);
        }
        if (changed.worldView) this.view.worldView = changed.worldView;
        if (changed.projection) this.view.projection = changed.projection;
        for (const each of changed.knobs ?? []) {
            const knob = this.opened.knobs[each.knob];
            if (knob) knob.current = each.current;
        }
        if (changed.knobs?.length) this.controls.refresh();
        if (changed.messages?.length) {
            const before = sorted(this.messages).length;
            this.messages = sorted([...this.messages, ...changed.messages]);
            if (this.messages.length > before) this.showMessages();
        }
    }

    /**
     * @param {number} index
     * @param {number[]} values
     */
    setKnob(index, values) {
        const knob = this.opened?.knobs[index];
        if (!knob) return;
        knob.current = values;
        this.take(this.call((module) => module.set({ knob: index, values })));
        this.controls.refresh();
        this.change();
    }

    /** @param {import("./types.js").Setting} setting of the command that made the page */
    preset(setting) {
        this.opened?.knobs.forEach((knob, index) => {
            if (knob.name !== setting.name || (setting.program && setting.program !== knob.owner)) return;
            const values = setting.word ? [knob.words.indexOf(setting.word)] : setting.values;
            if (values[0] === -1 && setting.word) return;
            if (values.length === knob.current.length) this.setKnob(index, values);
        });
    }

    /** After a new beginning of the module: the values that were there before. */
    putBack() {
        const hash = this.hash;
        if (this.opened) restore(hash, this.opened.knobs, this.clock, this.view, (knob, values) => this.setKnob(knob, values));
    }

    /**
     * @param {string} name
     * @param {string} text
     */
    edit(name, text) {
        const content = new TextEncoder().encode(text);
        this.files.set(name, content);
        this.call((module) => module.file(name, content));
        if (this.read()) this.change();
    }

    /** Something has changed, or begins to move: a frame is drawn. */
    change() {
        this.isStale = true;
        this.clock.show();
        this.view.show();
        this.ask();
        clearTimeout(this.linkTimer);
        this.linkTimer = setTimeout(() => this.writeLink(), 300);
    }

    get isMoving() {
        return this.keys.isHeld || (this.clock.isPlaying && !this.clock.element.hidden);
    }

    /** Asks the browser for a frame if there is something to draw. */
    ask() {
        if (this.frame || !this.module || !this.isSeen || document.hidden || (!this.isStale && !this.isMoving)) return;
        this.frame = requestAnimationFrame((time) => this.draw(time));
    }

    /** @param {boolean} isSeen */
    see(isSeen) {
        this.isSeen = isSeen;
        this.clock.last = undefined;
        this.ask();
    }

    /** @param {number} milliseconds */
    draw(milliseconds) {
        this.frame = 0;
        const seconds = this.clock.last === undefined ? 0 : (milliseconds - this.clock.last) / 1000;
        if (!this.clock.element.hidden) this.clock.advance(milliseconds);
        this.keys.hold(Math.min(seconds, 0.1));
        this.isStale = false;
        const restart = this.clock.restarts;
        this.clock.restarts = false;
        this.take(this.call((module) => module.draw({
            width: this.canvas.width, height: this.canvas.height, time: this.clock.seconds, samples: 1,
            view: this.view.view, camera: this.view.camera, mouse: this.view.mouse, restart,
        })));
        this.clock.show();
        if (!this.isMoving) this.clock.last = undefined;
        this.ask();
    }

    /** The canvas keeps the shape of the scene's window, and is no larger; a full screen it fills. */
    resize() {
        if (!this.opened) return;
        const isFull = document.fullscreenElement === this.stage;
        let width = this.data.width || this.opened.width || 512, height = this.data.height || this.opened.height || 512;
        // The sources stand beside picture and values if there is room.
        this.element.classList.toggle("wide", this.element.clientWidth - width > kWide);
        const hasPanel = !this.panel.hidden && getComputedStyle(this.element).gridTemplateColumns.includes(" ");
        const room = isFull ? window.innerWidth : this.element.clientWidth - (hasPanel ? this.panel.offsetWidth + kGap : 0);
        const most = isFull ? window.innerHeight - this.bar.offsetHeight : this.data.embed ? window.innerHeight - this.bar.offsetHeight - 8 : Infinity;
        const shrink = Math.min(1, room / width, most / height);
        [width, height] = isFull ? [room, most] : [width * shrink, height * shrink];
        this.canvas.style.width = `${width}px`;
        this.canvas.style.height = `${height}px`;
        const sharp = (/** @type {number} */ side) => Math.max(1, Math.round(side * Math.min(devicePixelRatio, 2)));
        if (this.canvas.width === sharp(width) && this.canvas.height === sharp(height)) return;
        this.canvas.width = sharp(width);
        this.canvas.height = sharp(height);
        this.change();
    }

    get hash() {
        return this.opened ? hashOf(this.opened.knobs, this.clock, this.view, !this.clock.element.hidden) : "";
    }

    writeLink() {
        const hash = this.hash;
        if (hash === location.hash.slice(1)) return;
        try {
            history.replaceState(null, "", hash ? `#${hash}` : location.pathname + location.search);
        } catch {
            // A frame that has no address of its own.
        }
    }

    restoreLink() {
        const { opened } = this;
        if (!opened || location.hash.length < 2 || location.hash.slice(1) === this.hash) return;
        restore(location.hash, opened.knobs, this.clock, this.view, (knob, values) => this.setKnob(knob, values));
        this.change();
    }

    async copyLink() {
        this.writeLink();
        const link = `${location.href.split("#")[0]}${this.hash ? `#${this.hash}` : ""}`;
        try {
            await navigator.clipboard.writeText(link);
            this.flash("The link is copied");
        } catch {
            this.flash(link);
        }
    }

    hardcopy() {
        this.draw(performance.now());  // what is drawn can be read until the browser shows it
        this.canvas.toBlob((blob) => {
            if (!blob) return;
            const link = make("a", { href: URL.createObjectURL(blob), download: `${this.title}.png` });
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 1000);
        });
    }

    fullScreen() {
        if (document.fullscreenElement) document.exitFullscreen();
        else this.stage.requestFullscreen().catch(() => this.flash("The browser forbids it here"));
    }

    /** @param {boolean} on */
    showSources(on) {
        this.editor.element.hidden = !on || this.editor.sources.size === 0;
        this.sourceButton.setAttribute("aria-pressed", String(on));
        if (on) this.editor.paint();
    }

    /**
     * @param {string} text
     * @param {() => void} [act] for a button
     */
    showNote(text, act) {
        this.note.replaceChildren(act ? make("button", { type: "button", text, click: act }) : text);
        this.note.hidden = false;
    }

    hideNote() {
        this.note.hidden = true;
    }

    /** @param {string} text that goes away by itself */
    flash(text) {
        this.showNote(text);
        setTimeout(() => this.hideNote(), 2500);
    }
}
