// glibra format, language-server and language --grammar, as editors run them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

bool isInstalled(const char* program) {
    return std::system((std::string("command -v ") + program + " > /dev/null 2>&1").c_str()) == 0;
}

TEST(FormatCommand, FormatsInPlaceAndChecks) {
    const Folder folder;
    folder.write("a.glib", "group\nsphere\nEndGroup\n");
    folder.write("b.glib", "Sphere\n");
    const Finished checked = glibra(folder.path(), "format --check a.glib b.glib");
    EXPECT_EQ(checked.status, 1);
    EXPECT_EQ(checked.err, "a.glib is not formatted\n");
    EXPECT_EQ(glibra(folder.path(), "format .").status, 0);
    EXPECT_EQ(readFile(folder / "a.glib"), "Group\n    Sphere\nEndGroup\n");
    EXPECT_EQ(glibra(folder.path(), "format --check .").status, 0);
    folder.write("input", " box 1");
    EXPECT_EQ(shell(folder.path(), "(cat input | '" GLIBRA_PROGRAM "' format --stdin)").out, "Box 1\n");
    EXPECT_EQ(shell(folder.path(), "(cat input | '" GLIBRA_PROGRAM "' format - --check)").status, 1);
    EXPECT_EQ(glibra(folder.path(), "format no.glib").status, 3);
    EXPECT_EQ(glibra(folder.path(), "format").status, 2);
}

TEST(FormatCommand, KeepsThePermissionsAndTheNamesOfAFile) {
    const Folder folder;
    folder.write("a.glib", " sphere\n");
    folder.write("b.glib", " sphere\n");
    fs::permissions(folder / "a.glib", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_hard_link(folder / "b.glib", folder / "c.glib");
    fs::create_symlink("c.glib", folder / "d.glib");
    EXPECT_EQ(glibra(folder.path(), "format a.glib d.glib").status, 0);
    EXPECT_EQ(fs::status(folder / "a.glib").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_TRUE(fs::is_symlink(folder / "d.glib"));
    EXPECT_EQ(readFile(folder / "b.glib"), "Sphere\n");
    EXPECT_EQ(fs::hard_link_count(folder / "b.glib"), 2U);
}

/// A submission may hold a link to any file of who formats it, or be another name of one.
TEST(FormatCommand, ChangesNoFileOutsideOfAFolderThroughWhatItFindsThere) {
    const Folder folder;
    folder.write("Makefile", " sphere\n");
    folder.write("other", " sphere\n");
    folder.write("all/ana/b.glib", " sphere\n");
    fs::create_symlink("../../Makefile", folder / "all/ana/a.glib");
    fs::create_hard_link(folder / "other", folder / "all/ana/c.glib");
    const Finished formatted = glibra(folder.path(), "format all");
    EXPECT_EQ(formatted.status, 0) << formatted.err;
    EXPECT_TRUE(contains(formatted.err, "all/ana/a.glib is a link")) << formatted.err;
    EXPECT_EQ(readFile(folder / "Makefile"), " sphere\n");
    EXPECT_EQ(readFile(folder / "other"), " sphere\n");
    EXPECT_TRUE(fs::is_symlink(folder / "all/ana/a.glib"));
    for (const char* each : {"all/ana/b.glib", "all/ana/c.glib"})
        EXPECT_EQ(readFile(folder / each), "Sphere\n") << each;
    EXPECT_EQ(glibra(folder.path(), "format --check all").status, 0);
    EXPECT_EQ(glibra(folder.path(), "format all all/ana/a.glib").status, 0) << "the command names it";
    EXPECT_EQ(readFile(folder / "Makefile"), "Sphere\n");
}

/// Speaks to the server through a Python script, which has `send`, `receive` and `process`.
Finished converse(const Folder& folder, const std::string& script) {
    folder.write("converse.py",
                 "import json, subprocess, sys\n"
                 "process = subprocess.Popen([sys.argv[1], 'language-server'], stdin=subprocess.PIPE, "
                 "stdout=subprocess.PIPE)\n"
                 "def raw(data):\n    process.stdin.write(data)\n    process.stdin.flush()\n"
                 "def send(method, params=None, id=None):\n"
                 "    message = {'jsonrpc': '2.0', 'method': method, 'params': params or {}}\n"
                 "    if id is not None: message['id'] = id\n"
                 "    data = json.dumps(message).encode()\n"
                 "    raw(b'Content-Length: %d\\r\\n\\r\\n' % len(data) + data)\n"
                 "def receive():\n"
                 "    length = 0\n"
                 "    while True:\n"
                 "        line = process.stdout.readline()\n"
                 "        if not line.strip(): break\n"
                 "        length = int(line.split(b':')[1])\n"
                 "    return json.loads(process.stdout.read(length))\n" +
                     script);
    return shell(folder.path(), "timeout 60 python3 converse.py '" GLIBRA_PROGRAM "'");
}

TEST(LanguageServerCommand, EndsWithTheProcessOfItsClient) {
    const Folder folder;
    const Finished gone = converse(folder, R"(
client = subprocess.Popen(['sleep', '1'])
send('initialize', {'processId': client.pid, 'capabilities': {}}, 1)
receive()
client.wait()
sys.exit(0 if process.wait(20) == 1 else 3)
)");
    EXPECT_EQ(gone.status, 0) << gone.err;
    const Finished stays = converse(folder, R"(
send('initialize', {'processId': 99999999, 'capabilities': {}}, 1)  # of another machine
receive()
try: process.wait(4); sys.exit(3)
except subprocess.TimeoutExpired: process.kill()
)");
    EXPECT_EQ(stays.status, 0) << stays.err;
}

TEST(LanguageServerCommand, SpeaksAndEndsAsTheProtocolSays) {
    const Folder folder;
    const Finished whole = converse(folder, R"(
raw(b'Content-Length: 5\r\n\r\n{"a":')
assert receive()['error']['code'] == -32700
send('initialize', {'capabilities': {}}, 1)
assert receive()['result']['capabilities']['hoverProvider'] is True
send('initialized')
send('textDocument/didOpen', {'textDocument': {'uri': 'file:///nowhere/a.glib', 'languageId': 'glib', 'version': 1, 'text': 'Spere 1\n'}})
told = receive()
assert told['method'] == 'textDocument/publishDiagnostics', told
message = told['params']['diagnostics'][0]
assert message['code'] == 'glib-E01' and 'Sphere' in message['message'], message
send('shutdown', None, 2)
assert receive()['result'] is None
send('exit')
sys.exit(process.wait())
)");
    EXPECT_EQ(whole.status, 0) << whole.err;
    EXPECT_EQ(converse(folder, "process.stdin.close()\nsys.exit(process.wait())\n").status, 1);
    EXPECT_EQ(converse(folder, "send('exit')\nsys.exit(process.wait())\n").status, 1);
}

TEST(LanguageServerCommand, AnswersWhileASceneIsChecked) {
    const Folder folder;
    folder.write("a.vert", kVertexShader);
    folder.write("a.glib", "Vertex a.vert\nFragment a.frag\nProgram A uTint {1 0 0 1}\nBox\n");
    folder.write("a.frag",
                 "#version 330\nuniform vec4 uTint;\nout vec4 c;\nvoid main() {\n    c = uTint.;\n}\n");
    const Finished session = converse(folder, R"(
import os
base = 'file://' + os.path.realpath('.')
shader = base + '/a.frag'
def ask(method, params, id):
    send(method, params, id)
    told = []
    while True:
        message = receive()
        if message.get('id') == id: return message.get('result', message), told
        told.append(message)
def at(line, character, **more): return {'textDocument': {'uri': shader}, 'position': {'line': line, 'character': character}, **more}
ask('initialize', {'capabilities': {}}, 1)
for name, language in (('a.glib', 'glib'), ('a.frag', 'glsl')):
    send('textDocument/didOpen', {'textDocument': {'uri': base + '/' + name, 'languageId': language, 'version': 1, 'text': open(name).read()}})
# Before the driver has said anything.
items, told = ask('textDocument/completion', at(4, 14), 2)
assert [each['label'] for each in items['items']][:2] == ['xyzw', 'xyz'], items
wrong = []
while not wrong:
    message = receive()
    if message['method'] == 'textDocument/publishDiagnostics' and message['params']['uri'] == shader: wrong = message['params']['diagnostics']
assert wrong[0]['code'] == 'glsl-E01' and wrong[0]['range']['start']['line'] == 4, wrong
send('textDocument/didChange', {'textDocument': {'uri': shader, 'version': 2}, 'contentChanges': [{'range': {'start': {'line': 4, 'character': 13}, 'end': {'line': 4, 'character': 14}}, 'text': ''}]})
edit, told = ask('textDocument/rename', at(1, 14, newName='uColor'), 3)
assert len(edit['changes']) == 2, edit
right = None
while right is None:
    message = told.pop(0) if told else receive()
    if message.get('method') == 'textDocument/publishDiagnostics' and message['params']['uri'] == shader: right = message['params']['diagnostics']
assert right == [], right
# Places and documents that do not exist.
assert ask('textDocument/completion', at(2 ** 40, -7), 4)[0]['items'] is not None
assert 'error' in ask('textDocument/rename', {'textDocument': {'uri': 'file:///none'}, 'newName': 7}, 5)[0]
# The client goes while a scene is checked.
send('textDocument/didChange', {'textDocument': {'uri': shader, 'version': 3}, 'contentChanges': [{'text': open('a.frag').read()}]})
process.stdin.close()
sys.exit(process.wait(5))
)");
    EXPECT_EQ(session.status, 1) << session.err;
}

TEST(LanguageServerCommand, SaysWhyItEndsAfterAnAbsurdLength) {
    const Folder folder;
    const Finished ended =
        converse(folder, "raw(b'Content-Length: 99999999999\\r\\n\\r\\n{}')\nsys.exit(process.wait())\n");
    EXPECT_EQ(ended.status, 1);
    EXPECT_PRED2(contains, ended.err,
                 "glibra: error: the client states a message of more than 67108864 bytes");
}

TEST(LanguageServerCommand, SaysThatItCannotWrite) {
    const Folder folder;
    folder.write("hello", "Content-Length: 40\r\n\r\n{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"x\"}   ");
    const Finished full = shell(folder.path(), "('" GLIBRA_PROGRAM "' language-server < hello > /dev/full)");
    EXPECT_EQ(full.status, 3);
    EXPECT_PRED2(contains, full.err, "cannot write to standard output");
}

TEST(LanguageServerCommand, SaysWhatCheckSays) {
    const Folder folder;
    folder.write("a.vert", kVertexShader);
    folder.write("a.frag", "#version 330\nout vec4 c;\nin vec3 vNo;\nvoid main() { c = vec4(vNo, 1); }\n");
    folder.write("a.glib",
                 "Vertex a.vert\nFragment a.frag\nProgram A uA <0 1\nSpere\nColor 2 0 0\nTranslate (tim)\n"
                 "Box 1 2 3 4 5 6\n");
    const Finished checked = glibra(folder.path(), "check --json a.glib");
    folder.write("check.json", checked.out);
    const Finished same = converse(folder, R"(
import os
base = 'file://' + os.path.realpath('.')
send('initialize', {'capabilities': {}}, 1)
receive()
send('textDocument/didOpen', {'textDocument': {'uri': base + '/a.glib', 'languageId': 'glib', 'version': 1, 'text': open('a.glib').read()}})
told = set()
for each in range(2):
    params = receive()['params']
    for one in params['diagnostics']:
        told.add((os.path.basename(params['uri']), one['range']['start']['line'] + 1, one['code'], one['message']))
wanted = set()
for one in json.load(open('check.json'))[0]['diagnostics']:
    wanted.add((os.path.basename(one['file']), one['line'], one['id'], one['text']))
print('only the server:', told - wanted)
print('only check:', wanted - told)
process.kill()
sys.exit(0 if told == wanted and len(told) >= 6 else 1)
)");
    EXPECT_EQ(same.status, 0) << same.out << same.err << checked.out;
}

TEST(Grammar, OfVscodeIsJsonWhoseRulesFindEveryStatement) {
    const Folder folder;
    ASSERT_EQ(glibra(folder.path(), "language --grammar vscode -o vscode").status, 0);
    folder.write("test.py", R"(
import json, pathlib, re, subprocess, sys
folder = pathlib.Path('vscode')
package = json.loads((folder / 'package.json').read_text())
grammar = json.loads((folder / package['contributes']['grammars'][0]['path']).read_text())
language = json.loads((folder / package['contributes']['languages'][0]['configuration']).read_text())
for pattern in language['indentationRules'].values(): re.compile(pattern)
rules = grammar['patterns']
for rule in rules:
    for key in ('match', 'begin', 'end'):
        if key in rule: re.compile(rule[key])
words = subprocess.run([sys.argv[1], 'language', '--words'], capture_output=True, text=True, check=True).stdout.split()
def kind(line, column):
    "The name that the rules give to the byte of a line outside of shaders."
    at = 0
    while at < len(line):
        best = None
        for rule in rules:
            found = re.compile(rule.get('match') or rule['begin']).search(line, at)
            if found and found.end() > found.start() and (best is None or found.start() < best[0].start()):
                best = (found, rule)
        if not best: return ''
        found, rule = best
        if column < found.start(): return ''
        if column < found.end():
            captures = rule.get('captures') or rule.get('beginCaptures') or {}
            for number, capture in captures.items():
                if found.start(int(number)) <= column < found.end(int(number)): return capture['name']
            return rule.get('name', '')
        at = found.end()
    return ''
for word in words:
    if '.' in word: continue
    assert kind('  ' + word.lower() + ' 1', 3) == 'keyword.control.glib', word
assert kind('Sphere 1.5e3 # Box', 8) == 'constant.numeric.glib'
assert kind('Sphere 1.5e3 # Box', 16) == 'comment.line.glib'
assert kind('Vertex "a # b" x', 10) == 'string.quoted.double.glib'
assert kind('Pass window from eye', 13) == 'storage.modifier.glib'
assert kind('Translate (sin(time))', 11) == 'support.function.glib'
assert kind('Translate (sin(time))', 16) == 'variable.language.glib'
assert kind('Spheres', 2) == ''
assert kind('Fragment inline', 10) == 'storage.modifier.glib'
)");
    const Finished tested = shell(folder.path(), "python3 test.py '" GLIBRA_PROGRAM "'");
    EXPECT_EQ(tested.status, 0) << tested.err;
}

TEST(Grammar, OfVimColorsScenes) {
    if (!isInstalled("vim")) GTEST_SKIP() << "vim is not installed";
    const Folder folder;
    ASSERT_EQ(glibra(folder.path(), "language --grammar vim -o vim").status, 0);
    folder.write("a.glib",
                 "# comment\nsphere 1.5 // end\nFragment inline\n#version 330\nvoid main() {}\nEndFragment\n"
                 "Pass window from eye\n  Translate (sin(time)) 0 \"a # b\"\nDisplay fold\n");
    folder.write("test.vim",
                 "set nocompatible\nset runtimepath^=vim\nfiletype plugin on\nsyntax on\nedit a.glib\n"
                 "let s:out = [&filetype]\n"
                 "for s:at in [[1, 3], [2, 1], [2, 9], [2, 14], [3, 1], [4, 1], [6, 1], [7, 1], [7, 13], "
                 "[8, 3], [8, 14], [8, 18], [8, 28]]\n"
                 "  call add(s:out, synIDattr(synID(s:at[0], s:at[1], 0), 'name'))\nendfor\n"
                 "call writefile(s:out, 'out.txt')\nqall!\n");
    const Finished ran = shell(folder.path(), "timeout 20 vim -N -u NONE -es -S test.vim < /dev/null");
    const std::string out = readFile(folder / "out.txt");
    EXPECT_TRUE(out.starts_with("glib\nglibComment\nglibStatement\nglibNumber\nglibComment\nglibStatement\n"))
        << out << ran.err;
    EXPECT_TRUE(
        out.ends_with("glibStatement\nglibStatement\nglibKey\nglibStatement\nglibFunction\nglibName\n"
                      "glibString\n"))
        << out;
}

TEST(Grammar, OfVimHasNoErrorInAnySceneOfTheProject) {
    if (!isInstalled("vim")) GTEST_SKIP() << "vim is not installed";
    const Folder folder;
    ASSERT_EQ(glibra(folder.path(), "language --grammar vim -o vim").status, 0);
    // The first word of every line that is no comment, no shader and no continued statement.
    folder.write("test.vim", R"(set nocompatible
set runtimepath^=vim
syntax on
let s:wrong = []
for s:file in split(glob(g:folder . '/glib/modern/*.glib') . "\n" . glob(g:folder . '/glib/start/*.glib'), "\n")
  execute 'edit ' . fnameescape(s:file)
  set filetype=glib syntax=glib
  let s:inside = 0
  for s:line in range(1, line('$'))
    let s:text = getline(s:line)
    if s:text =~? '^\s*End\(Vertex\|Fragment\|Compute\|Geometry\|TessControl\|TessEvaluation\)\s*$' | let s:inside = 0 | endif
    let s:first = match(s:text, '\S')
    if !s:inside && s:first >= 0 && getline(s:line - 1) !~ '\\$'
      let s:want = s:text[s:first] == '#' ? 'glibComment' : 'glibStatement'
      if synIDattr(synID(s:line, s:first + 1, 0), 'name') != s:want | call add(s:wrong, s:file . ':' . s:line . ' ' . s:text) | endif
    endif
    if s:text =~? '^\s*\a\+\s\+inline\s*$' | let s:inside = 1 | endif
  endfor
endfor
call writefile(s:wrong + ['done'], 'out.txt')
qall!
)");
    shell(folder.path(), "timeout 60 vim -N -u NONE -es --cmd \"let g:folder = '" GLIBRA_SOURCE_DIR
                         "'\" -S test.vim < /dev/null");
    EXPECT_EQ(readFile(folder / "out.txt"), "done\n");
}

TEST(Grammar, OfKateIsXmlWithAllItsContexts) {
    const Folder folder;
    ASSERT_EQ(glibra(folder.path(), "language --grammar kate -o kate").status, 0);
    folder.write("test.py", R"(
import re, xml.etree.ElementTree as tree
language = tree.parse('kate/glib.xml').getroot()
assert language.get('extensions') == '*.glib' and language.get('kateversion')
contexts = {each.get('name') for each in language.iter('context')}
attributes = {each.get('name') for each in language.iter('itemData')}
lists = {each.get('name') for each in language.iter('list')}
for rule in language.iter('contexts'):
    for each in rule.iter():
        if each.get('attribute'): assert each.get('attribute') in attributes, each.attrib
        context = each.get('context')
        if context and not context.startswith('#'): assert context in contexts, context
        if each.tag == 'keyword': assert each.get('String') in lists, each.attrib
        if each.tag == 'RegExpr': re.compile(each.get('String'))
)");
    const Finished tested = shell(folder.path(), "python3 test.py");
    EXPECT_EQ(tested.status, 0) << tested.err;
    for (const char* each : {"ksyntaxhighlighter6", "ksyntaxhighlighter5"}) {
        if (!isInstalled(each)) continue;
        folder.write("a.glib", "Sphere 1\n");
        const Finished colored = shell(folder.path(),
                                       "mkdir -p x/org.kde.syntax-highlighting/syntax && cp kate/glib.xml "
                                       "x/org.kde.syntax-highlighting/syntax && XDG_DATA_HOME=$PWD/x " +
                                           std::string(each) + " -s GLIB a.glib");
        EXPECT_PRED2(contains, colored.out, "Sphere");
        EXPECT_EQ(colored.status, 0) << colored.err;
    }
}

TEST(LanguageServerCommand, ServesNeovim) {
    if (!isInstalled("nvim")) GTEST_SKIP() << "neovim is not installed";
    const Folder folder;
    folder.write("a.vert", kVertexShader);
    folder.write("a.frag", "#version 330\nuniform vec4 uTint;\nout vec4 c;\nvoid main() { c = uTint; }\n");
    folder.write("a.glib",
                 "Vertex a.vert\nFragment a.frag\nProgram A uTint {1 .5 0 1}\nGroup\nspere 1\nEndGroup\n");
    folder.write("test.lua", R"LUA(
local log = {}
local function say(text) table.insert(log, text) end
local client = vim.lsp.start_client({ name = 'glibra', cmd = { vim.env.GLIBRA, 'language-server' }, root_dir = vim.fn.getcwd() })
vim.cmd('edit a.glib')
vim.lsp.buf_attach_client(0, client)
local function wait(what, condition)
    if not vim.wait(10000, condition, 20) then say('no ' .. what) end
end
wait('diagnostic', function() return #vim.diagnostic.get(0) > 0 end)
for _, each in ipairs(vim.diagnostic.get(0)) do
    say(string.format('%d:%d %s %s', each.lnum, each.col, each.code or each.user_data.lsp.code, each.message))
end
vim.api.nvim_buf_set_lines(0, 4, 5, true, { 'sphere 1' })
wait('correction', function() return #vim.diagnostic.get(0) == 0 end)
say('corrected')
local function ask(method, line, column)
    local params = { textDocument = vim.lsp.util.make_text_document_params(), position = { line = line, character = column } }
    local answers = vim.lsp.buf_request_sync(0, method, params, 10000)
    return answers[client].result
end
local items = ask('textDocument/completion', 4, 3).items
say('completes ' .. items[1].label)
say(ask('textDocument/hover', 4, 2).contents.value)
local place = ask('textDocument/definition', 1, 11)
say('goes to ' .. vim.fn.fnamemodify(vim.uri_to_fname(place.uri), ':t'))
local edits = vim.lsp.buf_request_sync(0, 'textDocument/formatting', vim.lsp.util.make_formatting_params(), 10000)[client].result
vim.lsp.util.apply_text_edits(edits, vim.api.nvim_get_current_buf(), 'utf-16')
say(table.concat(vim.api.nvim_buf_get_lines(0, 3, 6, true), '|'))
vim.lsp.stop_client(client)
wait('end', function() return vim.lsp.client_is_stopped(client) end)
vim.fn.writefile(vim.split(table.concat(log, '\n'), '\n'), 'out.txt')
vim.cmd('qall!')
)LUA");
    const Finished ran =
        shell(folder.path(), "GLIBRA='" GLIBRA_PROGRAM
                             "'"
                             " HOME=$PWD timeout 60 nvim --headless -i NONE -u NONE -n -c 'luafile test.lua' "
                             "-c 'cquit' < /dev/null");
    const std::string out = readFile(folder / "out.txt");
    EXPECT_PRED2(contains, out, "4:0 glib-E01 ") << ran.err;
    EXPECT_PRED2(contains, out, "corrected\ncompletes Sphere\n") << ran.err;
    EXPECT_PRED2(contains, out, "Sphere [radius") << out;
    EXPECT_PRED2(contains, out, "goes to a.frag\nGroup|    Sphere 1|EndGroup\n") << ran.err;
    EXPECT_FALSE(contains(out, "no ")) << out;
}

}  // namespace
}  // namespace glibra::test
