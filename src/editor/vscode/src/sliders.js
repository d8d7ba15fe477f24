// The sliders of a scene: the ranges `name <low value high>` of its Program and Let statements.
'use strict';

const NUMBER = '[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?';
const RANGE = new RegExp(`([A-Za-z_]\\w*)\\s*<\\s*(${NUMBER})[\\s,]+(${NUMBER})[\\s,]+(${NUMBER})\\s*>`, 'g');
const SHADER = /^\s*(Vertex|TessControl|TessEvaluation|Geometry|Fragment|Compute)\s+inline\b/i;
const ENOUGH = 4; // whole numbers, between which there may be no others: the variable may be a count

/** The lines of the scene itself, with the offset of each: not those of shaders in it, and without comments. */
function* sceneLines(text) {
    let offset = 0;
    let end = null;
    for (const line of text.split('\n')) {
        const begins = end === null ? line.match(SHADER) : null;
        if (end !== null && end.test(line)) end = null;
        else if (end === null && !begins) yield { line: line.replace(/#.*$/, ''), offset };
        if (begins) end = new RegExp(`^\\s*End${begins[1]}\\s*$`, 'i');
        offset += line.length + 1;
    }
}

/** [{name, low, value, high, isWhole, begin, end}]: the numbers, and the offsets of the value in the text. */
function slidersIn(text) {
    const sliders = [];
    for (const { line, offset } of sceneLines(text)) {
        for (const found of line.matchAll(RANGE)) {
            const [whole, name, first, value, last] = found;
            if (sliders.some((each) => each.name === name)) continue;
            const atValue = whole.indexOf(value, whole.indexOf(first, whole.indexOf('<')) + first.length);
            const begin = offset + found.index + atValue;
            const [low, high] = [Number(first), Number(last)].sort((a, b) => a - b);
            const isWhole = high - low >= ENOUGH && [first, value, last].every((each) => /^[-+]?\d+$/.test(each));
            sliders.push({ name, low, value: Number(value), high, isWhole, begin, end: begin + value.length });
        }
    }
    return sliders;
}

/** A value as scenes write it: four digits that count, within the range. */
function written(value, { low, high, isWhole }) {
    const rounded = isWhole ? Math.round(value) : Number(value.toPrecision(4));
    return String(Math.min(Math.max(rounded, low), high));
}

module.exports = { slidersIn, written };
