// The types of what the page and the module of WebAssembly tell each other (src/page/runtime/runtime.h), and of the data
// of a page.

/**
 * @typedef {{ severity: "error" | "warning" | "note", id: string, text: string, suggestion?: string, file: string,
 *             line: number, column: number }} Message
 * @typedef {{ owner: string, name: string, widget: "slider" | "checkBox" | "color" | "choice" | "numbers",
 *             declaration: string, isInteger: boolean, minimum: number, maximum: number, components: number,
 *             initial: number[], current: number[], words: string[], shared: number[] }} Knob
 * @typedef {{ key: string, text: string, variable: string, values: number[][], isHeld: boolean, restarts: boolean }} Key
 * @typedef {{ drawn: boolean, messages: Message[], title: string, width: number, height: number, animated: boolean,
 *             readsMouse: boolean, hasSteps: boolean, stepRate: number,
 *             files: { name: string, language: "glib" | "glsl" | "" }[], missing: string[], cameras: string[],
 *             keys: Key[], knobs: Knob[] }} Opened
 * @typedef {{ knob: number, current: number[] }} Moved
 * @typedef {{ messages?: Message[], knobs?: Moved[], opened?: Opened, worldView?: number[],
 *             projection?: number[] }} Changed
 * @typedef {{ scene: number[], eye: number[], texture: number[],
 *             projection: "scene" | "perspective" | "orthographic" }} View
 * @typedef {{ width: number, height: number, time: number, samples: number, view: View, camera: string,
 *             mouse: [number, number, number], restart: boolean }} Frame
 * @typedef {{ program: string, name: string, values: number[], word: string }} Setting
 * @typedef {{ scene: string, files: { name: string, bytes: number, converted: boolean }[], content: string,
 *             set: Setting[], time: number, width: number, height: number, embed: boolean, poster: boolean }} Scene
 *
 * What runtime.js gives: the module with one scene, which draws into one canvas. Its functions throw when the module
 * has ended.
 * @typedef {{ file(name: string, content: Uint8Array): void, open(scene: string): Opened,
 *             set(change: { knob: number, values: number[] }): Changed, draw(frame: Frame): Changed,
 *             colour(source: { name: string, text: string }): string }} Module
 */
export {};
