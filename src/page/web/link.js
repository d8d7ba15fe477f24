// What a reader has set, as the hash of the page's address: a link shows what one saw.

/** @typedef {import("./types.js").Knob} Knob */
/** @typedef {import("./time.js").Clock} Clock */
/** @typedef {import("./view.js").ViewControl} ViewControl */
import { isChanged } from "./controls.js";
import { isIdentity } from "./matrices.js";

/** @param {number[]} numbers */
const textOf = (numbers) => numbers.map((each) => Number(each.toPrecision(9))).join(",");

/**
 * @param {string | null} text
 * @param {number} [count] of numbers that it must have
 * @returns {number[] | undefined}
 */
function numbersOf(text, count) {
    const numbers = (text ?? "").split(",").map((each) => (each.trim() === "" ? NaN : Number(each)));
    return numbers.every(Number.isFinite) && (count === undefined || numbers.length === count) ? numbers : undefined;
}

/**
 * The name of a knob in a link; several of one name are counted.
 * @param {Knob[]} knobs
 * @param {number} index
 */
function keyOf(knobs, index) {
    const isSame = (/** @type {Knob} */ each) => each.owner === knobs[index].owner && each.name === knobs[index].name;
    const earlier = knobs.slice(0, index).filter(isSame).length;
    return `${knobs[index].owner}:${knobs[index].name}${earlier > 0 ? `:${earlier + 1}` : ""}`;
}

/**
 * The hash for what differs from the page as it opens.
 * @param {Knob[]} knobs
 * @param {Clock} clock
 * @param {ViewControl} view
 * @param {boolean} hasTime
 */
export function hashOf(knobs, clock, view, hasTime) {
    const parts = new URLSearchParams();
    knobs.forEach((knob, index) => {
        if (isChanged(knob)) parts.set(keyOf(knobs, index), textOf(knob.current));
    });
    if (hasTime && !clock.isPlaying) parts.set("time", textOf([clock.seconds]));
    if (hasTime && clock.speed !== 1) parts.set("speed", textOf([clock.speed]));
    if (view.camera) parts.set("camera", view.camera);
    if (view.view.projection !== "scene") parts.set("projection", view.view.projection);
    for (const name of /** @type {const} */ (["eye", "scene", "texture"]))
        if (!isIdentity(view.view[name])) parts.set(name, textOf(view.view[name]));
    return parts.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
}

/**
 * Takes over what a link has; what does not fit the scene is left out.
 * @param {string} hash
 * @param {Knob[]} knobs
 * @param {Clock} clock
 * @param {ViewControl} view
 * @param {(change: object) => void} tell the runtime
 */
export function restore(hash, knobs, clock, view, tell) {
    const parts = new URLSearchParams(hash.replace(/^#/, ""));
    knobs.forEach((knob, index) => {
        const values = numbersOf(parts.get(keyOf(knobs, index)), knob.current.length);
        if (values) tell({ knob: index, values });
    });
    const time = numbersOf(parts.get("time"), 1), speed = numbersOf(parts.get("speed"), 1);
    if (speed) clock.setSpeed(speed[0]);
    if (time) clock.goTo(time[0]);
    const camera = parts.get("camera") ?? "", projection = parts.get("projection");
    if (view.isFixed) return;
    if (view.cameras.includes(camera)) tell({ camera });
    if (projection === "perspective" || projection === "orthographic") view.view.projection = projection;
    for (const name of /** @type {const} */ (["eye", "scene", "texture"])) {
        const matrix = numbersOf(parts.get(name), 16);
        if (matrix) view.view[name] = matrix;
    }
}
