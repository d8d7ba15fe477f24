// In place of src/page/web/runtime.js, for tests of the interface: the answers of a scene that only this file knows. What it is
// told is kept in `globalThis.told`.

const kKnob = { owner: "", declaration: "", isInteger: false, minimum: 0, maximum: 1 };
const identityOfMock = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
globalThis.told = { frames: [], changes: [], opened: 0 };

export class Runtime {
    constructor(module, canvas) {
        this.canvas = canvas;
        this.context = canvas.getContext("webgl2", { alpha: false });
        this.files = new Map();
        this.calls = null;
        this.onrestored = () => {};
        this.knobs = undefined;
        globalThis.runtime = this;
        canvas.addEventListener("webglcontextlost", (event) => { event.preventDefault(); this.calls = null; });
        canvas.addEventListener("webglcontextrestored", () => this.onrestored());
    }
    file(name, content) { this.files.set(name, new TextDecoder().decode(content)); }
    async open(scene) {
        if (!this.context) return { drawn: false, messages: [{ severity: "error", id: "gpu-E01", text: "this browser has no WebGL 2" }] };
        this.calls = {};
        globalThis.told.opened += 1;
        const messages = [], text = this.files.get(scene) ?? "";
        text.split("\n").forEach((each, i) => {
            if (each.includes("Spere")) messages.push({ severity: "error", id: "glib-E01", text: `unknown command '${each.split(" ")[0]}'; did you mean 'Sphere'?`, file: scene, line: i + 1, column: 1 });
        });
        const owner = text.match(/Program (\S+)/)?.[1] ?? "Ball", name = text.match(/Program \S+ (\S+)/)?.[1] ?? "uTone";
        this.knobs ??= [
            { ...kKnob, name: "size", widget: "slider", minimum: .2, maximum: 2, initial: [1], current: [1] },
            { ...kKnob, name: "show", widget: "numbers", words: ["plain", "striped"], initial: [0], current: [0] },
            { ...kKnob, owner, name, widget: "slider", declaration: "float uTone", initial: [.8], current: [.8] },
            { ...kKnob, owner, name: "uOn", widget: "checkBox", initial: [1], current: [1] },
            { ...kKnob, owner, name: "uTint", widget: "color", initial: [1, .5, .2], current: [1, .5, .2] },
            { ...kKnob, owner, name: "uPlace", widget: "numbers", initial: [0, 1, 2], current: [0, 1, 2] },
            { ...kKnob, owner, name: "uCount", widget: "slider", isInteger: true, minimum: 1, maximum: 9, initial: [3], current: [3] },
            { ...kKnob, owner, name: "uKd", widget: "slider", initial: [.5], current: [.5] },
            { ...kKnob, owner: "Floor", name: "uKd", widget: "slider", initial: [.5], current: [.5] },
        ];
        this.animated = [...this.files.values()].join("").includes("Timer");
        return {
            drawn: true, messages, width: 512, height: 384, animated: this.animated, hasSteps: false, missing: [], camera: this.camera ?? "",
            cameras: ["eye", "lamp"], knobs: structuredClone(this.knobs), shared: [[7, 8]],
            files: [...this.files.keys()].map((each) => ({ name: each, language: each.endsWith(".glib") ? "glib" : "glsl" })),
            keys: [{ key: "k", what: "set size", isHeld: false }, { key: "g", what: "hold to move size", isHeld: true }],
        };
    }
    set(change) {
        globalThis.told.changes.push(change);
        const moved = new Map();
        const move = (knob, values) => { this.knobs[knob].current = [...values]; moved.set(knob, values); };
        if ("knob" in change) for (const each of change.shared ? [7, 8] : [change.knob]) move(each, change.values);
        if (change.reset === -1) this.knobs.forEach((each, i) => move(i, each.initial));
        if (change.key === "k") move(0, [1.5]);
        if (change.key === "g" && change.seconds) move(0, [this.knobs[0].current[0] + (2 - this.knobs[0].current[0]) * change.seconds]);
        if ("camera" in change) this.camera = change.camera;
        return { knobs: [...moved].map(([knob, current]) => ({ knob, current })), animated: this.animated, camera: this.camera ?? "", ...(change.restart && { restart: true }) };
    }
    draw(frame) {
        globalThis.told.frames.push(structuredClone(frame));
        if (this.canvas.width !== frame.width) this.canvas.width = frame.width;
        if (this.canvas.height !== frame.height) this.canvas.height = frame.height;
        const gl = this.context, [tone, tint] = [this.knobs[2].current[0], this.knobs[4].current];
        gl.viewport(0, 0, frame.width, frame.height);
        gl.clearColor(tint[0] * tone, tint[1] * tone, .4, 1);
        gl.clear(gl.COLOR_BUFFER_BIT);
        return { drawn: true, animated: this.animated, around: { before: identityOfMock.with(14, -5), projection: identityOfMock } };
    }
    release() {
        this.onrestored = () => {};
        this.calls = null;
        this.context?.getExtension("WEBGL_lose_context")?.loseContext();
    }
    colour(language, text) {
        const escaped = text.replace(/[&<>"]/g, (each) => `&#${each.charCodeAt(0)};`);
        return `<ol>${escaped.split("\n").map((each) => `<li>${each.replace(/^(\w+)/, '<span class="keyword">$1</span>')}</li>`).join("")}</ol>`;
    }
}
