// The pixels of shots that are not plain passes. A page from file:// may not read the pixels of picture files, so
// pixels/N.js provides them: each row minus the row above it, byte by byte, then zlib, then base64.

const kTypes = {
    u8: {array: Uint8Array, full: 255},
    u16: {array: Uint16Array, full: 65535},
    f32: {array: Float32Array, full: 1},
};
const kPicturesKept = 8;
const loading = new Map();   // file -> promise of {expected, got}
const handedOver = new Map();  // file -> resolve

window.glibraPixels = (file, pictures) => handedOver.get(file)?.(pictures);

async function unpack(packed) {
    const text = atob(packed.data);
    const compressed = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) compressed[i] = text.charCodeAt(i);
    const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    const {array, full} = kTypes[packed.type];
    const rowBytes = packed.width * packed.components * array.BYTES_PER_ELEMENT;
    for (let i = rowBytes; i < bytes.length; ++i) bytes[i] += bytes[i - rowBytes];
    return {...packed, data: undefined, full, values: new array(bytes.buffer)};
}

// The pixels of both pictures of a shot, or null if the report has none or the browser cannot unpack them.
function pixelsOf(file) {
    if (!file || typeof DecompressionStream === "undefined") return Promise.resolve(null);
    const known = loading.get(file);
    if (known) return known;
    const promise = new Promise((resolve) => {
        handedOver.set(file, resolve);
        const script = document.createElement("script");
        script.src = file;
        script.onerror = () => resolve(null);
        script.onload = () => script.remove();
        document.head.append(script);
    }).then(async (packed) => {
        handedOver.delete(file);
        if (!packed) return null;
        const pictures = {};
        for (const which of ["expected", "got"])
            if (packed[which]) pictures[which] = await unpack(packed[which]);
        return pictures;
    }).catch(() => null);
    loading.set(file, promise);
    if (loading.size > kPicturesKept) loading.delete(loading.keys().next().value);
    return promise;
}

function newCanvas(width, height) {
    const canvas = document.createElement("canvas");
    canvas.width = width;
    canvas.height = height;
    return canvas;
}

// A canvas of the picture's size. Floats are clamped to 0..1; NaN is magenta.
function toCanvas({width, height, components, full, values}) {
    const canvas = newCanvas(width, height);
    const context = canvas.getContext("2d");
    const shown = context.createImageData(width, height);
    const scale = 255 / full;
    for (let from = 0, to = 0; to < shown.data.length; from += components, to += 4) {
        for (let c = 0; c < 3; ++c) shown.data[to + c] = values[from + c] * scale;
        shown.data[to + 3] = components === 4 ? values[from + 3] * scale : 255;
        if (Number.isNaN(values[from] + values[from + 1] + values[from + 2]))
            shown.data.set([255, 0, 255, 255], to);
    }
    context.putImageData(shown, 0, 0);
    return canvas;
}

// |a - b| times the factor. A difference in alpha is grey, a pixel that only one picture has is white, and a number
// against NaN is magenta.
function differenceCanvas(a, b, factor) {
    const width = Math.max(a.width, b.width), height = Math.max(a.height, b.height);
    const canvas = newCanvas(width, height);
    const context = canvas.getContext("2d");
    const shown = context.createImageData(width, height);
    shown.data.fill(255);
    const scaleA = 255 / a.full, scaleB = 255 / b.full;
    for (let y = 0; y < Math.min(a.height, b.height); ++y)
        for (let x = 0; x < Math.min(a.width, b.width); ++x) {
            const atA = (y * a.width + x) * a.components, atB = (y * b.width + x) * b.components;
            const to = (y * width + x) * 4;
            const alphaA = a.components === 4 ? a.values[atA + 3] * scaleA : 255;
            const alphaB = b.components === 4 ? b.values[atB + 3] * scaleB : 255;
            const alpha = Math.abs(alphaA - alphaB);
            for (let c = 0; c < 3; ++c) {
                const valueA = a.values[atA + c] * scaleA, valueB = b.values[atB + c] * scaleB;
                const onlyOne = Number.isNaN(valueA) !== Number.isNaN(valueB);
                if (onlyOne) {
                    shown.data.set([255, 0, 255], to);
                    break;
                }
                const both = valueA === valueB || Number.isNaN(valueA) ? 0 : Math.abs(valueA - valueB);
                shown.data[to + c] = Math.max(both, alpha) * factor;
            }
        }
    context.putImageData(shown, 0, 0);
    return canvas;
}

// The square in which two pictures of one size differ most: a sixth of their longer side, but at least 24 pixels. Null if
// they do not differ, if they differ everywhere alike, or if the square is most of them.
function placeOfDifference(a, b) {
    const {width, height} = a;
    const side = Math.max(24, Math.ceil(Math.max(width, height) / 6)), mostPixels = 2 ** 22;
    if (b.width !== width || b.height !== height || 2 * side > Math.max(width, height) || width * height > mostPixels) return null;
    // sums[x, y]: of all differences to the left and above.
    const across = width + 1, sums = new Float64Array(across * (height + 1));
    for (let y = 0; y < height; ++y)
        for (let x = 0, row = 0; x < width; ++x) {
            const atA = (y * width + x) * a.components, atB = (y * width + x) * b.components;
            for (let c = 0; c < 3; ++c) {
                const difference = Math.abs(a.values[atA + c] / a.full - b.values[atB + c] / b.full);
                row += Number.isFinite(difference) ? difference : Number.isNaN(a.values[atA + c]) === Number.isNaN(b.values[atB + c]) ? 0 : 1;
            }
            sums[(y + 1) * across + x + 1] = sums[y * across + x + 1] + row;
        }
    const sumOf = (left, top, wide, high) => sums[(top + high) * across + left + wide] - sums[top * across + left + wide] -
        sums[(top + high) * across + left] + sums[top * across + left];
    const wide = Math.min(side, width), high = Math.min(side, height), step = Math.max(1, side >> 3);
    let best = null, most = 0;
    for (let top = 0; top <= height - high; top += step)
        for (let left = 0; left <= width - wide; left += step) {
            const sum = sumOf(left, top, wide, high);
            if (sum > most * (1 + 1e-9)) [best, most] = [{left, top}, sum];
        }
    if (!best || most < 2 * sumOf(0, 0, width, height) * wide * high / (width * height)) return null;
    // What differs is in its middle.
    let x = 0, y = 0;
    for (let i = 0; i < wide; ++i) x += (best.left + i + .5) * sumOf(best.left + i, best.top, 1, high);
    for (let i = 0; i < high; ++i) y += (best.top + i + .5) * sumOf(best.left, best.top + i, wide, 1);
    const clamped = (middle, part, whole) => Math.max(0, Math.min(whole - part, Math.round(middle / most - part / 2)));
    return {left: clamped(x, wide, width), top: clamped(y, high, height), side};
}

// The values of a pixel as in the file: 0..255, 0..65535 or floats; null outside of the picture.
function valuesAt(pixels, x, y) {
    if (!pixels || x < 0 || y < 0 || x >= pixels.width || y >= pixels.height) return null;
    const at = (y * pixels.width + x) * pixels.components;
    return Array.from(pixels.values.subarray(at, at + pixels.components));
}

function valueText(values, isFloat) {
    if (!values) return "-";
    return values.map((each) => isFloat ? String(Number(each.toPrecision(6))) : String(each)).join(" ");
}
