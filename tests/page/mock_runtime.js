// In place of src/page/web/runtime.js, for tests of the interface: the answers of a scene that only this file knows. What it is
// told is kept in `globalThis.told`.

const kOf = { owner: "", declaration: "", isInteger: false, minimum: 0, maximum: 1, components: 1, words: [], shared: [] };
const identityOfMock = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

class MockModule {
    constructor(canvas) {
        this.context = canvas.getContext("webgl2", { alpha: false });
        if (!this.context) throw new Error("there is no WebGL 2");
        this.files = new Map();
        globalThis.told = { frames: [], sets: [], opened: 0, files: this.files };
    }
    file(name, content) { this.files.set(name, new TextDecoder().decode(content)); }
    text() { return [...this.files.values()].join("\n"); }
    open(scene) {
        globalThis.told.opened += 1;
        const lines = (this.files.get(scene) ?? "").split("\n");
        const faulty = lines.findIndex((each) => each.includes("Spere"));
        const messages = faulty < 0 ? [] : [{ severity: "error", id: "glib-E01", text: "unknown command 'Spere'; did you mean 'Sphere'?", file: scene, line: faulty + 1, column: 1 }];
        const hostile = globalThis.hostile ?? "uTone";
        this.knobs = [
            { ...kOf, name: "size", widget: "slider", minimum: .2, maximum: 2, initial: [1], current: [1] },
            { ...kOf, name: "show", widget: "choice", words: ["plain", "striped"], initial: [0], current: [0] },
            { ...kOf, owner: "Ball", name: hostile, widget: "slider", declaration: "float uTone", initial: [.8], current: [.8] },
            { ...kOf, owner: "Ball", name: "uOn", widget: "checkBox", initial: [1], current: [1] },
            { ...kOf, owner: "Ball", name: "uTint", widget: "color", components: 3, initial: [1, .5, .2], current: [1, .5, .2] },
            { ...kOf, owner: "Ball", name: "uPlace", widget: "numbers", components: 3, initial: [0, 1, 2], current: [0, 1, 2] },
            { ...kOf, owner: "Ball", name: "uCount", widget: "slider", isInteger: true, minimum: 1, maximum: 9, initial: [3], current: [3] },
            { ...kOf, owner: "Ball", name: "uKd", widget: "slider", initial: [.5], current: [.5], shared: [7, 8] },
            { ...kOf, owner: "Floor", name: "uKd", widget: "slider", initial: [.5], current: [.5], shared: [7, 8] },
        ];
        return {
            drawn: true, messages, title: "", width: 512, height: 384, animated: this.text().includes("Timer"), readsMouse: false,
            hasSteps: false, stepRate: 0, missing: [], cameras: ["eye", "lamp"], knobs: this.knobs,
            files: [...this.files.keys()].map((name) => ({ name, language: name.endsWith(".glib") ? "glib" : "glsl" })),
            keys: [{ key: "k", text: "next value of size", variable: "size", values: [[.5], [1.5]], isHeld: false, restarts: false },
                { key: "g", text: "hold to move size", variable: "size", values: [[2]], isHeld: true, restarts: false }],
        };
    }
    set(change) {
        globalThis.told.sets.push(change);
        this.knobs[change.knob].current = change.values;
        return { knobs: [{ knob: change.knob, current: change.values }] };
    }
    draw(frame) {
        globalThis.told.frames.push(structuredClone(frame));
        const gl = this.context;
        gl.viewport(0, 0, frame.width, frame.height);
        gl.clearColor(this.knobs[4].current[0] * this.knobs[2].current[0], .3 + .2 * Math.sin(frame.time), .4, 1);
        gl.clear(gl.COLOR_BUFFER_BIT);
        return { worldView: identityOfMock.with(14, -5), projection: identityOfMock };
    }
    colour({ text }) {
        const escaped = text.replace(/[&<>"]/g, (each) => `&#${each.charCodeAt(0)};`);
        return `<ol>${escaped.split("\n").map((each) => `<li>${each.replace(/^(#.*|\/\/.*)$/, '<span class="comment">$1</span>')
            .replace(/^(\w+)/, '<span class="keyword">$1</span>')}</li>`).join("")}</ol>`;
    }
}

export async function startModule(module, canvas) { return new MockModule(canvas); }
