// The debug adapter and VS Code's own test client: what they say to each other is what both understand.
// SPDX-License-Identifier: MIT
//
// Usage: node debug_client.cjs RMPL_RUN MODULES EXAMPLES      exits with 77 where @vscode/debugadapter-testsupport is not in MODULES
'use strict';
const assert = require('assert');
const fs = require('fs');
const path = require('path');

const [program, modules, examples] = process.argv.slice(2).map((given) => path.resolve(given));
let DebugClient;
try {
  ({ DebugClient } = require(path.resolve(modules, '@vscode', 'debugadapter-testsupport')));
} catch {
  console.log('skipped: @vscode/debugadapter-testsupport is not in ' + modules + '; cmake/install-packages editors puts it there');
  process.exit(77);
}

const file = (folder, name) => path.join(examples, folder, name);
const lineOf = (name, text) => fs.readFileSync(name, 'utf8').split('\n').findIndex((line) => line.includes(text)) + 1;

/// The client starts one argument; a shell takes the line apart.
async function started() {
  const client = new DebugClient('"' + program + '"', 'step --dap', 'rmpl', { shell: true });
  client.defaultTimeout = 30000;
  await client.start();
  return client;
}

async function lines() {
  const rmpl = file('mars-entry', 'mars_entry.rmpl');
  const client = await started();
  await client.hitBreakpoint({ scenario: file('mars-entry', 'mars_entry.scn'), only: 'nominal flight', stopOnEntry: false },
    { path: rmpl, line: lineOf(rmpl, 'nav = inertial') });
  const { body } = await client.evaluateRequest({ expression: 'engine = standby' });
  assert.strictEqual(body.result, 'true');
  await Promise.all([client.nextRequest({ threadId: 1 }), client.waitForEvent('stopped')]);
  await Promise.all([client.stepBackRequest({ threadId: 1 }), client.waitForEvent('stopped')]);
  const { body: { stackFrames } } = await client.stackTraceRequest({ threadId: 1 });
  assert.strictEqual(stackFrames[0].line, lineOf(rmpl, 'nav = inertial'));
  await client.stop();
}

async function surprise() {
  const client = await started();
  const stopped = client.waitForEvent('stopped');
  await Promise.all([
    client.launch({ scenario: file('safe-mode', 'safe_mode.scn'), only: 'a reading that nothing explains', stopOnEntry: false }),
    client.waitForEvent('initialized').then(async () => {
      await client.setExceptionBreakpointsRequest({ filters: ['surprise'] });
      const { body } = await client.setFunctionBreakpointsRequest({ breakpoints: [{ name: 'computer = safe' }] });
      assert.ok(body.breakpoints[0].verified);
      await client.configurationDoneRequest();
    }),
  ]);
  assert.strictEqual((await stopped).body.reason, 'exception');
  const { body: { scopes } } = await client.scopesRequest({ frameId: 1 });
  const readings = scopes.find((scope) => scope.name === 'Readings');
  const { body: { variables } } = await client.variablesRequest({ variablesReference: readings.variablesReference });
  assert.strictEqual(variables.find((one) => one.name === 'engine.thrust').value, 'full');
  await client.stop();
}

lines().then(surprise).then(
  () => console.log('a breakpoint on a line and a surprise, by the client of others'),
  (error) => { console.error(error); process.exit(1); });
