// A film in a canvas, in place of a runtime: pictures of a scene over time, and over the values of each control
// (src/page/page.h). It answers as the runtime does. It has pictures of one change at a time: when another control or the time
// moves, the earlier one returns to where it begins.

/** @typedef {import("./types.js").Knob} Knob */
/** @typedef {import("./types.js").FilmData} FilmData */
import { unpacked } from "./dom.js";

const kMostPixels = 2 ** 26;  // of the pictures that are kept unpacked

export class Film {
    /**
     * @param {FilmData} data
     * @param {HTMLCanvasElement} canvas
     */
    constructor(data, canvas) {
        this.data = data;
        this.canvas = canvas;
        canvas.width = data.width;
        canvas.height = data.height;
        this.context = canvas.getContext("2d", { alpha: false });
        this.calls = {};  // null: it has ended
        this.onrestored = () => {};
        /** @type {Map<number, ImageBitmap>} those seen last at the end */
        this.unpacked = new Map();
        this.wanted = 0;  // the picture
        /** @type {ImageBitmap | undefined} over which parts lie */
        this.first = undefined;
        this.sources = /** @type {Record<string, string>} */ ({});
        this.knobs = data.knobs.map((each) => ({ ...each, current: [...each.initial] }));
        // What is not as it begins: a value of a component of a knob, or none.
        this.moved = { knob: -1, component: 0, stop: 0 };
    }

    /** The files are those of the film. */
    file() {}

    async open() {
        this.sources = JSON.parse(new TextDecoder().decode(await unpacked(this.data.sources)));
        await this.show(0);
        const { width, height, begin, length, frames, files, shared } = this.data;
        return {
            drawn: true, width, height, animated: frames.length > 1, hasSteps: false, camera: "", cameras: [], keys: [], files, shared,
            knobs: structuredClone(this.knobs), span: { begin, step: length / frames.length, count: frames.length },
        };
    }

    /**
     * @param {any} change as glibra_set() takes it
     * @returns {import("./types.js").Answer}
     */
    set({ knob, values, reset, restart }) {
        if (knob !== undefined) this.move(knob, values);
        else if (reset !== undefined || restart) this.moved.knob = -1;
        return { knobs: this.changed(), restart, isStill: knob !== undefined && this.moved.knob >= 0 };
    }

    /**
     * Moves the component of the knob that differs from before, to the nearest value that has a picture.
     * @param {number} index
     * @param {number[]} values
     */
    move(index, values) {
        const knob = this.knobs[index], component = values.findIndex((each, i) => each !== knob.current[i]);
        if (component < 0) return;
        const stops = knob.stops[component], distances = stops.map((each) => Math.abs(each - values[component]));
        const stop = distances.indexOf(Math.min(...distances));
        this.moved = { knob: stops[stop] === knob.initial[component] ? -1 : index, component, stop };
    }

    /** The knobs that have other values now. */
    changed() {
        const { knob: moved, component, stop } = this.moved, group = this.data.shared.find((each) => each.includes(moved)) ?? [moved];
        return this.knobs.flatMap((knob, index) => {
            const current = knob.initial.map((each, i) => (group.includes(index) && i === component ? knob.stops[i][stop] : each));
            if (current.every((each, i) => each === knob.current[i])) return [];
            knob.current = current;
            return [{ knob: index, current }];
        });
    }

    /**
     * @param {Record<string, any>} frame
     * @returns {import("./types.js").Answer}
     */
    draw({ time }) {
        const { begin, length, frames, knobs } = this.data, frame = Math.floor((time - begin) / length * frames.length + 1e-6);
        const place = Math.min(Math.max(frame || 0, 0), frames.length - 1);
        if (place > 0) this.moved.knob = -1;
        const answer = { knobs: this.changed() }, { knob, component, stop } = this.moved;
        this.show(knob < 0 ? frames[place] : knobs[knob].pictures[component][stop]);
        return answer;
    }

    /**
     * Draws the picture, once it is unpacked.
     * @param {number} index
     */
    async show(index) {
        this.wanted = index;
        let picture = this.unpacked.get(index);
        this.unpacked.delete(index);
        if (!picture) {
            const digits = atob(this.data.pictures[index] ?? "");
            picture = await createImageBitmap(new Blob([Uint8Array.from(digits, (each) => each.charCodeAt(0))], { type: "image/png" }));
        }
        this.unpacked.set(index, picture);
        for (const [each, { width, height }] of this.unpacked) if (this.unpacked.size * width * height > kMostPixels) this.unpacked.delete(each);
        if (index === 0) this.first = picture;
        if (!this.calls || index !== this.wanted) return;
        if (this.first && this.data.parts.includes(index)) this.context?.drawImage(this.first, 0, 0);
        this.context?.drawImage(picture, 0, 0);
    }

    /**
     * @param {string} language
     * @param {string} text
     * @param {string} name of the file
     */
    colour(language, text, name) {
        return this.sources[name] ?? "";
    }

    release() {
        this.calls = /** @type {any} */ (null);
    }
}
