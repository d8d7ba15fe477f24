// glibra in Visual Studio Code: the client of its language server, and the picture beside the text.
'use strict';

const vscode = require('vscode');
const { LanguageClient } = require('vscode-languageclient/node');
const { Picture } = require('./picture');

let client;
const pictures = new Map(); // by the address of the scene

function program() {
    return vscode.workspace.getConfiguration('glibra').get('program') || 'glibra';
}

/** The scene of the editor in front; for a shader, the scene that is open. */
function sceneInFront() {
    const document = vscode.window.activeTextEditor?.document;
    if (document?.languageId === 'glib') return document;
    return vscode.window.visibleTextEditors.map((each) => each.document).find((each) => each.languageId === 'glib') ??
        vscode.workspace.textDocuments.find((each) => each.languageId === 'glib');
}

function showPicture() {
    const document = sceneInFront();
    if (!document || document.isUntitled) {
        vscode.window.showInformationMessage('Open the scene (.glib) whose picture is to be shown, and save it once.');
        return;
    }
    const key = document.uri.toString();
    const known = pictures.get(key);
    if (known) {
        known.panel.reveal(undefined, true);
        return;
    }
    const picture = new Picture(document, program());
    pictures.set(key, picture);
    picture.panel.onDidDispose(() => {
        picture.isGone = true;
        pictures.delete(key);
    });
}

async function activate(context) {
    context.subscriptions.push(
        vscode.commands.registerCommand('glibra.showPicture', showPicture),
        vscode.workspace.onDidChangeTextDocument(({ document }) => pictures.get(document.uri.toString())?.changed()),
        vscode.workspace.onDidSaveTextDocument((document) => {
            if (document.languageId === 'glsl') for (const each of pictures.values()) each.changed();
        }));
    client = new LanguageClient('glibra', 'glibra', { command: program(), args: ['language-server'] }, {
        documentSelector: [{ scheme: 'file', language: 'glib' }, { scheme: 'file', language: 'glsl' }],
        synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher('**/*.{glib,glsl,vert,tesc,tese,geom,frag,comp}') }
    });
    try {
        await client.start();
    } catch {
        vscode.window.showErrorMessage(`glibra does not start as '${program()}'. Install it, or name it in the setting glibra.program.`);
    }
}

function deactivate() {
    return client?.stop();
}

module.exports = { activate, deactivate };
