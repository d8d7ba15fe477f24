// glibra in Visual Studio Code: the client of its language server, and the picture beside the text.
'use strict';

const { execFile } = require('child_process');
const os = require('os');
const vscode = require('vscode');
const { LanguageClient } = require('vscode-languageclient/node');
const { Picture } = require('./picture');

const FILES = '**/*.{glib,glsl,vert,tesc,tese,geom,frag,comp,vs,tcs,tes,gs,fs}';

let client;
let starting = Promise.resolve();
const pictures = new Map(); // by the address of the scene

function program() {
    const name = vscode.workspace.getConfiguration('glibra').get('program').trim() || 'glibra';
    return name.replace(/^~(?=[\\/])/, os.homedir());
}

/** The scene of the editor in front; for a shader, the scene that is open. */
function sceneInFront() {
    const document = vscode.window.activeTextEditor?.document;
    if (document?.languageId === 'glib') return document;
    return vscode.window.visibleTextEditors.map((each) => each.document).find((each) => each.languageId === 'glib') ??
        vscode.workspace.textDocuments.find((each) => each.languageId === 'glib');
}

function add(uri, panel) {
    const key = uri.toString();
    const picture = new Picture(uri, program, panel);
    pictures.set(key, picture);
    picture.panel.onDidDispose(() => {
        picture.close();
        pictures.delete(key);
    });
}

function showPicture() {
    const document = sceneInFront();
    if (document?.uri.scheme !== 'file') {
        vscode.window.showInformationMessage('Open the scene (.glib) whose picture is to be shown, and save it once.');
        return;
    }
    const known = pictures.get(document.uri.toString());
    if (known) known.panel.reveal(undefined, true);
    else add(document.uri);
}

function allChanged() {
    for (const each of pictures.values()) each.changed();
}

/** What keeps the program from starting: null if nothing does. */
function obstacle() {
    return new Promise((resolve) => execFile(program(), ['--version'], (error) => {
        if (!error) resolve(null);
        else resolve(error.code === 'ENOENT' ? `there is no program '${program()}'` : `'${program()}' does not start: ${error.message.trim()}`);
    }));
}

async function startClient(watcher) {
    const old = client;
    client = null;
    await old?.stop().catch(() => {});
    if (!vscode.workspace.isTrusted) return;
    const why = await obstacle();
    if (why) {
        vscode.window.showErrorMessage(`glibra: ${why}. Install glibra, or name its program in the setting glibra.program.`, 'Open the Setting')
            .then((chosen) => chosen && vscode.commands.executeCommand('workbench.action.openSettings', 'glibra.program'));
        return;
    }
    client = new LanguageClient('glibra', 'glibra', { command: program(), args: ['language-server'] }, {
        documentSelector: [{ scheme: 'file', language: 'glib' }, { scheme: 'file', language: 'glsl' }],
        synchronize: { fileEvents: watcher }
    });
    await client.start().catch(() => {}); // the client has said why
}

function activate(context) {
    const watcher = vscode.workspace.createFileSystemWatcher(FILES);
    const start = () => { starting = starting.then(() => startClient(watcher)); };
    context.subscriptions.push(
        watcher,
        watcher.onDidChange(allChanged), watcher.onDidCreate(allChanged), watcher.onDidDelete(allChanged),
        vscode.commands.registerCommand('glibra.showPicture', showPicture),
        vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
            if (contentChanges.length) pictures.get(document.uri.toString())?.changed();
        }),
        vscode.workspace.onDidSaveTextDocument((document) => {
            if (document.languageId === 'glsl' || document.languageId === 'glib') allChanged();
        }),
        vscode.workspace.onDidGrantWorkspaceTrust(start),
        vscode.workspace.onDidChangeConfiguration((event) => {
            if (!event.affectsConfiguration('glibra.program')) return;
            start();
            allChanged();
        }),
        vscode.window.registerWebviewPanelSerializer('glibra.picture', { // after the window is loaded again
            async deserializeWebviewPanel(panel, state) {
                if (state && vscode.workspace.isTrusted && !pictures.has(state.scene)) add(vscode.Uri.parse(state.scene), panel);
                else panel.dispose();
            }
        }));
    start();
}

async function deactivate() {
    await starting;
    await client?.stop().catch(() => {});
}

module.exports = { activate, deactivate };
