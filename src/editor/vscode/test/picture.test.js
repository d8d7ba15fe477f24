// The panel without an editor: the program glibra that GLIBRA names draws, and the module `vscode` is played.
'use strict';

const assert = require('node:assert');
const fs = require('node:fs');
const Module = require('node:module');
const os = require('node:os');
const path = require('node:path');
const test = require('node:test');

const GLIBRA = process.env.GLIBRA;
const SCENE = 'WindowSize 32 32\nVertex a.vert\nFragment a.frag\nProgram P uG <0. .5 1.> uN <0 1 3>\nQuadXY 0 1\n';
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'glibra panel '));
test.after(() => fs.rmSync(folder, { recursive: true }));
fs.writeFileSync(path.join(folder, 'a.vert'), '#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = aVertex; }\n');
fs.writeFileSync(path.join(folder, 'a.frag'),
    '#version 330\nuniform float uG;\nuniform int uN;\nout vec4 c;\nvoid main() { c = vec4(uG, float(uN), 0., 1.); }\n');

let text = SCENE;
const sent = []; // to the page of the panel
const waiting = [];
const panel = {
    webview: {
        onDidReceiveMessage: (receive) => { panel.receive = receive; },
        postMessage: (message) => { sent.push(message); waiting.splice(0).forEach((each) => each()); }
    }
};
const load = Module._load;
Module._load = (name, ...rest) => name !== 'vscode' ? load(name, ...rest) : {
    workspace: { openTextDocument: async () => ({ getText: () => text }) }
};
const { Picture } = require('../src/picture');

async function next(isRight) {
    while (!sent.some(isRight)) await new Promise((resolve) => waiting.push(resolve));
    return sent.splice(0).find(isRight);
}

test('draws what changes, and keeps the picture of a text with an error', { skip: !GLIBRA }, async () => {
    const uri = { fsPath: path.join(folder, 'a.glib'), toString: () => 'file:///a.glib' };
    const picture = new Picture(uri, () => GLIBRA, panel);
    panel.receive({ type: 'ready' });
    const first = await next(({ png }) => png);
    assert.deepStrictEqual(first.sliders.map(({ name, value }) => [name, value]), [['uG', .5], ['uN', 1]]);

    for (const value of [.6, .7, .8, .9]) panel.receive({ type: 'move', name: 'uG', value: String(value) });
    const moved = await next(({ sliders }) => sliders[0].value === .9);
    assert.ok(moved.isMoved && moved.png !== first.png);

    panel.receive({ type: 'move', name: 'uN', value: '2.3' }); // which glibra cuts
    const whole = await next(({ sliders, messages }) => sliders[1].isWhole && !messages.includes('W27'));
    assert.strictEqual(whole.sliders[0].isWhole, false);

    text = SCENE.replace('QuadXY', 'QuadXi').replace('.5', '.4');
    picture.changed();
    const wrong = await next(({ png }) => !png);
    assert.match(wrong.messages, /a\.glib:5:1: error: .*QuadXi/);
    assert.strictEqual(wrong.sliders[0].value, .4); // what is written anew counts

    picture.close();
    picture.changed();
    await new Promise((resolve) => setTimeout(resolve, 500));
    assert.strictEqual(sent.length, 0);
});

test('says which program does not start', async () => {
    new Picture({ fsPath: path.join(folder, 'a.glib'), toString: () => '' }, () => 'no such program', panel);
    panel.receive({ type: 'ready' });
    assert.match((await next(({ png }) => !png)).messages, /'no such program' does not start.*glibra\.program/);
});
