'use strict';

const assert = require('node:assert');
const test = require('node:test');
const { slidersIn, written } = require('../src/sliders');

const SCENE = 'Vertex inline\nvoid main() { if (a <1 2 3> b) {} }\nEndVertex\nFragment lit.frag\n' +
    'Program Lit uShine <0 8 20> uTint {1 .5 0 1} uOn <true>  # uOld <0 1 2>\nLet size <-1, .5, 1e1>\r\nBox (size < 1)\n';

test('finds the ranges of statements, not those of shaders and comments', () => {
    assert.deepStrictEqual(slidersIn(SCENE).map(({ name, low, value, high }) => [name, low, value, high]),
        [['uShine', 0, 8, 20], ['size', -1, .5, 10]]);
});

test('knows where the values stand', () => {
    assert.deepStrictEqual(slidersIn(SCENE).map(({ begin, end }) => SCENE.slice(begin, end)), ['8', '.5']);
    const same = 'Let a <1 1 1>';
    assert.strictEqual(slidersIn(same)[0].begin, same.indexOf('1 1>'));
});

test('takes the smaller end first, and counts by whole numbers', () => {
    const sliders = slidersIn('Let a <3 2 1> b <0 1 9> c <0. 1 9> d <0 1 2>');
    assert.deepStrictEqual(sliders.map(({ low, high, isWhole }) => [low, high, isWhole]),
        [[1, 3, false], [0, 9, true], [0, 9, false], [0, 2, false]]);
});

test('writes numbers shortly, and none outside of the range', () => {
    const wide = { low: -1e9, high: 1e9, isWhole: false };
    assert.deepStrictEqual([1 / 3, 2, -1e-7, 123456].map((each) => written(each, wide)), ['0.3333', '2', '-1e-7', '123500']);
    assert.strictEqual(written(3.14159, { low: 0, high: 3.14159, isWhole: false }), '3.14159');
    assert.strictEqual(written(12345.6, { low: 0, high: 99999, isWhole: true }), '12346');
});
