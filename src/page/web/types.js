// The types of what the page and its runtime tell each other (src/page/runtime/runtime.h), and of the data of a page.

/**
 * @typedef {{ severity: string, id: string, text: string, suggestion?: string, file?: string, line?: number,
 *             column?: number }} Message
 * @typedef {{ owner: string, name: string, widget: string, declaration: string, isInteger: boolean, minimum: number,
 *             maximum: number, initial: number[], current: number[], words?: string[], stops?: number[][] }} Knob
 * @typedef {{ key: string, what: string, isHeld: boolean }} Key
 * @typedef {{ drawn: boolean, ended?: boolean, messages?: Message[], width: number, height: number, animated: boolean,
 *             hasSteps: boolean, stepRate?: number, files: { name: string, language: string }[], camera: string,
 *             cameras: string[], keys: Key[], knobs: Knob[], shared: number[][], span?: Span }} Opened
 * @typedef {{ begin: number, step: number, count: number }} Span seconds, and the number of pictures, of a film
 * @typedef {{ ended?: boolean, messages?: Message[], knobs?: { knob: number, current: number[] }[], animated?: boolean,
 *             camera?: string, restart?: boolean, unsure?: boolean, isStill?: boolean, around?: { before: number[], projection: number[] } }} Answer
 * @typedef {{ scene: number[], eye: number[], texture: number[],
 *             projection: "scene" | "perspective" | "orthographic" }} View
 * @typedef {{ program: string, name: string, values: number[], word: string }} Setting
 * @typedef {{ scene: string, files: { name: string, bytes: number, converted: boolean }[], content: string,
 *             set: Setting[], time: number, width: number, height: number, samples: number,
 *             embed: boolean, poster: boolean, film?: FilmData }} Scene
 * @typedef {{ width: number, height: number, begin: number, length: number, frames: number[], parts: number[], shared: number[][],
 *             knobs: (Knob & { stops: number[][], pictures: number[][] })[], files: { name: string, language: string }[],
 *             sources: string, pictures: string[] }} FilmData
 */
export {};
