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

test('writes numbers shortly', () => {
    assert.deepStrictEqual([1 / 3, 2, -1e-7, 123456].map(written), ['0.3333', '2', '-1e-7', '123500']);
});
