// The picture of a scene beside its text, with a slider for each range. `glibra render` draws the text as it stands in the
// editor, and the shaders as they are saved.
'use strict';

const { spawn } = require('child_process');
const crypto = require('crypto');
const path = require('path');
const vscode = require('vscode');
const { slidersIn, written } = require('./sliders');

const PAUSE = 200; // milliseconds without a key before the scene is drawn
const LIMIT = 20; // seconds that a picture may take
const LONGEST = 2000; // letters of messages

/** Draws a scene: a promise of {png, messages}. `values` has the numbers of sliders that were moved. */
function draw(program, text, folder, values) {
    return new Promise((resolve) => {
        const settings = Object.entries(values).flatMap(([name, value]) => ['--set', `${name}=${written(value)}`]);
        const child = spawn(program, ['render', '-', '-o', '-', ...settings], { cwd: folder });
        const picture = [];
        let messages = '';
        const timer = setTimeout(() => child.kill('SIGKILL'), 1000 * LIMIT);
        child.stdout.on('data', (bytes) => picture.push(bytes));
        child.stderr.on('data', (bytes) => { if (messages.length < LONGEST) messages += bytes; });
        child.on('error', () => {
            clearTimeout(timer);
            resolve({ png: null, messages: `cannot start '${program}'; the setting glibra.program names it` });
        });
        child.on('close', (status, signal) => {
            clearTimeout(timer);
            const late = signal === 'SIGKILL' ? `the picture takes more than ${LIMIT} seconds\n` : '';
            resolve({ png: status === 0 ? Buffer.concat(picture) : null, messages: late + messages.slice(0, LONGEST) });
        });
        child.stdin.on('error', () => {}); // the program has ended
        child.stdin.end(text);
    });
}

class Picture {
    constructor(document, program) {
        this.document = document;
        this.program = program;
        this.values = {};
        this.isDrawing = this.isDue = false;
        this.panel = vscode.window.createWebviewPanel('glibra.picture', path.basename(document.fileName),
            { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true }, { enableScripts: true, retainContextWhenHidden: true });
        this.panel.webview.html = page();
        this.panel.webview.onDidReceiveMessage((message) => this.receive(message));
    }

    /** The text or a shader has changed. */
    changed() {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.update(), PAUSE);
    }

    receive(message) {
        if (message.type === 'ready') this.update();
        if (message.type === 'move') {
            this.values[message.name] = Number(message.value);
            this.update();
        }
        if (message.type === 'keep') this.keep();
    }

    /** One picture at a time: what changes meanwhile is drawn after it. */
    async update() {
        if (this.isDrawing) {
            this.isDue = true;
            return;
        }
        this.isDrawing = true;
        const text = this.document.getText();
        const sliders = slidersIn(text);
        for (const name of Object.keys(this.values))
            if (!sliders.some((each) => each.name === name)) delete this.values[name];
        const { png, messages } = await draw(this.program, text, path.dirname(this.document.fileName), this.values);
        this.isDrawing = false;
        if (this.isGone) return;
        const moved = sliders.map((each) => ({ ...each, value: this.values[each.name] ?? each.value }));
        this.panel.webview.postMessage({ png: png && png.toString('base64'), messages, sliders: moved });
        if (this.isDue) {
            this.isDue = false;
            this.update();
        }
    }

    /** Writes the values of the sliders into the scene. */
    async keep() {
        const edit = new vscode.WorkspaceEdit();
        for (const each of slidersIn(this.document.getText())) {
            if (!(each.name in this.values)) continue;
            const range = new vscode.Range(this.document.positionAt(each.begin), this.document.positionAt(each.end));
            edit.replace(this.document.uri, range, written(this.values[each.name]));
        }
        this.values = {};
        await vscode.workspace.applyEdit(edit);
    }
}

function page() {
    const nonce = crypto.randomBytes(16).toString('hex');
    return `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
      content="default-src 'none'; img-src data:; style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'">
<style nonce="${nonce}">
img { max-width: 100%; display: block; }
label { display: grid; grid-template-columns: 8em 1fr 5em; gap: 1em; margin: .4em 0; }
pre { white-space: pre-wrap; color: var(--vscode-errorForeground); }
</style></head>
<body><img id="picture" alt="the picture of the scene"><div id="sliders"></div>
<button id="keep" hidden>Write the values into the scene</button><pre id="messages"></pre>
<script nonce="${nonce}">
const editor = acquireVsCodeApi();
const byId = (id) => document.getElementById(id);
function slider(each) {
    const label = document.createElement('label');
    const name = document.createElement('span'), number = document.createElement('span');
    const input = document.createElement('input');
    name.textContent = each.name;
    input.type = 'range';
    input.min = each.low;
    input.max = each.high;
    input.step = 'any';
    input.addEventListener('input', () => {
        number.textContent = Number(input.value).toPrecision(4);
        byId('keep').hidden = false;
        editor.postMessage({ type: 'move', name: each.name, value: input.value });
    });
    label.append(name, input, number);
    return label;
}
let shown = '';
window.addEventListener('message', ({ data }) => {
    if (data.png) byId('picture').src = 'data:image/png;base64,' + data.png;
    byId('messages').textContent = data.messages;
    const ranges = JSON.stringify(data.sliders.map((each) => [each.name, each.low, each.high]));
    if (ranges !== shown) byId('sliders').replaceChildren(...data.sliders.map(slider));
    shown = ranges;
    data.sliders.forEach((each, i) => {
        const [, input, number] = byId('sliders').children[i].children;
        if (document.activeElement === input && !byId('keep').hidden) return;
        input.value = each.value;
        number.textContent = each.value.toPrecision(4);
    });
});
byId('keep').addEventListener('click', () => {
    byId('keep').hidden = true;
    editor.postMessage({ type: 'keep' });
});
editor.postMessage({ type: 'ready' });
</script></body></html>`;
}

module.exports = { Picture, draw };
