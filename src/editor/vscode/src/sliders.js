// The sliders of a scene: the ranges `name <low value high>` of its Program and Let statements.
'use strict';

const NUMBER = '[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?';
const RANGE = new RegExp(`([A-Za-z_]\\w*)\\s*<\\s*(${NUMBER})[\\s,]+(${NUMBER})[\\s,]+(${NUMBER})\\s*>`, 'g');
const SHADER = /^\s*(Vertex|TessControl|TessEvaluation|Geometry|Fragment|Compute)\s+inline\b/i;

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

/** [{name, low, value, high, begin, end}]: the numbers, and the offsets of the value in the text. */
function slidersIn(text) {
    const sliders = [];
    for (const { line, offset } of sceneLines(text)) {
        for (const found of line.matchAll(RANGE)) {
            const [whole, name, low, value, high] = found;
            if (sliders.some((each) => each.name === name)) continue;
            const atValue = whole.indexOf(value, whole.indexOf(low, whole.indexOf('<')) + low.length);
            const begin = offset + found.index + atValue;
            sliders.push({ name, low: Number(low), value: Number(value), high: Number(high), begin, end: begin + value.length });
        }
    }
    return sliders;
}

/** A number as scenes write it: four digits that count. */
function written(number) {
    return String(Number(number.toPrecision(4)));
}

module.exports = { slidersIn, written };
