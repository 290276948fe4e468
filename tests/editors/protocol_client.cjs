// The language server and the protocol's own client library: what they say to each other is what both understand.
// SPDX-License-Identifier: MIT
//
// Usage: node protocol_client.cjs RMPLC MODULES EXAMPLES      exits with 77 where vscode-languageserver-protocol is not in MODULES
'use strict';
const assert = require('assert');
const { spawn } = require('child_process');
const fs = require('fs');
const path = require('path');
const { pathToFileURL } = require('url');

const [program, modules, examples] = process.argv.slice(2).map((given) => path.resolve(given));
let protocol;
try {
  protocol = require(path.resolve(modules, 'vscode-languageserver-protocol', 'node'));
} catch {
  console.log('skipped: vscode-languageserver-protocol is not in ' + modules + '; cmake/install-packages editors puts it there');
  process.exit(77);
}

const uriOf = (name) => pathToFileURL(path.join(examples, 'mars-entry', name)).href;
const read = (name) => fs.readFileSync(path.join(examples, 'mars-entry', name), 'utf8');

async function main() {
  const server = spawn(program, ['server', '--stdio'], { stdio: ['pipe', 'pipe', 'inherit'] });
  const ended = new Promise((resolve) => server.on('exit', resolve));
  const connection = protocol.createProtocolConnection(
    new protocol.StreamMessageReader(server.stdout), new protocol.StreamMessageWriter(server.stdin));
  const waiting = new Map();
  connection.onNotification(protocol.PublishDiagnosticsNotification.type, (told) => {
    const key = told.uri + ' ' + told.version;
    if (waiting.has(key)) waiting.get(key)(told.diagnostics);
  });
  const diagnostics = (uri, version) => new Promise((resolve) => waiting.set(uri + ' ' + version, resolve));
  connection.listen();

  const { capabilities } = await connection.sendRequest(protocol.InitializeRequest.type, { processId: process.pid, rootUri: null, capabilities: {} });
  assert.strictEqual(capabilities.textDocumentSync.change, protocol.TextDocumentSyncKind.Incremental);
  await connection.sendNotification(protocol.InitializedNotification.type, {});

  const uri = uriOf('mars_entry.rmpl');
  const textDocument = { uri };
  let told = diagnostics(uri, 1);
  await connection.sendNotification(protocol.DidOpenTextDocumentNotification.type,
    { textDocument: { uri, languageId: 'rmpl', version: 1, text: read('mars_entry.rmpl') } });
  assert.deepStrictEqual(await told, []);

  const lines = read('mars_entry.rmpl').split('\n');
  const line = lines.findIndex((l) => l.includes('engine = standby'));
  const position = { line, character: lines[line].indexOf('standby') };
  const hover = await connection.sendRequest(protocol.HoverRequest.type, { textDocument, position });
  assert.match(hover.contents.value, /mode standby/);
  const definition = await connection.sendRequest(protocol.DefinitionRequest.type, { textDocument, position });
  assert.strictEqual(definition.uri, uriOf('mars_lander.tcca'));
  const references = await connection.sendRequest(protocol.ReferencesRequest.type, { textDocument, position, context: { includeDeclaration: true } });
  assert.ok(references.length > 5, 'uses of standby: ' + references.length);
  const symbols = await connection.sendRequest(protocol.DocumentSymbolRequest.type, { textDocument });
  assert.deepStrictEqual(symbols.map((s) => s.name), ['EntrySequence']);
  const lenses = await connection.sendRequest(protocol.CodeLensRequest.type, { textDocument });
  assert.deepStrictEqual(lenses.map((l) => [l.command.title, l.command.command]), [['check', 'rmpl.run']]);
  const [item] = await connection.sendRequest(protocol.CallHierarchyPrepareRequest.type,
    { textDocument, position: symbols[0].selectionRange.start });
  assert.strictEqual(item.name, 'EntrySequence');
  const incoming = await connection.sendRequest(protocol.CallHierarchyIncomingCallsRequest.type, { item });
  assert.deepStrictEqual(incoming.filter(({ from }) => from.kind !== protocol.SymbolKind.Event), []);
  const completion = await connection.sendRequest(protocol.CompletionRequest.type, { textDocument, position });
  assert.deepStrictEqual(completion.items.map((i) => i.label).filter((l) => l === 'heating'), ['heating']);
  const tokens = await connection.sendRequest(protocol.SemanticTokensRequest.type, { textDocument });
  assert.ok(tokens.data.length > 100 && tokens.data.length % 5 === 0);
  const edit = await connection.sendRequest(protocol.RenameRequest.type, { textDocument, position, newName: 'warm' });
  assert.deepStrictEqual(Object.keys(edit.changes).sort(), ['mars_entry.rmpl', 'mars_entry.scn', 'mars_lander.tcca'].map(uriOf));
  await assert.rejects(connection.sendRequest(protocol.RenameRequest.type, { textDocument, position, newName: 'firing' }));

  told = diagnostics(uri, 2);
  await connection.sendNotification(protocol.DidChangeTextDocumentNotification.type, {
    textDocument: { uri, version: 2 },
    contentChanges: [{ range: { start: position, end: { line, character: position.character + 7 } }, text: 'standbye' }],
  });
  const [wrong] = await told;
  assert.strictEqual(wrong.code, 'RMPL0102');
  assert.deepStrictEqual(wrong.range.start, position);
  const actions = await connection.sendRequest(protocol.CodeActionRequest.type,
    { textDocument, range: wrong.range, context: { diagnostics: [wrong] } });
  assert.strictEqual(actions[0].edit.changes[uri][0].newText, 'standby');

  await connection.sendRequest(protocol.ShutdownRequest.type);
  await connection.sendNotification(protocol.ExitNotification.type);
  assert.strictEqual(await ended, 0);
  console.log('the protocol client and the server understand each other');
}

main().then(() => process.exit(0), (error) => { console.error(error); process.exit(1); });
