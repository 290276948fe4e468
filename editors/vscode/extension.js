// Starts `rmplc server` for the four languages. Made by grammar/editor/generate.
// SPDX-License-Identifier: MIT
const { workspace } = require('vscode');
const { LanguageClient, TransportKind } = require('vscode-languageclient/node');

let client;

exports.activate = () => {
  const command = workspace.getConfiguration('rmpl').get('server.path');
  const run = { command, args: ['server'], transport: TransportKind.stdio };
  const documentSelector = ['rmpl', 'tcca', 'scn', 'props'].map((language) => ({ language }));
  const synchronize = { fileEvents: workspace.createFileSystemWatcher('**/*.{rmpl,tcca,scn,props}') };
  client = new LanguageClient('rmpl', 'RMPL', run, { documentSelector, synchronize });
  return client.start();
};

exports.deactivate = () => client && client.stop();
