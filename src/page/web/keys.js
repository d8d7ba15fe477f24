// The keys: those that the scene declares, then those of the page.

/** @typedef {import("./types.js").Key} Key */
/** @typedef {import("./app.js").App} App */
import { make } from "./dom.js";

/** @type {Record<string, string>} */
const kNames = { " ": "space", Enter: "enter", ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down" };

/** @param {number} x @param {number} y degrees @returns {import("./matrices.js").Drag} */
const turn = (x, y) => ({ gesture: "rotate", x, y, width: 180, height: 180 });

/** @type {Record<string, (app: App) => void>} */
const kOwn = {
    space: (app) => app.clock.play(!app.clock.isPlaying),
    ".": (app) => app.clock.step(1),
    ",": (app) => app.clock.step(-1),
    b: (app) => app.clock.nextStep(),
    r: (app) => app.view.reset(),
    c: (app) => app.view.nextCamera(),
    p: (app) => app.view.nextProjection(),
    e: (app) => app.showSources(app.editor.element.hidden),
    v: (app) => app.showValues(),
    f: (app) => app.fullScreen(),
    left: (app) => app.view.drag(turn(-5, 0)),
    right: (app) => app.view.drag(turn(5, 0)),
    up: (app) => app.view.drag(turn(0, 5)),
    down: (app) => app.view.drag(turn(0, -5)),
    1: (app) => app.view.setMode("scene"),
    2: (app) => app.view.setMode("eye"),
    4: (app) => app.view.setMode("texture"),
};

const kArrows = ["left", "right", "up", "down"];  // while the picture has the focus
const kOfView = ["r", "c", "p", "1", "2", "4", ...kArrows];

/** @param {KeyboardEvent} event as Key statements name it */
const nameOf = (event) => kNames[event.key] ?? event.key.toLowerCase();

/** @param {EventTarget | null} target @param {string} name */
function isTyping(target, name) {
    if (!(target instanceof HTMLElement)) return false;
    if (target.closest("textarea, select, input:not([type=range], [type=checkbox])")) return true;
    const isUsed = name === "space" || name === "enter" || kArrows.includes(name);
    return isUsed && target.closest("input, button, summary, a, [role=tab]") !== null;
}

export class Keys {
    /** @param {App} app */
    constructor(app) {
        this.app = app;
        /** @type {Key[]} */
        this.keys = [];
        this.down = new Set();
        this.element = make("p", { class: "keys", hidden: true });
    }

    /** @param {Key[]} keys */
    fill(keys) {
        this.keys = keys;
        this.element.replaceChildren(...keys.flatMap((each) => [make("button", { type: "button", class: "key", "aria-label": `Key ${each.key}: ${each.what}`,
            pointerdown: () => this.press(each.key), pointerup: () => this.down.clear(), pointerleave: () => this.down.clear(),
            click: (/** @type {MouseEvent} */ event) => { if (event.detail === 0 && !each.isHeld) this.press(each.key); } },
            make("kbd", { text: each.key })), ` ${each.what} `]));
        this.element.hidden = keys.length === 0;
    }

    listen() {
        document.addEventListener("keydown", (event) => {
            const name = nameOf(event);
            if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target, name)) return;
            const isOfScene = !event.shiftKey && this.keys.some((each) => each.key.toLowerCase() === name);
            const isElsewhere = kArrows.includes(name) && event.target !== this.app.canvas;
            const isOwn = kOwn[name] && !isElsewhere && !(this.app.view.isFixed && kOfView.includes(name));
            if (isOfScene) this.press(name, event.repeat);
            else if (isOwn) kOwn[name](this.app);
            else return;
            event.preventDefault();
        });
        document.addEventListener("keyup", (event) => this.down.delete(nameOf(event)));
        window.addEventListener("blur", () => this.down.clear());
    }

    /** True while a key is down that moves a value. */
    get isHeld() {
        return this.keys.some((each) => each.isHeld && this.down.has(each.key.toLowerCase()));
    }

    /**
     * @param {string} name
     * @param {boolean} [isRepeated] by a key that stays down
     */
    press(name, isRepeated = false) {
        this.down.add(name.toLowerCase());
        if (!isRepeated) this.app.tell({ key: name });
        this.app.change();
    }

    /** @param {number} seconds that the keys have been down since the last frame */
    hold(seconds) {
        for (const { key, isHeld } of this.keys)
            if (isHeld && this.down.has(key.toLowerCase())) this.app.tell({ key, seconds });
    }
}
