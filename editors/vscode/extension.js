// Starts `rmplc server` for the languages, runs what its code lenses say, and `rmpl-run step --dap` to debug. Made by
// grammar/editor/generate.
// SPDX-License-Identifier: MIT
const { commands, debug, DebugAdapterExecutable, ProcessExecution, Task, tasks, TaskScope, workspace } = require('vscode');
const { LanguageClient, TransportKind } = require('vscode-languageclient/node');

let client;

const setting = (name) => workspace.getConfiguration('rmpl').get(name);
// Programs that a lens may run; what they are called is a setting.
const programs = { 'rmplc': 'server.path', 'rmpl-run': 'run.path', 'tcca-check': 'check.path' };

const debuggers = { createDebugAdapterDescriptor: () => new DebugAdapterExecutable(setting('run.path'), ['step', '--dap']) };

// The programs read files: what is not saved they do not see.
const saved = (action) => async (argument) => (await workspace.saveAll(false)) && action(argument);
const run = ({ program, arguments: words, folder }) => {
  if (!(program in programs)) throw new Error('no program of RMPL: ' + program);
  const execution = new ProcessExecution(setting(programs[program]), words, { cwd: folder });
  return tasks.executeTask(new Task({ type: 'rmpl' }, TaskScope.Workspace, program + ' ' + words[0], 'RMPL', execution));
};
const fly = (configuration) => debug.startDebugging(undefined, configuration);

exports.activate = (context) => {
  context.subscriptions.push(debug.registerDebugAdapterDescriptorFactory('rmpl', debuggers),
    commands.registerCommand('rmpl.run', saved(run)), commands.registerCommand('rmpl.debug', saved(fly)));
  const server = { command: setting('server.path'), args: ['server'], transport: TransportKind.stdio };
  const documentSelector = ['rmpl', 'tcca', 'scn', 'props', 'mon'].map((language) => ({ language }));
  const synchronize = { fileEvents: workspace.createFileSystemWatcher('**/*.{rmpl,tcca,scn,props,mon}') };
  client = new LanguageClient('rmpl', 'RMPL', server, { documentSelector, synchronize });
  return client.start();
};

exports.deactivate = () => client && client.stop();
