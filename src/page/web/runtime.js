// A scene in a canvas: the module of WebAssembly, whose functions src/page/runtime/runtime.h explains, with WebGL 2.

import {glImports} from "./gl.js";
import {wasiImports} from "./wasi.js";

/** @typedef {import("./types.js").Message} Message */
/** @typedef {import("./types.js").Knob} Knob */
/** @typedef {{drawn: boolean, messages?: Message[], ended?: boolean, animated?: boolean, knobs?: any[]} & Record<string, any>} Answer */

const same = (/** @type {any} */ a, /** @type {any} */ b) => JSON.stringify(a) === JSON.stringify(b);

export class Runtime {
    /**
     * @param {WebAssembly.Module} module
     * @param {HTMLCanvasElement} canvas
     */
    constructor(module, canvas) {
        this.module = module;
        this.canvas = canvas;
        this.context = canvas.getContext("webgl2", {
            alpha: false, antialias: false, depth: false, stencil: false, powerPreference: "high-performance",
        });
        /** @type {Map<string, Uint8Array>} */
        this.files = new Map();
        /** @type {any} what the instance exports; null: it has ended */
        this.calls = null;
        // As open() and set() have answered them.
        /** @type {Knob[]} */
        this.knobs = [];
        // To set again, as they were in an instance that has ended.
        /** @type {Knob[]} */
        this.changed = [];
        /** @type {string[]} */
        this.lines = [];
        // Why the last instance has ended.
        /** @type {Message[]} */
        this.why = [];
        /** Called once the browser has a context again: open() then draws the scene as it was. */
        this.onrestored = () => {};
        canvas.addEventListener("webglcontextlost", (event) => {
            event.preventDefault();
            this.why = [{severity: "error", id: "", text: "the browser has lost the graphics card; it tries to get it back"}];
            this.end();
        });
        canvas.addEventListener("webglcontextrestored", () => this.onrestored());
    }

    /**
     * The content of a file, for the next open().
     * @param {string} name
     * @param {Uint8Array | string} content
     */
    file(name, content) {
        const bytes = typeof content === "string" ? new TextEncoder().encode(content) : content;
        this.files.set(name, bytes);
        if (this.calls) this.run("glibra_file", name, bytes);
    }

    /**
     * Reads the scene, also again. In a new instance if the last one has ended.
     * @param {string} scene
     * @returns {Promise<Answer>}
     */
    async open(scene) {
        if (!this.calls && !(await this.start()))
            return {drawn: false, messages: [{severity: "error", id: "gpu-E01", text: "this browser has no WebGL 2"}]};
        const answer = this.ask("glibra_open", scene);
        if (!answer.knobs) return answer;
        this.knobs = answer.knobs;
        for (const each of this.changed) {
            const knob = this.knobs.findIndex((one) => one.owner === each.owner && one.name === each.name &&
                                                       same(one.initial, each.initial));
            if (knob >= 0) this.set({knob, values: each.current});
        }
        this.changed = [];
        return answer;
    }

    /**
     * @param {object} change
     * @returns {Answer}
     */
    set(change) {
        const answer = this.ask("glibra_set", JSON.stringify(change));
        for (const {knob, current} of answer.knobs ?? []) this.knobs[knob].current = current;
        return answer;
    }

    /**
     * Draws into the canvas, whose size it sets.
     * @param {Record<string, any>} frame
     * @returns {Answer}
     */
    draw(frame) {
        const {width, height} = frame;
        if (this.canvas.width !== width) this.canvas.width = width;
        if (this.canvas.height !== height) this.canvas.height = height;
        return this.ask("glibra_draw", JSON.stringify(frame));
    }

    /**
     * A text as HTML, a list item per line; empty while there is no instance.
     * @param {string} language
     * @param {string} text
     * @param {string} [_name] of the file
     */
    colour(language, text, _name) {
        return this.run("glibra_colour", language === "glib" ? 1 : 0, text);
    }

    // ---- Instances

    /** False if there is no WebGL 2. */
    async start() {
        if (!this.context || this.context.isContextLost()) return false;
        const memory = {memory: /** @type {any} */ (null), allocate: (/** @type {number} */ bytes) => calls.glibra_memory(bytes)};
        const {exports} = await WebAssembly.instantiate(this.module, {
            gl: /** @type {any} */ (glImports(this.context, memory)),
            wasi_snapshot_preview1: wasiImports(memory, (line) => { this.lines.push(line); console.warn(line); }),
        });
        const calls = /** @type {any} */ (exports);
        memory.memory = calls.memory;
        calls._initialize();
        this.calls = calls;
        for (const [name, bytes] of this.files) this.run("glibra_file", name, bytes);
        return true;
    }

    /** The instance cannot be called any more; open() makes another one with the values that were set. */
    end() {
        this.calls = null;
        if (this.changed.length === 0) this.changed = this.knobs.filter((each) => !same(each.initial, each.current));
    }

    /** Gives the context back. The canvas cannot be drawn into any more. */
    release() {
        this.onrestored = () => {};
        this.end();
        this.context?.getExtension("WEBGL_lose_context")?.loseContext();
    }

    /**
     * Calls a function whose answer is JSON.
     * @param {string} name
     * @param {...(string | Uint8Array | number)} given
     * @returns {Answer}
     */
    ask(name, ...given) {
        const text = this.run(name, ...given);
        return text ? JSON.parse(text) : {drawn: false, ended: true, messages: this.why};
    }

    /**
     * Calls a function; its answer, or an empty text if the instance ends. Texts and bytes lie in memory that it releases.
     * @param {string} name
     * @param {...(string | Uint8Array | number)} given
     */
    run(name, ...given) {
        if (!this.calls) return "";
        try {
            const at = this.calls[name](...given.flatMap((each) => {
                if (typeof each === "number") return [each];
                const bytes = typeof each === "string" ? new TextEncoder().encode(each) : each;
                const place = this.calls.glibra_memory(bytes.length);
                if (!place) throw new RangeError("out of memory");
                new Uint8Array(this.calls.memory.buffer).set(bytes, place);
                return [place, bytes.length];
            }));
            if (!at) return "";
            const bytes = new Uint8Array(this.calls.memory.buffer);
            return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
        } catch (error) {
            const why = this.lines.splice(0).pop() ?? (error instanceof Error ? error.message : String(error));
            this.why = [{severity: "error", id: "", text: `drawing ended: ${why}`}];
            console.error(error);
            this.end();
            return "";
        }
    }
}
