// Makes what the package has besides the sources: the grammar that the program glibra writes (GLIBRA names it, if it is not in
// the PATH), one file of code, and the licences.
'use strict';

const { execFileSync } = require('child_process');
const { buildSync } = require('esbuild');
const fs = require('fs');
const path = require('path');

process.chdir(__dirname);
execFileSync(process.env.GLIBRA || 'glibra', ['language', '--grammar', 'vscode', '-o', 'generated'], { stdio: 'inherit' });
fs.copyFileSync('../../../LICENSE', 'LICENSE');
const { metafile } = buildSync({
    entryPoints: ['src/extension.js'], outfile: 'dist/extension.js', bundle: true, platform: 'node', target: 'node18',
    external: ['vscode'], minifySyntax: true, minifyWhitespace: true, metafile: true
});
const packages = new Set(Object.keys(metafile.inputs).map((file) => file.match(/^.*node_modules\/(?:@[^/]+\/)?[^/]+/)?.[0]).filter(Boolean));
const texts = [...packages].sort().map((folder) => {
    const licence = fs.readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
    return `${folder.replace(/^.*node_modules\//, '')}\n\n${fs.readFileSync(path.join(folder, licence), 'utf8').trim()}\n`;
});
fs.writeFileSync('dist/LICENSES.txt', texts.join('\n---\n\n'));
