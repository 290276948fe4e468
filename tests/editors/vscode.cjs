// The extension for VS Code as its host would use it: its grammars in the editor's own tokenizer, its start.
// SPDX-License-Identifier: MIT
//
// Usage: node vscode.cjs EXTENSION MODULES EXAMPLES      exits with 77 where vscode-textmate is not in MODULES
'use strict';
const assert = require('assert');
const fs = require('fs');
const Module = require('module');
const path = require('path');

const [extension, modules, examples] = process.argv.slice(2).map((given) => path.resolve(given));
let textmate, oniguruma;
try {
  textmate = require(path.join(modules, 'vscode-textmate'));
  oniguruma = require(path.join(modules, 'vscode-oniguruma'));
} catch {
  console.log('skipped: vscode-textmate is not in ' + modules + '; cmake/install-packages editors puts it there');
  process.exit(77);
}
const manifest = JSON.parse(fs.readFileSync(path.join(extension, 'package.json'), 'utf8'));

/// The tokens of a text, each with its innermost scope; what has none but the language's own is left out.
function tokens(grammar, text) {
  const result = [];
  let state = textmate.INITIAL;
  for (const line of text.split('\n')) {
    const told = grammar.tokenizeLine(line, state);
    state = told.ruleStack;
    for (const token of told.tokens) {
      if (token.scopes.length > 1) result.push([line.slice(token.startIndex, token.endIndex), token.scopes[token.scopes.length - 1]]);
    }
  }
  return result;
}

/// Lines with what some of their words are.
const EXPECTED = {
  rmpl: ['when (t1 >= 4.5 min) donext nav = inertial; // why',
         { when: 'keyword.control.rmpl', '>=': 'keyword.operator.rmpl', '4.5 min': 'constant.numeric.rmpl', nav: 'variable.other.rmpl',
           '// why': 'comment.line.double-slash.rmpl' }],
  tcca: ['component Valve { initial closed; closed -> open when cmd = open after 2 s; }',
         { component: 'storage.type.tcca', initial: 'storage.modifier.tcca', '->': 'keyword.operator.tcca', after: 'keyword.control.tcca',
           '2 s': 'constant.numeric.tcca' }],
  scn: ['plant "a.tcca"; at 5 s expect v = open; /* no', { '5 s': 'constant.numeric.scn', '/*': 'comment.block.scn' }],
  props: ['never v = stuck;', { v: 'variable.other.props' }],
  mon: ['channel "T" : v { low below 5; }', { below: 'keyword.operator.word.mon', v: 'variable.other.mon' }],
};

async function grammars() {
  await oniguruma.loadWASM(fs.readFileSync(path.join(modules, 'vscode-oniguruma/release/onig.wasm')).buffer);
  const files = new Map(manifest.contributes.grammars.map((grammar) => [grammar.scopeName, path.join(extension, grammar.path)]));
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({ createOnigScanner: (sources) => new oniguruma.OnigScanner(sources),
                               createOnigString: (text) => new oniguruma.OnigString(text) }),
    loadGrammar: async (scope) => textmate.parseRawGrammar(fs.readFileSync(files.get(scope), 'utf8'), files.get(scope)),
  });
  let counted = 0;
  for (const { language, scopeName } of manifest.contributes.grammars) {
    const grammar = await registry.loadGrammar(scopeName);
    const [line, wanted] = EXPECTED[language];
    const found = tokens(grammar, line);
    for (const [word, scope] of Object.entries(wanted)) {
      assert.ok(found.some(([text, told]) => text.trim() === word && told === scope || text.startsWith(word) && told === scope),
                `${language}: ${word} is no ${scope} in ${JSON.stringify(found)}`);
    }
    for (const folder of fs.readdirSync(examples)) {
      const inside = path.join(examples, folder);
      if (!fs.statSync(inside).isDirectory()) continue;
      for (const file of fs.readdirSync(inside).filter((name) => name.endsWith('.' + language))) {
        const all = tokens(grammar, fs.readFileSync(path.join(inside, file), 'utf8'));
        assert.ok(all.some(([, scope]) => /^(keyword|storage)/.test(scope)), `${file}: no keyword is told`);
        counted += all.length;
      }
    }
  }
  return counted;
}

/// Activates the extension against stand-ins of the editor and of its client library, which note what they are asked for.
async function activation() {
  const noted = {};
  const stand_ins = {
    vscode: { commands: { registerCommand: (name, action) => { noted[name] = action; return { name }; } },
              tasks: { executeTask: (task) => { noted.task = task; } },
              Task: class { constructor(...all) { this.execution = all[4]; } },
              TaskScope: { Workspace: 2 },
              ProcessExecution: class { constructor(process, args, options) { Object.assign(this, { process, args, options }); } },
              workspace: { saveAll: async () => { noted.saved = true; return true; },
                           getConfiguration: (section) => ({ get: (key) => manifest.contributes.configuration.properties[section + '.' + key].default }),
                           createFileSystemWatcher: (pattern) => ({ pattern }) },
              debug: { startDebugging: (folder, configuration) => { noted.debugged = configuration; },
                       registerDebugAdapterDescriptorFactory: (type, factory) => { noted.debuggers = { type, factory }; return { type }; } },
              DebugAdapterExecutable: class { constructor(command, args) { Object.assign(this, { command, args }); } } },
    'vscode-languageclient/node': {
      TransportKind: { stdio: 0 },
      LanguageClient: class {
        constructor(id, name, run, options) { Object.assign(noted, { id, name, run, options }); }
        async start() { noted.started = true; }
        async stop() { noted.started = false; }
      },
    },
  };
  const load = Module._load;
  Module._load = (request, ...rest) => (request in stand_ins ? stand_ins[request] : load(request, ...rest));
  const loaded = require(path.join(extension, manifest.main));
  Module._load = load;
  const context = { subscriptions: [] };
  await loaded.activate(context);
  assert.strictEqual(noted.run.command, 'rmplc');
  assert.deepStrictEqual(noted.run.args, ['server']);
  assert.deepStrictEqual(noted.options.documentSelector.map(({ language }) => language), manifest.contributes.languages.map(({ id }) => id));
  assert.strictEqual(noted.debuggers.type, manifest.contributes.debuggers[0].type);
  const { command, args } = noted.debuggers.factory.createDebugAdapterDescriptor();
  assert.deepStrictEqual([command, args], ['rmpl-run', ['step', '--dap']]);
  assert.strictEqual(context.subscriptions.length, 3);
  await noted['rmpl.run']({ program: 'tcca-check', arguments: ['check', 'a b.props'], folder: '/x' });
  assert.ok(noted.saved);
  assert.deepStrictEqual({ ...noted.task.execution }, { process: 'tcca-check', args: ['check', 'a b.props'], options: { cwd: '/x' } });
  await assert.rejects(noted['rmpl.run']({ program: 'sh', arguments: ['-c', 'true'], folder: '/' }));
  await noted['rmpl.debug']({ type: 'rmpl', scenario: 'a.scn' });
  assert.strictEqual(noted.debugged.scenario, 'a.scn');
  assert.ok(noted.started);
  await loaded.deactivate();
  assert.ok(!noted.started);
}

(async () => {
  const counted = await grammars();
  await activation();
  console.log(`grammars of each language, ${counted} tokens of the examples; the extension starts rmplc server and stops it`);
})().catch((error) => {
  console.log(String(error.stack || error));
  process.exit(1);
});
