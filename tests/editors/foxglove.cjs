// A flight that goes on, read by Foxglove's own client library: what it understands is what is sent.
// SPDX-License-Identifier: MIT
//
// Usage: node foxglove.cjs RMPL-RUN MODULES EXAMPLES      exits with 77 where @foxglove/ws-protocol or ws is not in MODULES
'use strict';
const assert = require('assert');
const { spawn } = require('child_process');
const path = require('path');

const [program, modules, examples] = process.argv.slice(2).map((given) => path.resolve(given));
let FoxgloveClient, WebSocket;
try {
  ({ FoxgloveClient } = require(path.join(modules, '@foxglove/ws-protocol')));
  WebSocket = require(path.join(modules, 'ws'));
} catch {
  console.log('skipped: @foxglove/ws-protocol is not in ' + modules + '; cmake/install-packages editors puts it there');
  process.exit(77);
}

async function main() {
  const flight = spawn(program, ['execute', path.join(examples, 'mars-entry/mars_entry.rmpl'), path.join(examples, 'mars-entry/mars_lander.tcca'),
    '--exec', 'exec python3 ' + path.join(examples, 'live/lander.py'), '--cycle', '0.02 s', '--duration', '10 s', '--foxglove', '0'],
    { stdio: ['ignore', 'ignore', 'pipe'] });
  const ended = new Promise((resolve) => flight.on('exit', resolve));
  const url = await new Promise((resolve, reject) => {
    let said = '';
    flight.stderr.on('data', (more) => {
      said += more;
      const found = /ws:\/\/\S+/.exec(said);
      if (found) resolve(found[0]);
    });
    flight.on('exit', () => reject(new Error('it ended: ' + said)));
  });

  const client = new FoxgloveClient({ ws: new WebSocket(url, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]) });
  const topics = new Map(), messages = new Map(), told = [];
  let info, time = -1n;
  client.on('error', (error) => { throw error; });
  client.on('serverInfo', (message) => { info = message; });
  client.on('status', (message) => told.push(message));
  client.on('time', ({ timestamp }) => {
    assert.ok(timestamp > time, 'time goes on');
    time = timestamp;
  });
  client.on('message', ({ subscriptionId, timestamp, data }) => {
    const topic = topics.get(subscriptionId);
    if (!messages.has(topic)) messages.set(topic, []);
    messages.get(topic).push([timestamp, JSON.parse(new TextDecoder().decode(data))]);
  });
  client.on('advertise', (channels) => {
    for (const channel of channels) {
      assert.strictEqual(channel.encoding, 'json');
      assert.strictEqual(JSON.parse(channel.schema).type, 'object');
      topics.set(client.subscribe(channel.id), channel.topic);
    }
  });
  await new Promise((resolve) => client.on('close', resolve));
  assert.strictEqual(await ended, 0);
  assert.strictEqual(info.name, 'rmpl-run: EntrySequence');
  assert.deepStrictEqual([...topics.values()],
    ['/estimate', '/truth', '/belief', '/goal', '/command', '/reading', '/marking', '/event', '/channel']);
  assert.strictEqual(messages.get('/estimate').at(-1)[1].engine, 'heating');
  assert.deepStrictEqual(messages.get('/goal').at(-1)[1], { engine: 'standby' });
  assert.strictEqual(messages.get('/reading').at(-1)[1]['engine.temp'], 'low');
  for (const [topic, all] of messages) {
    all.forEach(([timestamp], i) => assert.ok(i === 0 || timestamp >= all[i - 1][0], topic + ' is in order'));
  }
  assert.match(told.at(-1).message, /the duration ended/);
  console.log(`Foxglove's client library reads a flight: ${[...messages.values()].flat().length} messages`);
}

main().then(() => process.exit(0), (error) => { console.error(error); process.exit(1); });
