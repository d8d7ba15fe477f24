// The keys: those that the scene declares, then those of the page.

/** @typedef {import("./types.js").Key} Key */
/** @typedef {import("./app.js").App} App */
import { make } from "./dom.js";

/** @type {Record<string, string>} */
const kNames = { " ": "space", Enter: "enter", ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down" };

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
    1: (app) => app.view.setMode("scene"),
    2: (app) => app.view.setMode("eye"),
    4: (app) => app.view.setMode("texture"),
};

/** @param {KeyboardEvent} event as Key statements name it */
const nameOf = (event) => kNames[event.key] ?? event.key.toLowerCase();

/** @param {EventTarget | null} target @param {string} name */
function isTyping(target, name) {
    if (!(target instanceof HTMLElement)) return false;
    if (target.closest("textarea, select, input:not([type=range], [type=checkbox])")) return true;
    const isUsed = name === "space" || name === "enter" || ["left", "right", "up", "down"].includes(name);
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
        this.element.replaceChildren(...keys.flatMap((each) => [make("button", { type: "button", class: "key", "aria-label": `Key ${each.key}: ${each.text}`,
            pointerdown: () => this.press(each.key), pointerup: () => this.down.delete(each.key), pointerleave: () => this.down.delete(each.key),
            click: (/** @type {MouseEvent} */ event) => { if (event.detail === 0 && !each.isHeld) this.press(each.key); } },
            make("kbd", { text: each.key })), ` ${each.text} `]));
        this.element.hidden = keys.length === 0;
    }

    listen() {
        document.addEventListener("keydown", (event) => {
            const name = nameOf(event);
            if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target, name)) return;
            const isOfScene = !event.shiftKey && this.keys.some((each) => each.key.toLowerCase() === name);
            if (isOfScene) this.press(name, event.repeat);
            else if (kOwn[name]) kOwn[name](this.app);
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

    /** @param {Key} key the knob of its variable */
    knobOf(key) {
        return this.app.opened?.knobs.findIndex((each) => !each.owner && each.name === key.variable) ?? -1;
    }

    /**
     * @param {string} name
     * @param {boolean} [isRepeated] by a key that stays down
     */
    press(name, isRepeated = false) {
        this.down.add(name);
        for (const key of this.keys) {
            if (key.key.toLowerCase() !== name.toLowerCase()) continue;
            if (key.restarts && !isRepeated) this.app.clock.restart();
            const index = this.knobOf(key);
            if (key.isHeld || index < 0 || key.values.length === 0) continue;
            const now = this.app.opened?.knobs[index].current ?? [];
            const at = key.values.findIndex((each) => each.length === now.length && each.every((value, i) => value === now[i]));
            this.app.setKnob(index, [...key.values[(at + 1) % key.values.length]]);
        }
        this.app.change();
    }

    /** @param {number} seconds that the keys have been down since the last frame */
    hold(seconds) {
        for (const key of this.keys) {
            const index = this.knobOf(key), knob = this.app.opened?.knobs[index];
            if (!key.isHeld || !this.down.has(key.key.toLowerCase()) || !knob || key.values.length === 0) continue;
            const moved = knob.current.map((each, k) => {
                const next = each + ((key.values[0][k] ?? each) - each) * seconds;
                if (knob.widget !== "slider") return next;
                // A value that the scene states outside of its range can come back into it.
                return Math.min(Math.max(next, Math.min(knob.minimum, each)), Math.max(knob.maximum, each));
            });
            this.app.setKnob(index, moved);
        }
    }
}
