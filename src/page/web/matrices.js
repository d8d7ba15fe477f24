// Matrices of 4 x 4 numbers, column by column, and what a drag of the mouse makes of them: the same as in the window
// (src/view/scene/transforms.cpp).

/** @typedef {number[]} Matrix */

/** @returns {Matrix} */
export const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** @param {Matrix} matrix */
export const isIdentity = (matrix) => identity().every((each, i) => each === matrix[i]);

/**
 * @param {...Matrix} factors
 * @returns {Matrix}
 */
export function product(...factors) {
    return factors.reduce((a, b) => {
        const result = new Array(16).fill(0);
        for (let column = 0; column < 4; ++column)
            for (let row = 0; row < 4; ++row)
                for (let k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
        return result;
    });
}

/** @param {number} x @param {number} y @param {number} z */
export const translation = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

/** @param {number} factor */
export const scaling = (factor) => [factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, 1];

/**
 * @param {number} degrees
 * @param {0 | 1 | 2} axis
 * @returns {Matrix}
 */
export function rotation(degrees, axis) {
    const angle = (degrees * Math.PI) / 180, matrix = identity();
    const one = (axis + 1) % 3, two = (axis + 2) % 3;
    matrix[4 * one + one] = matrix[4 * two + two] = Math.cos(angle);
    matrix[4 * one + two] = Math.sin(angle);
    matrix[4 * two + one] = -Math.sin(angle);
    return matrix;
}

/**
 * @param {Matrix} matrix
 * @param {number[]} point four numbers
 */
const applied = (matrix, point) =>
    [0, 1, 2, 3].map((row) => [0, 1, 2, 3].reduce((sum, k) => sum + matrix[4 * k + row] * point[k], 0));

/**
 * 0 for the elements that dragging there and back leaves of 0.
 * @param {Matrix} matrix
 */
function withoutLeftovers(matrix) {
    const largest = Math.max(...matrix.map(Math.abs));
    return matrix.map((each) => (Math.abs(each) < 1e-13 * largest ? 0 : each));
}

/**
 * @typedef {{ gesture: "rotate" | "scale" | "pan", x: number, y: number, width: number, height: number }} Drag pixels,
 *     x to the right and y upwards, over a picture of that size
 */

/** @param {Drag} drag */
const growthOf = (drag) => 10 ** ((drag.x + drag.y) / drag.height);

/**
 * The transform after the drag. `before` is applied to a point before it, and `projection` after it. A drag across the
 * shorter side of the picture rotates by 180 degrees, one over its height scales by ten, and panning keeps the origin
 * under the mouse.
 * @param {Matrix} transform
 * @param {Drag} drag
 * @param {Matrix} before
 * @param {Matrix} projection
 */
export function dragged(transform, drag, before, projection) {
    const pivot = applied(product(transform, before), [0, 0, 0, 1]);
    if (!pivot[3] || drag.width < 1 || drag.height < 1) return transform;
    const [x, y, z] = pivot.map((each) => each / pivot[3]);
    let change = identity();
    if (drag.gesture === "pan") {
        const w = Math.abs(applied(projection, [x, y, z, 1])[3]);
        const right = Math.abs(projection[0]), up = Math.abs(projection[5]);
        if (right && up) change = translation((drag.x * 2 * w) / (right * drag.width), (drag.y * 2 * w) / (up * drag.height), 0);
    } else if (drag.gesture === "rotate") {
        const perPixel = 180 / Math.min(drag.width, drag.height);
        change = product(translation(x, y, z), rotation(drag.x * perPixel, 1), rotation(-drag.y * perPixel, 0), translation(-x, -y, -z));
    } else {
        change = product(translation(x, y, z), scaling(growthOf(drag)), translation(-x, -y, -z));
    }
    return kept(product(change, transform), transform);
}

/**
 * The same for texture coordinates: in the unit square about its centre, rotation about the p axis.
 * @param {Matrix} transform
 * @param {Drag} drag
 */
export function draggedTexture(transform, drag) {
    const change = drag.gesture === "rotate" ? rotation((180 * drag.x) / drag.width, 2)
        : drag.gesture === "scale" ? scaling(growthOf(drag))
        : translation(drag.x / drag.width, drag.y / drag.height, 0);
    return kept(product(translation(0.5, 0.5, 0.5), change, translation(-0.5, -0.5, -0.5), transform), transform);
}

/**
 * The matrix, or the earlier one if it cannot be used.
 * @param {Matrix} matrix
 * @param {Matrix} earlier
 */
function kept(matrix, earlier) {
    const size = Math.hypot(matrix[0], matrix[1], matrix[2]);
    return matrix.every(Number.isFinite) && size > 1e-30 && size < 1e30 ? withoutLeftovers(matrix) : earlier;
}
