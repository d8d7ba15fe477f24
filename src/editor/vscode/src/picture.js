// The picture of a scene beside its text, with a slider for each range. `glibra render` draws the text as it stands in the
// editor, and the shaders as they are saved.
'use strict';

const { spawn } = require('child_process');
const crypto = require('crypto');
const path = require('path');
const vscode = require('vscode');
const { slidersIn, written } = require('./sliders');

const PAUSE = 200; // milliseconds without a key before the scene is drawn
const LIMIT = 20000; // milliseconds that a picture may take
const LIMIT_OF_OLD = 3000; // of a text that has changed meanwhile
const LONGEST = 2000; // letters of messages

/** Draws a scene: {done, end}, a promise of {png, messages} and what ends the program. `settings` are those of `--set`. */
function draw(program, text, file, settings) {
    const child = spawn(program, ['render', '-', '-o', '-', ...settings.flatMap((each) => ['--set', each])], { cwd: path.dirname(file) });
    const done = new Promise((resolve) => {
        const picture = [];
        let messages = '';
        const timer = setTimeout(() => child.kill('SIGKILL'), LIMIT);
        child.stdout.on('data', (bytes) => picture.push(bytes));
        child.stderr.setEncoding('utf8').on('data', (part) => { if (messages.length < LONGEST) messages += part; });
        child.on('error', () => {
            clearTimeout(timer);
            resolve({ png: null, messages: `'${program}' does not start in ${path.dirname(file)}. The setting glibra.program names the program.` });
        });
        child.on('close', (status, signal) => {
            clearTimeout(timer);
            const late = signal === 'SIGKILL' ? `The picture takes more than ${LIMIT / 1000} seconds.\n` : '';
            resolve({
                png: status === 0 ? Buffer.concat(picture) : null,
                messages: late + messages.slice(0, LONGEST).replaceAll('<stdin>', path.basename(file))
            });
        });
        child.stdin.on('error', () => {}); // the program has ended
        child.stdin.end(text);
    });
    return { done, end: () => child.kill('SIGKILL') };
}

class Picture {
    /** `program` gives the name of the program; `panel`: one that is there already. */
    constructor(uri, program, panel) {
        this.uri = uri;
        this.program = program;
        this.moved = new Map(); // by the names of sliders: {value, stated}, stated by the text at that time
        this.counts = new Set(); // names of sliders whose values glibra cuts to whole numbers
        this.drawing = null;
        this.isDue = this.isClosed = false;
        this.panel = panel ?? vscode.window.createWebviewPanel('glibra.picture', '',
            { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true }, { retainContextWhenHidden: true });
        this.panel.title = `Picture of ${path.basename(uri.fsPath)}`;
        this.panel.webview.options = { enableScripts: true, localResourceRoots: [] };
        this.panel.webview.onDidReceiveMessage((message) => this.receive(message));
        this.panel.webview.html = page(uri.toString());
    }

    close() {
        this.isClosed = true;
        clearTimeout(this.timer);
        clearTimeout(this.limit);
        this.drawing?.end();
    }

    /** The text or a shader has changed. */
    changed() {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.update(), PAUSE);
    }

    async receive(message) {
        if (message.type === 'ready') this.update();
        if (message.type === 'move') {
            const slider = this.slidersIn(await this.text()).find((each) => each.name === message.name);
            if (slider) this.moved.set(slider.name, { value: Number(message.value), stated: slider.value });
            this.update();
        }
        if (message.type === 'keep') this.keep();
    }

    /** Also where no editor has the scene any more. */
    async text() {
        return (await vscode.workspace.openTextDocument(this.uri)).getText();
    }

    slidersIn(text) {
        return slidersIn(text).map((each) => ({ ...each, isWhole: each.isWhole || this.counts.has(each.name) }));
    }

    /** One picture at a time: what changes meanwhile is drawn after it. */
    async update() {
        if (this.isClosed) return;
        if (this.isDrawing) {
            this.isDue = true;
            this.limit ??= setTimeout(() => this.drawing?.end(), Math.max(0, this.began + LIMIT_OF_OLD - Date.now()));
            return;
        }
        this.isDrawing = true;
        this.isDue = false;
        this.began = Date.now();
        try {
            this.show(...await this.drawn());
        } catch (error) {
            this.panel.webview.postMessage({ png: null, messages: error.message, sliders: [] }); // the scene is gone
        }
        clearTimeout(this.limit);
        this.limit = null;
        this.isDrawing = false;
        if (this.isDue) this.update();
    }

    async drawn() {
        const text = await this.text();
        const sliders = this.slidersIn(text);
        for (const [name, { stated }] of this.moved) // what is written anew counts
            if (sliders.find((each) => each.name === name)?.value !== stated) this.moved.delete(name);
        const settings = sliders.filter((each) => this.moved.has(each.name))
            .map((each) => [each.name, written(this.moved.get(each.name).value, each)]);
        this.drawing = draw(this.program(), text, this.uri.fsPath, settings.map((each) => each.join('=')));
        const { png, messages } = await this.drawing.done;
        this.drawing = null;
        for (const [, number] of messages.matchAll(/warning: (\S+) is cut to .*\[glib-W27\]/g))
            for (const [name, value] of settings)
                if (value === number) {
                    this.counts.add(name);
                    this.isDue = true;
                }
        return [png, messages, this.slidersIn(text)];
    }

    show(png, messages, sliders) {
        if (this.isClosed || (!png && this.isDue)) return;
        this.panel.webview.postMessage({
            png: png?.toString('base64'), messages, isMoved: this.moved.size > 0,
            sliders: sliders.map((each) => ({ ...each, value: this.moved.get(each.name)?.value ?? each.value }))
        });
    }

    /** Writes the values of the sliders into the scene. */
    async keep() {
        const document = await vscode.workspace.openTextDocument(this.uri);
        const edit = new vscode.WorkspaceEdit();
        for (const each of this.slidersIn(document.getText())) {
            if (!this.moved.has(each.name)) continue;
            const range = new vscode.Range(document.positionAt(each.begin), document.positionAt(each.end));
            edit.replace(this.uri, range, written(this.moved.get(each.name).value, each));
        }
        if (!await vscode.workspace.applyEdit(edit)) return;
        this.moved.clear();
        this.changed();
    }
}

/** The page of the panel; `scene` is the address that it is shown again with after the window is loaded again. */
function page(scene) {
    const nonce = crypto.randomBytes(16).toString('hex');
    return `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
      content="default-src 'none'; img-src data:; style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'">
<style nonce="${nonce}">
img { max-width: 100%; display: block; }
img:not([src]) { display: none; }
.old img { opacity: .5; }
label { display: grid; grid-template-columns: 8em 1fr 5em; gap: 1em; margin: .4em 0; }
button { color: var(--vscode-button-foreground); background: var(--vscode-button-background); border: 0; padding: .4em 1em; }
pre { white-space: pre-wrap; }
.old pre { color: var(--vscode-errorForeground); }
</style></head>
<body><img id="picture" alt="the picture of the scene"><p id="age" hidden>The picture is older than the text:</p>
<pre id="messages"></pre>
<div id="sliders"></div>
<button id="keep" hidden>Write the values into the scene</button>
<script nonce="${nonce}">
const editor = acquireVsCodeApi();
editor.setState({ scene: ${JSON.stringify(scene).replaceAll('<', '\\u003c')} });
const byId = (id) => document.getElementById(id);
const digits = (each, value) => each.isWhole ? String(Math.round(value)) : Number(value).toPrecision(4);
function slider(each) {
    const label = document.createElement('label');
    const name = document.createElement('span'), number = document.createElement('span');
    const input = document.createElement('input');
    name.textContent = each.name;
    input.type = 'range';
    input.min = each.low;
    input.max = each.high;
    input.step = each.isWhole ? 1 : 'any';
    input.addEventListener('input', () => {
        number.textContent = digits(each, input.value);
        byId('keep').hidden = false;
        editor.postMessage({ type: 'move', name: each.name, value: input.value });
    });
    label.append(name, input, number);
    return label;
}
let shown = '[]', held = false;
window.addEventListener('pointerdown', () => { held = true; });
for (const event of ['pointerup', 'pointercancel', 'blur']) window.addEventListener(event, () => { held = false; });
window.addEventListener('message', ({ data }) => {
    if (data.png) byId('picture').src = 'data:image/png;base64,' + data.png;
    document.body.className = data.png ? '' : 'old';
    byId('age').hidden = Boolean(data.png) || !byId('picture').hasAttribute('src');
    byId('messages').textContent = data.messages;
    if (held) return; // the slider shows what the hand does
    byId('keep').hidden = !data.isMoved;
    const ranges = JSON.stringify(data.sliders.map((each) => [each.name, each.low, each.high, each.isWhole]));
    if (ranges !== shown) byId('sliders').replaceChildren(...data.sliders.map(slider));
    shown = ranges;
    data.sliders.forEach((each, i) => {
        const [, input, number] = byId('sliders').children[i].children;
        input.value = each.value;
        number.textContent = digits(each, each.value);
    });
});
byId('keep').addEventListener('click', () => editor.postMessage({ type: 'keep' }));
editor.postMessage({ type: 'ready' });
</script></body></html>`;
}

module.exports = { Picture, draw };
