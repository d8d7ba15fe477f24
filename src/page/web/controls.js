// The values of a scene as inputs: those of the scene, those that several programs share, and those of each program.

/** @typedef {import("./types.js").Knob} Knob */
import { make } from "./dom.js";
import { SliderScale, StopScale } from "./slider.js";

/** @param {Knob} knob */
export const isChanged = ({ current, initial }) => current.length !== initial.length || current.some((each, i) => each !== initial[i]);

/**
 * A colour of numbers from 0 to 1 as #rrggbb.
 * @param {number[]} color
 */
const hexOf = (color) => "#" + color.slice(0, 3).map((each) =>
    Math.round(Math.min(Math.max(each, 0), 1) * 255).toString(16).padStart(2, "0")).join("");

export class Controls {
    /**
     * @param {HTMLElement} panel
     * @param {(change: object) => void} tell the runtime
     */
    constructor(panel, tell) {
        this.panel = panel;
        this.tell = tell;
        /** @type {Knob[]} */
        this.knobs = [];
        /** @type {(() => void)[]} what shows the values again */
        this.shown = [];
        /** @type {Map<string, boolean>} folds that were opened or closed */
        this.folds = new Map();
        this.shape = "";
    }

    /**
     * Shows other knobs.
     * @param {Knob[]} knobs
     * @param {number[][]} shared those that one control moves together
     */
    fill(knobs, shared) {
        const shape = JSON.stringify([shared, knobs.map((each) => ({ ...each, current: each.current.length, initial: 0, line: 0 }))]);
        this.knobs = knobs;
        if (shape === this.shape) return this.refresh();
        this.shape = shape;
        this.shown = [];
        /** @type {[string, HTMLElement[]][]} */
        const groups = [["Variables", []], ["Shared by programs", []]];
        knobs.forEach((knob, index) => {
            const group = shared.find((each) => each.includes(index));
            if (group?.[0] === index) groups[1][1].push(this.row(index, true));
        });
        knobs.forEach((knob, index) => {
            if (shared.some((each) => each.includes(index))) return;
            const title = knob.owner || "Variables";
            let group = groups.find((each) => each[0] === title);
            if (!group) groups.push(group = [title, []]);
            group[1].push(this.row(index, false));
        });
        const filled = groups.filter(([, rows]) => rows.length > 0);
        this.panel.replaceChildren(...filled.map(([title, rows]) => {
            const fold = make("details", { open: this.folds.get(title) ?? true }, make("summary", { text: title }), make("div", { class: "rows" }, ...rows));
            fold.addEventListener("toggle", () => this.folds.set(title, fold.open));
            return fold;
        }));
        if (knobs.length > 0) {
            const all = make("button", { type: "button", class: "reset-all", text: "Reset values", click: () => this.reset() });
            this.panel.append(all);
            this.shown.push(() => { all.disabled = !this.knobs.some(isChanged); });
        }
        this.panel.hidden = knobs.length === 0;
        this.refresh();
    }

    /** All values are those with which the page opens. */
    reset() {
        this.tell({ reset: -1 });
        this.knobs.forEach((knob, index) => isChanged(knob) && this.tell({ knob: index, values: knob.initial }));
    }

    /** Shows all values again. */
    refresh() {
        for (const show of this.shown) show();
    }

    /**
     * The row of one knob, or of several that move together.
     * @param {number} index
     * @param {boolean} isShared
     */
    row(index, isShared) {
        const knob = this.knobs[index];
        const set = (/** @type {number[]} */ values) => this.tell({ knob: index, values, shared: isShared });
        /** @param {number} component @param {number} value */
        const setOne = (component, value) => {
            if (!Number.isFinite(value)) return this.refresh();
            const values = [...this.knobs[index].current];
            values[component] = value;
            set(values);
        };
        const owner = knob.owner && !isShared ? ` of ${knob.owner}` : "";
        const reset = make("button", { type: "button", class: "reset", text: "\u21ba", title: `Reset ${knob.name}`,
            "aria-label": `Reset ${knob.name}${owner}`, click: () => set([...this.knobs[index].initial]) });
        this.shown.push(() => { reset.disabled = !isChanged(this.knobs[index]); });
        const inputs = this.inputs(index, knob.name + owner, setOne, set);
        return make("div", { class: `knob ${knob.words ? "choice" : knob.widget}` },
            make("span", { class: "name", text: knob.name, title: knob.declaration || knob.name }), make("span", { class: "inputs" }, ...inputs), reset);
    }

    /**
     * @param {number} index
     * @param {string} label
     * @param {(component: number, value: number) => void} setOne
     * @param {(values: number[]) => void} setAll
     * @returns {HTMLElement[]}
     */
    inputs(index, label, setOne, setAll) {
        const knob = this.knobs[index], now = () => this.knobs[index].current;
        if (knob.widget === "checkBox" && !knob.words)
            return knob.current.map((_, i) => {
                const box = make("input", { type: "checkbox", "aria-label": labelOf(label, knob, i), change: ({ target }) => setOne(i, target.checked ? 1 : 0) });
                this.shown.push(() => { box.checked = now()[i] !== 0; });
                return box;
            });
        if (knob.words) {
            const menu = make("select", { "aria-label": label, change: ({ target }) => setAll([target.selectedIndex]) },
                ...knob.words.map((word) => make("option", { text: word })));
            this.shown.push(() => { menu.selectedIndex = now()[0]; });
            return [menu];
        }
        if (knob.widget === "color") {
            const field = make("input", { type: "color", "aria-label": label, input: ({ target }) => {
                const parts = [1, 3, 5].map((at) => parseInt(target.value.slice(at, at + 2), 16) / 255);
                setAll([...parts, ...now().slice(3)]);
            } });
            const text = make("output", { class: "number" });
            this.shown.push(() => {
                field.value = hexOf(now());
                text.value = now().slice(0, 3).map((each) => each.toFixed(2)).join(" ");
            });
            return knob.current.length > 3 ? [field, text, ...this.sliders(index, label, setOne, 3)] : [field, text];
        }
        if (knob.widget === "slider") return this.sliders(index, label, setOne, 0);
        return knob.current.map((_, i) => this.numberField(index, i, labelOf(label, knob, i), setOne));
    }

    /**
     * A slider and a field for each component from `first` on.
     * @param {number} index
     * @param {string} label
     * @param {(component: number, value: number) => void} setOne
     * @param {number} first
     */
    sliders(index, label, setOne, first) {
        const knob = this.knobs[index];
        const whole = knob.widget === "slider" ? new SliderScale(knob) : new SliderScale({ minimum: 0, maximum: 1, isInteger: false });
        return knob.current.slice(first).flatMap((_, k) => {
            const i = first + k, name = labelOf(label, knob, i), scale = knob.stops ? new StopScale(knob.stops[i]) : whole;
            const thumb = make("input", { type: "range", min: 0, max: 1, step: "any", "aria-label": name,
                input: ({ target }) => setOne(i, scale.valueAt(target.valueAsNumber)) });
            if (scale.isInteger) thumb.step = String(1 / Math.max(1, scale.maximum - scale.minimum));
            this.shown.push(() => {
                const value = this.knobs[index].current[i];
                // The thumb stays where the user holds it: it may stand between two rounded values.
                if (scale.valueAt(thumb.valueAsNumber) !== value) thumb.valueAsNumber = scale.positionOf(value);
                thumb.setAttribute("aria-valuetext", String(value));
            });
            return [thumb, this.numberField(index, i, `${name}, number`, setOne)];
        });
    }

    /**
     * @param {number} index
     * @param {number} component
     * @param {string} label
     * @param {(component: number, value: number) => void} setOne
     */
    numberField(index, component, label, setOne) {
        const field = make("input", { type: "number", class: "number", step: "any", "aria-label": label,
            change: ({ target }) => setOne(component, target.valueAsNumber) });
        this.shown.push(() => {
            const value = this.knobs[index].current[component];
            if (field.valueAsNumber !== value) field.value = String(Number(value.toPrecision(7)));
        });
        return field;
    }
}

/**
 * @param {string} label
 * @param {Knob} knob
 * @param {number} component
 */
const labelOf = (label, knob, component) => (knob.current.length === 1 ? label : `${label}, ${"xyzw"[component] ?? component + 1}`);
