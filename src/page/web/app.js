// A scene on a page: it draws only while something moves, and only while it can be seen.

/** @typedef {import("./types.js").Scene} Scene */
/** @typedef {import("./types.js").Opened} Opened */
/** @typedef {import("./types.js").Answer} Answer */
/** @typedef {import("./runtime.js").Runtime | import("./film.js").Film} Runtime */
/** @typedef {import("./types.js").Message} Message */
import { Controls } from "./controls.js";
import { iconButton, make, unpacked } from "./dom.js";
import { Editor } from "./editor.js";
import { Keys } from "./keys.js";
import { hashOf, restore } from "./link.js";
import { showMessages, sorted } from "./messages.js";
import { Clock } from "./time.js";
import { ViewControl } from "./view.js";

// CSS pixels
const kGap = 16;  // between the picture and what stands beside it
const kNarrow = 760;  // from here on values stand beside the picture
const kWide = 960;  // from here on sources do
const kSources = 480;  // that they have at least
const kSure = 300;  // milliseconds from a change until loops are looked at
const kRest = 1000;  // milliseconds off the screen until a frame gives its context back

/** @param {{ width: number, height: number }} [size] in pixels */
const makeCanvas = (size = { width: 300, height: 150 }) =>
    make("canvas", { width: size.width, height: size.height, tabindex: 0, "aria-label": "the scene" });

export class App {
    /**
     * @param {HTMLElement} element which holds the picture that stands there first
     * @param {Scene} data
     * @param {(canvas: HTMLCanvasElement) => Promise<Runtime>} start
     */
    constructor(element, data, start) {
        this.element = element;
        this.data = data;
        this.start = start;
        this.title = document.title;
        this.poster = element.querySelector("img");
        /** @type {HTMLElement | null} */
        this.shown = this.poster;
        this.canvas = makeCanvas();
        this.note = make("div", { class: "note", role: "status", hidden: true });
        /** @type {Runtime | undefined} */
        this.runtime = undefined;
        /** @type {Opened | undefined} */
        this.opened = undefined;
        /** @type {Map<string, Uint8Array>} */
        this.files = new Map();
        this.isStale = true;
        this.isSeen = true;
        // The scene of a frame waits until it can be seen, and once more after it has given its context back.
        this.isWaiting = data.embed && !data.poster;
        this.restTimer = this.sureTimer = 0;
        this.frame = 0;  // that is asked for
        this.size = { width: 0, height: 0 };  // of the canvas in pixels
        this.linkTimer = 0;
        /** @type {Message[]} of the last reading, and of frames since then */
        this.messages = [];
        this.clock = new Clock(() => this.change(), () => this.tell({ restart: true }));
        this.view = new ViewControl(() => this.change(), (change) => this.tell(change));
        this.panel = make("aside", { class: "panel", "aria-label": "Values", hidden: true });
        this.controls = new Controls(this.panel, (change) => this.tell(change));
        this.keys = new Keys(this);
        this.list = make("ul", { class: "messages", "aria-label": "Messages", "aria-live": "polite", hidden: true });
        this.editor = new Editor((name, text) => this.edit(name, text),
            (name, text) => this.runtime?.colour(this.opened?.files.find((each) => each.name === name)?.language ?? "", text, name) ?? "",
            (name, text) => this.save(name, new Blob([text])));
        this.sourceButton = iconButton("code", "Sources (E)", () => this.showSources(this.editor.element.hidden));
        this.valuesButton = iconButton("values", "Values (V)", () => this.showValues());
        this.bar = make("div", { class: "bar", role: "toolbar", "aria-label": "Scene" },
            this.valuesButton, this.clock.element, this.view.element, make("span", { class: "tools" }, iconButton("save", "Save the picture", () => this.hardcopy()),
                iconButton("link", "Copy a link to what is shown", () => this.copyLink()), this.sourceButton,
                ...(document.fullscreenEnabled ? [iconButton("screen", "Full screen (F)", () => this.fullScreen())] : [])));
        this.bar.hidden = true;  // until there is a scene
        if (data.film) for (const each of [this.view, this.editor]) each.fix();
        this.stage = make("div", { class: "stage" }, ...(this.poster ? [this.poster] : []), this.note, this.bar, this.keys.element);
        element.prepend(this.stage);
        if (data.poster) this.showNote("Start the scene", () => this.run());
        else if (!data.embed) this.run();
        const watch = new IntersectionObserver((entries) => {
            for (const each of entries)
                if (each.target === this.stage) this.see(each.isIntersecting);
                else this.rest(!each.isIntersecting);
        });
        watch.observe(this.stage);
        if (data.embed) watch.observe(element);
    }

    /** Begins, once more after the runtime has ended. */
    async run() {
        const hasFocus = this.note.contains(document.activeElement);
        this.note.hidden = true;
        try {
            if (this.files.size === 0) await this.unpack();
            if (!this.runtime) {
                this.runtime = await this.start(this.canvas);
                this.runtime.onrestored = () => this.run();
                for (const [name, content] of this.files) this.runtime.file(name, content);
            }
            const isFirst = this.opened === undefined;
            if (!(await this.read()) || !this.opened) return;
            if (isFirst) this.build();
        } catch (failure) {
            return this.stop(failure instanceof Error ? failure.message : String(failure));
        }
        this.show(this.canvas);
        if (hasFocus) this.canvas.focus({ preventScroll: true });
        this.resize();
        this.change();
    }

    /** @param {HTMLElement} picture that stands on the stage from now on */
    show(picture) {
        if (this.shown && this.shown !== picture) this.shown.replaceWith(picture);
        else if (!this.shown) this.stage.prepend(picture);
        this.shown = picture;
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
        this.showSources(!this.data.embed && this.element.clientWidth >= kWide);
        this.listen(this.canvas);
        this.keys.listen();
        const watch = new ResizeObserver(() => this.resize());
        for (const each of [this.element, this.bar, this.list]) watch.observe(each);
        document.addEventListener("visibilitychange", () => this.change());
        document.addEventListener("fullscreenchange", () => this.resize());
        window.addEventListener("hashchange", () => this.restoreLink());
        window.addEventListener("beforeunload", (event) => this.editor.isChanged && event.preventDefault());
        this.clock.seconds = this.data.time;
        this.controls.reset();
        this.restoreLink();
    }

    /** @param {HTMLCanvasElement} canvas */
    listen(canvas) {
        this.view.listen(canvas);
        canvas.addEventListener("webglcontextlost", () => {
            if (canvas !== this.canvas) return;
            if (this.poster) this.show(this.poster);  // a lost canvas is black
            if (this.data.embed && !this.isSeen) this.isWaiting = true;
            else this.showNote("The browser took the graphics away, perhaps because a shader took too long. Continue", () => this.begin());
        });
    }

    /**
     * In a frame of another page: a browser has some 16 contexts for all scenes, so one that is off the screen for a while
     * gives its context back. Its last picture stays, and it goes on from there once it can be seen again.
     * @param {boolean} isHidden
     */
    rest(isHidden) {
        clearTimeout(this.restTimer);
        if (isHidden) this.restTimer = setTimeout(() => this.giveBack(), kRest);
        else if (this.isWaiting) this.begin();
    }

    giveBack() {
        if (!this.runtime?.calls || !this.opened) return;
        this.draw(performance.now());  // what is drawn can be copied until the browser shows it
        const still = makeCanvas(this.canvas);
        still.getContext("2d")?.drawImage(this.canvas, 0, 0);
        this.show(this.canvas = still);
        this.resize();
        this.runtime.release();
        this.isWaiting = true;
    }

    /** Begins with a new canvas, where the browser does not give the old one its context back. */
    async begin() {
        const { opened, hash } = this;
        this.isWaiting = false;
        this.canvas = makeCanvas();
        if (opened) this.listen(this.canvas);
        this.runtime?.release();
        this.runtime = undefined;
        await this.run();
        if (!opened) return;  // build() has set the values
        this.controls.reset();
        restore(hash, this.controls.knobs, this.clock, this.view, (change) => this.tell(change));
    }

    /** @param {string} why nothing more can be drawn */
    stop(why) {
        if (this.opened) this.showNote("The scene has stopped. Start it again", () => this.run());
        else this.showNote(`${this.poster ? "This is a picture" : "There is no picture yet"}: ${why}`);
        this.note.title = why;
    }

    /** Reads the scene with what the files have now. False if there is nothing to draw. */
    async read() {
        /** @type {any} */
        const answer = await this.runtime?.open(this.data.scene);
        if (!answer) return false;
        const boxes = (answer.boxes ?? []).map((/** @type {string} */ text) => ({ severity: "note", id: "", text }));
        this.messages = [...boxes, ...(answer.messages ?? [])];
        if (answer.ended || (!answer.drawn && !this.opened)) this.stop(this.messages[0]?.text ?? "");
        if (answer.drawn) {
            this.opened = /** @type {Opened} */ (answer);
            this.opened.knobs = this.opened.knobs.map((each) => ({ ...each, initial: this.firstOf(each) }));
            this.clock.last = undefined;
            this.fill(this.opened);
        }
        this.showMessages();
        return answer.drawn;
    }

    /** @param {Opened} opened */
    fill(opened) {
        this.clock.fill(opened);
        this.view.fill(opened.cameras, opened.camera);
        this.controls.fill(opened.knobs, opened.shared ?? []);
        this.valuesButton.hidden = opened.knobs.length === 0;
        this.keys.fill(opened.keys);
        const text = new TextDecoder();
        this.editor.fill(opened.files.filter((each) => each.language && this.files.has(each.name))
            .map((each) => ({ name: each.name, text: text.decode(this.files.get(each.name)) })));
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

    /** @param {Answer | undefined} answer of the runtime */
    take(answer) {
        if (!answer || !this.opened) return;
        if (answer.messages) {
            this.messages = answer.messages;
            this.showMessages();
        }
        if (answer.ended) return this.stop(this.messages[0]?.text ?? "");
        for (const { knob, current } of answer.knobs ?? []) this.opened.knobs[knob].current = current;
        if (answer.knobs) this.controls.refresh();
        if (answer.around) Object.assign(this.view.around, answer.around);
        if (answer.camera !== undefined) this.view.camera = answer.camera;
        if (answer.animated !== undefined && answer.animated !== this.opened.animated) {
            this.opened.animated = answer.animated;
            this.clock.fill(this.opened);
        }
        if (answer.unsure) this.sureTimer = (clearTimeout(this.sureTimer), setTimeout(() => this.change(), kSure));
        if (answer.restart || answer.isStill) this.clock.restart();
        if (answer.isStill) this.clock.play(false);
    }

    /** @param {object} change as glibra_set() takes it */
    tell(change) {
        this.take(this.runtime?.set(change));
        this.controls.refresh();
        this.change();
    }

    /**
     * The values with which a knob opens: those of the command that made the page, or those of the scene.
     * @param {import("./types.js").Knob} knob
     */
    firstOf(knob) {
        let first = knob.initial;
        for (const { program, name, word, values } of this.data.set) {
            if (knob.name !== name || (program && program !== knob.owner)) continue;
            const given = word ? [knob.words?.indexOf(word) ?? -1] : values;
            if (given.length === knob.current.length && !(word && given[0] < 0)) first = given;
        }
        return first;
    }

    /**
     * @param {string} name
     * @param {string} text
     */
    async edit(name, text) {
        const content = new TextEncoder().encode(text);
        this.files.set(name, content);
        this.runtime?.file(name, content);
        if (/** @type {any} */ (this.runtime?.context)?.isContextLost()) await this.begin();
        else if (await this.read()) this.change();
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
        if (this.frame || !this.runtime?.calls || !this.isSeen || document.hidden || (!this.isStale && !this.isMoving)) return;
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
        this.keys.hold(this.clock.secondsSince(milliseconds));
        this.clock.advance(milliseconds);
        this.isStale = false;
        this.take(this.runtime?.draw({ ...this.size, time: this.clock.seconds, samples: this.data.samples, view: this.view.view, mouse: this.view.mouse }));
        this.clock.show();
        if (!this.isMoving) this.clock.last = undefined;
        this.ask();
    }

    /** The canvas keeps the shape of the scene's window, and is no larger; a full screen it fills. */
    resize() {
        if (!this.opened) return;
        const { element, panel, isFull } = this, isFrame = this.data.embed && !isFull, across = element.clientWidth;
        let width = this.data.width || this.opened.width || 512, height = this.data.height || this.opened.height || 512;
        const hasSources = !this.editor.element.hidden && !isFull, isBeside = hasSources && across >= kWide;
        const isBelow = hasSources && !isBeside, isOver = isFull || (isFrame && (isBelow || across <= kNarrow));
        const isSide = !hasSources && !isOver && !panel.hidden && across > kNarrow;
        const layout = { beside: isBeside, below: isBelow, over: isOver, side: isSide };  // see live.css
        for (const [name, on] of Object.entries(layout)) element.classList.toggle(name, on);
        const room = across - (isBeside ? kSources + kGap : isSide ? panel.offsetWidth + kGap : 0);
        const whole = isFrame ? element.clientHeight : window.innerHeight - (isBeside ? 5 * kGap : 0);
        const under = isFrame && !isBeside ? [this.bar, this.keys.element, this.list] : [this.bar, this.keys.element];
        const rest = under.reduce((sum, each) => sum + each.offsetHeight, 0);
        const most = isBelow ? 0.4 * whole : isFull || isFrame || isBeside ? whole - rest : Infinity;
        const shrink = Math.min(1, room / width, Math.max(most, 1) / height);
        [width, height] = isFull ? [room, most] : [width * shrink, height * shrink];
        this.canvas.style.width = `${width}px`;
        this.canvas.style.height = `${height}px`;
        panel.style.maxHeight = isOver ? `${height}px` : "";
        const sharp = (/** @type {number} */ side) => Math.max(1, Math.round(side * Math.min(devicePixelRatio, 2)));
        if (this.size.width === sharp(width) && this.size.height === sharp(height)) return;
        this.size = { width: sharp(width), height: sharp(height) };
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
        if (!this.opened || location.hash.length < 2 || location.hash.slice(1) === this.hash) return;
        restore(location.hash, this.controls.knobs, this.clock, this.view, (change) => this.tell(change));
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
        this.canvas.toBlob((blob) => blob && this.save(`${this.title}.png`, blob));
    }

    /**
     * @param {string} name of the file
     * @param {Blob} content
     */
    save(name, content) {
        const link = make("a", { href: URL.createObjectURL(content), download: name });
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 1000);
        // A frame is not told whether it has saved.
        if (window !== top && origin === "null") this.flash("Nothing is saved if this frame has no \u201callow-downloads\u201d");
    }

    get isFull() {
        return document.fullscreenElement === this.element;
    }

    fullScreen() {
        if (document.fullscreenElement) document.exitFullscreen();
        else this.element.requestFullscreen?.().catch(() => this.flash("The browser forbids it here"));
    }

    /** @param {boolean} on */
    showSources(on) {
        if (this.isFull) return;
        this.editor.element.hidden = !on || this.editor.sources.size === 0;
        this.sourceButton.setAttribute("aria-pressed", String(on));
        this.resize();
        if (on) this.editor.paint();
    }

    /** Those that lie over the picture where there is no room beside it. */
    showValues() {
        this.valuesButton.setAttribute("aria-pressed", String(this.element.classList.toggle("open")));
    }

    /**
     * @param {string} text
     * @param {() => void} [act] for a button
     */
    showNote(text, act) {
        this.note.replaceChildren(act ? make("button", { type: "button", text, click: act }) : text);
        this.note.hidden = false;
    }

    /** @param {string} text that goes away by itself */
    flash(text) {
        this.showNote(text);
        setTimeout(() => { this.note.hidden = true; }, 2500);
    }
}
